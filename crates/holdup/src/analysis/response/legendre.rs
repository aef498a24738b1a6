//! Polynomials on one cell in the Legendre basis, `p(s) = Σ c_k·P_k(s)` with s from −1 to 1.
//!
//! Why this basis: `∫p` and `∫p²` are sums over coefficients, `|p − c_0|` is bounded by the sum of the others (every
//! Legendre polynomial is at most 1), integration is an index shift, and a lag of any stiffness is a tridiagonal system that is
//! well conditioned (see `lag.rs`).

use std::sync::LazyLock;

/// Number of coefficients of a cell's polynomial.
pub(super) const TERMS: usize = 24;

/// Coefficients of a polynomial on one cell.
pub(super) type Poly = [f64; TERMS];

/// `1/(2k+1)`.
#[expect(clippy::cast_precision_loss, reason = "k is at most 24")]
const RECIPROCAL: [f64; TERMS + 1] = {
    let mut table = [0.0; TERMS + 1];
    let mut k = 0;
    while k <= TERMS {
        table[k] = 1.0 / (2 * k + 1) as f64;
        k += 1;
    }
    table
};

/// `2k+1`.
#[expect(clippy::cast_precision_loss, reason = "k is at most 24")]
pub(super) const ODD: Poly = {
    let mut table = [0.0; TERMS];
    let mut k = 0;
    while k < TERMS {
        table[k] = (2 * k + 1) as f64;
        k += 1;
    }
    table
};

/// Clenshaw factors `(2k+1)/(k+1)` and `(k+1)/(k+2)`.
#[expect(clippy::cast_precision_loss, reason = "k is at most 24")]
const CLENSHAW: [(f64, f64); TERMS] = {
    let mut table = [(0.0, 0.0); TERMS];
    let mut k = 0;
    while k < TERMS {
        table[k] = ((2 * k + 1) as f64 / (k + 1) as f64, (k + 1) as f64 / (k + 2) as f64);
        k += 1;
    }
    table
};

/// Value at `s` of the polynomial with these (possibly trimmed) coefficients.
pub(super) fn value(coefficients: &[f64], s: f64) -> f64 {
    let (mut one, mut two) = (0.0, 0.0);
    for k in (0..coefficients.len().min(TERMS)).rev() {
        let (a, b) = CLENSHAW[k];
        let zero = (coefficients[k] - b * two) + a * s * one;
        two = one;
        one = zero;
    }
    one
}

/// Power-basis coefficients of each Legendre polynomial, row k for degree k.
static POWERS: LazyLock<[Poly; TERMS]> = LazyLock::new(|| {
    let mut table = [[0.0; TERMS]; TERMS];
    table[0][0] = 1.0;
    table[1][1] = 1.0;
    let mut k = 1.0;
    for i in 1..TERMS - 1 {
        for j in 0..TERMS {
            let shifted = if j > 0 { table[i][j - 1] } else { 0.0 };
            table[i + 1][j] = ((2.0 * k + 1.0) * shifted - k * table[i - 1][j]) / (k + 1.0);
        }
        k += 1.0;
    }
    table
});

/// Power-basis coefficients of `p`, lowest first, and how many there are: the fastest form for many points. The last
/// coefficients of p, up to rounding of its values, are left out: the power basis would enlarge their noise.
pub(super) fn powers(p: &Poly) -> (Poly, usize) {
    let terms = significant(p, 1e-16 * magnitude(p));
    let mut sum = [0.0; TERMS];
    for (c, row) in p[..terms].iter().zip(POWERS.iter()) {
        add(&mut sum, *c, row);
    }
    (sum, terms)
}

/// Legendre coefficients of each power of s.
static OF_POWERS: LazyLock<[Poly; TERMS]> = LazyLock::new(|| {
    let mut table = [[0.0; TERMS]; TERMS];
    table[0][0] = 1.0;
    for j in 1..TERMS {
        table[j] = times_s(&table[j - 1]);
    }
    table
});

/// Legendre coefficients of the polynomial with these coefficients of powers.
pub(super) fn from_powers(c: &Poly) -> Poly {
    let mut sum = [0.0; TERMS];
    for (c, row) in c.iter().zip(OF_POWERS.iter()) {
        add(&mut sum, *c, row);
    }
    sum
}

/// Values at both ends, s = −1 and s = 1.
#[inline]
pub(super) fn ends(p: &Poly) -> (f64, f64) {
    let mut lanes = [0.0; LANES];
    for k in 0..TERMS {
        lanes[k % LANES] += p[k];
    }
    let [a, b, c, d, e, f, g, h] = lanes;
    let (even, odd) = ((a + e) + (c + g), (b + f) + (d + h));
    (even - odd, even + odd)
}

/// Sum of the magnitudes of all coefficients but the first: a bound on `|p − c_0|`.
pub(super) fn swing(p: &Poly) -> f64 {
    magnitude(p) - p[0].abs()
}

/// Sum of the magnitudes of the coefficients: a bound on |p|.
#[inline]
pub(super) fn magnitude(p: &Poly) -> f64 {
    let mut lanes = [0.0; LANES];
    for k in 0..TERMS {
        lanes[k % LANES] += p[k].abs();
    }
    total(lanes)
}

/// Sums are gathered in as many lanes, so that they need not wait for each other.
const LANES: usize = 8;

#[inline]
fn total([a, b, c, d, e, f, g, h]: [f64; LANES]) -> f64 {
    ((a + e) + (b + f)) + ((c + g) + (d + h))
}

/// Size of the last coefficients: what the cell's resolution is judged by.
pub(super) fn tail(p: &Poly) -> f64 {
    p[TERMS - 3].abs() + p[TERMS - 2].abs() + p[TERMS - 1].abs()
}

/// `p += weight·q`.
#[inline]
pub(super) fn add(p: &mut Poly, weight: f64, q: &Poly) {
    for k in 0..TERMS {
        p[k] += weight * q[k];
    }
}

/// Right-hand side of the integrated equation: coefficients 1… of `∫g` (coefficient 0 is that of `∫` from −1).
pub(super) fn integrated(g: &Poly) -> Poly {
    let mut x = [0.0; TERMS];
    x[0] = g[0] - g[1] * RECIPROCAL[1];
    for k in 1..TERMS - 1 {
        x[k] = g[k - 1] * RECIPROCAL[k - 1] - g[k + 1] * RECIPROCAL[k + 1];
    }
    x[TERMS - 1] = g[TERMS - 2] * RECIPROCAL[TERMS - 2];
    x
}

/// `∫_{−1}^{1} p² ds`.
#[inline]
pub(super) fn square_integral(p: &Poly) -> f64 {
    let mut lanes = [0.0; LANES];
    for k in 0..TERMS {
        lanes[k % LANES] += p[k] * p[k] * RECIPROCAL[k];
    }
    2.0 * total(lanes)
}

/// `∫_{−1}^{s} p` and `∫_{−1}^{s} s·p`: the primitives from which integrals between roots are made.
pub(super) fn primitives(p: &Poly) -> (Poly, Poly) {
    (integrated(p), integrated(&times_s(p)))
}

/// `s·p(s)`, its highest term dropped.
fn times_s(p: &Poly) -> Poly {
    let mut product = [0.0; TERMS];
    let mut k = 0.0;
    for i in 0..TERMS {
        // s·P_k = ((k+1)·P_{k+1} + k·P_{k−1}) / (2k+1)
        if i + 1 < TERMS {
            product[i + 1] += p[i] * (k + 1.0) * RECIPROCAL[i];
        }
        if i > 0 {
            product[i - 1] += p[i] * k * RECIPROCAL[i];
        }
        k += 1.0;
    }
    product
}

/// `dp/ds`.
pub(super) fn derivative(p: &Poly) -> Poly {
    let mut q = [0.0; TERMS];
    let (mut same, mut other) = (0.0, 0.0);
    for k in (0..TERMS - 1).rev() {
        // q_k = (2k+1)·(c_{k+1} + c_{k+3} + …)
        let sum: f64 = p[k + 1] + other;
        other = same;
        same = sum;
        q[k] = ODD[k] * sum;
    }
    q
}

/// Number of leading coefficients that matter: the rest are at most `floor` in sum.
pub(super) fn significant(p: &Poly, floor: f64) -> usize {
    let mut rest = 0.0;
    for k in (0..TERMS).rev() {
        rest += p[k].abs();
        if rest > floor {
            return k + 1;
        }
    }
    0
}

/// Gauss nodes and the transform from values at the nodes to coefficients.
struct Gauss {
    nodes: Poly,
    weights: Poly,
    transform: [Poly; TERMS],
}

/// Gauss nodes in increasing order, and their weights.
pub(super) fn gauss_rule<const N: usize>() -> ([f64; N], [f64; N]) {
    let (mut nodes, mut weights) = ([0.0; N], [0.0; N]);
    let mut index = 0.0;
    for i in 0..N {
        #[expect(clippy::cast_precision_loss, reason = "at most 24")]
        let n = N as f64;
        let mut s = -(std::f64::consts::PI * (index + 0.75) / (n + 0.5)).cos();
        for _ in 0..20 {
            let (p, dp) = of_degree(N, s);
            s -= p / dp;
        }
        let (_, dp) = of_degree(N, s);
        nodes[i] = s;
        weights[i] = 2.0 / ((1.0 - s * s) * dp * dp);
        index += 1.0;
    }
    (nodes, weights)
}

static GAUSS: LazyLock<Gauss> = LazyLock::new(|| {
    let (nodes, weights) = gauss_rule::<TERMS>();
    let basis = basis(&nodes);
    let mut transform = [[0.0; TERMS]; TERMS];
    for k in 0..TERMS {
        for i in 0..TERMS {
            transform[i][k] = 0.5 * ODD[k] * weights[i] * basis[k][i];
        }
    }
    Gauss { nodes, weights, transform }
});

/// Gauss nodes in increasing order, their weights, and what a value of 1 at each node adds to the coefficients.
pub(super) fn gauss() -> (Poly, Poly, [Poly; TERMS]) {
    (GAUSS.nodes, GAUSS.weights, GAUSS.transform)
}

/// The polynomial that has the values of `f` at the Gauss nodes.
pub(super) fn interpolated(f: impl Fn(f64) -> f64) -> Poly {
    let mut p = [0.0; TERMS];
    for (x, row) in GAUSS.nodes.iter().zip(&GAUSS.transform) {
        add(&mut p, f(*x), row);
    }
    p
}

/// The Legendre polynomial of this degree and its derivative at `s`.
fn of_degree(degree: usize, s: f64) -> (f64, f64) {
    let (mut before, mut now, mut k) = (1.0, s, 1.0);
    for _ in 1..degree {
        (before, now) = (now, ((2.0 * k + 1.0) * s * now - k * before) / (k + 1.0));
        k += 1.0;
    }
    (now, k * (s * now - before) / (s * s - 1.0))
}

/// All Legendre polynomials at 24 points.
fn basis(points: &Poly) -> [Poly; TERMS] {
    let mut table = [[1.0; TERMS]; TERMS];
    table[1] = *points;
    let mut k = 1.0;
    for i in 1..TERMS - 1 {
        for j in 0..TERMS {
            table[i + 1][j] = ((2.0 * k + 1.0) * points[j] * table[i][j] - k * table[i - 1][j]) / (k + 1.0);
        }
        k += 1.0;
    }
    table
}

/// Values of `p` at `middle + half·node` for all Gauss nodes.
fn values_at_nodes(p: &[f64], middle: f64, half: f64) -> Poly {
    let points = GAUSS.nodes.map(|x| middle + half * x);
    let (mut one, mut two) = ([0.0; TERMS], [0.0; TERMS]);
    for (c, (a, b)) in p.iter().zip(&CLENSHAW).rev() {
        for j in 0..TERMS {
            let zero = c + a * points[j] * one[j] - b * two[j];
            two[j] = one[j];
            one[j] = zero;
        }
    }
    one
}

/// The polynomial of `p` on the part of its cell from `from` to `to` (within −1…1), as a cell of its own.
pub(super) fn restricted(p: &[f64], from: f64, to: f64) -> Poly {
    let mut part = [0.0; TERMS];
    if p.len() <= 1 {
        part[0] = p.first().copied().unwrap_or(0.0);
        return part;
    }
    let values = values_at_nodes(p, 0.5 * (from + to), 0.5 * (to - from));
    for (value, row) in values.iter().zip(&GAUSS.transform) {
        add(&mut part, *value, row);
    }
    // A part has the degree of the whole: what the sums leave above it is rounding.
    part[p.len()..].fill(0.0);
    without_noise(&mut part);
    part
}

/// Drops the last coefficients of a projection that are rounding of the sums they came from: coefficient k carries the
/// rounding of values times 2k+1.
pub(super) fn without_noise(p: &mut Poly) {
    let noise = 2.0 * f64::EPSILON * p.iter().fold(0.0f64, |m, c| m.max(c.abs()));
    for k in (0..TERMS).rev() {
        if p[k].abs() > noise * ODD[k] {
            break;
        }
        p[k] = 0.0;
    }
}

/// Adds to `sum` the exact projection of a piece: `p` between `from` and `to` of its own cell fills the new cell
/// from `start` to `end`, and the rest of the new cell is 0.
pub(super) fn project(sum: &mut Poly, p: &[f64], (from, to): (f64, f64), (start, end): (f64, f64)) {
    if p.is_empty() {
        return;
    }
    let values = values_at_nodes(p, 0.5 * (from + to), 0.5 * (to - from));
    let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
    let table = basis(&GAUSS.nodes.map(|x| middle + half * x));
    for k in 0..TERMS {
        let mut dot = 0.0;
        for i in 0..TERMS {
            dot += values[i] * GAUSS.weights[i] * table[k][i];
        }
        sum[k] += 0.5 * ODD[k] * half * dot;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// e^(rate·s).
    fn exponential(rate: f64) -> Poly {
        interpolated(|x| (rate * x).exp())
    }

    #[test]
    fn values_derivatives_and_integrals_of_an_exponential_are_those_of_an_exponential() {
        let p = exponential(0.7);
        let mut primitive = integrated(&p);
        primitive[0] += (-0.7f64).exp() / 0.7;
        // 1e-14: rounding of 24 terms of size 1; the derivative of rounding grows with the cube of the index.
        for s in [-1.0, -0.3, 0.0, 0.55, 1.0] {
            let exact = f64::exp(0.7 * s);
            assert!((value(&p, s) - exact).abs() < 1e-14);
            assert!((value(&derivative(&p), s) - 0.7 * exact).abs() < 1e-11);
            assert!((value(&primitive, s) - exact / 0.7).abs() < 1e-14);
        }
        assert!((square_integral(&p) - 1.4f64.sinh() / 0.7).abs() < 1e-14);
        assert!((ends(&p).0 - (-0.7f64).exp()).abs() < 1e-14 && (ends(&p).1 - 0.7f64.exp()).abs() < 1e-14);
    }

    #[test]
    fn a_part_of_a_cell_is_the_same_function() {
        // 1e-13: coefficient k of a projection carries rounding times 2k+1.
        let (p, half) = (exponential(1.3), restricted(&exponential(1.3), -0.2, 0.7));
        for s in [-1.0f64, 0.1, 1.0] {
            assert!((value(&half, s) - value(&p, 0.25 + 0.45 * s)).abs() < 1e-13);
        }
    }

    #[test]
    fn projection_of_two_halves_is_the_whole() {
        let p = exponential(1.3);
        let (left, right) = (restricted(&p, -1.0, 0.2), restricted(&p, 0.2, 1.0));
        let mut sum = [0.0; TERMS];
        project(&mut sum, &left, (-1.0, 1.0), (-1.0, 0.2));
        project(&mut sum, &right, (-1.0, 1.0), (0.2, 1.0));
        for k in 0..TERMS {
            assert!((sum[k] - p[k]).abs() < 1e-13, "{k}");
        }
    }
}
