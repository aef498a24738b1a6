//! The metrics of a response, and the table that everything which lists metrics iterates.

use serde::{Serialize, Serializer};

use crate::model::Seconds;

/// Metrics of one response; a metric that is infinite or has no meaning is absent, with a sentence in the warnings.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Metrics {
    /// Integral of the absolute error [output unit · s].
    pub iae: Option<f64>,
    /// Integral of the squared error [output unit² · s].
    pub ise: Option<f64>,
    /// Integral of time times the absolute error [output unit · s²], time counted from 0.
    pub itae: Option<f64>,
    /// Integral of the squared controller output [input unit² · s], the load not included.
    pub control_energy: Option<f64>,
    /// Total variation of the controller output [input unit], jumps included, from 0 before the first event.
    pub total_variation: Option<f64>,
    /// Largest excess over the setpoint [ratio of the setpoint move].
    pub overshoot: Option<f64>,
    /// First crossing of 90 % of the setpoint move minus first crossing of 10 % [s].
    #[serde(rename = "rise_time_s", serialize_with = "seconds")]
    pub rise_time: Option<Seconds>,
    /// Last time the error leaves ±2 % of the setpoint move, from the move on [s].
    #[serde(rename = "settling_time_s", serialize_with = "seconds")]
    pub settling_time: Option<Seconds>,
    /// Last time the error leaves ±5 % of the setpoint move, from the move on [s].
    #[serde(rename = "settling_time_5_s", serialize_with = "seconds")]
    pub settling_time_5: Option<Seconds>,
    /// Largest deviation of the controlled variable from its initial level [output unit].
    pub peak: Option<f64>,
    /// Distance that the valve moves [input unit]; of a sampled loop only, and left out of the JSON of others.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub valve_travel: Option<f64>,
}

#[expect(clippy::ref_option, reason = "serde's signature")]
fn seconds<S: Serializer>(time: &Option<Seconds>, serializer: S) -> Result<S::Ok, S::Error> {
    time.map(|t| t.0).serialize(serializer)
}

/// One line of the table of metrics.
#[derive(Debug, Clone, Copy)]
pub struct Metric {
    /// Name in the JSON, in the files and on the command line.
    pub name: &'static str,
    /// Unit, in words.
    pub unit: &'static str,
    /// What it is, in one line.
    pub description: &'static str,
    /// Its value in a set of metrics.
    pub value: fn(&Metrics) -> Option<f64>,
}

/// Every metric, in the order of the JSON.
///
/// ```
/// use holdup::analysis::metrics::METRICS;
/// let names: Vec<&str> = METRICS.iter().map(|metric| metric.name).collect();
/// assert_eq!(names[..3], ["iae", "ise", "itae"]);
/// ```
pub static METRICS: &[Metric] = &[
    Metric {
        name: "iae",
        unit: "output unit · s",
        description: "integral of the absolute error",
        value: |m| m.iae,
    },
    Metric {
        name: "ise",
        unit: "output unit² · s",
        description: "integral of the squared error",
        value: |m| m.ise,
    },
    Metric {
        name: "itae",
        unit: "output unit · s²",
        description: "integral of time times the absolute error, time from 0",
        value: |m| m.itae,
    },
    Metric {
        name: "control_energy",
        unit: "input unit² · s",
        description: "integral of the squared controller output, the load not included",
        value: |m| m.control_energy,
    },
    Metric {
        name: "total_variation",
        unit: "input unit",
        description: "total variation of the controller output, jumps included",
        value: |m| m.total_variation,
    },
    Metric {
        name: "overshoot",
        unit: "ratio",
        description: "largest excess over the setpoint as a ratio of the setpoint move",
        value: |m| m.overshoot,
    },
    Metric {
        name: "rise_time_s",
        unit: "s",
        description: "first crossing of 90 % minus first crossing of 10 % of the setpoint move",
        value: |m| m.rise_time.map(|t| t.0),
    },
    Metric {
        name: "settling_time_s",
        unit: "s",
        description: "last time the error leaves 2 % of the setpoint move",
        value: |m| m.settling_time.map(|t| t.0),
    },
    Metric {
        name: "settling_time_5_s",
        unit: "s",
        description: "last time the error leaves 5 % of the setpoint move",
        value: |m| m.settling_time_5.map(|t| t.0),
    },
    Metric {
        name: "peak",
        unit: "output unit",
        description: "largest deviation of the controlled variable from its initial level",
        value: |m| m.peak,
    },
    Metric {
        name: "valve_travel",
        unit: "input unit",
        description: "distance that the valve moves, of a sampled loop",
        value: |m| m.valve_travel,
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_and_the_json_have_the_same_names_in_the_same_order() {
        let metrics = Metrics { valve_travel: Some(1.0), ..Metrics::default() };
        let json = serde_json::to_value(metrics).unwrap();
        let names: Vec<&String> = json.as_object().unwrap().keys().collect();
        let table: Vec<&str> = METRICS.iter().map(|m| m.name).collect();
        assert_eq!(names, table);
    }
}
