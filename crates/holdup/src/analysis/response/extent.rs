//! The least and the greatest controller output of a response.

use crate::model::ClosedLoop;

use super::cell::{Cell, Watch};
use super::error::ResponseError;
use super::layered::Segment;
use super::legendre::{derivative, ends, significant, swing, value};
use super::roots::sign_changes;
use super::scenario::Scenario;
use super::solver::Solver;
use super::system::System;

/// A value and the time at which it is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extreme {
    /// Controller output [input unit], relative to rest.
    pub value: f64,
    /// Time [s].
    pub time: f64,
}

/// The range that the controller output runs through, from 0 at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutputExtent {
    /// The least output.
    pub least: Extreme,
    /// The greatest output.
    pub greatest: Extreme,
    /// Whether there are impulses besides: a setpoint step through an unfiltered derivative.
    pub impulsive: bool,
}

/// The least and the greatest controller output over a scenario, extrema between breakpoints included; `None` where
/// the signals of an unstable loop leave the range of numbers.
///
/// ```
/// use holdup::analysis::response::{Scenario, output_extent};
/// use holdup::model::{ClosedLoop, Process, Seconds, notation::read_controller};
/// let pid = read_controller("Kc=2.95,Ti=15,Td=3,N=100")?;
/// let closed = ClosedLoop::new(&Process::integrating(0.0506, Seconds(6.0))?, &pid);
/// let extent = output_extent(&closed, &Scenario::unit_setpoint_step(Seconds(300.0))?)?.expect("stable");
/// // The kick, Kc·(1 + Td·N), at once.
/// assert!((extent.greatest.value - 2.95 * 301.0).abs() < 1e-9 && extent.greatest.time == 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ResponseError`] as [`simulate`](super::simulate).
pub fn output_extent(
    closed_loop: &ClosedLoop,
    scenario: &Scenario,
) -> Result<Option<OutputExtent>, ResponseError> {
    let system = System::new(closed_loop);
    let mut gatherer = Gatherer::at_rest();
    let outcome = Solver::new(&system).run(scenario, &mut gatherer)?;
    let Gatherer { least, greatest } = gatherer;
    let extent = OutputExtent { least, greatest, impulsive: outcome.impulsive };
    Ok(outcome.overflow_at.is_none().then_some(extent))
}

struct Gatherer {
    least: Extreme,
    greatest: Extreme,
}

impl Gatherer {
    fn at_rest() -> Self {
        let rest = Extreme { value: 0.0, time: 0.0 };
        Self { least: rest, greatest: rest }
    }

    fn take(&mut self, value: f64, time: f64) {
        if value < self.least.value {
            self.least = Extreme { value, time };
        }
        if value > self.greatest.value {
            self.greatest = Extreme { value, time };
        }
    }
}

impl Watch for Gatherer {
    fn cell(&mut self, cell: &Cell<'_>) {
        let u = cell.manipulated;
        let reach = swing(u);
        if u[0] + reach <= self.greatest.value && u[0] - reach >= self.least.value {
            return;
        }
        let time = |s: f64| cell.start + 0.5 * cell.length * (1.0 + s);
        let (start, end) = ends(u);
        self.take(start, time(-1.0));
        self.take(end, time(1.0));
        // Coefficients below a rounding of the range move no extremum.
        let mut smooth = *u;
        smooth[significant(u, 1e-16 * (self.greatest.value - self.least.value))..].fill(0.0);
        let slope = derivative(&smooth);
        if slope[0].abs() < swing(&slope) {
            for &s in sign_changes(&slope, 0.0).as_slice() {
                self.take(value(u, s), time(s));
            }
        }
    }

    /// Never shown: the run is the one of cells, whose extrema are those of one polynomial.
    fn segment(&mut self, _: &Segment<'_>) {}

    fn restart(&mut self) {
        *self = Self::at_rest();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Seconds;
    use crate::model::notation::{read_controller, read_process};

    #[test]
    fn the_output_of_a_proportional_loop_turns_where_its_closed_form_does() {
        // K = d = 1, Kc = 0.5: u = 0.5·e; e = 1, then 1.5 − t/2, then with (t − 2)²/8 more: e(3) = 1/8 falling.
        let closed = ClosedLoop::new(&read_process("K=1,d=1").unwrap(), &read_controller("Kc=0.5").unwrap());
        let to = |horizon| Scenario::unit_setpoint_step(Seconds(horizon)).unwrap();
        let extent = output_extent(&closed, &to(3.0)).unwrap().unwrap();
        assert_eq!(extent.greatest, Extreme { value: 0.5, time: 0.0 });
        assert_eq!(extent.least.value, 0.0);
        // In 3…4, τ = t − 3: e = 1/8 − τ/4 + τ²/8 − τ³/48; e' = 0 where τ² − 4τ + 4 = 0: at τ = 2, beyond. In 4…5 the
        // slope is −e(t − 1)/2, so the extremum is one dead time after the root of that cubic.
        let extent = output_extent(&closed, &to(12.0)).unwrap().unwrap();
        let root = (0..60).fold((0.0, 1.0), |(low, high): (f64, f64), _| {
            let tau = 0.5 * (low + high);
            let e = 1.0 / 8.0 - tau / 4.0 + tau * tau / 8.0 - tau.powi(3) / 48.0;
            if e > 0.0 { (tau, high) } else { (low, tau) }
        });
        // 1e-7: at an extremum the time is known to the square root of the rounding only.
        assert!((extent.least.time - (4.0 + root.0)).abs() < 1e-7, "{extent:?}");
    }

    #[test]
    fn an_unfiltered_derivative_asks_for_impulses_and_an_unstable_loop_for_everything() {
        let process = read_process("K=0.0506,d=6").unwrap();
        let extent = |text: &str| {
            let closed = ClosedLoop::new(&process, &read_controller(text).unwrap());
            output_extent(&closed, &Scenario::unit_setpoint_step(Seconds(60_000.0)).unwrap()).unwrap()
        };
        assert!(extent("Kc=1.5321,Td=1.0343").unwrap().impulsive);
        assert!(!extent("Kc=1.5321,Td=1.0343,c=0").unwrap().impulsive);
        assert_eq!(extent("Kc=60"), None);
    }
}
