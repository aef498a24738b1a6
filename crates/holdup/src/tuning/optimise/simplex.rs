//! Simplex search (J. A. Nelder and R. Mead, Computer J. 7, 1965, 308–313) on the unit cube, started again where it ended
//! until that gains nothing: the value has kinks where two peaks are equally high.

/// Relative gain of a new start below which the search ends.
const GAIN: f64 = 1e-8;
/// Steps of one search and searches in a row.
const STEPS: usize = 120;
const SEARCHES: usize = 3;

/// The least value found from a start, and where; a search ends when the simplex is as small as `finest`.
pub(super) fn minimise(
    start: &[f64],
    size: f64,
    finest: f64,
    value: &(dyn Fn(&[f64]) -> f64 + Sync),
) -> (Vec<f64>, f64) {
    let mut best = (start.to_vec(), value(start));
    let mut size = size;
    for _ in 0..SEARCHES {
        let found = search(&best.0, size, finest, value);
        let gained = best.1 - found.1;
        // Where nothing finite is found, nothing is gained.
        let goes_on = gained > GAIN * found.1.abs();
        if found.1 < best.1 {
            best = found;
        }
        if !goes_on {
            break;
        }
        size *= 0.3;
    }
    best
}

fn search(start: &[f64], size: f64, finest: f64, value: &(dyn Fn(&[f64]) -> f64 + Sync)) -> (Vec<f64>, f64) {
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
        let along = |factor: f64| {
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

    #[test]
    fn a_valley_with_a_kink_is_followed_to_its_end() {
        // The greater of two planes and a bowl: the least value 0 is at (0.3, 0.7), on the kink.
        let value = |x: &[f64]| {
            let (u, v) = (x[0] - 0.3, x[1] - 0.7);
            (u + v).abs() * 3.0 + u * u + 0.5 * v * v
        };
        // From a corner of the cube it may end in another one: that is why the optimum is searched from many starts.
        for start in [[0.9, 0.1], [0.5, 0.5]] {
            let (at, least) = minimise(&start, 0.2, 1e-9, &value);
            assert!(least < 1e-6, "{start:?}: {at:?} {least}"); // a simplex may collapse on the kink before its end
        }
    }

    #[test]
    fn the_end_of_the_cube_is_reached() {
        let (at, _) = minimise(&[0.4, 0.4], 0.2, 1e-9, &|x: &[f64]| x[0] - x[1]);
        assert_eq!(at, [0.0, 1.0]);
    }
}
