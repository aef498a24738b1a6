//! Branch and bound over the frequency, and over the dead time where the family is an ellipse.

use super::faces::Faces;
use super::sector::Sector;
use super::shape::Family;
use crate::analysis::frequency::characteristic::Characteristic;
use crate::analysis::frequency::envelope::{Envelope, Modulus as _};
use crate::analysis::frequency::error::FrequencyError;
use crate::analysis::frequency::margins;
use crate::analysis::frequency::quasi_polynomial::{Jet, QuasiPolynomial};
use crate::model::{ClosedLoop, Controller, Process};

/// How far the proven bound may lie from the worst member found, relative: for a box, whose sector is exact at each
/// frequency, and for an ellipse, where the dead time is searched, too.
const TOLERANCE: f64 = 1e-8;
const TOLERANCE_OF_ELLIPSE: f64 = 1e-4;
/// A distance from −1 below which the family counts as reaching it.
const TOUCHED: f64 = 1e-7;
/// Bands examined before the search is given up.
const WORK: usize = 2_000_000;
/// Rounding of a value, relative to the sum of the moduli of its terms: a Horner scheme, a rotation and a product.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A member of the family.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Member {
    /// Factor on the process gain \[–\].
    pub gain: f64,
    /// Factor on the dead time \[–\].
    pub dead_time: f64,
    /// Frequency \[rad/s\] at which its |S| is that given; `None` where it is the limit at infinite frequency.
    pub frequency: Option<f64>,
    /// |S| there \[–\]: its own sensitivity peak is that or more.
    pub sensitivity: f64,
}

/// What is known of a family.
#[derive(Debug, Clone, PartialEq)]
pub struct WorstCase {
    /// Whether every member is proven stable; a search for [`Goal::AtMost`] that met a member above the peak proves nothing.
    pub stable: bool,
    /// A sensitivity peak that no member exceeds, proven \[–\]; `None` where not all are proven stable.
    pub sensitivity_peak: Option<f64>,
    /// The worst member found; of an unstable family one with a pole on or next to the imaginary axis, `None` where the
    /// member in the middle is already unstable.
    pub worst: Option<Member>,
    /// Bands of frequency that were examined.
    pub bands: usize,
    /// The search was given up: nothing is proven.
    pub given_up: bool,
}

/// What the search is for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Goal {
    /// The worst case, its bound within 1e-8 of a member that has it (1e-4 for an ellipse).
    Worst,
    /// Whether no member exceeds this sensitivity peak; the search ends at the first that does.
    AtMost(f64),
}

/// The worst sensitivity peak of a family, proven.
///
/// An observer without a model of its own keeps the model of `process`, the nominal one.
///
/// ```
/// use holdup::analysis::frequency::family::{Family, Goal, worst_case};
/// use holdup::model::{Controller, Process, Seconds};
/// let process = Process::integrating(0.0506, Seconds(6.0))?;
/// let simc = Controller::proportional(1.647)?.with_integral_time(Seconds(48.0))?;
/// let found = worst_case(&process, &simc, &Family::ranges([0.8, 1.2], [0.8, 1.2])?, Goal::Worst)?;
/// // The worst corner has 1.44 times the gain times dead time of the nominal loop, whose peak is 1.70.
/// assert!(found.stable && found.sensitivity_peak.is_some_and(|peak| peak > 2.0 && peak < 3.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FrequencyError`] if the numbers of the loop are out of the reach of double precision.
pub fn worst_case(
    process: &Process,
    controller: &Controller,
    family: &Family,
    goal: Goal,
) -> Result<WorstCase, FrequencyError> {
    let fixed = |_| FrequencyError::OutOfReach { quantity: "the process gain or dead time", value: f64::NAN };
    let controller = controller.with_model_of(process).map_err(fixed)?;
    let [gain, dead_time] = family.middle();
    let middle = process.perturbed(gain, dead_time).map_err(fixed)?;
    let stable = margins(&ClosedLoop::new(&middle, &controller))?.stable;
    let characteristic = Characteristic::new(&ClosedLoop::new(process, &controller))?;
    let greatest = family.gain()[1];
    let limit = greatest * characteristic.high_frequency_gain;
    let unproven =
        WorstCase { stable: false, sensitivity_peak: None, worst: None, bands: 0, given_up: false };
    if !stable {
        return Ok(unproven);
    }
    if limit >= 1.0 {
        let worst = Member { gain: greatest, dead_time, frequency: None, sensitivity: f64::INFINITY };
        return Ok(WorstCase { worst: Some(worst), ..unproven });
    }
    let limit = Member { gain: greatest, dead_time, frequency: None, sensitivity: 1.0 / (1.0 - limit) };
    Ok(Search::new(&characteristic, family, goal, limit).run())
}

struct Search<'a> {
    /// N without the rotation of its shortest delay.
    numerator: QuasiPolynomial,
    denominator: &'a QuasiPolynomial,
    shortest_delay: f64,
    envelope: Envelope,
    unit_of_time: f64,
    family: &'a Family,
    goal: Goal,
    /// Least distance from −1 found.
    least: f64,
    worst: Member,
    bands: usize,
}

/// A band of frequencies and a range of dead-time factors.
#[derive(Debug, Clone, Copy)]
struct Band {
    from: f64,
    to: f64,
    dead_time: [f64; 2],
}

/// What to do with a band.
enum Fate {
    Discarded,
    SplitFrequency,
    SplitDeadTime,
}

impl<'a> Search<'a> {
    fn new(characteristic: &'a Characteristic, family: &'a Family, goal: Goal, limit: Member) -> Self {
        let shortest_delay = characteristic.numerator.shortest_delay();
        Self {
            numerator: characteristic.numerator.advanced(shortest_delay),
            denominator: &characteristic.denominator,
            shortest_delay,
            envelope: Envelope::new(characteristic),
            unit_of_time: characteristic.dead_time,
            family,
            goal,
            least: 1.0 / limit.sensitivity,
            worst: limit,
            bands: 0,
        }
    }

    /// The distance that a band must be proven to keep.
    fn wanted(&self) -> f64 {
        match self.goal {
            Goal::Worst if self.family.is_box() => self.least * (1.0 - TOLERANCE),
            Goal::Worst => self.least * (1.0 - TOLERANCE_OF_ELLIPSE),
            Goal::AtMost(peak) => 1.0 / peak,
        }
    }

    /// Whether the answer is there before the search is complete.
    fn decided(&self) -> bool {
        self.least < TOUCHED || matches!(self.goal, Goal::AtMost(peak) if self.least * peak < 1.0)
    }

    fn run(mut self) -> WorstCase {
        let (mut from, mut to) = (0.0, 1.0);
        let mut stack = Vec::new();
        while !self.decided() && !self.below(self.wanted(), from, f64::INFINITY) {
            stack.push(Band { from, to, dead_time: self.family.dead_time() });
            while let Some(band) = stack.pop() {
                self.bands += 1;
                if self.bands > WORK {
                    return self.answer(true);
                }
                match self.examine(&band) {
                    _ if self.decided() => break,
                    Fate::Discarded => {}
                    Fate::SplitFrequency => {
                        let middle = f64::midpoint(band.from, band.to);
                        stack.push(Band { from: middle, ..band });
                        stack.push(Band { to: middle, ..band });
                    }
                    Fate::SplitDeadTime => {
                        let [low, high] = band.dead_time;
                        let middle = f64::midpoint(low, high);
                        stack.push(Band { dead_time: [middle, high], ..band });
                        stack.push(Band { dead_time: [low, middle], ..band });
                    }
                }
            }
            from = to;
            to *= 2.0;
        }
        self.answer(false)
    }

    /// Whether the greatest gain keeps `|1 + L| ≥ distance` on the band by its modulus alone.
    fn below(&self, distance: f64, from: f64, to: f64) -> bool {
        from > 0.0 && self.envelope.gain_is_below((1.0 - distance) / self.family.gain()[1], from, to)
    }

    /// Looks at the middle of a band, and proves it or says how to go on.
    fn examine(&mut self, band: &Band) -> Fate {
        let (omega, half) = (f64::midpoint(band.from, band.to), 0.5 * (band.to - band.from));
        let (n, d) = (self.numerator.on_axis(omega), self.denominator.on_axis(omega));
        let [low, high] = band.dead_time;
        let gain = self.family.gain_over(low, high);
        let (n_size, d_size) = (n[0].norm(), d[0].norm());
        // The delay of the family counts from the shortest delay of N, which holds the nominal dead time.
        let shortest_delay = self.shortest_delay;
        let delay = |factor: f64| factor - 1.0 + shortest_delay;
        let own = n[0].arg() - d[0].arg();
        let sector = Sector {
            radius: gain.map(|k| k * n_size / d_size),
            angle: [own - omega * delay(high), own - omega * delay(low)],
        };
        let nearest = sector.nearest();
        let at_middle = if d_size > 0.0 { d_size * nearest.distance } else { gain[0] * n_size };
        if d_size > 0.0 && omega > 0.0 {
            let dead_time = ((own - nearest.angle) / omega - self.shortest_delay + 1.0).clamp(low, high);
            let [least, greatest] = self.family.gain_over(dead_time, dead_time);
            let k = (nearest.radius * d_size / n_size).max(least).min(greatest);
            self.consider(k, dead_time, omega, k * n_size / d_size, own - omega * delay(dead_time));
        }
        let wanted = self.wanted();
        if gain[1] * n_size < (1.0 - wanted) * d_size && self.below(wanted, band.from, band.to) {
            return Fate::Discarded;
        }
        let (n_bound, d_bound) = (self.numerator.magnitudes(band.to), self.denominator.magnitudes(band.to));
        let drift = |jet: &Jet, third: f64| {
            half * (jet[1].norm() + half * (0.5 * jet[2].norm() + half * third / 6.0))
        };
        let (n_drift, d_drift) = (drift(&n, n_bound[3]), drift(&d, d_bound[3]));
        let rounding = ROUNDING * (d_bound[0] + gain[1] * n_bound[0]);
        let spare = at_middle - wanted * (d_size + rounding) - rounding;
        let moved = (1.0 + wanted) * d_drift + gain[1] * (n_drift + half * delay(high).abs() * n_size);
        if spare >= moved {
            return Fate::Discarded;
        }
        // Next to the worst frequency the distance is flat: to second order the band may be wider. The members between
        // the two dead times are farther away than one of these as long as none points at −1.
        let faces = Faces {
            omega,
            half,
            numerator: &n,
            denominator: &d,
            numerator_bounds: &n_bound,
            denominator_bounds: &d_bound,
        };
        let towards = nearest.towards;
        if spare > 0.0 && faces.keep(gain, [delay(low), delay(high)], wanted, towards) {
            return Fate::Discarded;
        }
        // An ellipse is split where the box about its part, and not the width of the band, is what spoils the proof.
        let middle = f64::midpoint(low, high);
        let own_gain = self.family.gain_over(middle, middle);
        let too_wide = (own_gain[0] - gain[0]).max(gain[1] - own_gain[1]) + omega * (high - low) * gain[1];
        if !self.family.is_box() && too_wide * n_size > moved {
            Fate::SplitDeadTime
        } else {
            Fate::SplitFrequency
        }
    }

    /// Keeps a member where it is the worst so far.
    fn consider(&mut self, gain: f64, dead_time: f64, omega: f64, radius: f64, angle: f64) {
        let distance = num_complex::Complex::new(1.0 + radius * angle.cos(), radius * angle.sin()).norm();
        if distance < self.least {
            self.least = distance;
            let frequency = Some(omega / self.unit_of_time);
            self.worst = Member { gain, dead_time, frequency, sensitivity: 1.0 / distance };
        }
    }

    fn answer(&self, given_up: bool) -> WorstCase {
        let stable = !given_up && self.least >= TOUCHED;
        let proven = match self.goal {
            Goal::Worst => Some(1.0 / self.wanted()),
            Goal::AtMost(peak) => (self.least * peak >= 1.0).then_some(peak),
        };
        WorstCase {
            // A search that ended early proves nothing of the frequencies it has not seen.
            stable: stable && proven.is_some(),
            sensitivity_peak: proven.filter(|_| stable),
            worst: Some(self.worst),
            bands: self.bands,
            given_up,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Observer, Seconds};

    fn family(gain: [f64; 2], dead_time: [f64; 2]) -> Family {
        Family::ranges(gain, dead_time).unwrap()
    }

    fn loops() -> Vec<(Process, Controller)> {
        let process = Process::integrating(0.0506, Seconds(6.0)).unwrap();
        let p = Controller::proportional(1.5321).unwrap();
        let pi = Controller::proportional(1.2).unwrap().with_integral_time(Seconds(60.0)).unwrap();
        let pd = p.with_derivative_time(Seconds(1.0343)).unwrap();
        let pid = Controller::proportional(2.0).unwrap().with_integral_time(Seconds(30.0)).unwrap();
        let pid = pid.with_derivative_time(Seconds(2.0)).unwrap();
        let observed = Controller::proportional(1.0).unwrap().with_derivative_time(Seconds(1.0)).unwrap();
        let observed =
            observed.with_filter_bandwidth(3.0).unwrap().with_observer(Observer::new(0.7).unwrap());
        let lagged = process.with_lag(Seconds(4.0)).unwrap();
        vec![
            (process, p),
            (process, pi),
            (process, pd),
            (process, pid),
            (process, pid.with_filter_bandwidth(10.0).unwrap()),
            (process, observed),
            (lagged, pi),
        ]
    }

    #[test]
    fn a_family_of_one_has_its_own_peak() {
        for (process, controller) in loops() {
            let peak = margins(&ClosedLoop::new(&process, &controller)).unwrap().sensitivity_peak.unwrap();
            let found = worst_case(&process, &controller, &family([1.0; 2], [1.0; 2]), Goal::Worst).unwrap();
            // The bound lies above a member by 1e-8 at most.
            let bound = found.sensitivity_peak.unwrap();
            assert!(
                bound >= peak * (1.0 - 1e-12) && bound <= peak * (1.0 + 2e-8),
                "{controller:?} {bound} {peak}"
            );
        }
    }

    #[test]
    fn no_member_exceeds_the_bound_and_one_has_it() {
        for (process, controller) in loops() {
            let uncertain = family([0.7, 1.15], [0.85, 1.2]);
            let found = worst_case(&process, &controller, &uncertain, Goal::Worst).unwrap();
            let bound = found.sensitivity_peak.unwrap();
            let fixed = controller.with_model_of(&process).unwrap();
            let peak = |gain: f64, dead_time: f64| {
                let member = process.perturbed(gain, dead_time).unwrap();
                margins(&ClosedLoop::new(&member, &fixed)).unwrap().sensitivity_peak.unwrap()
            };
            let mut greatest = 0.0_f64;
            for i in 0..=6 {
                for k in 0..=6 {
                    let part = |low: f64, high: f64, n: i32| low + (high - low) * f64::from(n) / 6.0;
                    greatest = greatest.max(peak(part(0.7, 1.15, i), part(0.85, 1.2, k)));
                }
            }
            assert!(greatest <= bound, "{controller:?}: {greatest} {bound}");
            let worst = found.worst.unwrap();
            // Its own peak, recomputed: the search polishes to 1e-8.
            assert!(peak(worst.gain, worst.dead_time) >= bound * (1.0 - 2e-8), "{worst:?} {bound}");
        }
    }

    #[test]
    fn proportional_control_has_the_worst_case_of_its_corner() {
        // K·Kc·d is all that counts: the corner with the greatest product is the worst.
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let p = Controller::proportional(0.5).unwrap();
        let found = worst_case(&process, &p, &family([0.8, 1.2], [0.7, 1.25]), Goal::Worst).unwrap();
        let corner = ClosedLoop::new(&process.perturbed(1.2, 1.25).unwrap(), &p);
        let peak = margins(&corner).unwrap().sensitivity_peak.unwrap();
        assert!((found.sensitivity_peak.unwrap() / peak - 1.0).abs() < 2e-8);
    }

    #[test]
    fn the_verdict_flips_at_the_limit_of_stability() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let p = Controller::proportional(0.5).unwrap();
        let limit = std::f64::consts::PI; // K·Kc·d = π/2
        for (factor, stable) in [(0.999, true), (1.0001, false)] {
            let uncertain = family([0.5, limit * factor], [1.0, 1.0]);
            let found = worst_case(&process, &p, &uncertain, Goal::Worst).unwrap();
            assert_eq!(found.stable, stable, "{found:?}");
        }
        // A neutral loop: K·Kc·Td reaches 1 at 1/0.4 of the gain.
        let pd = p.with_derivative_time(Seconds(0.8)).unwrap();
        let found = worst_case(&process, &pd, &family([1.0, 2.5], [1.0, 1.0]), Goal::Worst).unwrap();
        assert!(!found.stable && found.worst.unwrap().frequency.is_none());
    }

    #[test]
    fn the_least_gain_of_a_slow_pi_controller_is_the_worst() {
        // With Ti = 4 d a small gain oscillates slowly.
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let pi = Controller::proportional(0.35).unwrap().with_integral_time(Seconds(4.0)).unwrap();
        let uncertain = family([0.2, 1.0], [1.0, 1.0]);
        let found = worst_case(&process, &pi, &uncertain, Goal::Worst).unwrap();
        assert!((found.worst.unwrap().gain - 0.2).abs() < 1e-9);
    }

    #[test]
    fn an_ellipse_lies_between_the_boxes_inside_and_about_it() {
        for (process, controller) in loops() {
            let ellipse = Family::ellipse(0.2, 0.15, 0.5).unwrap();
            let peak = |family: &Family| {
                worst_case(&process, &controller, family, Goal::Worst).unwrap().sensitivity_peak.unwrap()
            };
            let outside = family([0.8, 1.2], [0.85, 1.15]);
            // The bound of an ellipse lies within 1e-4 above its worst member.
            assert!(peak(&ellipse) <= peak(&outside) * 1.0002);
            // At the nominal dead time the ellipse reaches √(1 − ρ²) = 0.87 of its half axis.
            let inside = family([0.83, 1.17], [1.0, 1.0]);
            assert!(peak(&ellipse) >= peak(&inside) * (1.0 - 1e-7));
        }
    }

    #[test]
    fn at_most_answers_as_the_worst_case_does() {
        for (process, controller) in loops() {
            let uncertain = family([0.8, 1.2], [0.8, 1.2]);
            let worst = worst_case(&process, &controller, &uncertain, Goal::Worst).unwrap();
            let peak = worst.sensitivity_peak.unwrap();
            let at_most =
                |limit: f64| worst_case(&process, &controller, &uncertain, Goal::AtMost(limit)).unwrap();
            assert!(at_most(peak * 1.0001).stable);
            assert!(!at_most(peak * 0.9999).stable);
        }
    }
}
