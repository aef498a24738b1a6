//! The margins of one sampled loop.

use std::f64::consts::{PI, TAU};

use holdup_control::Law;
use num_complex::Complex;

use super::circle::Circle;
use super::delay;
use super::pulse::Pulse;
use super::winding;
use crate::analysis::frequency::functions::Curve;
use crate::analysis::frequency::scan::{Findings, LISTED, Scan};
use crate::analysis::frequency::winding::Uncounted;
use crate::analysis::frequency::{FrequencyError, Margins};
use crate::model::{Process, Radians, Seconds};

/// What a sampled loop achieves. Frequencies are those of the continuous world [rad/s], up to π/h.
#[derive(Debug, Clone, PartialEq)]
pub struct SampledMargins {
    /// Sample period h [s].
    pub sample_period: Seconds,
    /// The margins, as of a continuous loop; `high_frequency_gain` is |L| at π/h, and a crossing may lie there.
    pub margins: Margins,
    /// Gain from the measurement to the output of the law at π/h [input unit / output unit]: what is left of the
    /// fastest noise that samples show.
    pub noise_gain: f64,
}

/// The margins of this law on this process, sampled every `sample_period` [s], its output late by `delay` [s].
///
/// Limits do not count: the margins are those of small signals.
///
/// ```
/// use holdup::analysis::frequency::sampled::sampled_margins;
/// use holdup::model::{Process, Seconds, notation::read_controller, sampled_law};
/// let level = Process::integrating(0.5, Seconds(2.0))?;
/// let law = sampled_law(&level, &read_controller("Kc=0.2")?, Seconds(2.0))?;
/// let found = sampled_margins(&law, &level, Seconds(2.0), Seconds(0.0))?;
/// // One sample of dead time: z² − z + K·Kc·h has its roots on the unit circle at K·Kc·h = 1, here 0.2.
/// assert!((found.margins.gain_margin.unwrap() - 5.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FrequencyError`] if the numbers of the loop are out of the reach of double precision, or if the dead time has more than
/// 50 000 samples (2000 of a law that predicts). An unstable loop is not an error.
pub fn sampled_margins(
    law: &Law<f64>,
    process: &Process,
    sample_period: Seconds,
    delay: Seconds,
) -> Result<SampledMargins, FrequencyError> {
    let h = sample_period.0;
    let longest =
        law.observer.map_or(0.0, |observer| observer.dead_time()).max(process.dead_time() + delay.0);
    // A law that predicts has a term for each of them.
    let most = if law.observer.is_some_and(|observer| observer.predicts()) { 2_000 } else { 50_000 };
    if longest / h > f64::from(most) {
        return Err(FrequencyError::TooManySamples { samples: longest / h, most });
    }
    let pulse = Pulse::new(law, process, h, delay);
    let circle = checked(&pulse)?;
    let unstable_poles = winding::unstable_poles(&circle);
    let stable = unstable_poles == Ok(0);
    let found = Scan::of_circle(&circle, &circle, stable).run_round();
    let mut margins = assemble(&circle, &found, unstable_poles, h);
    if stable {
        let loses = |change: f64| {
            let total = Seconds(delay.0 + change);
            checked(&Pulse::new(law, process, h, total))
                .is_ok_and(|circle| winding::unstable_poles(&circle) != Ok(0))
        };
        margins.delay_margin =
            margins.delay_margin.map(|first| Seconds(delay::limit(first.0, h, f64::INFINITY, loses)));
        let most = process.dead_time() + delay.0;
        margins.delay_margin_low =
            delay::cut(margins.delay_margin_low.map(|cut| cut.0), h, most, |change| loses(-change))
                .map(Seconds);
    }
    // From measurement to output, L without the process.
    let noise_gain = noise_gain(law, h);
    Ok(SampledMargins { sample_period, margins, noise_gain })
}

/// Whether the loop is stable.
pub(crate) fn is_stable(law: &Law<f64>, process: &Process, h: f64, delay: Seconds) -> bool {
    checked(&Pulse::new(law, process, h, delay)).is_ok_and(|circle| winding::unstable_poles(&circle) == Ok(0))
}

/// The circle of a loop whose numbers are in reach.
fn checked(pulse: &Pulse) -> Result<Circle, FrequencyError> {
    let circle = Circle::new(pulse);
    // Squares of them are formed.
    for (quantity, value) in [
        ("the numerator of the sampled loop", circle.numerator_bounds(PI)[0]),
        ("the denominator of the sampled loop", circle.denominator_bounds(PI)[0]),
    ] {
        if !(1e-100..=1e100).contains(&value) {
            return Err(FrequencyError::OutOfReach { quantity, value });
        }
    }
    Ok(circle)
}

/// |C| at z = −1.
fn noise_gain(law: &Law<f64>, h: f64) -> f64 {
    transfer(law, h, PI).map_or(f64::NAN, Complex::norm)
}

/// C of the law at z = e^(jθ), with u = −C·y: the same loop on a process that is known.
fn transfer(law: &Law<f64>, h: f64, theta: f64) -> Option<Complex<f64>> {
    // An integrator of gain 1/h with one sample of dead time is 1/((z − 1)·z).
    let unit = Process::integrating(1.0 / h, Seconds(h)).ok()?;
    let z = Complex::from_polar(1.0, theta);
    Some(Circle::new(&Pulse::new(law, &unit, h, Seconds(0.0))).open(theta) * (z - 1.0) * z)
}

fn assemble(circle: &Circle, found: &Findings, unstable_poles: Result<usize, Uncounted>, h: f64) -> Margins {
    let stable = unstable_poles == Ok(0);
    let in_seconds = |list: &[f64]| list.iter().map(|theta| theta / h).collect::<Vec<_>>();
    let when_stable = |value: Option<f64>| value.filter(|_| stable);
    let phases: Vec<(f64, f64)> =
        found.gain_crossovers.iter().map(|&theta| (theta, (-circle.direction(theta)[0]).arg())).collect();
    // A first guess of the delays, as if more delay only turned L.
    let least = |turn: fn(f64) -> f64| {
        phases.iter().map(|&(theta, phase)| turn(phase) / theta * h).min_by(f64::total_cmp)
    };
    let delay = least(|phase| phase.rem_euclid(TAU));
    let cut = least(|phase| (-phase).rem_euclid(TAU));
    let phase = phases.iter().map(|p| p.1).min_by(|a, b| a.abs().total_cmp(&b.abs()));
    // The closed end of (−π, π] is the upper one.
    let phase = phase.map(|phase| if phase <= -PI { PI } else { phase });
    let peak_at = |theta: Option<f64>| when_stable(theta.map(|theta| theta / h));
    let complete = found.phase_crossovers.len() < LISTED;
    Margins {
        stable,
        gain_margin: when_stable((found.below_one > 0.0).then(|| 1.0 / found.below_one)),
        gain_margin_low: when_stable(found.above_one.map(|gain| 1.0 / gain)),
        phase_margin: when_stable(phase).map(Radians),
        delay_margin: when_stable(delay).map(Seconds),
        delay_margin_low: when_stable(cut).map(Seconds),
        gain_crossovers: in_seconds(&found.gain_crossovers),
        phase_crossovers: in_seconds(&found.phase_crossovers),
        phase_crossovers_complete_to: found
            .phase_crossovers
            .last()
            .filter(|_| !complete)
            .map(|last| last / h),
        sensitivity_peak: when_stable(Some(found.sensitivity.value)),
        sensitivity_peak_frequency: peak_at(found.sensitivity.omega),
        complementary_sensitivity_peak: when_stable(Some(found.complementary.value)),
        complementary_sensitivity_peak_frequency: peak_at(found.complementary.omega),
        high_frequency_gain: circle.open(PI).norm(),
        unstable_poles: unstable_poles.ok(),
        warnings: warnings(found, unstable_poles, h),
    }
}

fn warnings(found: &Findings, unstable_poles: Result<usize, Uncounted>, h: f64) -> Vec<String> {
    let mut sentences = Vec::new();
    match unstable_poles {
        Ok(0) => {
            if found.gain_crossovers.is_empty() {
                sentences.push(
                    "The gain of the sampled loop never is 1: phase margin and delay margin are infinite.".into(),
                );
            }
            if found.below_one == 0.0 {
                sentences.push(
                    "No greater loop gain makes the sampled loop unstable: the gain margin is infinite.".into(),
                );
            }
        }
        Ok(n) => sentences.push(format!(
            "The sampled loop is unstable: {n} closed-loop pole{} outside the unit circle; it has no margins.",
            if n == 1 { "" } else { "s" }
        )),
        Err(Uncounted::OnAxis | Uncounted::Infinite) => sentences.push(
            "The sampled loop is not stable: a closed-loop pole lies on the unit circle, or too near to tell; it has no \
             margins."
                .into(),
        ),
        Err(Uncounted::GivenUp) => sentences.push(
            "The sampled loop is not proven stable: it has too many samples in a dead time; no margins are given."
                .into(),
        ),
    }
    if let Some(theta) = found.unfinished_from {
        let omega = theta / h;
        sentences.push(format!(
            "The search of the sampled loop was given up at {omega:e} rad/s: crossovers and peaks beyond it are not \
             proven absent."
        ));
    }
    sentences
}

#[cfg(test)]
mod tests {
    use holdup_control::{Input, Segment, Settings, State};

    use super::*;
    use crate::model::notation::{read_controller, read_process};
    use crate::model::{Compensator, CompensatorLaw, Controller, Lead, sampled_law};

    fn settings(law: &Law<f64>) -> Settings<f64> {
        let settings = Settings::new(law.pid);
        law.observer.map_or(settings, |observer| settings.with_observer(observer).unwrap())
    }

    /// What the code of the law makes of a measurement that is this wave.
    fn outputs(law: &Law<f64>, h: f64, wave: impl Fn(f64) -> f64) -> Vec<f64> {
        let settings = settings(law);
        let line = vec![Segment::default(); settings.segments_needed()];
        let mut state = State::at_rest(&settings, line, 0.0, 0.0, 0.0).unwrap();
        let mut update = |k| state.update(&settings, &Input::automatic(h, 0.0, wave(f64::from(k))));
        (0..1500).map(|k| update(k).manipulated_variable).collect()
    }

    #[test]
    fn a_dense_grid_knows_no_higher_peak_and_comes_near_the_one_found() {
        for (process, controller, h) in [
            ("K=1,d=1.13", "Kc=0.35,Td=0.5,Ko=0.25", 0.4),
            ("K=1,d=1", "Kc=0.4,Ti=8", 0.05),
            ("K=0.2,d=1,T=0.1,integrators=2", "Kc=0.02,Ti=40,Td=15,Tf=0.5", 0.9),
        ] {
            let process = read_process(process).unwrap();
            let law = sampled_law(&process, &read_controller(controller).unwrap(), Seconds(h)).unwrap();
            let found = sampled_margins(&law, &process, Seconds(h), Seconds(0.0)).unwrap().margins;
            let circle = Circle::new(&Pulse::new(&law, &process, h, Seconds(0.0)));
            let mut most = (0.0f64, 0.0f64);
            for k in 1..=200_000 {
                let l = circle.open(PI * f64::from(k) / 200_000.0);
                most = (most.0.max((l + 1.0).inv().norm()), most.1.max((l / (l + 1.0)).norm()));
            }
            for (exact, grid) in [
                (found.sensitivity_peak.unwrap(), most.0),
                (found.complementary_sensitivity_peak.unwrap(), most.1),
            ] {
                // A step of 1.6e-5 from a maximum of curvature up to 100 loses 1e-8.
                assert!(grid <= exact * (1.0 + 1e-12) && grid > exact * (1.0 - 1e-7), "{exact} {grid}");
            }
        }
    }

    #[test]
    fn the_transfer_of_the_law_is_what_its_code_does_to_a_sine() {
        let process = read_process("K=1,d=1").unwrap();
        let smith = |lead| {
            let law = CompensatorLaw::ModifiedSmith { main_gain: 0.8, disturbance_gain: 0.35, lead };
            Controller::from(Compensator::new(law, 1.0, Seconds(1.0)).unwrap())
        };
        let lead = Lead { derivative_time: 0.4, filter_time: 0.2 };
        let read = |text| read_controller(text).unwrap();
        for controller in [
            read("Kc=0.4"),
            read("Kc=0.4,Ti=8"),
            read("Kc=0.4,Td=0.4"),
            read("Kc=0.4,Ti=8,Td=0.4,Tf=0.2"),
            read("Kc=0.4,Td=0.4,Tf=0.2,Ko=0.3"),
            read("Kc=0.4,Ti=8,Ko=0.3,Km=0.8,dm=1.25"),
            smith(None),
            smith(Some(lead)),
        ] {
            for (h, theta) in [(0.3, 0.2), (0.3, 1.1), (0.25, 2.9), (0.07, 0.4)] {
                let law = sampled_law(&process, &controller, Seconds(h)).unwrap();
                let (cosine, sine) =
                    (outputs(&law, h, |k| (theta * k).cos()), outputs(&law, h, |k| (theta * k).sin()));
                let u = |k: usize| Complex::new(cosine[k], sine[k]);
                // The third difference leaves nothing of what the integrators made of the start.
                let difference = u(1499) - u(1498) * 3.0 + u(1497) * 3.0 - u(1496);
                let z = Complex::from_polar(1.0, theta);
                let found = -difference / (z.powi(1496) * (z - 1.0).powi(3));
                let expected = transfer(&law, h, theta).unwrap();
                // Rounding of outputs that integrators let grow to 100, over differences as small as θ³ = 0.008.
                assert!((found / expected - 1.0).norm() < 1e-9, "{controller:?} {theta} {found} {expected}");
            }
        }
    }
}
