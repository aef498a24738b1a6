//! What every language fills in: the settings by the names of `holdup_control`, and what is said of them.

use super::template::{Mark, Value};
use super::{Export, header};

impl Export {
    /// Every mark but those of the language's own words.
    pub(super) fn marks(&self) -> Vec<Mark> {
        let mut marks: Vec<Mark> = vec![
            ("name", Value::Text(self.name.clone())),
            ("NAME", Value::Text(self.name.to_ascii_uppercase())),
            ("header", Value::Text(header::text(self))),
            ("segments", Value::Text(self.segments.max(1).to_string())),
            ("last_segment", Value::Text((self.segments.max(1) - 1).to_string())),
            ("nominal_period", Value::Text(self.installation.sample_period.0.to_string())),
        ];
        let mut optional = |flag: &'static str, name: &'static str, value: Option<f64>| {
            marks.push((flag, Value::Flag(value.is_some())));
            marks.push((name, Value::Optional(value)));
        };
        let (law, limits, watch) = (self.settings.law(), self.settings.limits(), self.settings.watch());
        let pid = law.pid;
        // Where it is not set, the tracking time in use is the integral time.
        let tracking_time = pid.tracking_time().filter(|_| self.installation.tracking_time.is_some());
        optional("has_integral", "integral_time", pid.integral_time());
        optional("has_tracking_time", "tracking_time", tracking_time);
        optional("has_derivative", "derivative_time", pid.derivative_time());
        optional("has_derivative_filter", "filter_time", pid.filter_time());
        optional("has_bleed_time", "bleed_time", pid.bleed_time());
        optional("has_low", "low", limits.low());
        optional("has_high", "high", limits.high());
        optional("has_rate", "rate", limits.rate());
        optional("has_range", "range_low", watch.range().map(|range| range.0));
        optional("has_stale_time", "stale_time", watch.stale_time());
        optional("has_failure", "failure_time", watch.failure_time());
        let observer = law.observer;
        optional("has_observer", "observer_gain", observer.map(|observer| observer.observer_gain()));
        let lead = observer.and_then(|observer| observer.lead());
        optional("has_lead", "lead_time", lead.map(|(lead_time, _)| lead_time));
        marks.extend([
            ("proportional_gain", Value::Number(pid.proportional_gain())),
            ("setpoint_weight", Value::Number(pid.setpoint_weight())),
            ("derivative_setpoint_weight", Value::Number(pid.derivative_setpoint_weight())),
            ("bias", Value::Number(pid.bias())),
            ("range_high", Value::Optional(watch.range().map(|range| range.1))),
            ("safe_output", Value::Optional(watch.safe_output())),
            ("model_gain", Value::Optional(observer.map(|observer| observer.model_gain()))),
            ("dead_time", Value::Optional(observer.map(|observer| observer.dead_time()))),
            ("sample_period", Value::Optional(observer.map(|observer| observer.sample_period()))),
            ("predicts", Value::Flag(observer.is_some_and(|observer| observer.predicts()))),
            ("lead_filter_time", Value::Optional(lead.map(|(_, filter_time)| filter_time))),
        ]);
        marks
    }
}
