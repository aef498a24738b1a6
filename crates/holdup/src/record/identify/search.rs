//! The dead time, found globally.
//!
//! On an even grid with a held input the column of the integrating process is a straight line in the dead time between
//! two multiples of the sample period: v = (1 − f)·v_k + f·v_(k+1). The sum of squares that it leaves is then a ratio of
//! quadratics in f whose stationary point solves a linear equation, and so the best of each piece is known exactly. For
//! other inputs, kinds and grids the pieces are searched at both ends and in their middle. The best few are polished by
//! variable projection (G. H. Golub and V. Pereyra, SIAM J. Numer. Anal. 10 (1973) 413; the step is that of
//! L. Kaufman, BIT 15 (1975) 49).

use super::input::Shape;
use super::problem::{Fit, Whitened};
use super::squares::{Basis, dot, solve};

/// Most dead times that are tried in a first pass.
const TRIED: usize = 2000;

/// Most dead times that are tried for each lag.
const TRIED_WITH_LAG: usize = 40;

/// Lags that are tried, evenly on a logarithmic scale.
const LAGS: u32 = 14;

/// How many local best ones are polished.
const POLISHED: usize = 4;

/// Dead times from 0 to `greatest` that are tried: multiples of the step, or fewer where they would be too many.
fn grid(step: f64, greatest: f64, most: usize) -> Vec<f64> {
    #[expect(clippy::cast_precision_loss, reason = "at most a few thousand")]
    let stride = (greatest / step / most as f64).ceil().max(1.0) * step;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most a few thousand")]
    let count = (greatest / stride).floor() as u32;
    let mut tried: Vec<f64> = (0..=count).map(|k| f64::from(k) * stride).collect();
    if tried.last().is_some_and(|last| greatest - last > 1e-9 * stride) {
        tried.push(greatest);
    }
    tried
}

/// The best dead time from 0 to `greatest`, and the best lag.
pub(crate) fn search(whitened: &Whitened<'_, '_>, step: f64, greatest: f64) -> Option<Fit> {
    let starts = if whitened.kind.has_lag() {
        with_lag(whitened, step, greatest)
    } else {
        let (basis, response) = whitened.rest(1.0);
        along(whitened, &basis, &response, 1.0, &grid(step, greatest, TRIED))
    };
    let polished = starts.into_iter().map(|start| polish(whitened, start, greatest, true));
    polished.min_by(|a, b| a.squares.total_cmp(&b.squares)).filter(|fit| fit.column_squares > 0.0)
}

/// The best few local ones over dead time and lag.
fn with_lag(whitened: &Whitened<'_, '_>, step: f64, greatest: f64) -> Vec<Fit> {
    let span = whitened.problem.span();
    let (least, most) = (step / 2.0, 3.0 * span);
    let tried = grid(step, greatest, TRIED_WITH_LAG);
    let mut found: Vec<Fit> = (0..LAGS)
        .flat_map(|k| {
            let lag = least * (most / least).powf(f64::from(k) / f64::from(LAGS - 1));
            let (basis, response) = whitened.rest(lag);
            along(whitened, &basis, &response, lag, &tried).into_iter().take(2).collect::<Vec<_>>()
        })
        .collect();
    found.sort_by(|a, b| a.squares.total_cmp(&b.squares));
    found.truncate(POLISHED);
    found
}

/// The best few local ones along these dead times, by sums of products only.
fn along(whitened: &Whitened<'_, '_>, basis: &Basis, response: &[f64], lag: f64, tried: &[f64]) -> Vec<Fit> {
    let shape = whitened.kind.shape(lag);
    let total = dot(response, response);
    let mut found: Vec<Fit> = Vec::new();
    let mut before: Option<(f64, Vec<f64>, [f64; 2])> = None;
    // Squares left at each dead time tried, to tell the local best ones.
    let mut left: Vec<Fit> = Vec::new();
    for &dead_time in tried {
        let (column, own) = basis.outside(whitened.column(shape, dead_time));
        let with = dot(&column, response);
        let fit = |dead_time: f64, with: f64, own: f64| Fit {
            kind: whitened.kind,
            dead_time,
            lag,
            gain: if own > 0.0 { with / own } else { 0.0 },
            squares: if own > 0.0 { total - with * with / own } else { total },
            column_squares: own,
        };
        left.push(fit(dead_time, with, own));
        if let Some((earlier, last, [last_own, last_with])) = &before
            && shape == Shape::Integral
        {
            // f of the stationary point of (c0 + b·f)²/(a0 + 2·e·f + g·f²).
            let (cross, b) = (dot(last, &column), with - last_with);
            let (e, g) = (cross - last_own, last_own - 2.0 * cross + own);
            let f = (last_with * e - b * last_own) / (b * e - last_with * g);
            if f > 0.0 && f < 1.0 {
                let between = fit(
                    earlier + f * (dead_time - earlier),
                    last_with + b * f,
                    last_own + f * (2.0 * e + f * g),
                );
                left.push(between);
                let last = left.len() - 1;
                left.swap(last - 1, last);
            }
        }
        before = Some((dead_time, column, [own, with]));
    }
    for (k, fit) in left.iter().enumerate() {
        let lower = |other: Option<&Fit>| other.is_none_or(|other| fit.squares <= other.squares);
        if lower(k.checked_sub(1).and_then(|k| left.get(k))) && lower(left.get(k + 1)) {
            found.push(*fit);
        }
    }
    found.sort_by(|a, b| a.squares.total_cmp(&b.squares));
    found.truncate(POLISHED);
    found
}

/// Gauss–Newton steps on the dead time (unless it is kept) and the lag, each taken only if it lowers the squares.
pub(crate) fn polish(whitened: &Whitened<'_, '_>, start: Fit, greatest: f64, free: bool) -> Fit {
    let mut best = whitened.at(start.dead_time, start.lag);
    for _ in 0..60 {
        let Some(step) = gauss_newton(whitened, &best, free) else { break };
        let mut factor = 1.0;
        let mut better = None;
        while factor > 1e-3 {
            let dead_time = (best.dead_time + factor * step[0]).clamp(0.0, greatest);
            let lag = if whitened.kind.has_lag() {
                (best.lag + factor * step[1]).clamp(best.lag / 4.0, best.lag * 4.0)
            } else {
                best.lag
            };
            let next = whitened.at(dead_time, lag);
            if next.squares < best.squares {
                better = Some(next);
                break;
            }
            factor *= 0.4;
        }
        let Some(next) = better else { break };
        let done = best.squares - next.squares <= 1e-13 * best.squares;
        best = next;
        if done {
            break;
        }
    }
    best
}

/// The Gauss–Newton step of dead time and lag.
fn gauss_newton(whitened: &Whitened<'_, '_>, at: &Fit, free: bool) -> Option<[f64; 2]> {
    let (mut basis, response) = whitened.rest(at.lag);
    let shape = whitened.kind.shape(at.lag);
    let column = whitened.column(shape, at.dead_time);
    let bare = basis.projected(column.clone());
    let residual: Vec<f64> = response.iter().zip(&bare).map(|(y, v)| y - at.gain * v).collect();
    if !basis.add(column) {
        return None;
    }
    let mut slopes = Vec::new();
    if free {
        let mut slope = whitened.column(shape.rate(), at.dead_time);
        for value in &mut slope {
            *value *= -at.gain;
        }
        slopes.push(basis.projected(slope));
    }
    if whitened.kind.has_lag() {
        // Central difference: its error only slows the last steps.
        let change = 1e-4 * at.lag;
        let more = whitened.column(whitened.kind.shape(at.lag + change), at.dead_time);
        let less = whitened.column(whitened.kind.shape(at.lag - change), at.dead_time);
        let slope = more.iter().zip(&less).map(|(a, b)| at.gain * (a - b) / (2.0 * change)).collect();
        slopes.push(basis.projected(slope));
    }
    let normal = slopes.iter().map(|a| slopes.iter().map(|b| dot(a, b)).collect()).collect();
    let right = slopes.iter().map(|a| dot(a, &residual)).collect();
    let step = solve(normal, right)?;
    if step.iter().any(|value| !value.is_finite()) {
        return None;
    }
    Some(match (free, whitened.kind.has_lag()) {
        (true, true) => [step[0], step[1]],
        (true, false) => [step[0], 0.0],
        (false, true) => [0.0, step[0]],
        (false, false) => [0.0, 0.0],
    })
}
