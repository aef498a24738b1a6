//! The noise of a signal, told from its drift.

use serde::Serialize;

use super::statistics::{real, spread};

/// Measurement noise, as far as rows can tell it from movement.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Noise {
    /// Standard deviation; where `is_bound`, an upper bound of it.
    pub standard_deviation: f64,
    /// Autocorrelation from row to row; none where it cannot be told.
    pub lag_1_autocorrelation: Option<f64>,
    /// Whether the signal moves so smoothly that the noise can only be bounded.
    pub is_bound: bool,
}

/// Estimates noise from differences of second order over one and over two rows, which a drift of constant slope leaves
/// untouched and a few spikes or steps do not reach, as their spread is taken from the inner 68 %.
///
/// For noise with lag-1 autocorrelation ρ (AR(1)) and variance γ these have the variances 2γ(1 − ρ)(3 − ρ) and
/// 2γ(1 − ρ²)(3 − ρ²). Their ratio (1 + ρ)(3 − ρ²)/(3 − ρ) rises from 0 to 2 with ρ; from 2 on the signal moves too
/// smoothly for noise of this kind.
pub(super) fn noise(values: &[f64]) -> Option<Noise> {
    const LEAST_ROWS: usize = 20;
    if values.len() < LEAST_ROWS {
        return None;
    }
    let second = |apart: usize| {
        let bends =
            values.windows(2 * apart + 1).map(move |part| part[2 * apart] - 2.0 * part[apart] + part[0]);
        spread(bends).powi(2)
    };
    let (one, two) = (second(1), second(2));
    if one == 0.0 {
        return None;
    }
    let ratio = two / one;
    // The ratio itself scatters by a few over the square root of the rows.
    let limit = 2.0 - 3.0 / real(values.len()).sqrt();
    if ratio >= limit {
        // White noise of this size would make the second differences alone.
        let standard_deviation = (one / 6.0).sqrt();
        return Some(Noise { standard_deviation, lag_1_autocorrelation: None, is_bound: true });
    }
    let rho = autocorrelation(ratio);
    let standard_deviation = (one / (2.0 * (1.0 - rho) * (3.0 - rho))).sqrt();
    Some(Noise { standard_deviation, lag_1_autocorrelation: Some(rho), is_bound: false })
}

/// The ρ of a ratio below 2, by bisection: the ratio rises with ρ.
fn autocorrelation(ratio: f64) -> f64 {
    let (mut low, mut high) = (-0.99, 0.99);
    for _ in 0..60 {
        let rho = f64::midpoint(low, high);
        if (1.0 + rho) * (3.0 - rho * rho) / (3.0 - rho) < ratio { low = rho } else { high = rho }
    }
    f64::midpoint(low, high)
}

#[cfg(test)]
mod tests {
    use rand::{Rng, SeedableRng};

    use super::*;

    fn ar1(rho: f64, size: f64, drift: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(7);
        let mut state = 0.0;
        (0..6000)
            .map(|row| {
                // The sum of twelve uniform numbers, less six, is normal enough and has variance 1.
                let normal =
                    (0..12).map(|_| f64::from(random.next_u32()) / f64::from(u32::MAX)).sum::<f64>() - 6.0;
                state = rho * state + (1.0 - rho * rho).sqrt() * normal;
                size * state + drift(real(row))
            })
            .collect()
    }

    #[test]
    fn size_and_autocorrelation_of_noise_are_found_under_drift() {
        let drifts: [fn(f64) -> f64; 3] = [
            |_| 5.0,
            |row| 0.002 * row,
            |row| 3.0 * (row * 0.004).sin() + if row > 3000.0 { 20.0 } else { 0.0 },
        ];
        for rho in [0.0, 0.3, 0.6] {
            for drift in drifts {
                let found = noise(&ar1(rho, 0.2, drift)).unwrap();
                // 6000 rows: the variances scatter by 3 %, which the ratio turns into up to 0.06 in ρ and 10 % in size.
                assert!((found.lag_1_autocorrelation.unwrap() - rho).abs() < 0.08, "{rho}: {found:?}");
                assert!((found.standard_deviation / 0.2 - 1.0).abs() < 0.15, "{rho}: {found:?}");
            }
        }
    }

    #[test]
    fn a_smooth_signal_bounds_its_noise() {
        let smooth: Vec<f64> = (0..1000).map(|row| (real(row) * 0.01).sin()).collect();
        let found = noise(&smooth).unwrap();
        assert!(found.is_bound && found.standard_deviation < 1e-4, "{found:?}");
        assert_eq!(noise(&[1.0; 50]), None);
    }
}
