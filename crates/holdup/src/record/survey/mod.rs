//! Looking first: what a record shows before any model is fitted, and the part of it to use.

mod compression;
mod events;
mod noise;
mod oscillation;
mod quantisation;
mod sampling;
mod signal;
mod spectrum;
mod statistics;
mod text;
mod window;

use serde::Serialize;

pub use compression::{Compression, CompressionKind};
pub use events::{Move, OperationShares, Switch};
pub use noise::Noise;
pub use oscillation::{Oscillation, Shape};
pub use quantisation::Quantisation;
pub use sampling::{Gap, Sampling};
pub use signal::{Limit, Signal, Span};
pub use window::Window;

use super::Record;

/// The smallest step of a signal; 0 where there is none.
pub(super) fn quantum(values: &[f64]) -> f64 {
    quantisation::quantisation(values).map_or(0.0, |found| found.quantum)
}

/// The summary of a record: the signals one by one, what happened, and the window to use.
///
/// ```
/// use holdup::record::{Record, Survey};
///
/// let time: Vec<f64> = (0..200).map(|k| f64::from(k) * 10.0).collect();
/// let level = time.iter().map(|t| 50.0 + (t * 0.02).sin()).collect();
/// let valve = time.iter().map(|t| if *t < 900.0 { 20.0 } else { 25.0 }).collect();
/// let survey = Survey::of(&Record::new(time, level, valve)?);
/// assert_eq!(survey.sampling.period_s, 10.0);
/// assert_eq!(survey.output_steps[0].to, 25.0);
/// assert_eq!((survey.window.from, survey.window.to), (0, 200));
/// # Ok::<(), holdup::record::RecordError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Survey {
    /// Number of rows.
    pub rows: usize,
    /// Time from the first row to the last [s].
    pub duration_s: f64,
    /// The sample period and its irregularities.
    pub sampling: Sampling,
    /// The controlled variable.
    pub controlled_variable: Signal,
    /// The manipulated variable.
    pub manipulated_variable: Signal,
    /// The setpoint, where the record has it.
    pub setpoint: Option<Signal>,
    /// How long the controller moved the actuator, and when that changed; none where the record does not say.
    pub operation: Option<OperationShares>,
    /// Moves of the setpoint; rows that follow each other make one move.
    pub setpoint_moves: Vec<Move>,
    /// Whether the setpoint moves all the time, as that of a cascade or a ramp does.
    pub setpoint_follows: bool,
    /// Steps of the manipulated variable that stand out from its other movement.
    pub output_steps: Vec<Move>,
    /// The window to use.
    pub window: Window,
}

impl Survey {
    /// Looks at a record.
    #[must_use]
    pub fn of(record: &Record) -> Self {
        let sampling = Sampling::of(record.time());
        let signal = |values: &[f64], measured| Signal::of(record.time(), values, &sampling, measured);
        let controlled_variable =
            signal(record.controlled_variable(), true).without_rest(record.manipulated_variable());
        let manipulated_variable = signal(record.manipulated_variable(), false);
        let setpoint = record.setpoint().map(|values| signal(values, false));
        let (setpoint_moves, setpoint_follows) = record
            .setpoint()
            .map_or((Vec::new(), false), |values| events::setpoint_moves(record.time(), values));
        let output_steps = events::output_steps(record.time(), record.manipulated_variable());
        let operation = record.operation().map(|operation| OperationShares::of(record.time(), operation));
        let mut survey = Self {
            rows: record.len(),
            duration_s: record.time().last().copied().unwrap_or(0.0) - record.time()[0],
            sampling,
            controlled_variable,
            manipulated_variable,
            setpoint,
            operation,
            setpoint_moves,
            setpoint_follows,
            output_steps,
            window: Window { from: 0, to: record.len(), from_s: 0.0, to_s: 0.0, reason: String::new() },
        };
        survey.window = window::proposed(record, &survey);
        survey
    }
}
