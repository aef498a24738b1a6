//! Constants of the two bases, computed once.

use std::sync::LazyLock;

use super::super::legendre::{Poly, TERMS, add, gauss, gauss_rule};
use super::signal::{LAYER_TERMS, Layer};

/// `1/j`, and 0 for j = 0.
#[expect(clippy::cast_precision_loss, reason = "at most 64")]
pub(in super::super) const INVERSE: [f64; LAYER_TERMS + 1] = {
    let mut table = [0.0; LAYER_TERMS + 1];
    let mut j = 1;
    while j <= LAYER_TERMS {
        table[j] = 1.0 / j as f64;
        j += 1;
    }
    table
};

/// Points on the layer's axis between which one polynomial holds a layer, in most cases to rounding.
pub(super) const EDGES: [f64; 11] = [0.0, 5.0, 12.0, 20.0, 30.0, 42.0, 58.0, 78.0, 104.0, 140.0, 190.0];

/// Pairs of points to both sides of the middle, and the weights of half the integral over s.
pub(super) struct Points<const N: usize> {
    /// Squares of s.
    pub(super) squares: [f64; N],
    pub(super) weights: [f64; N],
}

impl<const N: usize> Points<N> {
    /// Pairs of a Gauss rule, from pair `from` on, counted from the ends.
    fn new(nodes: &[f64], weights: &[f64], from: usize) -> Self {
        Self {
            squares: std::array::from_fn(|k| nodes[from + k] * nodes[from + k]),
            weights: std::array::from_fn(|k| weights[from + k]),
        }
    }
}

/// What integrals over layers are made of.
pub(super) struct Tables {
    /// `C(i+j, i)`: `∫ e^(−θ)·θ^i/i!·θ^j/j! dθ` from 0 to ∞.
    pub(super) moments: [Layer; TERMS],
    /// `C(i+j, i)/2^(i+j+1)`, the same with e^(−2θ), for j = i, and twice that for j < i: what the square of a layer is the
    /// sum of.
    pub(super) squares: [Layer; LAYER_TERMS],
    /// `i!·C(j, i)·(−1)^(j−i)`: what coefficient j of a smooth part adds to its i-th derivative at s = −1.
    pub(super) at_start: [Poly; TERMS],
    /// The same at s = 1: `i!·C(j, i)`.
    pub(super) at_end: [Poly; TERMS],
    /// Half of `∫s^j` and of `∫s·s^j` from −1 to 1.
    pub(super) areas: Poly,
    pub(super) moments_about_middle: Poly,
    /// Gauss rules: exact for squares of polynomials of as many terms.
    pub(super) sixteen: Points<8>,
    pub(super) twenty_four: [Points<6>; 2],
    /// Largest value of `e^(−θ)·θ^j/j!` from each edge on.
    pub(super) bounds: [Layer; EDGES.len()],
    /// Legendre series of `e^(−θ)·θ^j/j!` from each edge to the next.
    pub(super) layers: [[Poly; LAYER_TERMS]; EDGES.len() - 1],
    /// Legendre series of `θ^i/i!` from each edge to the next.
    pub(super) powers: [[Poly; TERMS]; EDGES.len() - 1],
}

pub(super) static TABLES: LazyLock<Box<Tables>> = LazyLock::new(|| {
    let mut binomial = [[0.0; 2 * LAYER_TERMS]; 2 * LAYER_TERMS];
    for n in 0..2 * LAYER_TERMS {
        binomial[n][0] = 1.0;
        for k in 1..=n {
            binomial[n][k] = binomial[n - 1][k - 1] + binomial[n - 1][k];
        }
    }
    let mut half_powers = [0.5; 2 * LAYER_TERMS];
    for n in 1..2 * LAYER_TERMS {
        half_powers[n] = 0.5 * half_powers[n - 1];
    }
    let moments = std::array::from_fn(|i| std::array::from_fn(|j| binomial[i + j][i]));
    let mut squares = [[0.0; LAYER_TERMS]; LAYER_TERMS];
    for (i, row) in squares.iter_mut().enumerate() {
        for (j, entry) in row[..=i].iter_mut().enumerate() {
            *entry = binomial[i + j][i] * half_powers[i + j] * if j < i { 2.0 } else { 1.0 };
        }
    }
    let mut factorial = 1.0;
    let mut number = 0.0;
    let mut at_start = [[0.0; TERMS]; TERMS];
    for (i, row) in at_start.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate().skip(i) {
            *entry = if (j - i) % 2 == 0 { factorial } else { -factorial } * binomial[j][i];
        }
        number += 1.0;
        factorial *= number;
    }
    let at_end = at_start.map(|row| row.map(f64::abs));
    let bounds = EDGES.map(|edge| {
        let mut weights = [0.0; LAYER_TERMS];
        let mut order = 0.0f64;
        let mut log_factorial = 0.0;
        for w in &mut weights {
            let theta = edge.max(order);
            let power = if order > 0.0 { order * theta.ln() } else { 0.0 };
            *w = (power - theta - log_factorial).exp();
            order += 1.0;
            log_factorial += order.ln();
        }
        weights
    });
    let (all_nodes, all_weights, transform) = gauss();
    let (nodes, weights) = gauss_rule::<16>();
    let sixteen = Points::new(&nodes, &weights, 0);
    let twenty_four = [0, 6].map(|from| Points::new(&all_nodes, &all_weights, from));
    let piece = |i: usize| (0.5 * (EDGES[i] + EDGES[i + 1]), 0.5 * (EDGES[i + 1] - EDGES[i]));
    let mut layers = [[[0.0; TERMS]; LAYER_TERMS]; EDGES.len() - 1];
    let mut powers = [[[0.0; TERMS]; TERMS]; EDGES.len() - 1];
    for i in 0..EDGES.len() - 1 {
        let (middle, half) = piece(i);
        for (x, row) in all_nodes.iter().zip(&transform) {
            let theta = middle + half * x;
            let (mut power, mut decayed, mut order) = (1.0, (-theta).exp(), 0.0);
            for j in 0..LAYER_TERMS {
                if let Some(poly) = powers[i].get_mut(j) {
                    add(poly, power, row);
                }
                add(&mut layers[i][j], decayed, row);
                order += 1.0;
                power *= theta / order;
                decayed *= theta / order;
            }
        }
    }
    let areas = std::array::from_fn(|j| if j % 2 == 0 { INVERSE[j + 1] } else { 0.0 });
    let moments_about_middle = std::array::from_fn(|j| if j % 2 == 1 { INVERSE[j + 2] } else { 0.0 });
    Box::new(Tables {
        moments,
        squares,
        at_start,
        at_end,
        areas,
        moments_about_middle,
        sixteen,
        twenty_four,
        bounds,
        layers,
        powers,
    })
});
