//! `dx/ds = M·x + g` on one cell, for polynomials: exact to rounding however stiff M is.
//!
//! In the integrated form coefficient k of x obeys
//! `x_k − M·x_{k−1}/(2k−1) + M·x_{k+1}/(2k+3) = (coefficient k of ∫g)`: identity plus a skew part, so that
//! for real M elimination needs no pivoting and every pivot is at least 1. Coefficient 0 then follows from the
//! value at the start. Where M is so large that this start would leave its rounding in all coefficients, the polynomial that
//! solves the equation without any layer is computed instead, and the layer added to it. The factors depend only on the length of the cell and are kept for the next cell of that length.

#![expect(clippy::needless_range_loop, reason = "recurrences over fixed arrays read as their formulas")]

use super::legendre::{ODD, Poly, TERMS, add, ends, integrated, magnitude};

#[expect(clippy::cast_precision_loss, reason = "k is at most 24")]
fn couplings(k: usize) -> (f64, f64) {
    (1.0 / (2 * k - 1) as f64, 1.0 / (2 * k + 3) as f64)
}

/// From this |M| on, a polynomial solution follows from its highest coefficient downwards without growth of rounding.
const STIFF: f64 = 64.0;

/// One first-order lag, M a number.
#[derive(Debug, Clone)]
pub(super) struct Lag {
    inverse: Poly,
    above: Poly,
    below: Poly,
    homogeneous: Poly,
    reach: f64,
    m: f64,
}

impl Lag {
    /// Factors for `M = rate·length/2`.
    pub(super) fn new(m: f64) -> Self {
        let mut lag = Self {
            inverse: [0.0; TERMS],
            above: [0.0; TERMS],
            below: [0.0; TERMS],
            homogeneous: [0.0; TERMS],
            reach: 1.0,
            m,
        };
        let mut ratio_above = 0.0;
        for k in (1..TERMS).rev() {
            let (down, up) = couplings(k);
            let inverse = 1.0 / (1.0 + m * up * ratio_above);
            lag.inverse[k] = inverse;
            lag.above[k] = m * up * inverse;
            lag.below[k] = m * down * inverse;
            ratio_above = lag.below[k];
        }
        lag.homogeneous[0] = 1.0;
        let (mut sum, mut sign) = (1.0, 1.0);
        for k in 1..TERMS {
            lag.homogeneous[k] = lag.below[k] * lag.homogeneous[k - 1];
            sign = -sign;
            sum += sign * lag.homogeneous[k];
        }
        lag.reach = 1.0 / sum;
        lag
    }

    /// The solution that starts at `start`; `g` is the forcing times half the cell's length.
    pub(super) fn solve(&self, g: &Poly, start: f64) -> Poly {
        if self.m.abs() >= STIFF {
            return self.solve_stiff(g, start);
        }
        let mut x = integrated(g);
        let mut above = 0.0;
        for k in 1..TERMS {
            x[k] *= self.inverse[k];
        }
        for k in (1..TERMS).rev() {
            above = x[k] - self.above[k] * above;
            x[k] = above;
        }
        let mut below = 0.0;
        x[0] = 0.0;
        for k in 1..TERMS {
            below = x[k] + self.below[k] * below;
            x[k] = below;
        }
        let mean = (start - ends(&x).0) * self.reach;
        add(&mut x, mean, &self.homogeneous);
        x
    }
}

impl Lag {
    /// `x = (dx/ds − g)/M` from the highest coefficient downwards, and the layer at the start.
    fn solve_stiff(&self, g: &Poly, start: f64) -> Poly {
        let mut x = [0.0; TERMS];
        let (mut same, mut other) = (0.0, 0.0);
        for k in (0..TERMS).rev() {
            // Coefficient k of dx/ds is (2k+1)·(x_{k+1} + x_{k+3} + …).
            x[k] = (ODD[k] * other - g[k]) / self.m;
            (same, other) = (other, same + x[k]);
        }
        let layer = start - ends(&x).0;
        if layer.abs() > 8.0 * f64::EPSILON * (start.abs() + magnitude(&x)) {
            add(&mut x, layer * self.reach, &self.homogeneous);
        }
        x
    }
}

/// Several states that drive each other, M a square matrix.
#[derive(Debug, Clone)]
pub(super) struct CoupledLags {
    size: usize,
    matrix: Vec<f64>,
    inverses: Vec<Vec<f64>>,
    homogeneous: Vec<Vec<f64>>,
    reach: Vec<f64>,
}

impl CoupledLags {
    /// Factors for the matrix `M = A·length/2` (row by row); `None` where elimination would lose digits, which
    /// a shorter cell cures.
    pub(super) fn new(matrix: Vec<f64>, size: usize) -> Option<Self> {
        let mut inverses = vec![Vec::new(); TERMS];
        let mut ratio_above = vec![0.0; size * size];
        let mut ratios = vec![Vec::new(); TERMS];
        for k in (1..TERMS).rev() {
            let (down, up) = couplings(k);
            let mut pivot = product(&matrix, &ratio_above, size);
            scale(&mut pivot, up);
            (0..size).for_each(|i| pivot[i * size + i] += 1.0);
            inverses[k] = inverted(pivot, size)?;
            ratio_above = product(&inverses[k], &matrix, size);
            scale(&mut ratio_above, down);
            ratios[k].clone_from(&ratio_above);
        }
        let mut identity = vec![0.0; size * size];
        (0..size).for_each(|i| identity[i * size + i] = 1.0);
        let (mut homogeneous, mut sum, mut sign) = (vec![identity.clone()], identity, 1.0);
        for k in 1..TERMS {
            homogeneous.push(product(&ratios[k], &homogeneous[k - 1], size));
            sign = -sign;
            sum.iter_mut().zip(&homogeneous[k]).for_each(|(s, h)| *s += sign * h);
        }
        let reach = inverted(sum, size)?;
        Some(Self { size, matrix, inverses, homogeneous, reach })
    }

    /// The solution that starts at `start`; `g` is the forcing times half the cell's length.
    pub(super) fn solve(&self, g: &[Poly], start: &[f64], solution: &mut [Poly]) {
        let n = self.size;
        let right: Vec<Poly> = g.iter().map(integrated).collect();
        let mut particular = vec![vec![0.0; n]; TERMS + 1];
        for k in (1..TERMS).rev() {
            let up = couplings(k).1;
            let driven = multiply(&self.matrix, &particular[k + 1], n);
            let rest: Vec<f64> = (0..n).map(|i| right[i][k] - up * driven[i]).collect();
            particular[k] = multiply(&self.inverses[k], &rest, n);
        }
        let mut offset = start.to_vec();
        let mut sign = 1.0;
        for k in 1..TERMS {
            // ratio·x = inverse·M·x/(2k−1)
            let driven = multiply(&self.matrix, &particular[k - 1], n);
            let step = multiply(&self.inverses[k], &driven, n);
            let down = couplings(k).0;
            sign = -sign;
            for i in 0..n {
                particular[k][i] += down * step[i];
                offset[i] -= sign * particular[k][i];
            }
        }
        let mean = multiply(&self.reach, &offset, n);
        for k in 0..TERMS {
            let homogeneous = multiply(&self.homogeneous[k], &mean, n);
            for i in 0..n {
                solution[i][k] = particular[k][i] + homogeneous[i];
            }
        }
    }
}

fn product(a: &[f64], b: &[f64], n: usize) -> Vec<f64> {
    let mut c = vec![0.0; n * n];
    for i in 0..n {
        for k in 0..n {
            for j in 0..n {
                c[i * n + j] += a[i * n + k] * b[k * n + j];
            }
        }
    }
    c
}

fn scale(a: &mut [f64], factor: f64) {
    for v in a {
        *v *= factor;
    }
}

fn multiply(a: &[f64], x: &[f64], n: usize) -> Vec<f64> {
    a.chunks_exact(n).map(|row| row.iter().zip(x).map(|(a, x)| a * x).sum()).collect()
}

/// Inverse by elimination with pivoting; `None` if the matrix is close to singular.
fn inverted(mut a: Vec<f64>, n: usize) -> Option<Vec<f64>> {
    let size = a.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let mut inverse = vec![0.0; n * n];
    (0..n).for_each(|i| inverse[i * n + i] = 1.0);
    for column in 0..n {
        let pivot =
            (column..n).max_by(|&i, &j| a[i * n + column].abs().total_cmp(&a[j * n + column].abs()))?;
        if a[pivot * n + column].abs() <= 1e-3 * size.min(1.0) {
            return None;
        }
        for j in 0..n {
            a.swap(pivot * n + j, column * n + j);
            inverse.swap(pivot * n + j, column * n + j);
        }
        let factor = 1.0 / a[column * n + column];
        for j in 0..n {
            a[column * n + j] *= factor;
            inverse[column * n + j] *= factor;
        }
        for i in (0..n).filter(|&i| i != column) {
            let factor = a[i * n + column];
            for j in 0..n {
                a[i * n + j] -= factor * a[column * n + j];
                inverse[i * n + j] -= factor * inverse[column * n + j];
            }
        }
    }
    inverse.iter().all(|v| v.is_finite()).then_some(inverse)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::response::legendre::{tail, value};

    #[test]
    fn a_lag_decays_as_the_exponential_while_the_cell_resolves_it() {
        for m in [-1e-9, -0.3, -2.0, -5.0, 1.0] {
            let x = Lag::new(m).solve(&[0.0; TERMS], 1.0);
            for s in [-0.5, 0.4, 1.0] {
                // 1e-13: the 25th coefficient of e^(5s) relative to its start.
                assert!((value(&x, s) - f64::exp(m * (s + 1.0))).abs() < 1e-13, "{m} {s}");
            }
        }
    }

    #[test]
    fn a_stiff_lag_follows_a_slow_forcing_and_shows_a_layer_it_cannot_resolve() {
        let mut g = [0.0; TERMS];
        (g[0], g[1]) = (1e4, 1e4); // dx/ds = −1e4·(x − (1 + s))
        let slow = Lag::new(-1e4).solve(&g, -1e-4);
        assert!((ends(&slow).1 - (2.0 - 1e-4)).abs() < 1e-15 && tail(&slow) == 0.0);
        assert!(tail(&Lag::new(-1e4).solve(&g, 1.0)) > 1e-3);
    }

    #[test]
    fn the_two_ways_to_solve_agree_where_they_meet() {
        let g: Poly = std::array::from_fn(|k| 0.3f64.powi(i32::try_from(k).unwrap()));
        let (mut below, above) = (Lag::new(-STIFF), Lag::new(-STIFF));
        below.m = 0.0;
        for start in [0.002, 0.5] {
            let (x, y) = (below.solve(&g, start), above.solve(&g, start));
            for k in 0..TERMS {
                // 1e-13: rounding times 2k+1, relative to the start.
                assert!((x[k] - y[k]).abs() < 1e-13 * start, "{k}: {} {}", x[k], y[k]);
            }
        }
    }

    #[test]
    fn coupled_lags_oscillate_as_they_should() {
        // x'' + 2·ζ·ω·x' + ω²·x = 0 with ω = 2, ζ = 0.5 from x = 1, x' = 0, over a cell of length 2.
        let matrix = vec![0.0, 1.0, -4.0, -2.0];
        let mut x = [[0.0; TERMS]; 2];
        CoupledLags::new(matrix, 2).unwrap().solve(&[[0.0; TERMS]; 2], &[1.0, 0.0], &mut x);
        let (t, damped) = (2.0f64, 3.0f64.sqrt());
        let exact = (-t).exp() * ((damped * t).cos() + (damped * t).sin() / damped);
        // 1e-14: rounding.
        assert!((ends(&x[0]).1 - exact).abs() < 1e-14);
    }
}
