//! The integrating process fitted to even rows, where noise is white: every dead time weighed, the few that can be best
//! computed.
//!
//! Each function takes one pass over the rows, several rows side by side (`sums`, `running`, `moves`); `coarse` finds the
//! delay, `own` says what the input's integral is at each.

mod coarse;
mod moves;
mod own;
mod running;
mod sums;

use coarse::{Best, best};
use moves::moves;
use own::Own;
use running::{cumulate, ramps};
use sums::{Columns, less, line};

pub(super) use sums::are_even;

/// Share of the response below which what is left is summed row by row: above it the difference of two sums keeps
/// twelve digits.
const SMALL: f64 = 1e-3;

/// What rounding leaves of a straight line: a few times 2^−53 of its ends.
const ROUNDING: f64 = 1e-15;

/// What fits best, in rows.
#[derive(Debug, Clone, Copy)]
pub(super) struct EvenFit {
    /// Change of the output per row and unit of the input.
    pub(super) gain: f64,
    /// Dead time in rows.
    pub(super) dead_time: f64,
    /// Sum of the squares that are left.
    pub(super) squares: f64,
}

/// Input and output at even rows, at least three, and dead times up to `delays` rows, 1 or more. `None` where the input does
/// not move or its moves show nowhere.
#[expect(clippy::cast_precision_loss, reason = "a number of rows")]
pub(super) fn fit(input: &[f64], output: &[f64], delays: usize) -> Option<EvenFit> {
    let rows = input.len();
    let mean = sums::sum(&input[..rows - 1]) / (rows - 1) as f64;
    // The integral of the input, from `delays` rows before the record on: the input stood at its first value.
    let mut integral = vec![0.0; delays + rows];
    let before = input[0] - mean;
    for (k, value) in integral[..delays].iter_mut().enumerate() {
        *value = before * (k as f64 - delays as f64);
    }
    cumulate(input, mean, &mut integral[delays..]);
    let (response, squares, greatest) = less(output, line(output));
    // A straight line but for rounding shows no move.
    if greatest <= ROUNDING * output[0].abs().max(output[rows - 1].abs()) {
        return None;
    }
    let moves = moves(input);
    let sizes = moves.iter().map(|(_, size)| size.abs()).sum::<f64>();
    let of_moves = moves.iter().map(|(_, size)| size * size).sum::<f64>();
    let bend = (sizes * greatest).min((of_moves * squares).sqrt());
    let own = Own::new(&integral, input, mean, delays);
    let Best { delay, share: between } = best(moves, ramps(&response, delays), &own, bend)?;
    // The same piece, column by column: at its left end, and what the column gains to its right end.
    let columns =
        Columns { column: &integral[delays - delay..][..rows], response: &response, input, mean, delay };
    let found = columns.products();
    let [vv, vw, ww, vy, wy] = found.products;
    let determinant = vv * ww - vw * vw;
    let [along, across] = [(vy * ww - wy * vw) / determinant, (wy * vv - vy * vw) / determinant];
    let exact = across / along;
    let (gain, share) = if exact.is_finite() && (exact - between).abs() < 0.5 && (0.0..=1.0).contains(&exact)
    {
        (along, exact)
    } else {
        let own = vv + between * (2.0 * vw + between * ww);
        ((vy + between * wy) / own, between)
    };
    let left = squares - gain * (vy + share * wy);
    let squares = if left > SMALL * squares { left } else { columns.left(&found, gain, share) };
    Some(EvenFit { gain, dead_time: delay as f64 + share, squares })
        .filter(|fit| fit.gain.is_finite() && fit.gain != 0.0)
}
