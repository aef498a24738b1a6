//! The autocorrelation function, by the fast Fourier transform.

use num_complex::Complex64;

use super::statistics::{mean, real};

/// The biased autocorrelation function of a signal without its mean, from lag 0, which is 1; empty for a constant.
pub(super) fn autocorrelation(values: &[f64]) -> Vec<f64> {
    let centre = mean(values);
    let length = (2 * values.len()).next_power_of_two();
    let mut line: Vec<Complex64> = values.iter().map(|value| Complex64::new(value - centre, 0.0)).collect();
    line.resize(length, Complex64::ZERO);
    transform(&mut line);
    for entry in &mut line {
        *entry = Complex64::new(entry.norm_sqr(), 0.0);
    }
    // A second transform in the same direction runs backwards in time, which an even function does not notice.
    transform(&mut line);
    let whole = line[0].re;
    if whole <= 0.0 {
        return Vec::new();
    }
    line[..values.len()].iter().map(|entry| entry.re / whole).collect()
}

/// The discrete Fourier transform in place (J. W. Cooley and J. W. Tukey, 1965); the length is a power of two.
fn transform(line: &mut [Complex64]) {
    let length = line.len();
    let bits = length.trailing_zeros();
    if bits == 0 {
        return;
    }
    for index in 0..length {
        let mirrored = index.reverse_bits() >> (usize::BITS - bits);
        if index < mirrored {
            line.swap(index, mirrored);
        }
    }
    let mut width = 2;
    while width <= length {
        let half = width / 2;
        let factors: Vec<Complex64> = (0..half)
            .map(|k| Complex64::from_polar(1.0, -std::f64::consts::TAU * real(k) / real(width)))
            .collect();
        for block in line.chunks_exact_mut(width) {
            let (left, right) = block.split_at_mut(half);
            for ((a, b), factor) in left.iter_mut().zip(right).zip(&factors) {
                let turned = *b * factor;
                (*a, *b) = (*a + turned, *a - turned);
            }
        }
        width *= 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_sum_of_products() {
        let values: Vec<f64> = (0..37).map(|k| (real(k) * 0.9).sin() + 0.1 * real(k % 5)).collect();
        let centre = mean(&values);
        let product = |lag: usize| -> f64 {
            values.iter().zip(&values[lag..]).map(|(a, b)| (a - centre) * (b - centre)).sum()
        };
        for (lag, found) in autocorrelation(&values).iter().enumerate() {
            // Forty products of size 1: rounding to 1e-14.
            assert!((found - product(lag) / product(0)).abs() < 1e-13, "{lag}");
        }
        assert!(autocorrelation(&[2.0; 9]).is_empty());
    }
}
