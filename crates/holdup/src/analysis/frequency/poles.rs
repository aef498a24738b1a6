//! The rightmost closed-loop poles, proven complete to the right of a vertical line.
//!
//! The argument principle counts the zeros of Δ to the right of Re s = −σ, by counting those of Δ(s − σ) in the
//! right half plane. σ is chosen so that they are few; Newton's method with the found ones divided out then
//! has to find exactly that many.

use num_complex::Complex;
use serde::Serialize;

use super::characteristic::Characteristic;
use super::envelope::Envelope;
use super::error::FrequencyError;
use super::winding;
use crate::model::ClosedLoop;

/// Bands of an octave through which Δ is followed: where more are needed the line moves.
const WORK: usize = 10_000;

/// Most poles listed.
const MOST: usize = 8;

/// A closed-loop pole [1/s].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Pole {
    /// Real part [1/s]: the rate of decay, negative when stable.
    pub re: f64,
    /// Imaginary part [rad/s].
    pub im: f64,
}

/// The rightmost closed-loop poles, at most 8, from right to left and conjugate pairs together: no pole lies to
/// the right of the last one that is not listed.
///
/// Empty where no such list is found: a neutral loop may have infinitely many poles near its rightmost one.
///
/// ```
/// use holdup::analysis::frequency::dominant_poles;
/// use holdup::model::{ClosedLoop, Controller, Process, Seconds};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// // K·Kc·d = 1/e: two equal real poles at −1/d, the fastest answer without overshoot.
/// let p = Controller::proportional((-1.0f64).exp())?;
/// let poles = dominant_poles(&ClosedLoop::new(&process, &p))?;
/// assert!((poles[0].re + 1.0).abs() < 1e-6 && (poles[1].re + 1.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FrequencyError`] if the numbers of the loop are out of the reach of double precision.
pub fn dominant_poles(closed_loop: &ClosedLoop) -> Result<Vec<Pole>, FrequencyError> {
    let loop_ = Characteristic::new(closed_loop)?;
    // Beyond this decay a neutral loop has infinitely many poles: |L(j∞)|·e^σ must stay below 1.
    let deepest = if loop_.high_frequency_gain > 0.0 { -loop_.high_frequency_gain.ln() } else { 40.0 };
    let (mut few, mut many) = (None, deepest);
    let mut decay = deepest.min(1.0) * 0.931;
    for _ in 0..60 {
        match count(&loop_, decay) {
            Some(0) => few = Some(decay),
            Some(n) if n <= MOST => {
                if let Some(poles) = find(&loop_, decay, n) {
                    return Ok(poles);
                }
                many = decay;
            }
            _ => many = decay,
        }
        decay = match few {
            // Nothing to the right yet: farther to the left, but short of where they are too many.
            Some(few) => few + 0.513 * (many - few).min(1.0),
            None if decay > 1e-6 => 0.487 * decay,
            // An unstable loop with many poles: the line goes to the right.
            None => decay.min(0.0) * 2.1 - 0.1,
        };
    }
    Ok(Vec::new())
}

/// Zeros of Δ with real part greater than −`decay`.
fn count(loop_: &Characteristic, decay: f64) -> Option<usize> {
    let shifted = Characteristic {
        dead_time: loop_.dead_time,
        numerator: loop_.numerator.shifted(decay),
        denominator: loop_.denominator.shifted(decay),
        closed: loop_.closed.shifted(decay),
        order: loop_.order,
        high_frequency_gain: loop_.high_frequency_gain * decay.exp(),
    };
    winding::unstable_poles(&shifted, &Envelope::new(&shifted), WORK).ok()
}

/// The `n` zeros of Δ right of −`decay`, if Newton's method finds them all.
fn find(loop_: &Characteristic, decay: f64, n: usize) -> Option<Vec<Pole>> {
    let mut zeros: Vec<Complex<f64>> = Vec::with_capacity(n + 1);
    for start in starts(decay) {
        while let Some(zero) = newton(loop_, start, &zeros) {
            if zero.re <= -decay {
                // Left of the line: of no use, but divided out it would lead on.
                break;
            }
            zeros.push(zero);
            if zero.im != 0.0 {
                zeros.push(zero.conj());
            }
            if zeros.len() >= n {
                break;
            }
        }
        if zeros.len() >= n {
            break;
        }
    }
    if zeros.len() != n {
        return None;
    }
    zeros.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    let d = loop_.dead_time;
    Some(zeros.iter().map(|z| Pole { re: z.re / d, im: z.im / d }).collect())
}

/// Starting points: along the real axis, round the origin at every scale, and up the imaginary axis.
fn starts(decay: f64) -> impl Iterator<Item = Complex<f64>> {
    let scales = (0..24).map(|i| 4.0 * 0.5f64.powi(i));
    let near = scales.flat_map(|r| {
        [(-0.99, 0.0), (-0.7, 0.7), (0.0, 1.0), (0.7, 0.7), (0.99, 0.0)]
            .map(|(re, im)| Complex::new(re * r, im * r))
    });
    let up = (0..60).flat_map(move |i| {
        let height = 0.75 * f64::from(i);
        [-0.9 * decay, -0.3 * decay, 0.3].map(|re| Complex::new(re, height))
    });
    near.chain(up)
}

/// A zero of Δ other than those `found`, with a non-negative imaginary part.
fn newton(loop_: &Characteristic, start: Complex<f64>, found: &[Complex<f64>]) -> Option<Complex<f64>> {
    let mut s = start;
    for _ in 0..40 {
        let [f, df] = loop_.closed.at(s);
        if f.norm() == 0.0 {
            break;
        }
        // The logarithmic derivative of Δ/Π(s − zero).
        let slope = found.iter().fold(df / f, |sum, zero| sum - (s - zero).inv());
        let step = -slope.inv();
        if !step.is_finite() {
            return None;
        }
        let step = if step.norm() > 2.0 { step * (2.0 / step.norm()) } else { step };
        s += step;
        if step.norm() <= 1e-8 * s.norm() {
            return polished(loop_, s, found);
        }
    }
    None
}

/// Newton's method on Δ itself, last steps; a zero next to the real axis is put on it.
fn polished(loop_: &Characteristic, zero: Complex<f64>, found: &[Complex<f64>]) -> Option<Complex<f64>> {
    let mut s = zero;
    for _ in 0..3 {
        let [f, df] = loop_.closed.at(s);
        let step = f / df;
        // Next to a multiple zero the steps are noise.
        if !step.is_finite() || step.norm() > 1e-6 * s.norm() {
            break;
        }
        s -= step;
    }
    if s.im.abs() <= 1e-9 * s.norm() {
        s.im = 0.0;
    }
    s.im = s.im.abs();
    // Distinct from those found, or one of a multiple zero (where Δ' vanishes too).
    let same = found.iter().any(|z| (z - s).norm() <= 1e-9 * s.norm());
    (!same || s == zero).then_some(s)
}
