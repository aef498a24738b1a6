//! What disturbs the controlled variable, as a model that whitens it: measurement noise, coloured noise, a load that is
//! noise, and a load that wanders.

use serde::Serialize;

use super::squares::Basis;

/// The noise of the controlled variable: the sum of four independent parts, by their strengths.
///
/// White measurement noise and coloured noise do not accumulate. The level does: a load that is white noise makes it
/// a random walk, and a load that is itself a random walk makes it an integrated random walk.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Noise {
    /// Standard deviation of the white measurement noise [output unit].
    pub white: f64,
    /// Standard deviation of the coloured noise [output unit].
    pub coloured: f64,
    /// Correlation time of the coloured noise [s]: between samples h apart it is exp(−h/time).
    #[serde(rename = "correlation_time_s")]
    pub correlation_time: f64,
    /// Random walk of the level: standard deviation after one second [output unit/√s].
    pub walk: f64,
    /// Random walk of the rate of the level, by a wandering load: standard deviation after one second
    /// [output unit/(s·√s)].
    pub wander: f64,
}

impl Noise {
    /// White measurement noise of unit strength.
    pub(crate) const WHITE: Self =
        Self { white: 1.0, coloured: 0.0, correlation_time: 1.0, walk: 0.0, wander: 0.0 };

    /// The same noise so many times as strong.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self {
            white: self.white * factor,
            coloured: self.coloured * factor,
            walk: self.walk * factor,
            wander: self.wander * factor,
            ..self
        }
    }

    /// Whether the noise is white measurement noise only.
    pub(crate) fn is_white(&self) -> bool {
        self.coloured == 0.0 && self.walk == 0.0 && self.wander == 0.0
    }
}

/// A noise model made ready for rows at given times: whitens any column. It is the Kalman filter of the noise, whose
/// gains do not depend on the column: G. C. Goodwin and R. L. Payne, Dynamic System Identification, Academic Press
/// (1977), section 3.4; the initial value and load are columns of their own, so that its states start at rest.
#[derive(Debug, Clone)]
pub(crate) struct Whitener {
    rows: Vec<Row>,
    /// Σ ln of the innovations' variances.
    log_determinant: f64,
    white: bool,
}

/// What one row needs: its step to the next row, decay over it, gains, and 1 over the innovation's standard deviation.
#[derive(Debug, Clone, Copy)]
struct Row {
    step: f64,
    decay: f64,
    gain: [f64; 3],
    inverse: f64,
}

impl Whitener {
    /// The filter of this noise at these times.
    pub(crate) fn new(noise: &Noise, times: &[f64]) -> Self {
        if noise.is_white() {
            #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
            let log_determinant = 2.0 * noise.white.ln() * times.len() as f64;
            let row = Row { step: 0.0, decay: 0.0, gain: [0.0; 3], inverse: 1.0 / noise.white };
            return Self { rows: vec![row], log_determinant, white: true };
        }
        let [white, coloured, walk, wander] =
            [noise.white, noise.coloured, noise.walk, noise.wander].map(|strength| strength * strength);
        // Covariance of coloured noise, level and rate: aa, ab, ac, bb, bc, cc.
        let mut p = [coloured, 0.0, 0.0, 0.0, 0.0, 0.0];
        let mut rows: Vec<Row> = Vec::with_capacity(times.len());
        let mut log_determinant = 0.0;
        // Over steps of one length the covariance settles and need not be computed again.
        let mut settled = None;
        for k in 0..times.len() {
            let step = if k + 1 < times.len() { times[k + 1] - times[k] } else { 0.0 };
            if let Some((row, log)) = settled {
                let row: Row = row;
                if (row.step - step).abs() <= 1e-9 * step || k + 1 == times.len() {
                    rows.push(Row { step, ..row });
                    log_determinant += log;
                    continue;
                }
                settled = None;
            }
            let decay = (-step / noise.correlation_time).exp();
            let [aa, ab, ac, bb, bc, cc] = p;
            let (of_a, of_b, of_c) = (aa + ab, ab + bb, ac + bc);
            let variance = of_a + of_b + white;
            // Without white noise the variance of the first row may be 0: then the row says nothing.
            let variance = variance.max(f64::MIN_POSITIVE);
            let gain = [of_a / variance, of_b / variance, of_c / variance];
            let (aa, ab, ac) = (aa - gain[0] * of_a, ab - gain[0] * of_b, ac - gain[0] * of_c);
            let (bb, bc, cc) = (bb - gain[1] * of_b, bc - gain[1] * of_c, cc - gain[2] * of_c);
            let next = [
                decay * decay * aa + coloured * (1.0 - decay * decay),
                decay * (ab + step * ac),
                decay * ac,
                bb + step * (2.0 * bc + step * cc) + walk * step + wander * step * step * step / 3.0,
                bc + step * cc + wander * step * step / 2.0,
                cc + wander * step,
            ];
            let row = Row { step, decay, gain, inverse: variance.sqrt().recip() };
            rows.push(row);
            log_determinant += variance.ln();
            let moved = |a: f64, b: f64| (a - b).abs() > 1e-11 * a.abs();
            if k > 2 && rows[k - 1].step == step && !p.iter().zip(&next).any(|(a, b)| moved(*a, *b)) {
                settled = Some((row, variance.ln()));
            }
            p = next;
        }
        Self { rows, log_determinant, white: false }
    }

    /// ln of the determinant of the noise's covariance.
    pub(crate) fn log_determinant(&self) -> f64 {
        self.log_determinant
    }

    /// The innovations of a column, each over its standard deviation.
    pub(crate) fn whiten(&self, mut column: Vec<f64>) -> Vec<f64> {
        if self.white {
            for value in &mut column {
                *value *= self.rows[0].inverse;
            }
            return column;
        }
        let (mut a, mut b, mut c) = (0.0, 0.0, 0.0);
        for (value, row) in column.iter_mut().zip(&self.rows) {
            let innovation = *value - (a + b);
            a = row.decay * (a + row.gain[0] * innovation);
            let rate = c + row.gain[2] * innovation;
            b = b + row.gain[1] * innovation + row.step * rate;
            c = rate;
            *value = innovation * row.inverse;
        }
        column
    }
}

impl Whitener {
    /// Standard deviation of the last row's innovation [output unit].
    pub(crate) fn innovation(&self) -> f64 {
        self.rows.last().map_or(1.0, |row| 1.0 / row.inverse)
    }

    /// The transposed filter: what the weights of whitened rows are as weights of the rows themselves.
    pub(crate) fn transposed(&self, mut weights: Vec<f64>) -> Vec<f64> {
        if self.white {
            for value in &mut weights {
                *value *= self.rows[0].inverse;
            }
            return weights;
        }
        // The adjoint runs backwards: how what follows depends on the states after each row.
        let (mut of_a, mut of_b, mut of_c) = (0.0, 0.0, 0.0);
        for (weight, row) in weights.iter_mut().zip(&self.rows).rev() {
            let rate = of_c + row.step * of_b;
            let innovation = *weight * row.inverse
                + of_a * row.decay * row.gain[0]
                + of_b * row.gain[1]
                + rate * row.gain[2];
            let (next_a, next_b) = (of_a * row.decay - innovation, of_b - innovation);
            *weight = innovation;
            (of_a, of_b, of_c) = (next_a, next_b, rate);
        }
        weights
    }
}

/// How well a noise model explains a response beside the columns: ln of the restricted likelihood (H. D. Patterson and
/// R. Thompson, Biometrika 58 (1971) 545) with the overall strength at its best, which is returned beside it.
pub(crate) fn restricted_likelihood(
    noise: &Noise,
    times: &[f64],
    columns: &[Vec<f64>],
    response: &[f64],
) -> (f64, f64) {
    let whitener = Whitener::new(noise, times);
    let basis = Basis::of(columns.iter().map(|column| whitener.whiten(column.clone())));
    let rest = basis.projected(whitener.whiten(response.to_vec()));
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let freedom = (times.len().saturating_sub(basis.rank())).max(1) as f64;
    let squares = super::squares::dot(&rest, &rest).max(f64::MIN_POSITIVE);
    let strength = (squares / freedom).sqrt();
    let likelihood = -0.5
        * (freedom * (squares / freedom).ln()
            + whitener.log_determinant()
            + basis.log_determinant()
            + freedom);
    (likelihood, strength)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Covariance of the noise between two times, from its definition.
    fn covariance(noise: &Noise, start: f64, a: f64, b: f64) -> f64 {
        let (near, far) = (a.min(b) - start, a.max(b) - start);
        let same = if a == b { noise.white.powi(2) } else { 0.0 };
        let coloured = noise.coloured.powi(2) * (-(far - near) / noise.correlation_time).exp();
        let wander = noise.wander.powi(2) * near * near * (3.0 * far - near) / 6.0;
        same + coloured + noise.walk.powi(2) * near + wander
    }

    /// W·Σ·Wᵀ = 1 with Σ from the definition, also over uneven times. 1e-10: a product of a 7 by 7 matrix of
    /// condition 1e3.
    #[test]
    fn the_whitened_noise_is_white() {
        let noise = Noise { white: 0.4, coloured: 1.1, correlation_time: 2.0, walk: 0.3, wander: 0.2 };
        for times in [[0.0, 0.5, 2.0, 2.1, 4.0, 7.0, 8.0], [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]] {
            let whitener = Whitener::new(&noise, &times);
            let columns: Vec<Vec<f64>> = (0..7)
                .map(|k| whitener.whiten((0..7).map(|i| if i == k { 1.0 } else { 0.0 }).collect()))
                .collect();
            for i in 0..7 {
                for j in 0..7 {
                    let mut sum = 0.0;
                    for a in 0..7 {
                        for b in 0..7 {
                            sum += columns[a][i]
                                * covariance(&noise, times[0], times[a], times[b])
                                * columns[b][j];
                        }
                    }
                    let expected = if i == j { 1.0 } else { 0.0 };
                    assert!((sum - expected).abs() < 1e-10, "{i} {j}: {sum}");
                }
            }
        }
    }

    /// ⟨w, W·x⟩ = ⟨Wᵀ·w, x⟩ for unit vectors; rounding of a handful of products.
    #[test]
    fn the_transposed_filter_is_the_transposed_matrix() {
        let noise = Noise { white: 0.4, coloured: 1.1, correlation_time: 2.0, walk: 0.3, wander: 0.2 };
        let whitener = Whitener::new(&noise, &[0.0, 0.5, 2.0, 2.1, 4.0]);
        let unit = |k: usize| (0..5).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
        for i in 0..5 {
            for j in 0..5 {
                assert!((whitener.whiten(unit(j))[i] - whitener.transposed(unit(i))[j]).abs() < 1e-14);
            }
        }
    }

    /// The determinant of the covariance of two rows, by hand.
    #[test]
    fn the_determinant_is_that_of_the_covariance() {
        let noise = Noise { white: 0.5, coloured: 1.0, correlation_time: 1.0, walk: 0.7, wander: 0.0 };
        let whitener = Whitener::new(&noise, &[0.0, 1.0]);
        let of = |a, b| covariance(&noise, 0.0, a, b);
        let determinant: f64 = of(0.0, 0.0) * of(1.0, 1.0) - of(0.0, 1.0).powi(2);
        assert!((whitener.log_determinant() - determinant.ln()).abs() < 1e-14);
    }
}
