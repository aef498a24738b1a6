//! The smallest safe test that would suffice.

use serde::Serialize;

use super::Record;
use super::identify::{Basis, Hold, Joint, Kind, Load, Problem, dot};
use super::wording::three;

/// Relative standard deviation of the gain that a test is to reach: an interval of ±20 %.
const GAIN: f64 = 0.1;

/// Standard deviation of the dead time over (dead time + one row) that a test is to reach.
const DEAD_TIME: f64 = 0.15;

/// Rows of a test at most.
const MOST_ROWS: usize = 4000;

/// A pulse of the manipulated variable up, down, and back, which leaves an integrating process where it was.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SafeTest {
    /// Height of the pulses [input unit], to both sides of where the actuator stands.
    pub pulse: f64,
    /// Length of each pulse [s].
    #[serde(rename = "pulse_s")]
    pub pulse_time: f64,
    /// Length of the test with the rest before and after it [s].
    #[serde(rename = "duration_s")]
    pub duration: f64,
    /// How far the controlled variable moves [output unit].
    pub excursion: f64,
    /// How far it may move [output unit].
    pub allowed: f64,
    /// Whether the test suffices within what is allowed; if not, it is the best within it.
    pub suffices: bool,
    /// A setpoint step in automatic of this size [output unit] is the alternative.
    pub setpoint_step: f64,
}

impl SafeTest {
    /// The test in a sentence.
    #[must_use]
    pub fn text(&self) -> String {
        let verb = if self.suffices {
            "would settle it"
        } else {
            "is the best within what is allowed, and may not suffice"
        };
        format!(
            "in manual, {} above the present output for {} s, then as much below for {} s, then back, {} s in \
             all with rest before and after: the controlled variable moves by {} of the {} allowed; {verb}. Or in \
             automatic a setpoint step of {}",
            three(self.pulse),
            three(self.pulse_time),
            three(self.pulse_time),
            three(self.duration),
            three(self.excursion),
            three(self.allowed),
            three(self.setpoint_step)
        )
    }
}

/// The shortest pulse test after which gain and dead time would be known well, for a process like the fitted one under the
/// fitted noise; pulses longer by factors of two are tried until one does.
pub(crate) fn safe_test(joint: &Joint, step: f64, allowed: f64) -> Option<SafeTest> {
    let fit = joint.fit;
    let plausible =
        fit.gain.is_finite() && fit.gain != 0.0 && allowed > 0.0 && fit.kind != Kind::DoubleIntegrating;
    if !plausible {
        return None;
    }
    let mut best: Option<(f64, SafeTest)> = None;
    let mut pulse_time = (2.0 * step).max(fit.dead_time);
    for _ in 0..10 {
        let rest = fit.dead_time + pulse_time;
        let duration = 2.0 * pulse_time + 2.0 * rest;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positive and bounded")]
        let rows = (duration / step).ceil().min(1e6) as usize + 1;
        if rows > MOST_ROWS {
            break;
        }
        let unit = deviations(joint, step, rows, rest, pulse_time)?;
        // Deviations of gain and dead time fall with the height of the pulses.
        let needed = (unit[0] / (GAIN * fit.gain.abs())).max(unit[1] / (DEAD_TIME * (fit.dead_time + step)));
        let highest = allowed / (fit.process_gain().abs() * pulse_time);
        let suffices = needed <= highest;
        let pulse = needed.min(highest);
        let excursion = fit.process_gain().abs() * pulse * pulse_time;
        let test =
            SafeTest { pulse, pulse_time, duration, excursion, allowed, suffices, setpoint_step: allowed };
        let shortage = needed / highest;
        if best.as_ref().is_none_or(|(least, _)| shortage < *least) {
            best = Some((shortage, test));
        }
        if suffices {
            return Some(test);
        }
        pulse_time *= 2.0;
    }
    best.map(|(_, test)| test)
}

/// Standard deviations of gain and dead time after a test with pulses of height 1.
fn deviations(joint: &Joint, step: f64, rows: usize, rest: f64, pulse_time: f64) -> Option<[f64; 2]> {
    #[expect(clippy::cast_precision_loss, reason = "a few thousand rows")]
    let time: Vec<f64> = (0..rows).map(|k| k as f64 * step).collect();
    let input = time
        .iter()
        .map(|&t| match ((t - rest + 1e-9 * step) / pulse_time).floor() {
            0.0 => 1.0,
            1.0 => -1.0,
            _ => 0.0,
        })
        .collect();
    let record = Record::new(time, vec![0.0; rows], input).ok()?;
    let problem = Problem::new(&record, 0, 1, Hold::Constant, Load::Constant);
    let (fit, whitener) = (joint.fit, joint.whitener(&problem));
    let whiten = |column: Vec<f64>| whitener.whiten(column);
    let shape = fit.kind.shape(fit.lag);
    let own = Basis::of(problem.own_columns(fit.kind, fit.lag).into_iter().map(whiten));
    let column = own.projected(whitener.whiten(problem.column(shape, fit.dead_time)));
    let slope =
        problem.column(shape.rate(), fit.dead_time).into_iter().map(|value| -fit.gain * value).collect();
    let slope = own.projected(whitener.whiten(slope));
    let [vv, vs, ss] = [dot(&column, &column), dot(&column, &slope), dot(&slope, &slope)];
    let determinant = vv * ss - vs * vs;
    let variance = fit.squares / joint.freedom;
    let deviations = [(variance * ss / determinant).sqrt(), (variance * vv / determinant).sqrt()];
    deviations.iter().all(|value| value.is_finite()).then_some(deviations)
}
