//! Fixed places on the axis of x = ω², with what the proof of the sensitivity peak needs of cos√x, √x·sin√x and their
//! multiples by powers of x. All are power series in x that converge everywhere.

use std::sync::LazyLock;

/// Terms of the series: at x = 10 the last is below 1e-60.
const TERMS: usize = 32;
/// Beyond (π)² no loop of the normal form has its first phase crossover.
const TOP: f64 = 9.9;
/// Where the finest loops begin: a crossover of 0.0005 rad per dead time.
const BOTTOM: f64 = 2.5e-7;

/// The functions that the proof combines: 1/x and then cos√x, x·cos√x, x²·cos√x, √x·sin√x, x·√x·sin√x.
pub(super) const FUNCTIONS: usize = 6;

/// The fourth derivatives of the functions at x = 0, without sign; 1/x has none.
pub(super) const WEIGHTS: [f32; FUNCTIONS] = [0.0, 1.0 / 1680.0, 1.0 / 30.0, 1.0, 1.0 / 210.0, 0.2];

/// One place, in single precision: that is enough for a proof that leaves a margin.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) x: f32,
    pub(super) omega: f64,
    /// The functions here.
    pub(super) values: [f32; FUNCTIONS],
    /// Their second derivatives by x.
    pub(super) curvatures: [f32; FUNCTIONS],
    /// How far the second derivative of 1/x, and those of the others per [`WEIGHTS`], may lie beside the straight line to
    /// the next place, roundings included.
    pub(super) beside: [f32; 2],
    /// An eighth of the square of the distance to the next place.
    pub(super) sag: f32,
}

/// Relative, more than ten roundings in single precision add up to.
pub(super) const ROUNDING: f64 = 2e-6;

/// The nearest number in single precision.
#[expect(clippy::cast_possible_truncation, reason = "rounded on purpose")]
pub(super) fn single(value: f64) -> f32 {
    value as f32
}

/// Places in rising order; the last has no next one.
pub(super) struct Mesh {
    pub(super) nodes: Vec<Node>,
}

/// The mesh on which most loops are proven.
pub(super) static COARSE: LazyLock<Mesh> = LazyLock::new(|| Mesh::new(0.3, 0.6));
/// The mesh for the others.
pub(super) static FINE: LazyLock<Mesh> = LazyLock::new(|| Mesh::new(0.08, 0.1));

impl Mesh {
    /// Cells no longer than these, relative to their lower end and absolute.
    fn new(relative: f64, absolute: f64) -> Self {
        let mut places = vec![TOP];
        let mut x = TOP;
        while x > BOTTOM {
            x = (x / (1.0 + relative)).max(x - absolute);
            places.push(x);
        }
        places.reverse();
        let series = series();
        let node = |i: usize| {
            let x = places[i];
            let next = places.get(i + 1).copied().unwrap_or(x);
            let of = |order: usize, x: f64, own: f64| {
                let mut all = [own; FUNCTIONS];
                for (value, terms) in all[1..].iter_mut().zip(&series) {
                    *value = derivative(terms, order, x);
                }
                all
            };
            let curvatures = of(2, x, 2.0 / x.powi(3));
            let sag = (next - x).powi(2) / 8.0;
            // The fourth derivative of 1/x is greatest at the lower end; of a series it is that in the middle and at most
            // half a cell times the greatest fifth one.
            // 2/x³ lies below its chord, furthest where it has the chord's slope −6/x⁴.
            let fall = 2.0 * (next * next + next * x + x * x) / (next * x).powi(3);
            let furthest = (6.0 / fall).powf(0.25);
            let gap = curvatures[0] - fall * (furthest - x) - 2.0 / furthest.powi(3);
            let over = gap + ROUNDING * curvatures[0];
            let mut rest = 0.0_f64;
            for (function, terms) in series.iter().enumerate() {
                let middle = derivative(terms, 4, f64::midpoint(x, next)).abs();
                let fifth = derivative(&terms.map(f64::abs), 5, next);
                let own = (middle + 0.5 * (next - x) * fifth) * sag;
                let rounding =
                    ROUNDING * (of(2, next, 0.0)[function + 1].abs() + curvatures[function + 1].abs());
                rest = rest.max((own + rounding) / f64::from(WEIGHTS[function + 1]));
            }
            let beside = [over, rest].map(|bound| single(bound * (1.0 + ROUNDING)));
            let (values, curvatures) = (of(0, x, 1.0 / x).map(single), curvatures.map(single));
            Node {
                x: single(x),
                omega: x.sqrt(),
                values,
                curvatures,
                beside,
                sag: single(sag * (1.0 + ROUNDING)),
            }
        };
        Self { nodes: (0..places.len()).map(node).collect() }
    }
}

/// The coefficients of the functions that are power series.
fn series() -> [[f64; TERMS]; FUNCTIONS - 1] {
    let (mut cosine, mut sine) = ([0.0; TERMS], [0.0; TERMS]);
    let mut term = 1.0;
    let mut double = 0.0;
    for n in 0..TERMS {
        // (−1)ⁿ/(2n)! and, of √x·sin√x, (−1)ⁿ/(2n + 1)! one power higher.
        cosine[n] = term;
        if let Some(next) = sine.get_mut(n + 1) {
            *next = term / (double + 1.0);
        }
        term /= -(double + 1.0) * (double + 2.0);
        double += 2.0;
    }
    let raised = |terms: &[f64; TERMS], powers: usize| -> [f64; TERMS] {
        std::array::from_fn(|n| if n < powers { 0.0 } else { terms[n - powers] })
    };
    [cosine, raised(&cosine, 1), raised(&cosine, 2), sine, raised(&sine, 1)]
}

/// A derivative of a power series.
#[expect(clippy::cast_precision_loss, reason = "at most 32")]
fn derivative(terms: &[f64; TERMS], order: usize, x: f64) -> f64 {
    (order..TERMS).rev().fold(0.0, |sum, n| {
        let factor: f64 = (n + 1 - order..=n).map(|m| m as f64).product();
        sum * x + factor * terms[n]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_hold_the_functions_and_bound_their_curvature() {
        let series = series();
        for mesh in [&*COARSE, &*FINE] {
            for (node, next) in mesh.nodes.iter().zip(&mesh.nodes[1..]) {
                let (x, end) = (f64::from(node.x), f64::from(next.x));
                let (sin, cos) = x.sqrt().sin_cos();
                let values = [1.0 / x, cos, x * cos, x * x * cos, x.sqrt() * sin, x * x.sqrt() * sin];
                for (value, expected) in node.values.iter().zip(values) {
                    // Single precision, of the place and of the value.
                    let off = (f64::from(*value) - expected).abs();
                    assert!(off <= 3e-7 * (expected.abs() + x.powi(3)), "{x}");
                }
                for part in 0..=20 {
                    let share = f64::from(part) / 20.0;
                    let at = x + share * (end - x);
                    let off = |function: usize, exact: f64| {
                        let [from, to] = [node, next].map(|node| f64::from(node.curvatures[function]));
                        (exact - (from * (1.0 - share) + to * share)).abs()
                    };
                    assert!(off(0, 2.0 / at.powi(3)) <= f64::from(node.beside[0]), "1/x at {at}");
                    for function in 1..FUNCTIONS {
                        let bound = f64::from(node.beside[1]) * f64::from(WEIGHTS[function]);
                        let exact = derivative(&series[function - 1], 2, at);
                        assert!(off(function, exact) <= bound, "{function} at {at}");
                    }
                }
            }
        }
    }
}
