//! Unstable closed-loop poles, counted by the argument principle.
//!
//! Δ(s) = sⁿ·(1 + …) has no zero in the right half plane beyond |s| = Ω once its leading term outweighs the
//! rest; the zeros inside the half disc of radius Ω number `(n·π/2 + arg(Δ/sⁿ)(jΩ) − Φ)/π`, with Φ the change of
//! arg Δ(jω) from 0 to Ω. The change is summed over bands on each of which Δ is proven to stay in an open half
//! plane, or one of its terms to outweigh the others (then it turns with that term).

use std::f64::consts::{FRAC_PI_2, PI};

use num_complex::Complex;

use super::characteristic::Characteristic;
use super::envelope::{Envelope, Modulus};
use super::polynomial::Polynomial;
use super::taylor::Quadratic;

/// Why the unstable poles were not counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Uncounted {
    /// A pole lies on the imaginary axis, or nearer to it than double precision tells apart.
    OnAxis,
    /// There are infinitely many: |L(j∞)| ≥ 1.
    Infinite,
    /// The frequencies that matter turn too often to be followed.
    GivenUp,
}

/// Number of closed-loop poles with positive real part, following Δ through at most `work` bands an octave.
pub(super) fn unstable_poles(
    loop_: &Characteristic,
    envelope: &Envelope,
    work: usize,
) -> Result<usize, Uncounted> {
    if loop_.high_frequency_gain >= 1.0 {
        return Err(Uncounted::Infinite);
    }
    let closed = &loop_.closed;
    let Some((_, leading)) = closed.terms().first().filter(|(delay, _)| *delay == 0.0) else {
        return Err(Uncounted::GivenUp);
    };
    // From `end` on, the denominator outweighs the numerator: Δ follows its undelayed term.
    let mut end = 1.0;
    while !envelope.gain_is_below(1.0, end, f64::INFINITY) {
        end *= 2.0;
        if end > 1e110 {
            return Err(Uncounted::GivenUp);
        }
    }
    let mut phase = 0.0;
    let mut from = 0.0;
    let mut to = 1.0_f64;
    while from < end {
        phase += turn(loop_, envelope, from, to, work)?;
        from = to;
        to *= 2.0;
    }
    let at_end = closed.on_axis(from)[0] / leading.on_axis(from)[0];
    #[expect(clippy::cast_precision_loss, reason = "at most 15")]
    let arc = loop_.order as f64 * FRAC_PI_2;
    let zeros =
        (arc + at_end.arg() - phase - turn_to_infinity(leading, from).ok_or(Uncounted::GivenUp)?) / PI;
    let count = zeros.round();
    // The sum is an integer up to the roundings of the arguments.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked to be in range")]
    let number = count as usize;
    if (zeros - count).abs() < 0.01 && (0.0..1e15).contains(&count) {
        Ok(number)
    } else {
        Err(Uncounted::GivenUp)
    }
}

/// Change of arg Δ(jω) over [from, to].
fn turn(
    loop_: &Characteristic,
    envelope: &Envelope,
    from: f64,
    to: f64,
    most: usize,
) -> Result<f64, Uncounted> {
    let closed = &loop_.closed;
    let mut sum = 0.0;
    let mut start = closed.on_axis(from)[0];
    let mut stack = vec![(from, to)];
    let mut work = 0;
    while let Some((a, b)) = stack.pop() {
        let (middle, radius) = (f64::midpoint(a, b), 0.5 * (b - a));
        work += 1;
        if work > most || radius <= 4.0 * f64::EPSILON * b {
            return Err(Uncounted::GivenUp);
        }
        let wide = closed.longest_delay() * radius > 1.6;
        if wide && let Some(change) = turn_with_heaviest(loop_, envelope, a, b) {
            sum += change;
            start = closed.on_axis(b)[0];
            continue;
        }
        if !wide {
            let jet = closed.on_axis(middle);
            let bounds = closed.magnitudes(b);
            if in_half_plane(jet, bounds, radius) {
                let end = closed.on_axis(b)[0];
                sum += (end * start.conj()).arg();
                start = end;
                continue;
            }
            if jet[0].norm() <= 4.0 * f64::EPSILON * bounds[0] {
                return Err(Uncounted::OnAxis);
            }
        }
        stack.push((middle, b));
        stack.push((a, middle));
    }
    Ok(sum)
}

/// Whether a function of this jet at the middle and these derivative bounds stays in an open half plane.
pub(super) fn in_half_plane(jet: [Complex<f64>; 3], bounds: [f64; 4], radius: f64) -> bool {
    let direction = jet[0].conj() / jet[0].norm();
    let [f, df, ddf] = jet.map(|z| (z * direction).re);
    let rest = bounds[3] * radius.powi(3) / 6.0 + 4.0 * f64::EPSILON * bounds[0];
    Quadratic { f, df, ddf }.range(radius).0 > rest
}

/// Change of arg Δ over a wide band on which one term outweighs the others.
fn turn_with_heaviest(loop_: &Characteristic, envelope: &Envelope, from: f64, to: f64) -> Option<f64> {
    let k = envelope.heaviest(f64::midpoint(from, to));
    if !envelope.outweighs(k, 1.0, from, to) {
        return None;
    }
    let (delay, p) = loop_.denominator.terms().iter().chain(loop_.numerator.terms()).nth(k)?;
    let relative = |omega: f64| {
        let turned = Complex::from_polar(1.0, delay * omega);
        (loop_.closed.on_axis(omega)[0] * turned / p.on_axis(omega)[0]).arg()
    };
    let own = turn_of_polynomial(&along_axis(p), from, to)?;
    Some(own - delay * (to - from) + relative(to) - relative(from))
}

/// Change of arg p(jω) from `from` to infinity.
fn turn_to_infinity(p: &Polynomial, from: f64) -> Option<f64> {
    // With t = 1/ω: arg p(j/t) = arg(tⁿ·p(j/t)), a polynomial in t with the coefficients reversed.
    let mut reversed = along_axis(p);
    reversed.reverse();
    turn_of_polynomial(&reversed, 0.0, 1.0 / from).map(|turn| -turn)
}

/// The coefficients of p(jω) as a polynomial in ω: each takes its power of j.
fn along_axis(p: &Polynomial) -> Vec<Complex<f64>> {
    let mut power = Complex::new(1.0, 0.0);
    let mut turned = Vec::with_capacity(p.coefficients().len());
    for &c in p.coefficients() {
        turned.push(power * c);
        power *= Complex::i();
    }
    turned
}

/// Change of the argument of a polynomial with complex coefficients over [from, to] of the real line.
fn turn_of_polynomial(coefficients: &[Complex<f64>], from: f64, to: f64) -> Option<f64> {
    let zero = Complex::new(0.0, 0.0);
    let low = coefficients.iter().take_while(|c| **c == zero).count();
    let p = coefficients.get(low..).filter(|p| !p.is_empty())?;
    if p.len() == 1 || from == to {
        return Some(0.0);
    }
    let value = |x: f64| p.iter().rev().fold(zero, |sum, c| sum * x + c);
    let mut sum = 0.0;
    let mut stack = vec![(from, to)];
    let mut taylor = p.to_vec();
    while let Some((a, b)) = stack.pop() {
        let (middle, radius) = (f64::midpoint(a, b), 0.5 * (b - a));
        taylor.copy_from_slice(p);
        for i in 1..taylor.len() {
            for k in (i - 1..taylor.len() - 1).rev() {
                let higher = taylor[k + 1];
                taylor[k] += higher * middle;
            }
        }
        let direction = taylor[0].conj() / taylor[0].norm();
        let coefficient = |i: usize| taylor.get(i).map_or(0.0, |c| (c * direction).re);
        let quadratic = Quadratic { f: coefficient(0), df: coefficient(1), ddf: 2.0 * coefficient(2) };
        let rest = taylor.iter().skip(3).rev().fold(0.0, |sum, c| sum * radius + c.norm()) * radius.powi(3);
        if quadratic.range(radius).0 > rest {
            sum += (value(b) * value(a).conj()).arg();
        } else if radius <= 4.0 * f64::EPSILON * b.abs() || radius.is_nan() {
            return None;
        } else {
            stack.push((middle, b));
            stack.push((a, middle));
        }
    }
    Some(sum)
}
