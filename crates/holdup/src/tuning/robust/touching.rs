//! Where a growing box of processes first touches a sensitivity peak: found, not proven.
//!
//! At one frequency the box is a sector of an annulus that grows with its size, so that there is one size at which it comes
//! as near to −1 as the peak allows. The size of the box is the least of those over all frequencies: a row of frequencies
//! shows where the minima are, and each is then found to rounding. What lies between two frequencies of the row may be
//! missed; that is why [`largest_family`](super::largest_family) proves what is reported.

use std::f64::consts::TAU;

use num_complex::Complex;

use crate::analysis::frequency::family::{Family, Sector};
use crate::analysis::frequency::{FrequencyError, LoopTransfer};
use crate::model::{ClosedLoop, Controller, Process};
use crate::tuning::line::{boundary, least};

/// Ratio of neighbours in the row of frequencies, and the angle \[rad\] by which the dead time may turn L between them.
const RATIO: f64 = 1.1;
const TURN: f64 = 0.2;
/// After so many turns of L its modulus alone counts, as if it pointed at −1 at every frequency.
const TURNS: f64 = 12.0;
/// Least and greatest frequency of the row, in 1/dead time; at the greatest an unfiltered derivative has reached its limit.
const LOWEST: f64 = 1e-9;
const HIGHEST: f64 = 1e8;
/// The row ends where every |L| of the box is greater or less than those that come as near to −1, by this factor.
const CLEAR: f64 = 2.0;
/// A minimum of the distance that lies this much above the one that is kept, relative, is looked at closely.
const NEAR: f64 = 0.2;
/// How closely a minimum over the frequency is found, relative: its value misses the square of that.
const WIDTH: f64 = 1e-6;
/// How closely the size at one frequency is found, relative, and the distance.
const FINEST: f64 = 1e-13;
const SPARE: f64 = 1e-15;
/// The sizes about the least one of the row among which that at a minimum is looked for.
const ABOUT: f64 = 1.2;

/// The greatest size at which a box seems to keep a sensitivity peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Touching {
    /// The size; where not even the nominal loop keeps the peak, negative: by how much its distance from −1 falls short,
    /// relative.
    pub(crate) size: f64,
    /// The frequency at which the box touches \[rad/s\]; `None` where it is as large as was asked for.
    pub(crate) omega: Option<f64>,
}

/// Boxes of a shape about a process, and the sensitivity peak that they are to keep.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Boxes<'a> {
    process: &'a Process,
    gain: [f64; 2],
    dead_time: [f64; 2],
    sensitivity_peak: f64,
}

impl<'a> Boxes<'a> {
    /// `None` for an ellipse and for a shape without the nominal process.
    pub(crate) fn new(process: &'a Process, shape: &Family, sensitivity_peak: f64) -> Option<Self> {
        let (gain, dead_time) = (shape.gain(), shape.dead_time());
        let nominal = |[low, high]: [f64; 2]| low <= 1.0 && 1.0 <= high;
        let nested = shape.is_box() && nominal(gain) && nominal(dead_time);
        nested.then_some(Self { process, gain, dead_time, sensitivity_peak })
    }

    /// The greatest size, up to `most`, for a controller that stabilises the nominal process.
    pub(crate) fn touching(&self, controller: &Controller, most: f64) -> Result<Touching, FrequencyError> {
        Ok(self.growing(controller)?.touching(most))
    }

    /// The size that touches at one frequency \[rad/s\], next to another size.
    pub(crate) fn touching_at(
        &self,
        controller: &Controller,
        known: &Touching,
    ) -> Result<f64, FrequencyError> {
        let growing = self.growing(controller)?;
        Ok(known
            .omega
            .map_or(known.size, |omega| growing.about(&growing.at(omega * growing.unit), known.size)))
    }

    fn growing(&self, controller: &Controller) -> Result<Growing, FrequencyError> {
        let fixed =
            |_| FrequencyError::OutOfReach { quantity: "the process gain or dead time", value: f64::NAN };
        let controller = controller.with_model_of(self.process).map_err(fixed)?;
        Ok(Growing {
            transfer: LoopTransfer::new(&ClosedLoop::new(self.process, &controller))?,
            gain: self.gain,
            dead_time: self.dead_time,
            unit: self.process.dead_time(),
            wanted: self.sensitivity_peak.recip(),
        })
    }
}

/// L at one frequency.
#[derive(Clone, Copy)]
struct Place {
    /// In 1/dead time.
    omega: f64,
    value: Complex<f64>,
    modulus: f64,
}

struct Growing {
    transfer: LoopTransfer,
    gain: [f64; 2],
    dead_time: [f64; 2],
    /// The nominal dead time \[s\].
    unit: f64,
    /// The distance from −1 that is to be kept.
    wanted: f64,
}

impl Growing {
    fn touching(&self, most: f64) -> Touching {
        let (row, mut least_met) = self.row(most);
        let size = least_met.0.max(0.0);
        let slacks: Vec<f64> = row.iter().map(|place| self.slack(place, size)).collect();
        let of = |index: usize| slacks.get(index).copied().unwrap_or(f64::INFINITY);
        for index in 0..row.len() {
            let (before, here, after) = (of(index.wrapping_sub(1)), of(index), of(index + 1));
            if here > NEAR || here > before || here > after {
                continue;
            }
            let (low, high) = (index.saturating_sub(1), (index + 1).min(row.len() - 1));
            let size = least_met.0;
            least(row[low].omega, row[high].omega, WIDTH, &mut |omega| {
                let touching = self.about(&self.at(omega), size);
                if touching < least_met.0 {
                    least_met = (touching, Some(omega));
                }
                touching
            });
        }
        Touching { size: least_met.0, omega: least_met.1.map(|omega| omega / self.unit) }
    }

    /// The frequencies, rising, and the least of the sizes that touch at them.
    fn row(&self, most: f64) -> (Vec<Place>, (f64, Option<f64>)) {
        let mut least_met = (most, None);
        let mut look = |omega: f64| {
            let place = self.at(omega);
            let touching = self.below(&place, least_met.0);
            if touching < least_met.0 {
                least_met = (touching, Some(omega));
            }
            (place, least_met.0)
        };
        let (mut row, mut size) = (Vec::with_capacity(256), look(HIGHEST).1);
        let mut omega = 1.0;
        while omega > LOWEST {
            let (place, met) = look(omega);
            row.push(place);
            size = met;
            if factors(self.gain, size)[0] * place.modulus > CLEAR * (1.0 + self.wanted) {
                break;
            }
            omega /= RATIO;
        }
        row.reverse();
        omega = 1.0;
        while omega < HIGHEST {
            let step = (RATIO - 1.0) * omega;
            let turning = TURN / factors(self.dead_time, size)[1];
            omega += if omega < TURNS * TAU { step.min(turning) } else { step };
            let (place, met) = look(omega);
            row.push(place);
            size = met;
            if CLEAR * factors(self.gain, size)[1] * place.modulus < 1.0 - self.wanted {
                break;
            }
        }
        (row, least_met)
    }

    fn at(&self, omega: f64) -> Place {
        let value = self.transfer.at(omega / self.unit);
        Place { omega, value, modulus: value.norm_sqr().sqrt() }
    }

    /// By how much the box of this size keeps the distance at a frequency, relative; where that is much, a lower bound.
    fn slack(&self, place: &Place, size: f64) -> f64 {
        let radius = factors(self.gain, size).map(|factor| factor.max(0.0) * place.modulus);
        let gap = (1.0 - radius[1]).max(radius[0] - 1.0) / self.wanted - 1.0;
        if gap > NEAR {
            return gap;
        }
        let angle = if place.omega < TURNS * TAU {
            let own = place.value.arg();
            let [shorter, longer] = factors(self.dead_time, size).map(|factor| place.omega * (factor - 1.0));
            [own - longer, own - shorter]
        } else {
            [0.0, TAU]
        };
        Sector { radius, angle }.nearest().distance / self.wanted - 1.0
    }

    /// The size that touches at a frequency, if it is less than this one; negative where even size 0 is too near.
    fn below(&self, place: &Place, size: f64) -> f64 {
        if size <= 0.0 {
            return self.slack(place, 0.0);
        }
        let beyond = self.slack(place, size);
        if beyond >= 0.0 { f64::INFINITY } else { self.between(place, 0.0, (size, beyond)) }
    }

    /// The size that touches at a frequency, looked for about this one; where it is much larger, what leads there.
    fn about(&self, place: &Place, size: f64) -> f64 {
        if size <= 0.0 {
            return self.slack(place, 0.0);
        }
        let beyond = size * ABOUT;
        let slack = self.slack(place, beyond);
        if slack >= 0.0 { beyond * (1.0 + slack) } else { self.between(place, size / ABOUT, (beyond, slack)) }
    }

    fn between(&self, place: &Place, low: f64, outside: (f64, f64)) -> f64 {
        let inside = self.slack(place, low);
        if inside > 0.0 {
            boundary((low, inside), outside, (FINEST, SPARE), &mut |size| self.slack(place, size))
        } else if low > 0.0 {
            self.between(place, 0.0, (low, inside))
        } else {
            inside
        }
    }
}

/// The range of factors of a box of this size.
fn factors(range: [f64; 2], size: f64) -> [f64; 2] {
    range.map(|factor| 1.0 + size * (factor - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::frequency::family::{Goal, worst_case};
    use crate::analysis::frequency::margins;
    use crate::model::{Observer, Seconds};

    fn loops() -> Vec<(Process, Controller)> {
        let process = Process::integrating(0.0506, Seconds(6.0)).unwrap();
        let p = Controller::proportional(1.2).unwrap();
        let pi = p.with_integral_time(Seconds(60.0)).unwrap();
        let pd = p.with_derivative_time(Seconds(1.0343)).unwrap();
        let pid = pi.with_derivative_time(Seconds(2.0)).unwrap();
        let observed = pd.with_filter_bandwidth(3.0).unwrap().with_observer(Observer::new(0.3).unwrap());
        let lagged = process.with_lag(Seconds(4.0)).unwrap();
        let filtered = pid.with_filter_bandwidth(10.0).unwrap();
        let own = [p, pi, pd, pid, filtered, observed].map(|controller| (process, controller));
        own.into_iter().chain([(lagged, pi), (lagged, pid)]).collect()
    }

    fn touching(process: &Process, controller: &Controller, shape: &Family, peak: f64) -> f64 {
        Boxes::new(process, shape, peak).unwrap().touching(controller, 100.0).unwrap().size
    }

    #[test]
    fn the_worst_case_of_a_box_of_that_size_has_the_peak() {
        let mut compared = 0;
        let shapes = [([0.8, 1.2], [0.8, 1.2]), ([0.9, 1.3], [1.0, 1.0]), ([1.0, 1.0], [0.6, 1.4])];
        for (process, controller) in loops() {
            for (gain, dead_time) in shapes {
                let shape = Family::ranges(gain, dead_time).unwrap();
                for peak in [1.9, 2.5] {
                    let size = touching(&process, &controller, &shape, peak);
                    assert!(size > 0.0, "{controller:?}");
                    // From there on a factor is not positive.
                    let least = gain[0].min(dead_time[0]);
                    if size * (1.0 - least) >= 1.0 {
                        continue;
                    }
                    compared += 1;
                    let family = shape.scaled(size).unwrap();
                    let worst = worst_case(&process, &controller, &family, Goal::Worst).unwrap();
                    let bound = worst.sensitivity_peak.unwrap();
                    // The bound lies at most 1e-8 above a member.
                    assert!((bound / peak - 1.0).abs() < 2e-8, "{controller:?} {shape:?} {peak}: {bound}");
                }
            }
        }
        assert!(compared > 30, "{compared}");
    }

    #[test]
    fn proportional_control_touches_with_its_corner() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let p = Controller::proportional(0.25).unwrap();
        let size = touching(&process, &p, &Family::ranges([0.8, 1.2], [0.8, 1.2]).unwrap(), 1.8);
        let corner = process.perturbed(1.0 + 0.2 * size, 1.0 + 0.2 * size).unwrap();
        let peak = margins(&ClosedLoop::new(&corner, &p)).unwrap().sensitivity_peak.unwrap();
        // Rounding: the peak is flat in the frequency.
        assert!((peak / 1.8 - 1.0).abs() < 1e-11, "{peak}");
    }

    #[test]
    fn a_nominal_loop_above_the_peak_has_a_negative_size_and_a_neutral_one_ends_at_infinite_frequency() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let p = Controller::proportional(0.9).unwrap();
        let shape = Family::ranges([0.9, 1.1], [0.9, 1.1]).unwrap();
        let own = margins(&ClosedLoop::new(&process, &p)).unwrap().sensitivity_peak.unwrap();
        // It falls short by as much as its own peak is too high.
        assert!((touching(&process, &p, &shape, 1.5) + 1.0 - 1.5 / own).abs() < 1e-11);
        // K·Kc·Td = 0.49, and |1 + L| = 1 − 0.49·k: no frequency touches before the greatest k has 1/2.
        let pd = Controller::proportional(0.35).unwrap().with_derivative_time(Seconds(1.4)).unwrap();
        let shape = Family::ranges([1.0, 1.1], [1.0, 1.0]).unwrap();
        let size = touching(&process, &pd, &shape, 2.0);
        assert!(size <= 10.0 * (0.5 / 0.49 - 1.0) * (1.0 + 1e-12), "{size}");
    }

    #[test]
    fn an_ellipse_has_no_sector() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let ellipse = Family::ellipse(0.2, 0.2, 0.5).unwrap();
        assert!(Boxes::new(&process, &ellipse, 2.0).is_none());
        let elsewhere = Family::ranges([1.1, 1.2], [0.9, 1.1]).unwrap();
        assert!(Boxes::new(&process, &elsewhere, 2.0).is_none());
    }
}
