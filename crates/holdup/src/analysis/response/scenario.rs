//! What happens to the loop: setpoint moves, load steps, how long, and from which level.

use thiserror::Error;

use crate::model::Seconds;

/// A scenario that cannot be simulated: the option, its value and what is allowed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ScenarioError {
    /// A number lies outside its range, or is not a finite number.
    #[error("--{option} is {value}: must be {allowed}")]
    OutOfRange {
        /// Name of the option, without the dashes.
        option: &'static str,
        /// The value given.
        value: f64,
        /// What is allowed, in words.
        allowed: &'static str,
    },
    /// The times of the events do not increase.
    #[error("--{option} has time {value} after time {previous}: times must increase")]
    NotIncreasing {
        /// Name of the option, without the dashes.
        option: &'static str,
        /// The time that comes too late in the list [s].
        value: f64,
        /// The time before it [s].
        previous: f64,
    },
    /// An event lies at or beyond the horizon.
    #[error("--{option} has an event at {value} s: must lie before the horizon of {horizon} s")]
    BeyondHorizon {
        /// Name of the option, without the dashes.
        option: &'static str,
        /// Time of the event [s].
        value: f64,
        /// The horizon [s].
        horizon: f64,
    },
}

/// Piecewise-constant setpoint and load disturbance over a horizon, from rest at a level.
///
/// Before the first setpoint event the loop rests: output and setpoint are at `initial`, the controller output is
/// 0. All integrals run from 0 to the horizon. The load enters at the process input.
///
/// ```
/// use holdup::analysis::response::Scenario;
/// use holdup::model::Seconds;
/// let servo_and_load = Scenario::new(vec![(0.0, 1.0)], vec![(100.0, 1.0)], Seconds(300.0), 0.0)?;
/// assert_eq!(servo_and_load.load_at(99.0), 0.0);
/// assert_eq!(servo_and_load.load_at(100.0), 1.0);
/// assert!(Scenario::new(vec![(300.0, 1.0)], vec![], Seconds(300.0), 0.0).is_err());
/// # Ok::<(), holdup::analysis::response::ScenarioError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Scenario {
    setpoint: Vec<(f64, f64)>,
    load: Vec<(f64, f64)>,
    horizon: f64,
    initial: f64,
}

impl Scenario {
    /// A scenario of setpoint and load events (time [s], value from then on), a horizon and a level of rest.
    ///
    /// Without any event it is a setpoint step from `initial` to `initial` + 1 at time 0.
    ///
    /// # Errors
    /// [`ScenarioError`] unless all numbers are finite, times are ≥ 0, increase strictly and lie before the
    /// horizon, and the horizon is > 0.
    pub fn new(
        setpoint: Vec<(f64, f64)>,
        load: Vec<(f64, f64)>,
        horizon: Seconds,
        initial: f64,
    ) -> Result<Self, ScenarioError> {
        let out = |option, value, allowed| Err(ScenarioError::OutOfRange { option, value, allowed });
        let horizon = horizon.0;
        if !(horizon.is_finite() && horizon > 0.0) {
            return out("horizon", horizon, "a finite time greater than 0");
        }
        if !initial.is_finite() {
            return out("initial", initial, "a finite number");
        }
        for (option, events) in [("setpoint", &setpoint), ("load", &load)] {
            let mut previous = None;
            for &(time, value) in events {
                if !(time.is_finite() && time >= 0.0) {
                    return out(option, time, "a finite time, 0 or later, before each colon");
                }
                if !value.is_finite() {
                    return out(option, value, "a finite number after each colon");
                }
                if let Some(previous) = previous.filter(|&p| time <= p) {
                    return Err(ScenarioError::NotIncreasing { option, value: time, previous });
                }
                if time >= horizon {
                    return Err(ScenarioError::BeyondHorizon { option, value: time, horizon });
                }
                previous = Some(time);
            }
        }
        let setpoint =
            if setpoint.is_empty() && load.is_empty() { vec![(0.0, initial + 1.0)] } else { setpoint };
        Ok(Self { setpoint, load, horizon, initial })
    }

    /// A unit setpoint step at time 0 from rest at 0.
    ///
    /// # Errors
    /// [`ScenarioError`] unless the horizon is finite and greater than 0.
    pub fn unit_setpoint_step(horizon: Seconds) -> Result<Self, ScenarioError> {
        Self::new(vec![(0.0, 1.0)], vec![], horizon, 0.0)
    }

    /// A unit load step at time 0 from rest at 0.
    ///
    /// # Errors
    /// [`ScenarioError`] unless the horizon is finite and greater than 0.
    pub fn unit_load_step(horizon: Seconds) -> Result<Self, ScenarioError> {
        Self::new(vec![], vec![(0.0, 1.0)], horizon, 0.0)
    }

    /// Setpoint events: time [s] and the setpoint from then on.
    #[must_use]
    pub fn setpoint(&self) -> &[(f64, f64)] {
        &self.setpoint
    }

    /// Load events: time [s] and the load disturbance from then on.
    #[must_use]
    pub fn load(&self) -> &[(f64, f64)] {
        &self.load
    }

    /// The horizon [s].
    #[must_use]
    pub fn horizon(&self) -> f64 {
        self.horizon
    }

    /// The level at which output and setpoint rest before the first setpoint event.
    #[must_use]
    pub fn initial(&self) -> f64 {
        self.initial
    }

    /// The setpoint at a time [s], from the right at an event.
    #[must_use]
    pub fn setpoint_at(&self, time: f64) -> f64 {
        value_at(&self.setpoint, time).unwrap_or(self.initial)
    }

    /// The load disturbance at a time [s], from the right at an event.
    #[must_use]
    pub fn load_at(&self, time: f64) -> f64 {
        value_at(&self.load, time).unwrap_or(0.0)
    }

    /// The one setpoint move (time [s], size) of a scenario that has exactly one and no load; overshoot, rise and
    /// settling time are about it.
    #[must_use]
    pub fn single_setpoint_move(&self) -> Option<(f64, f64)> {
        match (self.setpoint_moves().as_slice(), self.load_moves().is_empty()) {
            (&[only], true) => Some(only),
            _ => None,
        }
    }

    /// The setpoint moves: time [s] and change; events that change nothing are left out.
    #[must_use]
    pub fn setpoint_moves(&self) -> Vec<(f64, f64)> {
        moves(&self.setpoint, self.initial)
    }

    /// The load moves: time [s] and change; events that change nothing are left out.
    #[must_use]
    pub fn load_moves(&self) -> Vec<(f64, f64)> {
        moves(&self.load, 0.0)
    }
}

fn value_at(events: &[(f64, f64)], time: f64) -> Option<f64> {
    events[..events.partition_point(|&(t, _)| t <= time)].last().map(|&(_, value)| value)
}

fn moves(events: &[(f64, f64)], rest: f64) -> Vec<(f64, f64)> {
    let mut before = rest;
    let mut moves = Vec::new();
    for &(time, value) in events {
        if value != before {
            moves.push((time, value - before));
        }
        before = value;
    }
    moves
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_events_it_is_a_unit_setpoint_step_above_the_level_of_rest() {
        let scenario = Scenario::new(vec![], vec![], Seconds(10.0), 2.5).unwrap();
        assert_eq!(scenario.single_setpoint_move(), Some((0.0, 1.0)));
        assert_eq!(scenario.setpoint_at(5.0), 3.5);
    }

    #[test]
    fn bad_scenarios_name_the_option_and_the_value() {
        let message = |setpoint, load, horizon| {
            Scenario::new(setpoint, load, Seconds(horizon), 0.0).unwrap_err().to_string()
        };
        assert!(message(vec![(0.0, 1.0), (0.0, 2.0)], vec![], 9.0).starts_with("--setpoint has time 0"));
        assert!(message(vec![], vec![(9.0, 1.0)], 9.0).starts_with("--load has an event at 9 s"));
        assert!(message(vec![], vec![(f64::NAN, 1.0)], 9.0).starts_with("--load is NaN"));
        assert!(message(vec![], vec![], 0.0).starts_with("--horizon is 0"));
        assert!(message(vec![(-1.0, 1.0)], vec![], 9.0).starts_with("--setpoint is -1"));
    }

    #[test]
    fn events_that_change_nothing_are_no_moves() {
        let scenario =
            Scenario::new(vec![(0.0, 0.0), (1.0, 2.0)], vec![(2.0, 0.0)], Seconds(9.0), 0.0).unwrap();
        assert_eq!(scenario.single_setpoint_move(), Some((1.0, 2.0)));
    }
}
