//! What the solver shows of each cell, to those who measure or draw.

use super::layered::Segment;
use super::legendre::Poly;

/// What happens in one cell, in units of the process: polynomials in s from −1 to 1 over the cell.
pub(super) struct Cell<'a> {
    /// Start [s].
    pub(super) start: f64,
    /// Length [s].
    pub(super) length: f64,
    /// Setpoint, relative to the initial level.
    pub(super) setpoint: f64,
    /// Control error.
    pub(super) error: &'a Poly,
    /// Controller output.
    pub(super) manipulated: &'a Poly,
    /// Load estimate of the observer.
    pub(super) load_estimate: Option<&'a Poly>,
}

/// Receives the response as it is computed.
pub(super) trait Watch {
    /// The next cell, in order.
    fn cell(&mut self, cell: &Cell<'_>);

    /// The next segment, in order, from the fast way.
    fn segment(&mut self, segment: &Segment<'_>);

    /// Forgets everything it was shown: the run starts again.
    fn restart(&mut self);
}

/// How a run ended.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outcome {
    /// When the signals left the range of numbers [s].
    pub(super) overflow_at: Option<f64>,
    /// Whether the controller output contained an impulse.
    pub(super) impulsive: bool,
}
