//! The orders of a ranking.

use super::Ranked;

/// By which quantity rules are ranked.
#[derive(Debug, Clone, Copy)]
pub struct Order {
    /// Its name in the JSON and on the command line.
    pub name: &'static str,
    /// What it is, and which end comes first.
    pub description: &'static str,
    /// What sorts: smaller comes first, absent last.
    key: fn(&Ranked) -> Option<f64>,
}

/// Every order, the default first.
pub static ORDERS: &[Order] = &[
    Order {
        name: "balance",
        description: "robust rules first, then the geometric mean of the two IAE in percent of the best possible",
        key: |rule| Some(f64::from(rule.class()) - rule.balance() / 200.0),
    },
    Order { name: "load_iae", description: "load IAE, least first", key: Ranked::load_iae },
    Order { name: "setpoint_iae", description: "setpoint IAE, least first", key: Ranked::setpoint_iae },
    Order {
        name: "sensitivity_peak",
        description: "sensitivity peak, least first",
        key: |rule| rule.achieved.sensitivity_peak,
    },
    Order {
        name: "gain_margin",
        description: "gain margin, greatest first",
        key: |rule| rule.achieved.gain_margin.map(|margin| -margin),
    },
    Order {
        name: "phase_margin",
        description: "phase margin, greatest first",
        key: |rule| rule.achieved.phase_margin.map(|margin| -margin.0),
    },
    Order {
        name: "delay_margin",
        description: "delay margin, greatest first",
        key: |rule| rule.achieved.delay_margin.map(|margin| -margin.0),
    },
    Order { name: "noise_gain", description: "noise gain, least first", key: |rule| rule.noise_gain },
    Order {
        name: "control_energy",
        description: "control energy of a setpoint step, least first",
        key: |rule| rule.setpoint.as_ref().and_then(|step| step.control_energy),
    },
    Order {
        name: "total_variation",
        description: "total variation of the controller output after a load step, least first",
        key: |rule| rule.load.as_ref().and_then(|step| step.total_variation),
    },
];

impl Order {
    /// What sorts: smaller comes first, absent last.
    pub(super) fn key(&self, rule: &Ranked) -> Option<f64> {
        (self.key)(rule)
    }
}
