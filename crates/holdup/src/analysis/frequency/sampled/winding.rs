//! Closed-loop poles outside the unit circle, counted by the argument principle.
//!
//! Δ is a polynomial in z over a power of z. All poles beside those that the power of z puts at the origin are zeros of
//! that polynomial; how often Δ goes round 0 on the half circle says how many of them lie within.

use std::f64::consts::PI;

use super::circle::Circle;
use crate::analysis::frequency::envelope::Modulus;
use crate::analysis::frequency::functions::Curve;
use crate::analysis::frequency::winding::{Uncounted, in_half_plane};

/// Bands through which Δ is followed before the verdict is given up.
const WORK: usize = 20_000_000;

/// Number of closed-loop poles outside the unit circle.
pub(super) fn unstable_poles(circle: &Circle) -> Result<usize, Uncounted> {
    let mut phase = 0.0;
    let mut start = circle.closed(0.0)[0];
    let mut stack = vec![(2.0, PI), (1.0, 2.0), (0.0, 1.0)];
    let mut work = 0;
    while let Some((a, b)) = stack.pop() {
        work += 1;
        let (middle, radius) = (f64::midpoint(a, b), 0.5 * (b - a));
        if work > WORK || radius <= 4.0 * f64::EPSILON * b {
            return Err(Uncounted::GivenUp);
        }
        // Where |L| < 1, Δ turns with D, whatever the delays.
        if a > 0.0
            && circle.gain_is_below(1.0, a, b)
            && let Some(turn) = circle.turn_of_denominator(a, b)
        {
            let relative = |theta: f64| (circle.open(theta) + 1.0).arg();
            phase += turn + relative(b) - relative(a);
            start = circle.closed(b)[0];
            continue;
        }
        if circle.longest_delay() * radius <= 1.6 {
            let jet = circle.closed(middle);
            let bounds = circle.closed_bounds(b);
            if in_half_plane(jet, bounds, radius) {
                let end = circle.closed(b)[0];
                phase += (end * start.conj()).arg();
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
    let outside = circle.order - phase / PI;
    let count = outside.round();
    // The sum is an integer up to the roundings of the arguments.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked to be in range")]
    let number = count as usize;
    if (outside - count).abs() < 0.01 && (0.0..1e15).contains(&count) {
        Ok(number)
    } else {
        Err(Uncounted::GivenUp)
    }
}
