//! PD control with a stated gain margin and a stated phase margin.
//!
//! Along the curve of constant gain margin Am the phase margin of the unfiltered loop is
//! `π/2 − p·sin p/√(Am² − cos²p) + asin(−cos p/Am)` at phase crossover p. It rises from 90°·(1 − 1/Am) at p = π/2
//! (Td = 0) towards 90° + asin(1/Am) for Td → ∞, so the pair is feasible between these, and then unique.

use std::f64::consts::{FRAC_PI_2, PI};

use super::curve::{Curve, Margin, Pd};
use super::root::bracket;
use crate::tuning::Specification;

/// The PD loops with both margins, unique without a filter; or why there is none, with the nearest that there are.
pub(super) fn solve(
    gain_margin: f64,
    phase_margin: f64,
    filter: f64,
) -> Result<Vec<Pd>, (String, Vec<Specification>)> {
    let curve = Curve { margin: Margin::Gain(gain_margin), filter };
    let (first, last) = curve.ends();
    let error = |q: f64| curve.phase_margin(curve.at(q)) - phase_margin;
    // Rounding of the limit itself: the limit belongs to the feasible set.
    if error(first).abs() <= 4.0 * f64::EPSILON {
        return Ok(vec![curve.at(first)]);
    }
    let points = if filter > 0.0 { 2000 } else { 2 };
    // Even in the logarithm of the distance to the far end, where Td grows without limit.
    let reach = (first - last) / (1e-12 * (1.0 + last));
    let grid = (0..points).map(|i| {
        if i == 0 { first } else { last + (first - last) * reach.powf(-f64::from(i) / f64::from(points - 1)) }
    });
    let grid: Vec<_> = grid.map(|q| (q, error(q))).collect();
    let crossings = grid.windows(2).filter(|pair| (pair[0].1 < 0.0) != (pair[1].1 < 0.0));
    let found: Vec<_> = crossings.map(|pair| curve.at(bracket(pair[0].0, pair[1].0, 0.0, error).0)).collect();
    if found.is_empty() { Err(infeasible(gain_margin, phase_margin, filter, &grid)) } else { Ok(found) }
}

fn infeasible(am: f64, phi: f64, filter: f64, grid: &[(f64, f64)]) -> (String, Vec<Specification>) {
    let pair = |am: f64, phi: f64| Specification {
        gain_margin: Some(am),
        phase_margin: Some(phi),
        ..Specification::default()
    };
    if filter > 0.0 {
        let phases = grid.iter().map(|(_, error)| error + phi);
        let (low, high) = phases.fold((PI, -PI), |(low, high), p| (p.min(low), p.max(high)));
        let reason = format!(
            "with gain margin {am} and this filter the phase margin is between {:.4}° and {:.4}°",
            low.to_degrees(),
            high.to_degrees()
        );
        return (reason, vec![pair(am, phi.clamp(low, high))]);
    }
    let (low, high) = (FRAC_PI_2 * (1.0 - 1.0 / am), FRAC_PI_2 + (1.0 / am).asin());
    let reason = format!(
        "with gain margin {am} the phase margin is at least {:.4}° and below {:.4}°",
        low.to_degrees(),
        high.to_degrees()
    );
    let mut nearest = Vec::new();
    if phi < low {
        nearest.push(pair(am, low));
        if phi > 0.0 {
            // The gain margin whose lower limit is this phase margin: P control.
            nearest.push(pair(1.0 / (1.0 - phi / FRAC_PI_2), phi));
        }
    } else {
        // The upper limit is never reached: a ten-thousandth of the way is left to it.
        nearest.push(pair(am, high - 1e-4 * (high - low)));
        if phi < PI {
            nearest.push(pair(1.0 + (1.0 / (phi - FRAC_PI_2).sin() - 1.0) * (1.0 - 1e-4), phi));
        }
    }
    (reason, nearest)
}
