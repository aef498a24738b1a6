//! `∫e²` and `∫u²` of several loops over a stretch, in closed form.

use std::ops::Range;

use super::super::legendre::{Poly, TERMS};
use super::integrals::ROUNDING;
use super::lanes::{Lanes, Set};
use super::propagate::Stretch;
use super::signal::LAYER_TERMS;
use super::signals::{BLOCK, Remainder, Signals, Sizes, in_chains};
use super::tables::{Points, TABLES};

/// Sums of several loops, and the loops for which they are decided.
pub(super) type Decided<T> = (T, Set);

/// `∫e²` and `∫u²`; `so_far` are the sums they are added to.
pub(super) fn squares<V: Lanes>(
    stretch: &Stretch<'_, V>,
    so_far: (V, V),
    [left_of_errors, left_of_outputs]: &mut [Remainder<V>; 2],
) -> (Decided<V>, Decided<V>) {
    V::widest(
        stretch.length.token(),
        #[inline(always)]
        || {
            let (errors, outputs) = (
                (stretch.deviation, stretch.deviation_sizes),
                (stretch.manipulated, stretch.manipulated_sizes),
            );
            let errors = square(stretch, errors, left_of_errors, so_far.0);
            (errors, square(stretch, outputs, left_of_outputs, so_far.1))
        },
    )
}

/// `∫x²`; not decided where the smooth part, expanded about an end, does not converge over the layer.
///
/// What a layer that lasts longer than the stretch adds beyond it is taken away again.
#[inline(always)]
fn square<V: Lanes>(
    stretch: &Stretch<'_, V>,
    (x, sizes): (&Signals<V>, Sizes<V>),
    left: &mut Remainder<V>,
    so_far: V,
) -> Decided<V> {
    left.begin(stretch.end, &x.layer, stretch.terms);
    let smooth = smooth_square(x.smooth_blocks()) * stretch.length;
    let layer = x.layer_blocks(stretch.terms);
    let (smooth_size, size) = (sizes.swing + x.smooth[0].abs(), sizes.layer);
    if size.largest() <= 0.0 {
        return (smooth, V::every());
    }
    let floor = (smooth + so_far) * stretch.rate * ROUNDING;
    let inverse = size.like(1.0) / stretch.rate;
    let mut sum = smooth;
    let mut decided = V::every();
    let ended = (left.area * (smooth_size + size) * 2.0).all_at_most(floor);
    let later =
        if ended { None } else { Some(&left.layer(stretch.end, &x.layer, stretch.terms)[..layer.len()]) };
    if !(size * smooth_size * 2.0).all_at_most(floor) {
        let p = (x.smooth_blocks(), x.order);
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

/// Half of `∫p²` over s, by the Gauss points that make it exact.
#[inline(always)]
fn smooth_square<V: Lanes>(p: &[V]) -> V {
    if p.len() <= 16 {
        return at_points(p, &TABLES.sixteen);
    }
    at_points(p, &TABLES.twenty_four[0]) + at_points(p, &TABLES.twenty_four[1])
}

/// Sum over pairs of points, to both sides of the middle, of weight times `p²`.
#[inline(always)]
fn at_points<V: Lanes, const N: usize>(p: &[V], points: &Points<N>) -> V {
    let zero = p[0].like(0.0);
    let (mut even, mut odd) = ([zero; N], [zero; N]);
    for [c, next] in p.as_chunks::<2>().0.iter().rev() {
        for k in 0..N {
            even[k] = even[k].scaled_plus(points.squares[k], *c);
            odd[k] = odd[k].scaled_plus(points.squares[k], *next);
        }
    }
    let mut sums = [zero; 2];
    for k in 0..N {
        let square = (odd[k] * odd[k]).scaled_plus(points.squares[k], even[k] * even[k]);
        sums[k % 2] = square.scaled_plus(points.weights[k], sums[k % 2]);
    }
    sums[0] + sums[1]
}

/// `∫ smooth·layer dθ` from an end on, where the smooth part has these derivatives, and for which loops that sum has
/// converged.
#[inline(always)]
fn product_sum<V: Lanes>(
    (smooth, order): (&[V], usize),
    derivatives: &[Poly; TERMS],
    layer: &[V],
    per_theta: V,
    floor: V,
) -> Decided<V> {
    let mut scale = floor.like(1.0);
    let (mut sum, mut before, mut size) =
        (floor.like(0.0), floor.like(f64::INFINITY), floor.like(f64::INFINITY));
    let mut converged = Set::NONE;
    for i in (0..order).step_by(BLOCK) {
        // Of lower powers nothing is left in these derivatives.
        let derivatives = dots(&smooth[i..], four(&derivatives[i..], i..TERMS), floor);
        let moments = dots(layer, four(&TABLES.moments[i..], 0..LAYER_TERMS), floor);
        for k in 0..BLOCK.min(order - i) {
            let term = scale * derivatives[k] * moments[k];
            sum += term;
            (before, size) = (size, term.abs());
            scale = scale * per_theta;
        }
        let enough = (sum.abs() * ROUNDING).max(floor);
        converged = size.at_most(enough) & before.at_most(enough);
        if converged == V::every() {
            break;
        }
    }
    // The series of a short polynomial ends by itself; what was cut off it is less than its last term where terms fall.
    if order < TERMS - 1 {
        converged = converged | size.at_most(before);
    }
    (sum, converged)
}

/// `∫ layer² dθ`.
#[inline(always)]
fn square_sum<V: Lanes>(layer: &[V], size: V, floor: V) -> V {
    let mut sum = size.like(0.0);
    for (block, own) in layer.as_chunks::<BLOCK>().0.iter().enumerate() {
        // Coefficients of the product are at most 1/2.
        let most = own[0].abs().max(own[1].abs()).max(own[2].abs().max(own[3].abs()));
        if (most * size).all_at_most(floor) {
            continue;
        }
        let (from, to) = (block * BLOCK, (block + 1) * BLOCK);
        let others = dots(&layer[..to], four(&TABLES.squares[from..], 0..to), size);
        for k in 0..BLOCK {
            sum = own[k].times_plus(others[k], sum);
        }
    }
    sum
}

/// These columns of the first four rows, block by block.
#[inline(always)]
fn four<const N: usize>(rows: &[[f64; N]], columns: Range<usize>) -> [&[[f64; BLOCK]]; BLOCK] {
    let mut all = [&[][..]; BLOCK];
    for k in 0..BLOCK {
        all[k] = rows[k][columns.clone()].as_chunks().0;
    }
    all
}

/// Sums of products with numbers of several rows.
#[inline(always)]
fn dots<V: Lanes>(list: &[V], rows: [&[[f64; BLOCK]]; BLOCK], like: V) -> [V; BLOCK] {
    let zero = like.like(0.0);
    let (mut sums, mut others) = ([zero; BLOCK], [zero; BLOCK]);
    for (index, block) in list.as_chunks::<BLOCK>().0.iter().enumerate() {
        for k in 0..BLOCK {
            let weights = &rows[k][index];
            sums[k] = block[0].scaled_plus(weights[0], sums[k]);
            others[k] = block[1].scaled_plus(weights[1], others[k]);
            sums[k] = block[2].scaled_plus(weights[2], sums[k]);
            others[k] = block[3].scaled_plus(weights[3], others[k]);
        }
    }
    for k in 0..BLOCK {
        sums[k] += others[k];
    }
    sums
}

/// Sum of products with numbers.
#[inline(always)]
pub(super) fn dot<V: Lanes>(list: &[V], weights: &[f64], like: V) -> V {
    in_chains(
        (list, weights),
        like.like(0.0),
        #[inline(always)]
        |c, weight, sum| c.scaled_plus(*weight, sum),
    )
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::super::lanes::One;
    use super::*;

    /// Half of `∫(Σ c_j·s^j)²`, and `∫ (1 − 2θ + 3θ²/2)²·e^(−2θ)`.
    fn both<V: Lanes>(token: V::Token, c: &[f64]) -> (f64, f64) {
        let all = |value: &f64| V::all(token, *value);
        let layer: Vec<V> = [1.0, -2.0, 3.0, 0.0].iter().map(all).collect();
        let smooth = smooth_square(&c.iter().map(all).collect::<Vec<V>>());
        (smooth[0], square_sum(&layer, all(&6.0), all(&0.0))[0])
    }

    #[test]
    fn both_gauss_rules_are_exact() {
        for order in [4_u32, 12, 16, 20, 24] {
            let c: Vec<f64> =
                (0..order).map(|j| (1.0 + f64::from(j % 3)) * (-0.9f64).powi(j.cast_signed())).collect();
            let found = dispatch!(Level::new(), simd => both::<One<_>>(simd, &c)).0;
            let mut expected = 0.0;
            for (i, a) in (0..order).zip(&c) {
                for (j, b) in (0..order).zip(&c).filter(|(j, _)| (i + j) % 2 == 0) {
                    expected += a * b / f64::from(i + j + 1);
                }
            }
            // 1e-14: rounding of the coefficients' sums, which are up to ten times the result.
            assert!((found / expected - 1.0).abs() < 1e-14, "{order}");
        }
    }

    #[test]
    fn the_square_of_a_layer_is_that_of_its_closed_form() {
        let found = dispatch!(Level::new(), simd => both::<One<_>>(simd, &[1.0; 4])).1;
        // Term by term: ∫ θ^n·e^(−2θ) = n!/2^(n+1).
        let expected = 0.5 - 4.0 / 4.0 + (4.0 + 3.0) * 2.0 / 8.0 - 6.0 * 6.0 / 16.0 + 2.25 * 24.0 / 32.0;
        // 1e-15: sums of a few numbers of size 1.
        assert!((found - expected).abs() < 1e-15);
    }
}
