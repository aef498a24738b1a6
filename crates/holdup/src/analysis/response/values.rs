//! Values of signals at many times, eight times to a vector.

#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the instruction set chosen at run time"
)]

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f64x8};

use super::layered::{INVERSE, LAYER_TERMS, Layer, Segment, Signal, exponential};
use super::legendre::{Poly, TERMS, magnitude, powers, significant};

/// What is this part of a signal is not seen.
const UNSEEN: f64 = 1e-13;

/// Vectors that are worked on together, so that none waits for another.
const VECTORS: usize = 4;
/// Times that are worked on together.
const BATCH: usize = 8 * VECTORS;

/// Where a stretch of time lies.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// Start [s].
    pub(super) start: f64,
    /// Length [s].
    pub(super) length: f64,
    /// Rate of the layers [1/s].
    pub(super) rate: f64,
}

/// One signal over a stretch of time: a polynomial of s, which runs from −1 to 1, and a layer `e^(−θ)·Q(θ)`.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    /// Coefficients of the powers of s; 0 where they do not count.
    powers: Poly,
    terms: usize,
    /// Coefficients of the powers of θ; 0 where they do not count.
    layer: Layer,
    layer_terms: usize,
    /// The layer is not seen, and left out, from so long after the start on [s].
    over: f64,
}

impl Curve {
    /// The signal with these Legendre coefficients.
    pub(super) fn of_cell(poly: &Poly) -> Self {
        let (powers, terms) = powers(poly);
        Self { powers, terms, layer: [0.0; LAYER_TERMS], layer_terms: 0, over: f64::NEG_INFINITY }
    }

    pub(super) fn of_segment(segment: &Segment<'_>, signal: &Signal) -> Self {
        let mut layer = [0.0; LAYER_TERMS];
        let given = &signal.layer[..segment.terms];
        let floor = UNSEEN * (magnitude(&signal.smooth) + given.iter().map(|q| q.abs()).sum::<f64>());
        // No e^(−θ)·θ^j/j! exceeds 1.
        let mut left_out = 0.0;
        let counts = |q: &f64| {
            left_out += q.abs();
            left_out > floor
        };
        let layer_terms = given.iter().rposition(counts).map_or(0, |last| last + 1);
        let mut scale = 1.0;
        for (j, (power, q)) in layer.iter_mut().zip(&given[..layer_terms]).enumerate() {
            *power = scale * q;
            scale *= INVERSE[j + 1];
        }
        let seen = segment.layer_over(signal, UNSEEN);
        let (mut powers, terms) = (signal.smooth, significant(&signal.smooth, floor));
        powers[terms..].fill(0.0);
        Self { powers, terms, layer, layer_terms, over: seen / segment.rate.max(f64::MIN_POSITIVE) }
    }

    /// `level − self`.
    pub(super) fn below(mut self, level: f64) -> Self {
        for c in &mut self.powers[..self.terms] {
            *c = -*c;
        }
        for c in &mut self.layer[..self.layer_terms] {
            *c = -*c;
        }
        self.powers[0] += level;
        self.terms = self.terms.max(1);
        self
    }
}

/// The values of these signals at these times [s], in rising order, of one stretch of time.
pub(super) fn evaluate(place: Place, curves: &[Curve], times: &[f64], values: &mut [&mut [f64]]) {
    dispatch!(Level::new(), simd => simd.vectorize(
        #[inline(always)]
        || in_batches(simd, place, curves, times, values)
    ));
}

#[inline(always)]
fn in_batches<S: Simd>(simd: S, place: Place, curves: &[Curve], times: &[f64], values: &mut [&mut [f64]]) {
    let (batches, rest) = times.as_chunks::<BATCH>();
    for (index, times) in batches.iter().enumerate() {
        batch(
            simd,
            place,
            curves,
            times,
            #[inline(always)]
            |curve, found| {
                let values = &mut values[curve][BATCH * index..BATCH * (index + 1)];
                for v in 0..VECTORS {
                    found[v].store_slice(&mut values[8 * v..8 * v + 8]);
                }
            },
        );
    }
    if let Some(last) = rest.last() {
        let mut filled = [*last; BATCH];
        filled[..rest.len()].copy_from_slice(rest);
        batch(
            simd,
            place,
            curves,
            &filled,
            #[inline(always)]
            |curve, found| {
                let mut all = [0.0; BATCH];
                for v in 0..VECTORS {
                    found[v].store_slice(&mut all[8 * v..8 * v + 8]);
                }
                values[curve][BATCH * batches.len()..].copy_from_slice(&all[..rest.len()]);
            },
        );
    }
}

/// Hands on, for each signal, its values at these times.
#[inline(always)]
fn batch<S: Simd>(
    simd: S,
    place: Place,
    curves: &[Curve],
    times: &[f64; BATCH],
    mut each: impl FnMut(usize, [f64x8<S>; VECTORS]),
) {
    let (mut since, mut s, mut squares) =
        ([splat(simd, 0.0); VECTORS], [splat(simd, 0.0); VECTORS], [splat(simd, 0.0); VECTORS]);
    for v in 0..VECTORS {
        since[v] = f64x8::from_slice(simd, &times[8 * v..8 * v + 8]) - place.start;
        s[v] = since[v].mul_add(splat(simd, 2.0 / place.length), splat(simd, -1.0));
        squares[v] = s[v] * s[v];
    }
    if curves.iter().all(|curve| curve.over <= times[0] - place.start) {
        for (index, curve) in curves.iter().enumerate() {
            each(index, horner(&curve.powers, curve.terms, s, squares));
        }
        return;
    }
    let (mut theta, mut decayed, mut squares_of_theta) = (since, since, since);
    for v in 0..VECTORS {
        // Beyond 700 nothing is left of any layer.
        theta[v] = (since[v] * place.rate).min(splat(simd, 700.0));
        decayed[v] = exponential(-theta[v]);
        squares_of_theta[v] = theta[v] * theta[v];
    }
    for (index, curve) in curves.iter().enumerate() {
        let mut sums = horner(&curve.powers, curve.terms, s, squares);
        let layer = horner(&curve.layer, curve.layer_terms, theta, squares_of_theta);
        for v in 0..VECTORS {
            // What one time is given does not depend on the others.
            let seen = since[v].simd_lt(curve.over);
            sums[v] = layer[v].mul_add(seen.select(decayed[v], splat(simd, 0.0)), sums[v]);
        }
        each(index, sums);
    }
}

/// `Σ c_j·x^j` over the first `terms`, even and odd powers apart: twice as many sums that do not wait for each other.
#[inline(always)]
fn horner<S: Simd>(
    coefficients: &[f64],
    terms: usize,
    x: [f64x8<S>; VECTORS],
    squares: [f64x8<S>; VECTORS],
) -> [f64x8<S>; VECTORS] {
    let simd = x[0].simd;
    let (mut even, mut odd) = ([splat(simd, 0.0); VECTORS], [splat(simd, 0.0); VECTORS]);
    let pairs = &coefficients.as_chunks::<2>().0[..terms.div_ceil(2)];
    for [c, next] in pairs.iter().rev() {
        for v in 0..VECTORS {
            even[v] = even[v].mul_add(squares[v], splat(simd, *c));
            odd[v] = odd[v].mul_add(squares[v], splat(simd, *next));
        }
    }
    for v in 0..VECTORS {
        even[v] = odd[v].mul_add(x[v], even[v]);
    }
    even
}

#[inline(always)]
fn splat<S: Simd>(simd: S, value: f64) -> f64x8<S> {
    f64x8::splat(simd, value)
}

const _: () =
    assert!(TERMS.is_multiple_of(2) && LAYER_TERMS.is_multiple_of(2), "coefficients are taken in pairs");

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::response::legendre::{interpolated, value};

    const PLACE: Place = Place { start: 2.0, length: 6.0, rate: 10.0 };

    /// Times over the place, in batches and a rest.
    fn times() -> Vec<f64> {
        (0..77).map(|i| 2.0 + 0.075 * f64::from(i)).collect()
    }

    #[test]
    fn a_polynomial_and_a_layer_are_added_at_any_number_of_times() {
        let mut curve = Curve::of_cell(&interpolated(|s| 1.0 + s - 0.5 * s * s * s));
        curve.layer[..3].copy_from_slice(&[0.5, -2.0, 1.5]);
        (curve.layer_terms, curve.over) = (3, f64::INFINITY);
        let curves = [curve.clone(), curve.below(7.0)];
        for count in [0, 1, 31, 32, 33, 77] {
            let times = &times()[..count];
            let (mut values, mut below) = (vec![0.0; count], vec![0.0; count]);
            evaluate(PLACE, &curves, times, &mut [&mut values, &mut below]);
            for ((t, value), below) in times.iter().zip(values).zip(below) {
                let (s, theta) = ((t - 2.0) / 3.0 - 1.0, 10.0 * (t - 2.0));
                let layer = (0.5 - 2.0 * theta + 1.5 * theta * theta) * (-theta).exp();
                let exact = 1.0 + s - 0.5 * s * s * s + layer;
                // 1e-14: rounding of numbers of size 1 to 7.
                assert!((value - exact).abs() < 1e-14 && (below - (7.0 - exact)).abs() < 1e-14, "{t}");
            }
        }
    }

    #[test]
    fn the_value_at_a_time_does_not_depend_on_the_other_times() {
        let mut curve = Curve::of_cell(&interpolated(|s| 1.0 + s));
        curve.layer[..3].copy_from_slice(&[0.5, -2.0, 1.5]);
        (curve.layer_terms, curve.over) = (3, 0.8);
        let (all, mut values) = (times(), vec![0.0; 77]);
        evaluate(PLACE, std::slice::from_ref(&curve), &all, &mut [&mut values]);
        for (t, expected) in all.iter().zip(values) {
            let mut alone = [0.0];
            evaluate(PLACE, std::slice::from_ref(&curve), &[*t], &mut [&mut alone]);
            assert_eq!(alone, [expected], "{t}");
        }
    }

    #[test]
    fn a_steep_cell_has_the_values_of_its_legendre_series() {
        // 5 is the steepest exponential that 24 terms hold to rounding: where the powers lose most.
        let p = interpolated(|s| f64::exp(5.0 * s));
        let (times, mut values) = (times(), vec![0.0; 77]);
        evaluate(PLACE, &[Curve::of_cell(&p)], &times, &mut [&mut values]);
        for (t, found) in times.iter().zip(values) {
            // 1e-13 relative to the largest value, e⁵: rounding of 24 terms.
            assert!((found - value(&p, (t - 2.0) / 3.0 - 1.0)).abs() < 1e-13 * 5f64.exp(), "{t}");
        }
    }
}
