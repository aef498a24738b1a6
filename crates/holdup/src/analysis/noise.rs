//! What noise of the measurement does to the controller output: its variance, exactly.
//!
//! The loop answers one held sample of noise with a pulse p(t) of the controller output. Samples are independent, so the
//! variance is the mean over a sample of Σ p(t + k·h)², that is `∫ p² dt / h`, which the exact simulation has (Parseval's
//! theorem makes it the integral over all frequencies). Noise of a bandwidth has its density on a finite range of
//! frequencies, on which |T/G|² is integrated; there is no tail.

use super::frequency::{LoopTransfer, dominant_poles};
use super::response::{Scenario, integrals};
use crate::model::{ClosedLoop, Controller, Process, Seconds};

/// White noise of the measurement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Noise {
    /// Independent samples, each held for the sample time.
    Held {
        /// Sample time \[s\].
        sample_time: f64,
    },
    /// A constant density up to the bandwidth and none above.
    Band {
        /// Bandwidth \[rad/s\].
        bandwidth: f64,
    },
}

/// The largest product of bandwidth and dead time that is integrated.
pub const WIDEST: f64 = 1e4;

/// Decay times after which the square of a pulse is over, to 1e-13 of it.
const DECAYS: f64 = 15.0;
/// Relative error of the integral over the frequencies, and how often a panel is halved.
const TOLERANCE: f64 = 1e-11;
const HALVINGS: u32 = 24;

/// Variance of the controller output of a **stable** loop at rest, as a multiple of the variance of the noise of its
/// measurement \[(input/output unit)²\]. Of held noise it is the mean over a sample.
///
/// `None` where it is infinite (held noise, which has steps, through a derivative without filter), for dead-time
/// compensators, for a bandwidth above [`WIDEST`] over the dead time, and where the loop is out of reach.
///
/// ```
/// use holdup::analysis::noise::{Noise, variance_gain};
/// use holdup::model::{Controller, Process, Seconds};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let pid = Controller::proportional(0.5)?.with_derivative_time(Seconds(0.4))?;
/// let noise = Noise::Held { sample_time: 0.1 };
/// assert_eq!(variance_gain(&process, &pid, noise), None);
/// let filtered = pid.with_filter_time(Seconds(0.1))?;
/// // More than the square of Kc, less than that of Kc·(1 + Td/Tf).
/// let gain = variance_gain(&process, &filtered, noise).unwrap();
/// assert!(gain > 0.25 && gain < 6.25);
/// # Ok::<(), holdup::model::ModelError>(())
/// ```
#[must_use]
pub fn variance_gain(process: &Process, controller: &Controller, noise: Noise) -> Option<f64> {
    let closed = ClosedLoop::new(process, controller);
    match noise {
        Noise::Held { sample_time } => of_held(process, controller, &closed, sample_time),
        Noise::Band { bandwidth } => of_band(process, &closed, bandwidth),
    }
}

fn of_held(process: &Process, controller: &Controller, closed: &ClosedLoop, sample_time: f64) -> Option<f64> {
    let noisy = closed.with_noise_for_setpoint(controller)?;
    let decay = dominant_poles(closed).ok()?.first().map(|pole| -pole.re).filter(|decay| *decay > 0.0);
    let time = process.dead_time() + process.lag().unwrap_or(0.0);
    let horizon = sample_time + decay.map_or(100.0 * time, |decay| DECAYS / decay + 4.0 * time);
    let pulse = vec![(0.0, 1.0), (sample_time, 0.0)];
    let scenario = Scenario::new(pulse, Vec::new(), Seconds(horizon), 0.0).ok()?;
    Some(integrals(&noisy, &scenario).ok()?.control_energy? / sample_time)
}

fn of_band(process: &Process, closed: &ClosedLoop, bandwidth: f64) -> Option<f64> {
    if bandwidth * process.dead_time() > WIDEST {
        return None;
    }
    let transfer = LoopTransfer::new(closed).ok()?;
    let (gain, lag) = (process.process_gain(), process.lag().unwrap_or(0.0));
    let power = i32::from(process.integrators());
    // |T/G|²: the process without its dead time has no zero in the denominator of T, so 0 is an ordinary point.
    let density = |omega: f64| {
        let inverse = omega.powi(power) / gain;
        transfer.complementary_sensitivity(omega).norm_sqr()
            * inverse
            * inverse
            * (1.0 + omega * lag * omega * lag)
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 1e4")]
    let panels = (bandwidth * process.dead_time()).ceil().max(1.0) as u32;
    let width = bandwidth / f64::from(panels);
    let mut sum = 0.0;
    for panel in 0..panels {
        let low = width * f64::from(panel);
        sum += kronrod(&density, low, low + width, sum, HALVINGS);
    }
    let variance = sum / bandwidth;
    variance.is_finite().then_some(variance)
}

/// Nodes from the middle outwards, weights of Kronrod's and of Gauss's rule (A. S. Kronrod, Nodes and Weights of
/// Quadrature Formulas, 1965; the pair 7–15).
const NODES: [f64; 8] = [
    0.0,
    0.207_784_955_007_898_47,
    0.405_845_151_377_397_2,
    0.586_087_235_467_691_1,
    0.741_531_185_599_394_4,
    0.864_864_423_359_769_1,
    0.949_107_912_342_758_5,
    0.991_455_371_120_812_6,
];
const KRONROD: [f64; 8] = [
    0.209_482_141_084_727_83,
    0.204_432_940_075_298_9,
    0.190_350_578_064_785_4,
    0.169_004_726_639_267_9,
    0.140_653_259_715_525_92,
    0.104_790_010_322_250_18,
    0.063_092_092_629_978_55,
    0.022_935_322_010_529_224,
];
const GAUSS: [f64; 4] =
    [0.417_959_183_673_469_4, 0.381_830_050_505_118_9, 0.279_705_391_489_276_7, 0.129_484_966_168_869_7];

/// The integral, halved where the two rules disagree.
fn kronrod(function: &dyn Fn(f64) -> f64, low: f64, high: f64, so_far: f64, halvings: u32) -> f64 {
    let (middle, half) = (f64::midpoint(low, high), 0.5 * (high - low));
    let (mut fine, mut coarse) = (0.0, 0.0);
    for (index, (node, weight)) in NODES.into_iter().zip(KRONROD).enumerate() {
        let pair = if index == 0 {
            function(middle)
        } else {
            function(middle - half * node) + function(middle + half * node)
        };
        fine += weight * pair;
        if index % 2 == 0 {
            coarse += GAUSS[index / 2] * pair;
        }
    }
    let (fine, coarse) = (half * fine, half * coarse);
    // The error of Kronrod's rule is far below the difference; where that is small its square root is the better guide.
    let agreed = (fine - coarse).abs() <= TOLERANCE.sqrt() * 1e-2 * fine.abs().max(1e-3 * so_far);
    if agreed || halvings == 0 || !fine.is_finite() {
        return fine;
    }
    let lower = kronrod(function, low, middle, so_far, halvings - 1);
    lower + kronrod(function, middle, high, so_far + lower, halvings - 1)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::model::Observer;

    fn loops() -> Vec<(Process, Controller)> {
        let plain = Process::integrating(0.5, Seconds(2.0)).unwrap();
        let lagged = plain.with_lag(Seconds(1.0)).unwrap();
        let pi = Controller::proportional(0.4).unwrap().with_integral_time(Seconds(14.0)).unwrap();
        let pid = pi.with_derivative_time(Seconds(0.7)).unwrap().with_filter_time(Seconds(0.2)).unwrap();
        let observed = Controller::proportional(0.3).unwrap().with_observer(Observer::new(0.1).unwrap());
        vec![
            (plain, pi),
            (plain, pid),
            (plain, observed),
            (lagged, pid.with_setpoint_weights(0.3, 0.0).unwrap()),
        ]
    }

    #[test]
    fn the_energy_of_the_pulse_is_the_integral_over_the_frequencies() {
        for (process, controller) in loops() {
            let h = 0.3;
            let exact = variance_gain(&process, &controller, Noise::Held { sample_time: h }).unwrap();
            let transfer = LoopTransfer::new(&ClosedLoop::new(&process, &controller)).unwrap();
            let lag = process.lag().unwrap_or(0.0);
            let square = |omega: f64| {
                let t = transfer.complementary_sensitivity(omega).norm_sqr();
                t * (omega / process.process_gain()).powi(2) * (1.0 + (omega * lag).powi(2))
            };
            let highest = 4000.0;
            let far = controller.noise_gain().unwrap().powi(2);
            // What is known of the density far out is taken away: (1/π)·∫h·sinc² dω = 1.
            let density = |omega: f64| {
                let x = 0.5 * omega * h;
                let sinc = if x == 0.0 { 1.0 } else { x.sin() / x };
                (square(omega) - far) * h * sinc * sinc / PI
            };
            let sum: f64 = (0..40_000)
                .map(|index| {
                    let low = highest / 40_000.0 * f64::from(index);
                    kronrod(&density, low, low + highest / 40_000.0, 1.0, 6)
                })
                .sum();
            // The rest is below 2·|L|·4/(π·h·ω²), about 1e-6 at the highest frequency.
            assert!((exact / (far + sum) - 1.0).abs() < 2e-6, "{exact} {}", far + sum);
        }
    }

    #[test]
    fn slow_noise_is_answered_less_than_fast_and_very_fast_noise_by_the_noise_gain() {
        let (process, controller) = loops()[1];
        let of =
            |sample_time: f64| variance_gain(&process, &controller, Noise::Held { sample_time }).unwrap();
        assert!(of(20.0) < of(2.0));
        let far = controller.noise_gain().unwrap().powi(2);
        // The filter takes noise that is a thousand times as fast away but for the proportional part, in about h/Tf.
        assert!(of(200.0) < 0.05 * far && of(2e-4) < far);
    }

    #[test]
    fn noise_of_a_band_is_that_of_an_independent_sum_and_of_the_noise_gain_far_out() {
        for (process, controller) in loops() {
            let of =
                |bandwidth: f64| variance_gain(&process, &controller, Noise::Band { bandwidth }).unwrap();
            let transfer = LoopTransfer::new(&ClosedLoop::new(&process, &controller)).unwrap();
            let lag = process.lag().unwrap_or(0.0);
            let count = 200_000;
            let sum: f64 = (0..count)
                .map(|index| {
                    let omega = 3.0 / f64::from(count) * (f64::from(index) + 0.5);
                    let t = transfer.complementary_sensitivity(omega).norm_sqr();
                    t * (omega / process.process_gain()).powi(2) * (1.0 + (omega * lag).powi(2))
                })
                .sum();
            // The rule of midpoints errs by the square of its step.
            assert!((of(3.0) * f64::from(count) / sum - 1.0).abs() < 1e-8);
            let far = controller.noise_gain().unwrap().powi(2);
            assert!((of(4000.0) / far - 1.0).abs() < 0.02); // 1/(bandwidth·Tf) of the range is below the filter's
        }
    }

    #[test]
    fn what_is_infinite_or_too_wide_is_absent() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let pd = Controller::proportional(0.4).unwrap().with_derivative_time(Seconds(0.3)).unwrap();
        assert_eq!(variance_gain(&process, &pd, Noise::Held { sample_time: 0.1 }), None);
        assert!(variance_gain(&process, &pd, Noise::Band { bandwidth: 10.0 }).is_some());
        assert_eq!(variance_gain(&process, &pd, Noise::Band { bandwidth: 2e4 }), None);
    }
}
