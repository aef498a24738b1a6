//! How strong each part of the noise is: restricted maximum likelihood over the four strengths and the correlation time.

use super::noise::{Noise, restricted_likelihood};

/// Steps of the simplex search: enough to settle the logarithm of a strength to some percent, which is far below what the
/// record itself says about it.
const STEPS: usize = 110;

/// Below this logarithm of a ratio of variances a part is absent.
const ABSENT: [f64; 4] = [-7.0, 0.0, -14.0, -22.0];

/// Above this the white part no longer matters.
const MOST: [f64; 4] = [8.0, 0.0, 10.0, 10.0];

/// The coordinates of the search: logarithms of the variances over the white one, and of the correlation time.
#[derive(Debug, Clone, Copy)]
struct Coordinates {
    /// Mean distance of rows [s].
    step: f64,
    /// Least and greatest logarithm of the correlation time over the step.
    time: [f64; 2],
}

impl Coordinates {
    fn noise(&self, at: &[f64; 4]) -> Noise {
        let strength = |k: usize, unit: f64| {
            if at[k] <= ABSENT[k] { 0.0 } else { (at[k].min(MOST[k]) / 2.0).exp() / unit }
        };
        Noise {
            white: 1.0,
            coloured: strength(0, 1.0),
            correlation_time: at[1].clamp(self.time[0], self.time[1]).exp() * self.step,
            walk: strength(2, self.step.sqrt()),
            wander: strength(3, self.step * self.step.sqrt()),
        }
    }

    fn at(&self, noise: &Noise) -> [f64; 4] {
        let log = |k: usize, strength: f64, unit: f64| {
            let ratio = strength * unit / noise.white;
            if ratio > 0.0 { (2.0 * ratio.ln()).clamp(ABSENT[k], MOST[k]) } else { ABSENT[k] }
        };
        [
            log(0, noise.coloured, 1.0),
            (noise.correlation_time / self.step).ln().clamp(self.time[0], self.time[1]),
            log(2, noise.walk, self.step.sqrt()),
            log(3, noise.wander, self.step * self.step.sqrt()),
        ]
    }
}

/// The noise that explains the response beside the columns best, and ln of its restricted likelihood. The search starts
/// from `near` where it is given, else from the best of a few noises of one part.
pub(crate) fn estimate(
    times: &[f64],
    columns: &[Vec<f64>],
    response: &[f64],
    near: Option<&Noise>,
) -> (Noise, f64) {
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let rows = times.len() as f64;
    let step = (times[times.len() - 1] - times[0]) / (rows - 1.0);
    // A correlation over more than a sixth of the record cannot be told from a random walk.
    let coordinates = Coordinates { step, time: [0.3f64.ln(), (rows / 6.0).max(1.0).ln()] };
    let cost =
        |at: &[f64; 4]| -> f64 { -restricted_likelihood(&coordinates.noise(at), times, columns, response).0 };
    let mut best = near.map_or_else(
        || {
            let absent = [ABSENT[0], 1.0, ABSENT[2], ABSENT[3]];
            let mut tried = vec![absent];
            for ratio in [-1.0, 2.0, 6.0] {
                tried.extend([0.0, 1.4, 2.8].map(|time| [ratio, time, absent[2], absent[3]]));
            }
            tried.extend([-9.0, -6.0, -3.0, 0.0, 4.0].map(|walk| [absent[0], 1.0, walk, absent[3]]));
            tried.extend([-17.0, -13.0, -9.0, -5.0, 0.0].map(|w| [absent[0], 1.0, absent[2], w]));
            let costs = tried.into_iter().map(|at| (cost(&at), at));
            costs.min_by(|a, b| a.0.total_cmp(&b.0)).map_or(absent, |(_, at)| at)
        },
        |noise| coordinates.at(noise),
    );
    let least = simplex(&cost, &mut best);
    let noise = coordinates.noise(&best);
    let (_, strength) = restricted_likelihood(&noise, times, columns, response);
    (noise.scaled(strength), -least)
}

/// Minimises by the simplex of J. A. Nelder and R. Mead, Computer J. 7 (1965) 308; returns the least value.
fn simplex(cost: &dyn Fn(&[f64; 4]) -> f64, start: &mut [f64; 4]) -> f64 {
    // An absent part comes in at a strength where it begins to matter.
    let entering = [-1.5, 0.0, -7.0, -13.0];
    let mut corners: Vec<(f64, [f64; 4])> = vec![(cost(start), *start)];
    for k in 0..4 {
        let mut corner = *start;
        corner[k] = match k {
            1 => corner[k] + 0.8,
            _ if corner[k] <= entering[k] - 1.0 => entering[k],
            _ => corner[k] - 1.5,
        };
        corners.push((cost(&corner), corner));
    }
    for _ in 0..STEPS {
        corners.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Two thousandths of a unit of log-likelihood change no interval.
        if corners[4].0 - corners[0].0 < 2e-3 {
            break;
        }
        let middle: [f64; 4] =
            std::array::from_fn(|k| corners[..4].iter().map(|(_, at)| at[k]).sum::<f64>() / 4.0);
        let worst = corners[4];
        let along = |factor: f64| {
            let at: [f64; 4] = std::array::from_fn(|k| {
                let at = middle[k] + factor * (worst.1[k] - middle[k]);
                if k == 1 { at } else { at.clamp(ABSENT[k], MOST[k]) }
            });
            (cost(&at), at)
        };
        let reflected = along(-1.0);
        corners[4] = if reflected.0 < corners[0].0 {
            let expanded = along(-2.0);
            if expanded.0 < reflected.0 { expanded } else { reflected }
        } else if reflected.0 < corners[3].0 {
            reflected
        } else {
            let contracted = along(if reflected.0 < worst.0 { -0.5 } else { 0.5 });
            if contracted.0 < worst.0.min(reflected.0) {
                contracted
            } else {
                let best = corners[0].1;
                for corner in &mut corners[1..] {
                    corner.1 = std::array::from_fn(|k| 0.5 * (corner.1[k] + best[k]));
                    corner.0 = cost(&corner.1);
                }
                continue;
            }
        };
    }
    corners.sort_by(|a, b| a.0.total_cmp(&b.0));
    *start = corners[0].1;
    corners[0].0
}
