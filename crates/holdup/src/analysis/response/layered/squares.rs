//! `∫e²` and `∫u²` of several loops over a stretch, in closed form.

use super::super::legendre::{Poly, TERMS};
use super::integrals::ROUNDING;
use super::lanes::{Lanes, Set};
use super::propagate::Stretch;
use super::signal::LAYER_TERMS;
use super::signals::{End, Signals, in_chains};
use super::tables::{INVERSE, TABLES};

/// Sums of several loops, and the loops for which they are decided.
pub(super) type Decided<T> = (T, Set);

/// `∫e²` and `∫u²`; `so_far` are the sums they are added to.
pub(super) fn squares<V: Lanes>(stretch: &Stretch<'_, V>, so_far: (V, V)) -> (Decided<V>, Decided<V>) {
    V::widest(
        stretch.length.token(),
        #[inline(always)]
        || (square(stretch, stretch.error, so_far.0), square(stretch, stretch.manipulated, so_far.1)),
    )
}

/// `∫x²`; not decided where the smooth part, expanded about an end, does not converge over the layer.
///
/// What a layer that lasts longer than the stretch adds beyond it is taken away again.
#[inline(always)]
fn square<V: Lanes>(stretch: &Stretch<'_, V>, x: &Signals<V>, so_far: V) -> Decided<V> {
    let smooth = smooth_square(&x.smooth[..x.order]) * stretch.length;
    let layer = &x.layer[..stretch.terms];
    let (smooth_size, size) = x.sizes(stretch.terms);
    if size.largest() <= 0.0 {
        return (smooth, V::every());
    }
    let floor = (smooth + so_far) * stretch.rate * ROUNDING;
    let inverse = size.like(1.0) / stretch.rate;
    let mut sum = smooth;
    let mut decided = V::every();
    let left = stretch.end.area(layer, size.like(0.0));
    let ended = (left * (smooth_size + size) * 2.0).all_at_most(floor);
    let later = (!ended).then(|| shifted(stretch.end, layer));
    let later = later.as_ref().map(|later| &later[..layer.len()]);
    if !(size * smooth_size * 2.0).all_at_most(floor) {
        let p = &x.smooth[..x.order];
        let per_theta = inverse * 2.0 / stretch.length;
        let (mut product, mut converged) = product_sum(p, &TABLES.at_start, layer, per_theta, floor);
        if let Some(later) = later {
            let (beyond, too) = product_sum(p, &TABLES.at_end, later, per_theta, floor);
            product = product - beyond;
            converged = converged & too;
        }
        sum += product * inverse * 2.0;
        decided = converged;
    }
    if !(size * size).all_at_most(floor) {
        let mut square = square_sum(layer, size, floor);
        if let Some(later) = later {
            square = square - square_sum(later, size, floor);
        }
        sum += square * inverse;
    }
    (sum, decided)
}

/// A layer about the end of the stretch.
#[inline(always)]
pub(super) fn shifted<V: Lanes>(end: &End<V>, layer: &[V]) -> [V; LAYER_TERMS] {
    let mut later = [layer[0]; LAYER_TERMS];
    later[..layer.len()].copy_from_slice(layer);
    end.shift(&mut later[..layer.len()]);
    later
}

/// Half of `∫p²` over s.
#[inline(always)]
fn smooth_square<V: Lanes>(p: &[V]) -> V {
    // Coefficient k of p², for even k, is a sum over pairs of coefficients whose numbers add up to k.
    let mut sum = p[0].like(0.0);
    for half in 0..p.len() {
        let mut pairs = p[half] * p[half] * 0.5;
        for apart in 1..=half.min(p.len() - 1 - half) {
            pairs = p[half - apart].times_plus(p[half + apart], pairs);
        }
        sum = pairs.scaled_plus(2.0 * INVERSE[2 * half + 1], sum);
    }
    sum
}

/// `∫ smooth·layer dθ` from an end on, where the smooth part has these derivatives, and for which loops that sum has
/// converged.
#[inline(always)]
fn product_sum<V: Lanes>(
    smooth: &[V],
    derivatives: &[Poly; TERMS],
    layer: &[V],
    per_theta: V,
    floor: V,
) -> Decided<V> {
    let mut scale = floor.like(1.0);
    let (mut sum, mut before, mut size) =
        (floor.like(0.0), floor.like(f64::INFINITY), floor.like(f64::INFINITY));
    let mut converged = Set::NONE;
    for (i, (row, moments)) in derivatives.iter().zip(&TABLES.moments).enumerate().take(smooth.len()) {
        let derivative = dot(&smooth[i..], &row[i..], floor);
        let moment = dot(layer, moments, floor);
        let term = scale * derivative * moment;
        sum += term;
        (before, size) = (size, term.abs());
        let enough = (sum.abs() * ROUNDING).max(floor);
        converged = size.at_most(enough) & before.at_most(enough);
        if converged == V::every() {
            break;
        }
        scale = scale * per_theta;
    }
    // The series of a short polynomial ends by itself; what was cut off it is less than its last term where terms fall.
    if smooth.len() < TERMS - 1 {
        converged = converged | size.at_most(before);
    }
    (sum, converged)
}

/// `∫ layer² dθ`.
#[inline(always)]
fn square_sum<V: Lanes>(layer: &[V], size: V, floor: V) -> V {
    let mut sum = size.like(0.0);
    for (j, q) in layer.iter().enumerate() {
        // Coefficients of the product are at most 1/2.
        if (*q * size).abs().all_at_most(floor) {
            continue;
        }
        let row = &TABLES.squares[j];
        let others = dot(&layer[..j], &row[..j], size);
        sum = q.times_plus(q.scaled_plus(row[j], others * 2.0), sum);
    }
    sum
}

/// Sum of products with numbers, in four chains.
#[inline(always)]
pub(super) fn dot<V: Lanes>(list: &[V], weights: &[f64], like: V) -> V {
    in_chains(
        (list, weights),
        like.like(0.0),
        #[inline(always)]
        |c, weight, sum| c.scaled_plus(*weight, sum),
    )
}

const _: () =
    assert!(LAYER_TERMS + 1 == INVERSE.len() && 2 * TERMS <= INVERSE.len(), "INVERSE reaches far enough");
