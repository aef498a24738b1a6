//! `∫|e|` and `∫t·|e|` of several loops over a stretch, in closed form between the roots of the error.

use super::crossings::{MOST_ROOTS, crossings};
use super::integrals::ROUNDING;
use super::lanes::{Lanes, Set};
use super::propagate::Stretch;
use super::signals::Remainder;
use super::squares::{Decided, dot};
use super::tables::{INVERSE, TABLES};

/// `∫|e|` and `∫t·|e|` of each loop, decided where its error changes sign at most [`MOST_ROOTS`] times, and provably so.
/// `left` is what is left of the layer.
pub(super) fn areas<V: Lanes>(
    stretch: &Stretch<'_, V>,
    so_far: (V, V),
    left: &mut Remainder<V>,
) -> Decided<(V, V)> {
    V::widest(
        stretch.length.token(),
        #[inline(always)]
        || of_magnitudes(stretch, so_far, left),
    )
}

#[inline(always)]
fn of_magnitudes<V: Lanes>(
    stretch: &Stretch<'_, V>,
    so_far: (V, V),
    left: &mut Remainder<V>,
) -> Decided<(V, V)> {
    let e = stretch.deviation;
    let zero = stretch.length.like(0.0);
    let layer_size = stretch.deviation_sizes.layer;
    let swing = stretch.deviation_sizes.swing + layer_size;
    let (mut total, mut moment) = totals(stretch);
    let end = stretch.start + stretch.length;
    let mut layer_end = zero;
    let floor = stretch.rate * ROUNDING;
    let (iae, itae) = (so_far.0 + total.abs(), so_far.1 + moment.abs());
    let ended = left.area.all_at_most(floor * iae) && (left.area * end).all_at_most(floor * itae);
    if stretch.terms > 0 && !ended {
        let theta = stretch.rate * stretch.length;
        let later = left.layer(stretch.end, &e.layer, stretch.terms);
        layer_end = later[0];
        let (all, first) = of_layer(&later[..stretch.terms], zero);
        let (area, weighted) = with_layer(stretch, stretch.terms, (all, first + theta * all), (zero, zero));
        (total, moment) = (total - area, moment - weighted);
    }
    let sums = (total.abs(), moment.abs());
    let keeps_its_sign = swing.at_most(e.smooth[0].abs());
    if keeps_its_sign == V::every() {
        return (sums, keeps_its_sign);
    }
    // Noise below this changes the sums by less than rounding does.
    let floor = (iae / stretch.length).min(itae / (stretch.length * end)) * ROUNDING;
    let open = V::every() & !keeps_its_sign;
    let found = crossings(stretch, open, layer_end, floor);
    let terms = if layer_size.all_at_most(floor) { 0 } else { stretch.terms };
    let (mut areas, mut moments) = (zero, zero);
    let mut before = (zero, zero);
    for number in 0..MOST_ROOTS {
        let of = found.roots.with(number) & found.known;
        if of == Set::NONE {
            break;
        }
        let (area, weighted) = integrals(stretch, terms, found.roots.root(stretch, terms, number));
        areas = (areas + (area - before.0).abs()).only_in(of, areas);
        moments = (moments + (weighted - before.1).abs()).only_in(of, moments);
        before = (area.only_in(of, before.0), weighted.only_in(of, before.1));
    }
    areas += (total - before.0).abs();
    moments += (moment - before.1).abs();
    ((areas, moments), keeps_its_sign | found.known)
}

/// `∫e dt` and `∫t·e dt` over the stretch, of the layer to infinity.
#[inline(always)]
fn totals<V: Lanes>(stretch: &Stretch<'_, V>) -> (V, V) {
    let e = stretch.deviation;
    let smooth = e.smooth_blocks();
    let half = stretch.length * 0.5;
    let area = stretch.length * dot(smooth, &TABLES.areas, half);
    let about_middle = stretch.length * half * dot(smooth, &TABLES.moments_about_middle, half);
    let moment = (stretch.start + half) * area + about_middle;
    with_layer(stretch, stretch.terms, of_layer(&e.layer[..stretch.terms], half.like(0.0)), (area, moment))
}

/// `∫ layer dθ` and `∫ θ·layer dθ` from 0 to infinity.
#[inline(always)]
fn of_layer<V: Lanes>(layer: &[V], zero: V) -> (V, V) {
    let (mut all, mut first, mut index) = (zero, zero, 0.0);
    for q in layer {
        index += 1.0;
        all += *q;
        first = q.scaled_plus(index, first);
    }
    (all, first)
}

/// Adds the integrals over a layer, `∫ dθ` and `∫θ dθ`.
#[inline(always)]
fn with_layer<V: Lanes>(
    stretch: &Stretch<'_, V>,
    terms: usize,
    (all, first): (V, V),
    (area, moment): (V, V),
) -> (V, V) {
    if terms == 0 {
        return (area, moment);
    }
    let inverse = all.like(1.0) / stretch.rate;
    let all = all * inverse;
    (area + all, moment + stretch.start * all + first * inverse * inverse)
}

/// The same from the start of the stretch to `s`.
#[inline(always)]
fn integrals<V: Lanes>(stretch: &Stretch<'_, V>, terms: usize, s: V) -> (V, V) {
    let e = stretch.deviation;
    let half = stretch.length * 0.5;
    let zero = s.like(0.0);
    let (mut area, mut before) = (zero, zero);
    let (mut moment, mut moment_before) = (zero, zero);
    for j in (0..e.order).rev() {
        let (by_one, by_two) = (e.smooth[j] * INVERSE[j + 1], e.smooth[j] * INVERSE[j + 2]);
        area = (area + by_one) * s;
        moment = (moment + by_two) * s;
        before = -(before + by_one);
        moment_before = -(moment_before + by_two);
    }
    let area = half * (area - before);
    let about_middle = half * half * (moment * s + moment_before);
    let moment = (stretch.start + half) * area + about_middle;
    if terms == 0 {
        return (area, moment);
    }
    let theta = (stretch.rate * half * (s + s.like(1.0))).max(zero).min(s.like(700.0));
    // From θ to infinity: sums of the coefficients from j on, and for θ·layer, whose coefficient j is j·q_(j−1).
    let layer = &e.layer[..terms];
    let (mut all, mut first) = (zero, zero);
    let (mut beyond, mut weighted) = (zero, zero);
    #[expect(clippy::cast_precision_loss, reason = "at most 64")]
    let mut index = terms as f64;
    for j in (0..terms).rev() {
        // `first` holds the sum from index j + 1 on.
        first = layer[j].scaled_plus(index, first);
        weighted = (weighted * theta).scaled_plus(if j + 2 <= terms { INVERSE[j + 2] } else { 0.0 }, first);
        all += layer[j];
        beyond = (beyond * theta).scaled_plus(INVERSE[j + 1], all);
        index -= 1.0;
    }
    weighted = weighted * theta + first;
    let decayed = theta.decayed();
    let until = (all - beyond * decayed, first - weighted * decayed);
    with_layer(stretch, terms, until, (area, moment))
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch, f64x8};

    use super::super::signals::{End, Signals};
    use super::*;

    /// `e = −a + e^(−θ)·(10 − 7θ + θ²)` from 0 to 60 s at a rate of 1/s.
    fn found<V: Lanes>(token: V::Token, a: f64) -> Vec<Option<(f64, f64)>> {
        let all = |value: f64| V::all(token, value);
        let mut error = Signals::<V>::zero(token);
        error.smooth[0] = all(-a);
        for (q, value) in error.layer.iter_mut().zip([10.0, -7.0, 2.0]) {
            *q = all(value);
        }
        let mut end = End::new(token);
        end.move_to(all(60.0), 3);
        let stretch = Stretch {
            start: all(0.0),
            length: all(60.0),
            setpoint: 0.0,
            rate: all(1.0),
            terms: 3,
            end: &end,
            deviation: &error,
            deviation_sizes: error.sizes(3),
            manipulated: &error,
            manipulated_sizes: error.sizes(3),
            load_estimate: None,
        };
        let mut left = Remainder::new(token);
        left.begin(&end, &error.layer, 3);
        let ((area, moment), known) = areas(&stretch, (all(0.0), all(0.0)), &mut left);
        (0..V::COUNT).map(|l| known.has(l).then(|| (area[l], moment[l]))).collect()
    }

    #[test]
    fn three_roots_within_the_layer_are_found() {
        let a = 1e-3;
        let e = |t: f64| -a + (-t).exp() * (10.0 - 7.0 * t + t * t);
        // ∫e and ∫t·e from t on, the constant apart: Q + Q' + …, and the same of t·Q.
        let area = |t: f64| -a * t - (-t).exp() * (5.0 - 5.0 * t + t * t);
        let moment = |t: f64| -0.5 * a * t * t - (-t).exp() * (2.0 + 2.0 * t - 4.0 * t * t + t * t * t);
        let root = |(mut low, mut high): (f64, f64)| {
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if (e(middle) < 0.0) == (e(low) < 0.0) { low = middle } else { high = middle }
            }
            low
        };
        let points = [0.0, root((0.5, 3.0)), root((3.0, 6.0)), root((6.0, 20.0)), 60.0];
        let sum =
            |of: &dyn Fn(f64) -> f64| points.windows(2).map(|w| (of(w[1]) - of(w[0])).abs()).sum::<f64>();
        let lanes = dispatch!(Level::new(), simd => found::<f64x8<_>>(simd, a));
        for lane in lanes {
            let (found_area, found_moment) = lane.unwrap();
            // 1e-13: cancellation between parts that are up to a hundred times the result.
            assert!((found_area / sum(&area) - 1.0).abs() < 1e-13, "{found_area}");
            assert!((found_moment / sum(&moment) - 1.0).abs() < 1e-13, "{found_moment}");
        }
    }
}
