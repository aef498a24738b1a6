//! The least value on the unit cube of a function with kinks: where two peaks are equally high, the value has one.
//!
//! Simplex search (J. A. Nelder and R. Mead, Computer J. 7, 1965, 308–313) is quick, but its simplex may collapse on a kink
//! before the end of it. So where it has become small a quasi-Newton search goes on, then the descent out of all gradients
//! nearby is asked for, and the simplex starts again from there, until there is none.

use super::kink::descend;
use super::quasi_newton::follow;
use crate::tuning::line::least;

/// A value on the unit cube.
pub(super) type Value<'a> = dyn FnMut(&[f64]) -> f64 + 'a;

/// Relative gain of a search below which the next is the last, as a part of the size at which a search ends.
const GAIN: f64 = 1e-2;
/// A simplex as small as this part of what it was has done its work.
const COARSE: f64 = 1e-2;
/// Least and most over which differences are taken: rounding against curvature.
const LEAST: f64 = 1e-7;
const MOST: f64 = 1e-5;
/// Steps of one search and searches in a row.
const STEPS: usize = 120;
const SEARCHES: usize = 12;

/// The least value found from a start, and where. The first simplex is of this size; a search ends when it is as small as
/// `finest`.
pub(super) fn minimise(start: &[f64], size: f64, finest: f64, value: &mut Value) -> (Vec<f64>, f64) {
    match start {
        [] => return (Vec::new(), value(start)),
        [start] => return along(*start, size, finest, value),
        _ => {}
    }
    let mut best = (start.to_vec(), value(start));
    let mut size = size;
    for _ in 0..SEARCHES {
        let before = best.1;
        let found = search(&best.0, size, finest.max(COARSE * size), value);
        if found.1 < best.1 {
            best = found;
        }
        // Nothing finite about the start: nothing to follow.
        if !best.1.is_finite() {
            break;
        }
        let from = best.0.clone();
        best = follow(best, (0.1 * finest).clamp(LEAST, MOST), value);
        best = descend(best, finest, value);
        let moved = from.iter().zip(&best.0).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if before - best.1 <= GAIN * finest * best.1.abs() || moved == 0.0 {
            break;
        }
        size = (2.0 * moved).clamp(10.0 * finest, size);
    }
    best
}

/// One variable: a bracket about the start, then its least value.
fn along(start: f64, size: f64, finest: f64, value: &mut Value) -> (Vec<f64>, f64) {
    let mut at = |x: f64| value(&[x]);
    let (mut middle, mut here) = (start, at(start));
    let (mut low, mut high) = ((start - size).max(0.0), (start + size).min(1.0));
    let (mut below, mut above) = (at(low), at(high));
    while below.min(above) < here {
        if below < above {
            (high, above) = (middle, here);
            (middle, here) = (low, below);
            low = (middle - size).max(0.0);
            below = if low < middle { at(low) } else { f64::INFINITY };
        } else {
            (low, below) = (middle, here);
            (middle, here) = (high, above);
            high = (middle + size).min(1.0);
            above = if high > middle { at(high) } else { f64::INFINITY };
        }
    }
    let found = least(low, high, finest, &mut at);
    if found.1 < here { (vec![found.0], found.1) } else { (vec![middle], here) }
}

/// The simplex search alone, until it is as small as `finest`.
pub(super) fn search(start: &[f64], size: f64, finest: f64, value: &mut Value) -> (Vec<f64>, f64) {
    let count = start.len();
    let inside = |point: Vec<f64>| -> Vec<f64> { point.into_iter().map(|x| x.clamp(0.0, 1.0)).collect() };
    let mut corners: Vec<(Vec<f64>, f64)> = vec![(start.to_vec(), value(start))];
    for index in 0..count {
        let mut corner = start.to_vec();
        corner[index] += if corner[index] + size > 1.0 { -size } else { size };
        let corner = inside(corner);
        let at = value(&corner);
        corners.push((corner, at));
    }
    for _ in 0..STEPS {
        corners.sort_by(|a, b| a.1.total_cmp(&b.1));
        let spread =
            (0..count).map(|axis| (corners[count].0[axis] - corners[0].0[axis]).abs()).fold(0.0, f64::max);
        if spread < finest {
            break;
        }
        let centre: Vec<f64> = (0..count)
            .map(|axis| corners[..count].iter().map(|corner| corner.0[axis]).sum::<f64>() / as_f64(count))
            .collect();
        let mut along = |factor: f64| {
            let point = (0..count).map(|i| centre[i] + factor * (centre[i] - corners[count].0[i])).collect();
            let point = inside(point);
            let at = value(&point);
            (point, at)
        };
        let reflected = along(1.0);
        let next = if reflected.1 < corners[0].1 {
            let expanded = along(2.0);
            if expanded.1 < reflected.1 { Some(expanded) } else { Some(reflected) }
        } else if reflected.1 < corners[count - 1].1 {
            Some(reflected)
        } else {
            let contracted = if reflected.1 < corners[count].1 { along(0.5) } else { along(-0.5) };
            (contracted.1 < corners[count].1.min(reflected.1)).then_some(contracted)
        };
        if let Some(next) = next {
            corners[count] = next;
        } else {
            let first = corners[0].0.clone();
            for corner in &mut corners[1..] {
                corner.0 = first.iter().zip(&corner.0).map(|(a, b)| f64::midpoint(*a, *b)).collect();
                corner.1 = value(&corner.0);
            }
        }
    }
    corners.sort_by(|a, b| a.1.total_cmp(&b.1));
    corners.swap_remove(0)
}

#[expect(clippy::cast_precision_loss, reason = "a handful of variables")]
fn as_f64(count: usize) -> f64 {
    count as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The greater of two planes and a bowl: the least value 0 is at (0.3, 0.7), on the kink.
    fn valley(x: &[f64]) -> f64 {
        let (u, v) = (x[0] - 0.3, x[1] - 0.7);
        (u + v).abs() * 3.0 + u * u + 0.5 * v * v
    }

    #[test]
    fn a_valley_with_a_kink_is_followed_to_its_end() {
        for start in [[0.9, 0.1], [0.5, 0.5], [0.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
            let mut count = 0;
            let (at, least) = minimise(&start, 0.2, 1e-9, &mut |x| {
                count += 1;
                valley(x)
            });
            assert!(least < 1e-8, "{start:?}: {at:?} {least} {count}");
        }
    }

    #[test]
    fn a_bent_kink_of_three_variables_is_followed_to_its_end() {
        // The greater of two, on a bent surface; the least value on it is 0, at (0.4, 0.16, 0.5).
        let value = |x: &[f64]| {
            let along = (x[0] - 0.4).powi(2) + (x[2] - 0.5).powi(2) * 0.3;
            along + (x[1] - x[0] * x[0]).abs() * 2.0
        };
        for start in [[0.9, 0.1, 0.1], [0.1, 0.9, 0.9], [0.0, 0.0, 0.0]] {
            let (at, least) = minimise(&start, 0.12, 1e-7, &mut |x| value(x));
            assert!(least < 1e-7, "{start:?}: {at:?} {least}");
        }
    }

    #[test]
    fn one_variable_is_searched_to_a_kink_and_to_an_end() {
        let (at, _) = minimise(&[0.9], 0.12, 1e-9, &mut |x| (x[0] - 0.2).abs());
        assert!((at[0] - 0.2).abs() < 1e-8, "{at:?}");
        assert_eq!(minimise(&[0.5], 0.12, 1e-9, &mut |x| x[0]).0, [0.0]);
    }

    #[test]
    fn the_end_of_the_cube_is_reached() {
        let (at, _) = minimise(&[0.4, 0.4], 0.2, 1e-9, &mut |x| x[0] - x[1]);
        assert_eq!(at, [0.0, 1.0]);
    }
}
