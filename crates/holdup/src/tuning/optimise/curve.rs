//! A monotone cubic through knots.

/// Cubics through given points that neither overshoot nor swing: slopes of F. N. Fritsch and J. Butland, SIAM J. Sci. Stat.
/// Comput. 5, 1984, 300–304, for uneven knots.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    places: Vec<f64>,
    values: Vec<f64>,
    slopes: Vec<f64>,
}

/// The optimum is nearly a power of how far M_s is from 1.
fn place(sensitivity_peak: f64) -> f64 {
    (sensitivity_peak - 1.0).ln()
}

impl Curve {
    /// The curve through values, all positive, at rising sensitivity peaks, two or more.
    pub(super) fn new(peaks: &[f64], values: &[f64]) -> Self {
        let places: Vec<f64> = peaks.iter().map(|&peak| place(peak)).collect();
        let values: Vec<f64> = values.iter().map(|value| value.ln()).collect();
        let width = |i: usize| places[i + 1] - places[i];
        let rise = |i: usize| (values[i + 1] - values[i]) / width(i);
        let last = places.len() - 1;
        let slopes = (0..=last).map(|i| match i {
            0 if last == 1 => rise(0),
            0 => end(rise(0), rise(1), width(0), width(1)),
            i if i == last => end(rise(last - 1), rise(last - 2), width(last - 1), width(last - 2)),
            i if rise(i - 1) * rise(i) <= 0.0 => 0.0,
            i => {
                // The parabola through three points, held to what keeps the curve monotone.
                let (a, b) = (rise(i - 1), rise(i));
                let slope = (width(i) * a + width(i - 1) * b) / (width(i - 1) + width(i));
                let most = 3.0 * a.abs().min(b.abs());
                slope.clamp(-most, most)
            }
        });
        let slopes = slopes.collect();
        Self { places, values, slopes }
    }

    /// The value at a sensitivity peak between the first and the last.
    pub(super) fn at(&self, sensitivity_peak: f64) -> f64 {
        let x = place(sensitivity_peak);
        let after = self.places.partition_point(|place| *place <= x).clamp(1, self.places.len() - 1);
        let i = after - 1;
        let width = self.places[after] - self.places[i];
        let t = ((x - self.places[i]) / width).clamp(0.0, 1.0);
        let s = 1.0 - t;
        let (y, z) = (self.values[i], self.values[after]);
        let bend = s * s * t * width * self.slopes[i] - s * t * t * width * self.slopes[after];
        (s * s * (1.0 + 2.0 * t) * y + t * t * (1.0 + 2.0 * s) * z + bend).exp()
    }
}

/// The slope at an end: of the parabola through the last three points, held to the sign of the last rise.
fn end(near: f64, far: f64, width: f64, next: f64) -> f64 {
    let slope = ((2.0 * width + next) * near - width * far) / (width + next);
    if slope * near <= 0.0 { 0.0 } else { slope.clamp(-3.0 * near.abs(), 3.0 * near.abs()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn knots_are_met_and_a_power_is_followed_exactly() {
        let peaks = [1.2, 1.3, 1.5, 1.6, 2.5];
        let values = peaks.map(|peak: f64| 3.0 * (peak - 1.0).powf(0.7));
        let curve = Curve::new(&peaks, &values);
        for (peak, value) in peaks.into_iter().zip(values) {
            assert!((curve.at(peak) / value - 1.0).abs() < 1e-14); // rounding of exp and ln
        }
        let at: f64 = 1.9;
        assert!((curve.at(at) / (3.0 * 0.9_f64.powf(0.7)) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn where_the_values_stop_rising_the_curve_stays_between_them() {
        let curve = Curve::new(&[1.2, 1.4, 1.6, 1.8, 2.0], &[1.0, 2.0, 3.0, 3.0, 3.0]);
        for index in 0..=80 {
            let value = curve.at(1.2 + 0.01 * f64::from(index));
            assert!((1.0 - 1e-12..=3.0 + 1e-12).contains(&value), "{index} {value}");
        }
    }
}
