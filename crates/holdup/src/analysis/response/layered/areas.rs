//! `∫|e|` and `∫t·|e|` of several loops over a stretch, in closed form between the roots of the error.

use super::crossings::{crossings, root};
use super::integrals::ROUNDING;
use super::lanes::{Lanes, Set};
use super::propagate::Stretch;
use super::squares::{Decided, dot};
use super::tables::{INVERSE, TABLES};

/// `∫|e|` and `∫t·|e|` of each loop, decided where its error changes sign at most twice, and provably so.
pub(super) fn areas<V: Lanes>(stretch: &Stretch<'_, V>, so_far: (V, V)) -> Decided<(V, V)> {
    V::widest(
        stretch.length.token(),
        #[inline(always)]
        || of_magnitudes(stretch, so_far),
    )
}

#[inline(always)]
fn of_magnitudes<V: Lanes>(stretch: &Stretch<'_, V>, so_far: (V, V)) -> Decided<(V, V)> {
    let e = stretch.deviation;
    let zero = stretch.length.like(0.0);
    let layer_size = stretch.deviation_sizes.layer;
    let swing = stretch.deviation_sizes.swing + layer_size;
    let (mut total, mut moment) = totals(stretch);
    let end = stretch.start + stretch.length;
    let mut layer_end = zero;
    let layer = &e.layer[..stretch.terms];
    let left = stretch.end.area(layer, zero);
    let floor = stretch.rate * ROUNDING;
    let (iae, itae) = (so_far.0 + total.abs(), so_far.1 + moment.abs());
    let ended = left.all_at_most(floor * iae) && (left * end).all_at_most(floor * itae);
    if stretch.terms > 0 && !ended {
        let theta = stretch.rate * stretch.length;
        let later = stretch.end.shifted(&e.layer, stretch.terms);
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
    let known = keeps_its_sign | found.none | found.one | found.two;
    let crossed = found.one | found.two;
    if crossed == Set::NONE {
        return (sums, known);
    }
    let terms = if layer_size.all_at_most(floor) { 0 } else { stretch.terms };
    let (area, weighted) = integrals(stretch, terms, root(stretch, terms, crossed, &found.roots[0]));
    let mut areas = area.abs() + (total - area).abs();
    let mut moments = weighted.abs() + (moment - weighted).abs();
    if found.two != Set::NONE {
        let second = root(stretch, terms, found.two, &found.roots[1]);
        let (later, later_weighted) = integrals(stretch, terms, second);
        let three = |first: V, second: V, all: V| first.abs() + (second - first).abs() + (all - second).abs();
        areas = three(area, later, total).only_in(found.two, areas);
        moments = three(weighted, later_weighted, moment).only_in(found.two, moments);
    }
    ((areas.only_in(crossed, sums.0), moments.only_in(crossed, sums.1)), known)
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
