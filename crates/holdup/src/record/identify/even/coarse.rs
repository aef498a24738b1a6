//! The best dead time among all, from coarse to fine.
//!
//! The product of the response y with the input's integral k rows earlier is p(k) = Σ_j Δu_j·R(j + k), where Δu_j is the
//! input's move at row j and R(m) the product of y with a ramp that starts at row m. Its second difference in k is
//! Σ_j Δu_j·y_(j+k), at most B = min(Σ|Δu|·max|y|, ‖Δu‖·‖y‖) in size. On a grid of h rows, with every move shared between the
//! two places next to it, p is therefore off by at most B·h²/8 at the places of the grid, and between them by as much
//! again from a straight line: what cannot be the best by these bounds is not looked at closer.

use super::moves::{Move, shared};
use super::own::Own;
use super::running::every_fourth;
use super::sums::products;

/// Rows between the places of the coarsest grid.
const COARSEST: usize = 16;

/// Places that a grid has at least: fewer would not be worth the pass.
const PLACES: usize = 8;

/// Rounding of the products against the best of them: sums over the rows lose five digits at most.
const ROUNDING: f64 = 1e-11;

/// One grid: moves and ramps every `rows` rows.
struct Grid {
    rows: usize,
    moves: Vec<Move>,
    ramps: Vec<f64>,
}

/// The best delay, and the share of a row beyond it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Best {
    pub(super) delay: usize,
    pub(super) share: f64,
}

/// The best of all delays; `bend` bounds the second difference of the products.
pub(super) fn best(moves: Vec<Move>, ramps: Vec<f64>, own: &Own, bend: f64) -> Option<Best> {
    let delays = own.neighbour.len();
    let mut grids = vec![Grid { rows: 1, moves, ramps }];
    while let Some(Grid { rows, moves, ramps }) = grids.last()
        && *rows < COARSEST
        && rows * 4 * PLACES <= delays
    {
        let coarser = Grid { rows: 4 * rows, moves: shared(moves), ramps: every_fourth(ramps) };
        grids.push(coarser);
    }
    // Lags that are left, in runs from one to another.
    let mut runs = vec![(0, delays)];
    while let Some(grid) = grids.pop() {
        if grids.is_empty() {
            return finest(&grid, &runs, own);
        }
        runs = narrowed(&grid, &runs, own, bend);
    }
    None
}

/// What is left of the runs: every piece of the grid that may hold a better one than the best that is sure.
#[expect(clippy::cast_precision_loss, reason = "a few rows")]
fn narrowed(grid: &Grid, runs: &[(usize, usize)], own: &Own, bend: f64) -> Vec<(usize, usize)> {
    let delays = own.neighbour.len();
    let off = bend * (grid.rows * grid.rows) as f64 / 8.0;
    let mut sure = 0.0_f64;
    let mut pieces = Vec::new();
    for &(from, to) in runs {
        let first = from / grid.rows;
        let values = products(&grid.moves, &grid.ramps, first, to.div_ceil(grid.rows) - first + 1);
        for (k, pair) in values.windows(2).enumerate() {
            let start = (first + k) * grid.rows;
            let end = (start + grid.rows).min(delays);
            let (least, most) = (pair[0].abs() - off, pair[0].abs().max(pair[1].abs()) + 2.0 * off);
            if least > 0.0 && own.squares[start] > own.floor {
                sure = sure.max(least * least / own.squares[start]);
            }
            pieces.push((start, end, most * most, own.least(start, end)));
        }
    }
    let sure = sure * (1.0 - ROUNDING);
    let mut left: Vec<(usize, usize)> = Vec::new();
    for (start, end, most, squares) in pieces {
        // Where the integral may vanish, anything is possible.
        if squares > own.floor && most < sure * squares {
            continue;
        }
        match left.last_mut() {
            Some((_, last)) if *last == start => *last = end,
            _ => left.push((start, end)),
        }
    }
    left
}

/// The best of these runs, every piece between two delays exactly.
fn finest(grid: &Grid, runs: &[(usize, usize)], own: &Own) -> Option<Best> {
    let mut best: Option<(f64, Best)> = None;
    for &(from, to) in runs {
        let values = products(&grid.moves, &grid.ramps, from, to - from + 1);
        for (k, pair) in values.windows(2).enumerate() {
            let delay = from + k;
            let (left, right, cross) = (own.squares[delay], own.squares[delay + 1], own.neighbour[delay]);
            let (c, b) = (pair[0], pair[1] - pair[0]);
            let (e, g) = (cross - left, left - 2.0 * cross + right);
            // The stationary point of (c + b·f)²/(left + 2·e·f + g·f²).
            let f = ((c * e - b * left) / (b * e - c * g)).clamp(0.0, 1.0);
            for share in [0.0, if f.is_nan() { 1.0 } else { f }, 1.0] {
                let squares = left + share * (2.0 * e + share * g);
                let with = c + b * share;
                if squares > own.floor && with * with > squares * best.map_or(0.0, |(score, _)| score) {
                    best = Some((with * with / squares, Best { delay, share }));
                }
            }
        }
    }
    best.map(|(_, best)| best)
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::super::moves::moves;
    use super::super::running::{cumulate, ramps};
    use super::super::sums::{less, line};
    use super::*;

    /// Nothing that is left out was the best: the search from coarse to fine gives what all delays give, with responses that
    /// follow the input and with responses that have nothing to do with it.
    #[test]
    fn the_best_of_all_lags_is_found() {
        let mut random = ChaCha8Rng::seed_from_u64(3);
        for case in 0..60 {
            let (rows, delays): (usize, usize) = (random.random_range(200..900), random.random_range(1..190));
            let chance = [0.02, 0.2, 1.0][case % 3];
            let mut value = 3.0;
            let input: Vec<f64> = (0..rows)
                .map(|_| {
                    if random.random_range(0.0..1.0) < chance {
                        value = random.random_range(-1.0..1.0);
                    }
                    value
                })
                .collect();
            let mut integral = vec![0.0; rows + delays];
            for (k, value) in integral[..delays].iter_mut().enumerate() {
                *value = input[0]
                    * (f64::from(u32::try_from(k).unwrap()) - f64::from(u32::try_from(delays).unwrap()));
            }
            cumulate(&input, 0.0, &mut integral[delays..]);
            let delay = random.random_range(0..=delays);
            let share = if case % 2 == 0 { 0.0 } else { 0.3 };
            let output: Vec<f64> = integral[delays - delay..][..rows]
                .iter()
                .map(|v| share * v + random.random_range(-1.0..1.0))
                .collect();
            let (response, squares, greatest) = less(&output, line(&output));
            let moves = moves(&input);
            let own = Own::new(&integral, &input, 0.0, delays);
            let sizes = moves.iter().map(|(_, size)| size.abs()).sum::<f64>();
            let of_moves = moves.iter().map(|(_, size)| size * size).sum::<f64>();
            let bend = (sizes * greatest).min((of_moves * squares).sqrt());
            let grid = Grid { rows: 1, moves: moves.clone(), ramps: ramps(&response, delays) };
            let all = finest(&grid, &[(0, delays)], &own);
            assert!(all.is_some());
            assert_eq!(best(moves, ramps(&response, delays), &own, bend), all, "case {case}");
        }
    }
}
