//! `∫|e|` and `∫t·|e|` of several loops over a stretch, in closed form between the roots of the error.

use super::crossings::{crossings, only_root};
use super::integrals::{PerLoop, ROUNDING};
use super::lanes::{Lanes, lane_by_lane};
use super::propagate::Stretch;
use super::signal::LAYER_TERMS;
use super::signals::shift;
use super::squares::{beyond, dot};
use super::tables::{INVERSE, TABLES};

/// `∫|e|` and `∫t·|e|` of each loop, where its error changes sign at most once, and provably so.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
pub(super) fn areas<const L: usize>(
    stretch: &Stretch<'_, L>,
    so_far: (Lanes<L>, Lanes<L>),
) -> PerLoop<(f64, f64), L> {
    let e = stretch.error;
    let (smooth_size, layer_size) = e.sizes(stretch.terms);
    let swing = smooth_size - e.smooth[0].abs() + layer_size;
    let (mut total, mut moment) = totals(stretch);
    let end = stretch.start + stretch.length;
    let mut layer_end = Lanes::ZERO;
    let left = beyond(stretch, e);
    let floor = stretch.rate * ROUNDING;
    let (iae, itae) = (so_far.0 + total.abs(), so_far.1 + moment.abs());
    let ended = left.every(floor * iae, |left, floor| left <= floor)
        && (left * end).every(floor * itae, |left, floor| left <= floor);
    if stretch.terms > 0 && !ended {
        let theta = stretch.rate * stretch.length;
        let mut later = [Lanes::ZERO; LAYER_TERMS];
        let later = &mut later[..stretch.terms];
        later.copy_from_slice(&e.layer[..stretch.terms]);
        shift(later, theta);
        layer_end = later[0];
        let (all, first) = of_layer(later);
        let none = (Lanes::ZERO, Lanes::ZERO);
        let (area, weighted) = with_layer(stretch, stretch.terms, (all, first + theta * all), none);
        (total, moment) = (total - area, moment - weighted);
    }
    let mut known = [None; L];
    let mut open = [false; L];
    for l in 0..L {
        if e.smooth[0].0[l].abs() >= swing.0[l] {
            known[l] = Some((total.0[l].abs(), moment.0[l].abs()));
        } else {
            open[l] = true;
        }
    }
    if open == [false; L] {
        return known;
    }
    // Noise below this changes the sums by less than rounding does.
    let floor = (iae / stretch.length).min(itae / (stretch.length * end)) * ROUNDING;
    let found = crossings(stretch, open, layer_end, (layer_size, floor));
    let mut crosses = false;
    for l in 0..L {
        if found.roots[l] == Some(0) {
            known[l] = Some((total.0[l].abs(), moment.0[l].abs()));
        }
        crosses |= found.roots[l] == Some(1);
    }
    if crosses {
        let layered = !layer_size.every(floor, |layer, floor| layer <= floor);
        let terms = if layered { stretch.terms } else { 0 };
        let root = only_root(stretch, terms, &found);
        let (area, weighted) = integrals(stretch, terms, root);
        let (later, later_weighted) = (total - area, moment - weighted);
        for l in 0..L {
            if found.roots[l] == Some(1) {
                let areas = area.0[l].abs() + later.0[l].abs();
                known[l] = Some((areas, weighted.0[l].abs() + later_weighted.0[l].abs()));
            }
        }
    }
    known
}

/// `∫e dt` and `∫t·e dt` over the stretch, of the layer to infinity.
#[inline(always)]
fn totals<const L: usize>(stretch: &Stretch<'_, L>) -> (Lanes<L>, Lanes<L>) {
    let e = stretch.error;
    let smooth = &e.smooth[..e.order];
    let half = stretch.length * 0.5;
    let area = stretch.length * dot(smooth, &TABLES.areas);
    let about_middle = stretch.length * half * dot(smooth, &TABLES.moments_about_middle);
    let moment = (stretch.start + half) * area + about_middle;
    with_layer(stretch, stretch.terms, of_layer(&e.layer[..stretch.terms]), (area, moment))
}

/// `∫ layer dθ` and `∫ θ·layer dθ` from 0 to infinity.
#[inline(always)]
fn of_layer<const L: usize>(layer: &[Lanes<L>]) -> (Lanes<L>, Lanes<L>) {
    let (mut all, mut first, mut index) = (Lanes::ZERO, Lanes::ZERO, 0.0);
    for q in layer {
        lane_by_lane::<L>();
        index += 1.0;
        all += *q;
        first += *q * index;
    }
    (all, first)
}

/// Adds the integrals over a layer, `∫ dθ` and `∫θ dθ`.
#[inline(always)]
fn with_layer<const L: usize>(
    stretch: &Stretch<'_, L>,
    terms: usize,
    (all, first): (Lanes<L>, Lanes<L>),
    (area, moment): (Lanes<L>, Lanes<L>),
) -> (Lanes<L>, Lanes<L>) {
    if terms == 0 {
        return (area, moment);
    }
    let inverse = Lanes::all(1.0) / stretch.rate;
    let all = all * inverse;
    (area + all, moment + stretch.start * all + first * inverse * inverse)
}

/// The same from the start of the stretch to `s`.
#[inline(always)]
fn integrals<const L: usize>(stretch: &Stretch<'_, L>, terms: usize, s: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
    let e = stretch.error;
    let half = stretch.length * 0.5;
    let (mut area, mut before) = (Lanes::ZERO, Lanes::ZERO);
    let (mut moment, mut moment_before) = (Lanes::ZERO, Lanes::ZERO);
    for j in (0..e.order).rev() {
        lane_by_lane::<L>();
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
    let theta = (stretch.rate * half * (s + Lanes::all(1.0))).map(|theta| theta.clamp(0.0, 700.0));
    // From θ to infinity: sums of the coefficients from j on, and for θ·layer, whose coefficient j is j·q_(j−1).
    let layer = &e.layer[..terms];
    let (mut all, mut first) = (Lanes::ZERO, Lanes::ZERO);
    let (mut beyond, mut weighted) = (Lanes::ZERO, Lanes::ZERO);
    #[expect(clippy::cast_precision_loss, reason = "at most 64")]
    let mut index = terms as f64;
    for j in (0..terms).rev() {
        lane_by_lane::<L>();
        // `first` holds the sum from index j + 1 on.
        first += layer[j] * index;
        weighted = weighted * theta * if j + 2 <= terms { INVERSE[j + 2] } else { 0.0 } + first;
        all += layer[j];
        beyond = beyond * theta * INVERSE[j + 1] + all;
        index -= 1.0;
    }
    weighted = weighted * theta + first;
    let decayed = theta.map(|theta| (-theta).exp());
    let until = (all - beyond * decayed, first - weighted * decayed);
    with_layer(stretch, terms, until, (area, moment))
}
