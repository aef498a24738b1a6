//! The error part by part.

use super::super::lanes::{Lanes, Set};
use super::super::propagate::Stretch;
use super::super::tables::{EDGES, TABLES};
use super::apart;

/// Parts into which a stretch is cut, and where they begin and end in units of one.
pub(super) const PARTS: usize = 8;
const STEPS: [f64; PARTS + 1] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0];

/// The error between points at equal distances.
pub(super) struct Parts<V> {
    /// Values of the smooth part at these points.
    pub(super) values: [V; PARTS + 1],
    /// Length of a part.
    step: V,
    /// Loops for which a part has one root, and those for which it is not decided.
    pub(super) changed: [Set; PARTS],
    pub(super) open: [Set; PARTS],
}

impl<V: Lanes> Parts<V> {
    /// `fourth` is a bound on the fourth derivative of the smooth part by s.
    #[inline(always)]
    pub(super) fn new(stretch: &Stretch<'_, V>, fourth: V, (of, floor): (Set, V)) -> Self {
        let e = stretch.deviation;
        let zero = fourth.like(0.0);
        let step = zero.like(2.0 / STEPS[PARTS]);
        let mut values = [zero; PARTS + 1];
        let (mut slopes, mut bends) = (values, values);
        for k in 0..=PARTS {
            let s = step.scaled_plus(STEPS[k], zero.like(-1.0));
            let (mut value, mut slope, mut half) = (zero, zero, zero);
            for c in e.smooth[..e.order].iter().rev() {
                half = half.times_plus(s, slope);
                slope = slope.times_plus(s, value);
                value = value.times_plus(s, *c);
            }
            (values[k], slopes[k], bends[k]) = (value, slope, half.abs() * 2.0);
        }
        // How far the second derivative may be from its chord.
        let bulge = step * step * fourth * 0.126;
        let theta = stretch.rate * stretch.length;
        let (shortest, by_s) = (theta.smallest() / STEPS[PARTS], theta * 0.5);
        let mut decayed = stretch.terms == 0;
        let (mut layer, mut layer_slope) = (zero, zero);
        let mut new = Self { values, step, changed: [Set::NONE; PARTS], open: [Set::NONE; PARTS] };
        for k in 0..PARTS {
            if !decayed {
                let edge = EDGES.iter().rposition(|edge| *edge <= shortest * STEPS[k]).unwrap_or(0);
                let own = &e.layer[..stretch.terms];
                (layer_slope, layer) = bounds_in_layer(own, &TABLES.bounds[edge], zero);
                layer_slope = layer_slope * by_s;
                decayed = of & !(layer.at_most(floor) & layer_slope.at_most(floor)) == Set::NONE;
                if decayed {
                    (layer, layer_slope) = (zero, zero);
                }
            }
            // Over the part the slope changes by no more than this, and no value is farther from the chord.
            let bend = bends[k].max(bends[k + 1]) + bulge;
            let (turn, sag) = (step * bend, step * step * bend * 0.126);
            let (a, b) = (values[k], values[k + 1]);
            let (least, slope) = (a.abs().min(b.abs()), slopes[k].abs().max(slopes[k + 1].abs()));
            let sure = layer.at_most(least);
            let changed = apart(a, b);
            // The smooth part rises or falls all the way; so does the error.
            let (steep, steeper) = (turn.below(slope), (turn + layer_slope).below(slope));
            let clear = (sag + layer).below(least) | sure & steep;
            new.changed[k] = changed;
            new.open[k] = !changed & !clear | changed & !(sure & steeper);
        }
        new
    }

    /// Where part `k` begins, in s.
    #[inline(always)]
    pub(super) fn at(&self, k: usize) -> V {
        self.step.scaled_plus(STEPS[k], self.step.like(-1.0))
    }
}

/// Bounds on the derivative of a layer by θ and on the layer, where no `e^(−θ)·θ^j/j!` exceeds these bounds.
#[inline(always)]
pub(super) fn bounds_in_layer<V: Lanes>(layer: &[V], bounds: &[f64], zero: V) -> (V, V) {
    let (mut slope, mut size) = (zero, zero);
    let mut before = zero;
    for (q, bound) in layer.iter().zip(bounds).rev() {
        slope = (before - *q).abs().scaled_plus(*bound, slope);
        size = q.abs().scaled_plus(*bound, size);
        before = *q;
    }
    (slope, size)
}

/// Where part `k` begins, as a part of the stretch.
#[inline(always)]
pub(super) fn begin(k: usize) -> f64 {
    STEPS[k] / STEPS[PARTS]
}
