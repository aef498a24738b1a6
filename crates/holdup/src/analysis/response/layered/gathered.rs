//! The integrals of a single loop, eight segments to a vector: once the signals are known, segments do not wait for each other.

use std::fmt;

use fearless_simd::{Level, Simd, dispatch, f64x8};

use super::super::measure::Measure;
use super::integrals::{Found, Sums, integrals, of_one};
use super::lanes::{Lanes, One};
use super::propagate::{Follow, Stretch};
use super::segment::Segment;
use super::signals::{End, Remainder, Signals};

/// Segments that wait for their integrals, one in each lane.
struct Group<V: Lanes> {
    count: usize,
    start: V,
    length: V,
    rate: V,
    /// Coefficients of the layers: the largest number of them.
    terms: usize,
    /// Of either sign.
    error: Signals<V>,
    manipulated: Signals<V>,
    end: End<V>,
    /// Storage.
    left: [Remainder<V>; 2],
}

/// Coefficients of a smooth part and of a layer.
#[derive(Clone, Copy)]
struct Coefficients<'a, T> {
    smooth: &'a [T],
    layer: &'a [T],
}

impl<V: Lanes> Group<V> {
    #[inline(always)]
    fn new(token: V::Token) -> Self {
        let (zero, signals) = (V::zero(token), Signals::zero(token));
        Self {
            count: 0,
            start: zero,
            length: zero,
            rate: zero,
            terms: 0,
            error: signals.clone(),
            manipulated: signals,
            end: End::new(token),
            left: [Remainder::new(token), Remainder::new(token)],
        }
    }

    /// Takes a segment with this start, length and rate, its error and its output; true if there is no room for another one.
    #[inline(always)]
    fn push<T: Copy + Into<f64>>(
        &mut self,
        [start, length, rate]: [f64; 3],
        [error, manipulated]: [Coefficients<'_, T>; 2],
    ) -> bool {
        let l = self.count;
        if l == 0 {
            (self.terms, self.error.order, self.manipulated.order) = (0, 0, 0);
        }
        (self.start[l], self.length[l], self.rate[l]) = (start, length, rate);
        let terms = self.terms;
        for (own, new) in [(&mut self.error, error), (&mut self.manipulated, manipulated)] {
            own.order = fill(&mut own.smooth, l, new.smooth, own.order);
            self.terms = fill(&mut own.layer, l, new.layer, terms);
        }
        self.count += 1;
        self.count == V::COUNT
    }

    /// Adds the integrals of all segments that were taken to those of their loop, and forgets them.
    #[inline(always)]
    fn add_to(&mut self, measure: &mut Measure) {
        if self.count > 0 {
            V::widest(
                self.start.token(),
                #[inline(always)]
                || self.add_together(measure),
            );
        }
    }

    /// In closed form where that decides, part by part where it does not.
    #[inline(always)]
    fn add_together(&mut self, measure: &mut Measure) {
        // Signals of the lanes that are left are zero; they need a length.
        for l in self.count..V::COUNT {
            (self.start[l], self.length[l], self.rate[l]) = (self.start[0], self.length[0], self.rate[0]);
        }
        let (terms, count) = (self.terms, self.count);
        self.count = 0;
        self.end.move_to(self.rate * self.length, terms);
        self.error.fill(terms);
        self.manipulated.fill(terms);
        let stretch = Stretch {
            start: self.start,
            length: self.length,
            setpoint: 0.0,
            rate: self.rate,
            terms,
            end: &self.end,
            // Integrals of squares and magnitudes: the sign does not matter.
            deviation: &self.error,
            deviation_sizes: self.error.sizes(terms),
            manipulated: &self.manipulated,
            manipulated_sizes: self.manipulated.sizes(terms),
            load_estimate: None,
        };
        let so_far = Sums {
            iae: self.start.like(measure.iae),
            ise: self.start.like(measure.ise),
            itae: self.start.like(measure.itae),
            energy: self.start.like(measure.energy),
        };
        let Found { sums, squares_known, areas_known } = integrals(&stretch, so_far, &mut self.left);
        for l in 0..count {
            if squares_known.has(l) {
                measure.ise += sums.ise[l];
                measure.energy += sums.energy[l];
            } else {
                of_one(&stretch, l, |segment| measure.add_squares(segment));
            }
            if areas_known.has(l) {
                measure.iae += sums.iae[l];
                measure.itae += sums.itae[l];
            } else {
                of_one(&stretch, l, |segment| measure.add_areas(segment));
            }
        }
    }
}

/// Writes numbers into one lane. `most` is the largest number of them in any lane so far; returns what it is now. Lanes that have
/// fewer are filled with zeros.
#[inline(always)]
fn fill<V: Lanes, T: Copy + Into<f64>>(columns: &mut [V], lane: usize, numbers: &[T], most: usize) -> usize {
    let (of, all) = (numbers.len(), numbers.len().max(most));
    let columns = &mut columns[..all];
    for column in columns.iter_mut().skip(most) {
        *column = column.like(0.0);
    }
    for (column, number) in columns.iter_mut().zip(numbers) {
        column[lane] = (*number).into();
    }
    for column in columns.iter_mut().skip(of) {
        column[lane] = 0.0;
    }
    all
}

/// Measures the integrals of a single loop, and nothing else.
pub(super) struct OfOne<V: Lanes> {
    measure: Measure,
    group: Group<V>,
}

impl<V: Lanes> OfOne<V> {
    #[inline(always)]
    pub(super) fn new(token: V::Token) -> Self {
        Self { measure: Measure::integrals_only(), group: Group::new(token) }
    }

    /// IAE, ISE, ITAE and control energy.
    #[inline(always)]
    pub(super) fn finish(mut self) -> [f64; 4] {
        self.group.add_to(&mut self.measure);
        let Measure { iae, ise, itae, energy, .. } = self.measure;
        [iae, ise, itae, energy]
    }
}

impl<S: Simd> Follow<One<S>> for OfOne<f64x8<S>> {
    #[inline(always)]
    fn stretch(&mut self, stretch: &Stretch<'_, One<S>>) {
        let signals = [stretch.deviation, stretch.manipulated];
        let signals = signals.map(
            #[inline(always)]
            |x| Coefficients { smooth: &x.smooth[..x.order], layer: &x.layer[..stretch.terms] },
        );
        if self.group.push([stretch.start[0], stretch.length[0], stretch.rate[0]], signals) {
            self.group.add_to(&mut self.measure);
        }
    }
}

/// Segments that wait for their integrals, if there are any, for the widest instructions there are.
#[derive(Default)]
pub(in super::super) struct Gathered(Option<Box<dyn Gather>>);

impl fmt::Debug for Gathered {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Gathered")
    }
}

/// What [`Group`] does, whatever its instructions are.
trait Gather {
    /// Takes a segment; true if there is no room for another one.
    fn take(&mut self, segment: &Segment<'_>) -> bool;

    /// Adds the integrals of all segments that were taken, and forgets them.
    fn add(&mut self, measure: &mut Measure);
}

impl<V: Lanes> Gather for Group<V> {
    fn take(&mut self, segment: &Segment<'_>) -> bool {
        let signals = [segment.error, segment.manipulated]
            .map(|x| Coefficients { smooth: &x.smooth[..x.order], layer: &x.layer[..segment.terms] });
        self.push([segment.start, segment.length, segment.rate], signals)
    }

    fn add(&mut self, measure: &mut Measure) {
        self.add_to(measure);
    }
}

impl Measure {
    /// Adds the integrals of a segment, at the latest when [`Self::settle`] is called.
    pub(super) fn add_integrals(&mut self, segment: &Segment<'_>) {
        let new = || -> Box<dyn Gather> {
            dispatch!(Level::new(), simd => Box::new(Group::<f64x8<_>>::new(simd)) as Box<dyn Gather>)
        };
        if self.gathered.0.get_or_insert_with(new).take(segment) {
            self.settle();
        }
    }

    /// Adds the integrals of the segments that wait for them.
    pub(in super::super) fn settle(&mut self) {
        if let Some(mut gathered) = self.gathered.0.take() {
            gathered.add(self);
            self.gathered.0 = Some(gathered);
        }
    }
}
