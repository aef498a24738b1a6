//! Sums over the rows, eight rows side by side.

#![expect(clippy::cast_precision_loss, reason = "numbers of rows")]
#![expect(
    clippy::inline_always,
    reason = "a function outside the version for a processor does not have its instructions"
)]

use crate::analysis::widest;
use std::array::from_fn;
use std::hint::black_box;

use super::super::squares::dot;
use super::moves::Move;

/// Rows that are worked on side by side.
pub(super) const LANES: usize = 8;

/// Lags whose products are summed in one pass over the moves.
pub(super) const DELAYS: usize = 32;

/// A straight line over the rows: its value at row 0 and its slope per row.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    start: f64,
    slope: f64,
}

impl Line {
    /// The line of least squares through values of this sum and of this moment about the middle of the rows.
    fn of(sum: f64, moment: f64, rows: usize) -> Self {
        let n = rows as f64;
        let slope = moment / (n * (n * n - 1.0) / 12.0);
        Self { start: sum / n - slope * (n - 1.0) / 2.0, slope }
    }
}

/// The sum of the lanes. They are put down in memory before: a compiler that sees how they are added in the end works on
/// them in pairs all along.
#[inline(always)]
fn total(lanes: [f64; LANES]) -> f64 {
    black_box(lanes).iter().sum()
}

/// The sum of the values.
pub(super) fn sum(values: &[f64]) -> f64 {
    widest(
        #[inline(always)]
        || {
            let mut sums = [0.0; LANES];
            let (blocks, rest) = values.as_chunks::<LANES>();
            for block in blocks {
                for lane in 0..LANES {
                    sums[lane] += block[lane];
                }
            }
            total(sums) + rest.iter().sum::<f64>()
        },
    )
}

/// Whether all steps between the values are `step`, to a millionth of it.
pub(in super::super) fn are_even(values: &[f64], step: f64) -> bool {
    widest(
        #[inline(always)]
        || {
            let mut most = [0.0_f64; LANES];
            let (blocks, _) = values.as_chunks::<LANES>();
            let (after, rest) = values[1..].as_chunks::<LANES>();
            for (block, after) in blocks.iter().zip(after) {
                for lane in 0..LANES {
                    let off = (after[lane] - block[lane] - step).abs();
                    most[lane] = if off > most[lane] { off } else { most[lane] };
                }
            }
            let close = |off: f64| off <= 1e-6 * step;
            let rest = &values[values.len() - rest.len() - 1..];
            most.iter().all(|off| close(*off))
                && rest.windows(2).all(|pair| close((pair[1] - pair[0] - step).abs()))
        },
    )
}

/// The straight line of least squares through the values.
pub(super) fn line(values: &[f64]) -> Line {
    widest(
        #[inline(always)]
        || {
            let middle = (values.len() as f64 - 1.0) / 2.0;
            // From the first value on, so that an offset leaves no rounding.
            let first = values[0];
            let (mut sums, mut moments) = ([0.0; LANES], [0.0; LANES]);
            let mut places: [f64; LANES] = from_fn(|lane| lane as f64 - middle);
            let (blocks, rest) = values.as_chunks::<LANES>();
            for block in blocks {
                for lane in 0..LANES {
                    let value = block[lane] - first;
                    sums[lane] += value;
                    moments[lane] += places[lane] * value;
                    places[lane] += LANES as f64;
                }
            }
            let (mut sum, mut moment) = (total(sums), total(moments));
            for (k, value) in rest.iter().enumerate() {
                sum += value - first;
                moment += ((blocks.len() * LANES + k) as f64 - middle) * (value - first);
            }
            let line = Line::of(sum, moment, values.len());
            Line { start: first + line.start, ..line }
        },
    )
}

/// The values less a line, their sum of squares, and the greatest size among them.
pub(super) fn less(values: &[f64], line: Line) -> (Vec<f64>, f64, f64) {
    widest(
        #[inline(always)]
        || {
            let mut left = vec![0.0; values.len()];
            let (mut squares, mut most) = ([0.0; LANES], [0.0_f64; LANES]);
            let lines: [f64; LANES] = from_fn(|lane| line.start + line.slope * lane as f64);
            let (blocks, rest) = values.as_chunks::<LANES>();
            let (into, into_rest) = left.as_chunks_mut::<LANES>();
            for (k, (block, into)) in blocks.iter().zip(into).enumerate() {
                let base = line.slope * (k * LANES) as f64;
                for lane in 0..LANES {
                    let value = block[lane] - (lines[lane] + base);
                    into[lane] = value;
                    squares[lane] += value * value;
                    let size = value.abs();
                    most[lane] = if size > most[lane] { size } else { most[lane] };
                }
            }
            let (mut sum, mut greatest) = (total(squares), 0.0_f64);
            for (k, (value, into)) in rest.iter().zip(into_rest).enumerate() {
                *into = value - (line.start + line.slope * (blocks.len() * LANES + k) as f64);
                sum += *into * *into;
                greatest = greatest.max(into.abs());
            }
            (left, sum, black_box(most).into_iter().fold(greatest, f64::max))
        },
    )
}

/// Σ_j move_j·ramp_(j + delay) for so many delays from the first on.
pub(super) fn products(moves: &[Move], ramps: &[f64], first: usize, count: usize) -> Vec<f64> {
    widest(
        #[inline(always)]
        || {
            let mut found = Vec::with_capacity(count + DELAYS);
            while found.len() < count {
                let from = first + found.len();
                let mut sums = [0.0; DELAYS];
                for &(place, size) in moves {
                    // Beyond the last row the ramps are zero.
                    let Some(values) = ramps.get(place + from..).and_then(<[f64]>::first_chunk::<DELAYS>)
                    else {
                        break;
                    };
                    for (sum, value) in sums.iter_mut().zip(values) {
                        *sum += size * value;
                    }
                }
                found.extend(sums);
            }
            found.truncate(count);
            found
        },
    )
}

/// Of a column: sum, moment about the middle, squares, and products with the column `earlier` of the same length; and the
/// sum of squares of the input less its mean.
pub(super) fn own_sums(column: &[f64], earlier: &[f64], input: &[f64], mean: f64) -> ([f64; 4], f64) {
    widest(
        #[inline(always)]
        || {
            let middle = (column.len() as f64 - 1.0) / 2.0;
            let mut parts = [[0.0; LANES]; 5];
            let blocks = column.as_chunks::<LANES>().0.iter().zip(earlier.as_chunks::<LANES>().0);
            let done = column.len() / LANES * LANES;
            for (k, ((v, w), u)) in blocks.zip(input.as_chunks::<LANES>().0).enumerate() {
                let base = (k * LANES) as f64 - middle;
                for lane in 0..LANES {
                    let change = u[lane] - mean;
                    parts[0][lane] += v[lane];
                    parts[1][lane] += (base + lane as f64) * v[lane];
                    parts[2][lane] += v[lane] * v[lane];
                    parts[3][lane] += v[lane] * w[lane];
                    parts[4][lane] += change * change;
                }
            }
            let mut sums = parts.map(total);
            for row in done..column.len() {
                let (v, change) = (column[row], input[row] - mean);
                let terms = [v, (row as f64 - middle) * v, v * v, v * earlier[row], change * change];
                sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
            }
            let [sum, moment, squares, neighbour, change] = sums;
            ([sum, moment, squares, neighbour], change)
        },
    )
}

/// The columns of one piece: the input's integral v so many rows earlier, what it changes by to one row earlier still
/// (w, the input less its mean, negative), and the response.
pub(super) struct Columns<'r> {
    pub(super) column: &'r [f64],
    pub(super) response: &'r [f64],
    pub(super) input: &'r [f64],
    pub(super) mean: f64,
    pub(super) delay: usize,
}

/// Straight lines through both columns, and the products v·v, v·w, w·w, v·y and w·y outside straight lines.
pub(super) struct Products {
    lines: [Line; 2],
    pub(super) products: [f64; 5],
}

impl Columns<'_> {
    /// Sums over the rows of what `of` makes of row, v, w and y.
    #[inline(always)]
    fn sums<const N: usize>(&self, of: impl Fn(f64, f64, f64, f64) -> [f64; N]) -> [f64; N] {
        let rows = self.column.len();
        // Until the first row is felt the input stands at its first value.
        let head = (self.delay + 1).min(rows);
        let blocks = (rows - head) / LANES;
        let mut single = [0.0; N];
        let mut add = |row: usize, u: f64| {
            let terms = of(row as f64, self.column[row], self.mean - u, self.response[row]);
            single.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        };
        (0..head).for_each(|row| add(row, self.input[0]));
        (head + blocks * LANES..rows).for_each(|row| add(row, self.input[row - head]));
        let mut parts = [[0.0; LANES]; N];
        let (v, _) = self.column[head..].as_chunks::<LANES>();
        let (y, _) = self.response[head..].as_chunks::<LANES>();
        let (u, _) = self.input[..rows - head].as_chunks::<LANES>();
        for (k, ((v, y), u)) in v.iter().zip(y).zip(u).enumerate() {
            let base = (head + k * LANES) as f64;
            for lane in 0..LANES {
                let terms = of(base + lane as f64, v[lane], self.mean - u[lane], y[lane]);
                for (part, term) in parts.iter_mut().zip(terms) {
                    part[lane] += term;
                }
            }
        }
        from_fn(|k| single[k] + total(parts[k]))
    }

    /// All that the best gain and share of the piece need.
    pub(super) fn products(&self) -> Products {
        products_of(self).unwrap_or_else(|| self.row_by_row())
    }

    /// The same with straight lines taken out of the columns first.
    fn row_by_row(&self) -> Products {
        let rows = self.column.len();
        let change: Vec<f64> =
            (0..rows).map(|row| self.mean - self.input[(row + 1).saturating_sub(self.delay + 2)]).collect();
        let lines = [line(self.column), line(&change)];
        let [v, w] = [less(self.column, lines[0]).0, less(&change, lines[1]).0];
        let y = self.response;
        Products { lines, products: [dot(&v, &v), dot(&v, &w), dot(&w, &w), dot(&v, y), dot(&w, y)] }
    }

    /// The sum of squares that gain and share leave.
    pub(super) fn left(&self, found: &Products, gain: f64, share: f64) -> f64 {
        left_by(self, found, gain, share)
    }
}

/// Share of a column's squares outside straight lines below which a difference of sums is too small to be exact.
const MOSTLY_STRAIGHT: f64 = 1e-4;

/// `None` where a column is little more than a straight line.
fn products_of(columns: &Columns<'_>) -> Option<Products> {
    widest(
        #[inline(always)]
        || {
            let rows = columns.column.len();
            let n = rows as f64;
            let (middle, spread) = ((n - 1.0) / 2.0, n * (n * n - 1.0) / 12.0);
            let [v, mv, w, mw, vv, vw, ww, vy, wy] = columns.sums(|row, v, w, y| {
                let place = row - middle;
                [v, place * v, w, place * w, v * v, v * w, w * w, v * y, w * y]
            });
            let lines = [Line::of(v, mv, rows), Line::of(w, mw, rows)];
            let outside = [vv - v * v / n - mv * mv / spread, ww - w * w / n - mw * mw / spread];
            let products = [outside[0], vw - v * w / n - mv * mw / spread, outside[1], vy, wy];
            (outside[0] > MOSTLY_STRAIGHT * vv && outside[1] > MOSTLY_STRAIGHT * ww)
                .then_some(Products { lines, products })
        },
    )
}

fn left_by(columns: &Columns<'_>, found: &Products, gain: f64, share: f64) -> f64 {
    widest(
        #[inline(always)]
        || {
            let [v, w] = found.lines;
            let (start, slope) = (v.start + share * w.start, v.slope + share * w.slope);
            let [squares] = columns.sums(|row, v, w, y| {
                let left = y - gain * (v + share * w - (start + slope * row));
                [left * left]
            });
            squares
        },
    )
}
