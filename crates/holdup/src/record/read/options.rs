//! What is known of a file beforehand.

use super::civil::DateOrder;
use super::error::ReadError;
use super::number::DecimalMark;

/// What is known of a file beforehand. Everything is optional: what is not given is found out.
///
/// ```
/// use holdup::record::{ReadOptions, read_bytes};
///
/// let options = ReadOptions { time_unit: Some(60.0), ..ReadOptions::default() };
/// let reading = read_bytes(b"t,pv,op\n0,50,20\n1,51,20\n2,52,30\n", &options)?;
/// assert_eq!(reading.record.time(), [0.0, 60.0, 120.0]);
/// # Ok::<(), holdup::record::ReadError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ReadOptions {
    /// The time column: its name, or its number from 1.
    pub time: Option<String>,
    /// The column of the controlled variable.
    pub controlled_variable: Option<String>,
    /// The column of the manipulated variable.
    pub manipulated_variable: Option<String>,
    /// The column of the setpoint.
    pub setpoint: Option<String>,
    /// The column that says who moves the actuator.
    pub mode: Option<String>,
    /// Values of the mode column that mean automatic, where they are unusual.
    pub automatic: Vec<String>,
    /// Seconds in one unit of a time column of bare numbers [s].
    pub time_unit: Option<f64>,
    /// Time from row to row [s], for a file without a time column.
    pub sample_period: Option<f64>,
    /// Which number of a date is which.
    pub date_order: Option<DateOrder>,
    /// What separates the fraction of a number.
    pub decimal_mark: Option<DecimalMark>,
    /// Low and high end of the span of controlled variable and setpoint; both are then read in percent of it.
    pub controlled_span: Option<(f64, f64)>,
    /// Low and high end of the span of the manipulated variable, which is then read in percent of it.
    pub manipulated_span: Option<(f64, f64)>,
}

impl ReadOptions {
    /// Checks the numbers.
    pub(super) fn check(&self) -> Result<(), ReadError> {
        let spans = [("--pv-span", self.controlled_span), ("--op-span", self.manipulated_span)];
        for (option, (low, high)) in spans.into_iter().filter_map(|(option, span)| Some((option, span?))) {
            if !(low.is_finite() && high.is_finite() && low != high && (high - low).is_finite()) {
                let allowed = "two different finite numbers, low:high";
                return Err(ReadError::Option { option, given: format!("{low}:{high}"), allowed });
            }
        }
        for (option, given) in [("--time-unit", self.time_unit), ("--sample-period", self.sample_period)] {
            if let Some(value) = given.filter(|value| !(1e-9..=1e9).contains(value)) {
                let allowed = "a time from 1e-9 s to 1e9 s";
                return Err(ReadError::Option { option, given: format!("{value} s"), allowed });
            }
        }
        Ok(())
    }
}
