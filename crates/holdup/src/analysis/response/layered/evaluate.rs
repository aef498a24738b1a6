//! Values of a layer at many times.

use super::super::legendre::{BATCH, in_batches};
use super::lanes::{LN_2, ROUND};
use super::signal::LAYER_TERMS;
use super::tables::INVERSE;
use crate::analysis::widest;

/// Adds `factor` times the layer with these coefficients, of a segment that starts at `start`, to the values at these times.
pub(in super::super) fn add_layer(
    layer: &[f64],
    factor: f64,
    (start, rate): (f64, f64),
    times: &[f64],
    values: &mut [f64],
) {
    let mut powers = [0.0; LAYER_TERMS];
    let mut scale = factor;
    for (j, (power, q)) in powers.iter_mut().zip(layer).enumerate() {
        *power = scale * q;
        scale *= INVERSE[j + 1];
    }
    let powers = &powers[..layer.len()];
    in_batches(times, values, start, |times, values| add_batch(powers, (start, rate), times, values));
}

fn add_batch(powers: &[f64], (start, rate): (f64, f64), times: &[f64; BATCH], values: &mut [f64; BATCH]) {
    widest(
        #[inline(always)]
        || {
            let (mut theta, mut sums) = ([0.0; BATCH], [0.0; BATCH]);
            for i in 0..BATCH {
                theta[i] = (rate * (times[i] - start)).clamp(0.0, 700.0);
            }
            for c in powers.iter().rev() {
                for i in 0..BATCH {
                    sums[i] = sums[i] * theta[i] + c;
                }
            }
            let decayed = exponentials(&theta);
            for i in 0..BATCH {
                values[i] += sums[i] * decayed[i];
            }
        },
    );
}

/// `e^(−θ)` for θ from 0 to 700, in lanes: 2^k times a Taylor polynomial on |r| ≤ ln(2)/2, whose next term is below 1e-17.
#[inline(always)]
fn exponentials(theta: &[f64; BATCH]) -> [f64; BATCH] {
    let mut values = [0.0; BATCH];
    for i in 0..BATCH {
        let shifted = -theta[i] * std::f64::consts::LOG2_E + ROUND;
        let k = shifted - ROUND;
        let r = (-theta[i] - k * LN_2.0) - k * LN_2.1;
        let mut sum = 1.0;
        for inverse in INVERSE[1..14].iter().rev() {
            sum = sum * r * inverse + 1.0;
        }
        let power = f64::from_bits(shifted.to_bits().wrapping_add(1023) << 52);
        values[i] = sum * power;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponentials_are_those_of_the_standard_library() {
        for block in 0..20 {
            let theta: [f64; BATCH] =
                std::array::from_fn(|i| f64::from(block * 32 + i32::try_from(i).unwrap()) * 1.0931);
            for (value, theta) in exponentials(&theta).iter().zip(theta) {
                // 1e-15: a few roundings.
                assert!((value / (-theta).exp() - 1.0).abs() < 1e-15, "{theta}");
            }
        }
    }

    #[test]
    fn a_layer_is_added_to_any_number_of_points() {
        let times: Vec<f64> = (0..37).map(|i| 2.0 + 0.05 * f64::from(i)).collect();
        let mut values = vec![1.0; 37];
        add_layer(&[0.5, -2.0, 3.0], -1.0, (2.0, 10.0), &times, &mut values);
        for (t, value) in times.iter().zip(values) {
            let theta: f64 = 10.0 * (t - 2.0);
            let exact = 1.0 - (0.5 - 2.0 * theta + 1.5 * theta * theta) * (-theta).exp();
            // 1e-14: rounding of numbers of size 1.
            assert!((value - exact).abs() < 1e-14, "{t}");
        }
    }
}
