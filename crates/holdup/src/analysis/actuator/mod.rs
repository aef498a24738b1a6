//! What the actuator allows: the load that it can hold, the best that any controller can do within its limits, and
//! what a design asks of it.

mod best;
mod reach;

pub use best::{Best, best_after_load_step, best_after_setpoint_step};
pub use reach::{Asked, Reach, ReachError, kick, reach};

use crate::model::ModelError;
use crate::model::error::{finite, out_of_range};

/// The limits of the manipulated variable and where it stands at rest.
///
/// ```
/// use holdup::analysis::actuator::Actuator;
/// let valve = Actuator::new(0.0, 100.0, 40.0)?;
/// // At rest at 40 it can give way by 40 and add 60: loads from −60 to 40 are held.
/// assert_eq!(valve.loads_held(), (-60.0, 40.0));
/// # Ok::<(), holdup::model::ModelError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Actuator {
    low: f64,
    high: f64,
    rest: f64,
}

impl Actuator {
    /// An actuator that moves from `low` to `high` and rests at `rest` [input unit].
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] unless all are finite, `low` is below `high`, and `rest` is between them.
    pub fn new(low: f64, high: f64, rest: f64) -> Result<Self, ModelError> {
        finite("limits", low)?;
        finite("limits", high)?;
        if !(low < high && (high - low).is_finite()) {
            return Err(out_of_range("limits", high, "above the lower limit"));
        }
        if !(low..=high).contains(&rest) {
            return Err(out_of_range("output_at_rest", rest, "a finite number within the limits"));
        }
        Ok(Self { low, high, rest })
    }

    /// Lower limit [input unit].
    #[must_use]
    pub fn low(&self) -> f64 {
        self.low
    }

    /// Upper limit [input unit].
    #[must_use]
    pub fn high(&self) -> f64 {
        self.high
    }

    /// Output at rest [input unit].
    #[must_use]
    pub fn rest(&self) -> f64 {
        self.rest
    }

    /// How far the output can fall from rest [input unit], ≥ 0.
    #[must_use]
    pub fn below(&self) -> f64 {
        self.rest - self.low
    }

    /// How far the output can rise from rest [input unit], ≥ 0.
    #[must_use]
    pub fn above(&self) -> f64 {
        self.high - self.rest
    }

    /// The least and the greatest load step that the output can balance [input unit]: at rest u + D is the same, so
    /// that a load of D takes the output to `rest − D`. A load at either end is held, but nothing is left to recover
    /// from it with.
    #[must_use]
    pub fn loads_held(&self) -> (f64, f64) {
        (-self.above(), self.below())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_in_the_wrong_order_and_a_rest_outside_them_are_refused() {
        for (low, high, rest) in [
            (100.0, 0.0, 40.0),
            (0.0, 0.0, 0.0),
            (0.0, f64::INFINITY, 0.0),
            (f64::NAN, 1.0, 0.0),
            (0.0, 1.0, 1.5),
            (0.0, 1.0, f64::NAN),
            (-1.7e308, 1.7e308, 0.0),
        ] {
            assert!(Actuator::new(low, high, rest).is_err(), "{low} {high} {rest}");
        }
        assert_eq!(Actuator::new(0.0, 1.0, 0.0).unwrap().loads_held(), (-1.0, 0.0));
    }
}
