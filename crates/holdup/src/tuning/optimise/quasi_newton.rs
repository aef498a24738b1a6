//! Down along kinks with a matrix that learns them: BFGS with a weak Wolfe search (A. S. Lewis and M. L. Overton, Math.
//! Program. 141, 2013, 135–163).
//!
//! The matrix grows flat across a kink and long along it, so that steps end on it and yet lead on.

use super::simplex::Value;

/// Steps, and trials along a line.
const STEPS: usize = 60;
const TRIALS: usize = 20;
/// Of the promised fall this part is asked for; and the slope is to rise to this part of what it was.
const FALL: f64 = 1e-4;
const SLOPE: f64 = 0.5;
/// Relative gain of a step that counts, and steps in a row without one that end the search.
const GAIN: f64 = 1e-11;
const IDLE: usize = 4;
/// Length of the first step.
const FIRST: f64 = 1e-2;

/// A point and its value.
type Place = (Vec<f64>, f64);

/// Goes down from a point; differences are taken over `step`.
pub(super) fn follow(from: Place, step: f64, value: &mut Value) -> Place {
    let count = from.0.len();
    let mut best = from;
    let Some(mut gradient) = slopes(&best, step, value) else { return best };
    let mut matrix = unit(count, FIRST / norm(&gradient));
    let mut idle = 0;
    for _ in 0..STEPS {
        let mut way: Vec<f64> = matrix.iter().map(|row| -dot(row, &gradient)).collect();
        // What leads out of the cube is left out.
        for (part, x) in way.iter_mut().zip(&best.0) {
            if (*part < 0.0 && *x <= 0.0) || (*part > 0.0 && *x >= 1.0) {
                *part = 0.0;
            }
        }
        let slope = dot(&way, &gradient);
        if slope >= 0.0 || !slope.is_finite() {
            break;
        }
        let Some((next, after)) = search(&best, &way, (slope, step), value) else { break };
        let moved: Vec<f64> = next.0.iter().zip(&best.0).map(|(a, b)| a - b).collect();
        let turned: Vec<f64> = after.iter().zip(&gradient).map(|(a, b)| a - b).collect();
        idle = if best.1 - next.1 > GAIN * best.1.abs() { 0 } else { idle + 1 };
        (best, gradient) = (next, after);
        if idle >= IDLE {
            break;
        }
        learn(&mut matrix, &moved, &turned);
    }
    best
}

/// The gradient by differences, inwards at the upper end; `None` where it is no number.
fn slopes(at: &Place, step: f64, value: &mut Value) -> Option<Vec<f64>> {
    let slope = |axis: usize| {
        let mut point = at.0.clone();
        let side = if point[axis] + step > 1.0 { -step } else { step };
        point[axis] += side;
        (value(&point) - at.1) / side
    };
    let list: Vec<f64> = (0..at.0.len()).map(slope).collect();
    list.iter().all(|part| part.is_finite()).then_some(list)
}

/// A point along the way that is lower and where it falls less steeply, with its gradient; by halving and doubling. Where
/// none falls less steeply, the lowest.
fn search(
    from: &Place,
    way: &[f64],
    (slope, step): (f64, f64),
    value: &mut Value,
) -> Option<(Place, Vec<f64>)> {
    let (mut low, mut high, mut length) = (0.0, f64::INFINITY, 1.0);
    let mut lowest = None;
    for _ in 0..TRIALS {
        let point: Vec<f64> =
            from.0.iter().zip(way).map(|(x, part)| (x + length * part).clamp(0.0, 1.0)).collect();
        if point == from.0 {
            break;
        }
        let here = (point.clone(), value(&point));
        if here.1 < from.1 + FALL * length * slope {
            let gradient = slopes(&here, step, value)?;
            let steep = dot(&gradient, way) < SLOPE * slope;
            lowest = Some((here, gradient));
            if !steep {
                break;
            }
            low = length;
        } else {
            high = length;
        }
        length = if high.is_finite() { f64::midpoint(low, high) } else { 2.0 * length };
    }
    lowest
}

/// The update of the inverse of the second derivatives.
fn learn(matrix: &mut [Vec<f64>], moved: &[f64], turned: &[f64]) {
    let along = dot(moved, turned);
    if along <= 1e-14 * norm(moved) * norm(turned) {
        return;
    }
    let image: Vec<f64> = matrix.iter().map(|row| dot(row, turned)).collect();
    let scale = (1.0 + dot(turned, &image) / along) / along;
    for (i, row) in matrix.iter_mut().enumerate() {
        for (j, cell) in row.iter_mut().enumerate() {
            *cell += scale * moved[i] * moved[j] - (image[i] * moved[j] + moved[i] * image[j]) / along;
        }
    }
}

fn unit(count: usize, scale: f64) -> Vec<Vec<f64>> {
    let row = |i: usize| (0..count).map(|j| if i == j { scale } else { 0.0 }).collect();
    (0..count).map(row).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt().max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_narrow_bent_valley_with_a_kink_is_followed_to_its_end() {
        // Nesterov's version of the function of Rosenbrock, on [0, 1]²: 0 at (0.7, 0.49).
        let mut count = 0;
        let mut value = |x: &[f64]| {
            count += 1;
            0.25 * (x[0] - 0.7).powi(2) + (x[1] - x[0] * x[0]).abs()
        };
        let start = vec![0.1, 0.9];
        let first = value(&start);
        let (at, least) = follow((start, first), 1e-8, &mut value);
        // From 0.97, in the steps that a search has; each makes it smaller by a part.
        assert!(least < 1e-5, "{at:?} {least} {count}");
    }

    #[test]
    fn a_smooth_bowl_is_found_to_the_square_root_of_rounding() {
        let mut value = |x: &[f64]| 1.0 + (x[0] - 0.2).powi(2) + 7.0 * (x[1] - x[0] - 0.3).powi(2);
        let (at, _) = follow((vec![0.9, 0.9], value(&[0.9, 0.9])), 1e-7, &mut value);
        assert!((at[0] - 0.2).abs() < 1e-5 && (at[1] - 0.5).abs() < 1e-5, "{at:?}");
    }

    #[test]
    fn at_the_end_of_the_cube_the_other_variables_go_on() {
        let mut value = |x: &[f64]| 2.0 - x[0] + (x[1] - 0.4).powi(2);
        let (at, _) = follow((vec![0.5, 0.9], value(&[0.5, 0.9])), 1e-7, &mut value);
        assert!(at[0] == 1.0 && (at[1] - 0.4).abs() < 1e-5, "{at:?}");
    }
}
