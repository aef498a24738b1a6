//! Running sums. A sum waits for the one before it, so eight parts of the rows are summed side by side and put one on the
//! other afterwards.

#![expect(
    clippy::inline_always,
    reason = "a function outside the version for a processor does not have its instructions"
)]

use crate::analysis::widest;
use std::array::from_fn;
use std::hint::black_box;

use super::sums::{DELAYS, LANES};

/// The first eight parts of equal length of values and of what is made of them, and that length. Fewer than eight values have
/// none.
#[inline(always)]
fn parts<'v, 'o>(
    values: &'v [f64],
    out: &'o mut [f64],
) -> ([&'v [f64]; LANES], [&'o mut [f64]; LANES], usize) {
    let part = values.len() / LANES;
    let mut rest = out;
    let into = from_fn(|_| {
        let (part, after) = std::mem::take(&mut rest).split_at_mut(part);
        rest = after;
        part
    });
    (from_fn(|lane| &values[lane * part..(lane + 1) * part]), into, part)
}

/// Sums of the values before each place, less `mean` each; `out` is as long as the values.
pub(super) fn cumulate(values: &[f64], mean: f64, out: &mut [f64]) {
    widest(
        #[inline(always)]
        || {
            let (from, into, part) = parts(values, out);
            let mut sums = [0.0; LANES];
            for k in 0..part {
                for lane in 0..LANES {
                    into[lane][k] = sums[lane];
                    sums[lane] += from[lane][k] - mean;
                }
            }
            let mut start = 0.0;
            for (lane, sum) in black_box(sums).into_iter().enumerate() {
                out[lane * part..(lane + 1) * part].iter_mut().for_each(|value| *value += start);
                start += sum;
            }
            for place in LANES * part..values.len() {
                out[place] = start;
                start += values[place] - mean;
            }
        },
    );
}

/// Σ_(i<m) y_i·(m − i) at each place m: the product of the values with a ramp that starts at m, where the values are
/// orthogonal to straight lines. Zeros follow for moves up to `delays` places later.
#[expect(clippy::cast_precision_loss, reason = "a number of rows")]
pub(super) fn ramps(values: &[f64], delays: usize) -> Vec<f64> {
    widest(
        #[inline(always)]
        || {
            // Room for the delays of a grid that ends beyond the last.
            let mut out = vec![0.0; values.len() + delays + 16 * DELAYS];
            let (from, into, part) = parts(values, &mut out);
            let (mut sums, mut ramps) = ([0.0; LANES], [0.0; LANES]);
            for k in 0..part {
                for lane in 0..LANES {
                    into[lane][k] = ramps[lane];
                    sums[lane] += from[lane][k];
                    ramps[lane] += sums[lane];
                }
            }
            let (mut ramp, mut slope) = (0.0, 0.0);
            let (sums, ramps) = black_box((sums, ramps));
            for lane in 0..LANES {
                for (k, value) in out[lane * part..(lane + 1) * part].iter_mut().enumerate() {
                    *value += ramp + slope * k as f64;
                }
                ramp += part as f64 * slope + ramps[lane];
                slope += sums[lane];
            }
            for place in LANES * part..values.len() {
                out[place] = ramp;
                slope += values[place];
                ramp += slope;
            }
            out
        },
    )
}

/// Every fourth value.
pub(super) fn every_fourth(values: &[f64]) -> Vec<f64> {
    values.as_chunks::<4>().0.iter().map(|block| block[0]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the plain loops: with integers the sums are exact.
    #[test]
    fn parts_put_on_each_other_are_the_whole() {
        for rows in [3_u32, 8, 21, 64, 100] {
            let values: Vec<f64> = (0..rows).map(|k| f64::from(k * k % 17) - 8.0).collect();
            let mut out = vec![f64::NAN; values.len()];
            cumulate(&values, 2.0, &mut out);
            let found = ramps(&values, 5);
            let (mut sum, mut slope, mut ramp) = (0.0, 0.0, 0.0);
            for (place, value) in values.iter().enumerate() {
                assert_eq!((out[place], found[place]), (sum, ramp), "{rows}, {place}");
                sum += value - 2.0;
                slope += value;
                ramp += slope;
            }
            assert!(found[values.len()..].iter().all(|value| *value == 0.0));
        }
    }
}
