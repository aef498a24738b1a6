//! The integrals of several loops, stretch by stretch: in closed form for all lanes at once, and for a lane alone where the
//! sign of its error or the convergence of a series is not decided at once.

use super::super::measure::Measure;
use super::areas::areas;
use super::lanes::{Lanes, Set};
use super::propagate::{Follow, Stretch};
use super::segment::Segment;
use super::signal::Signal;
use super::signals::Remainder;
use super::squares::squares;

/// A part of a sum below this is left out: a hundred of them are 2e-12.
pub(super) const ROUNDING: f64 = 2e-14;

/// The four integrals, of each loop.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sums<T> {
    pub(super) iae: T,
    pub(super) ise: T,
    pub(super) itae: T,
    pub(super) energy: T,
}

/// The integrals over one stretch, and the loops for which they are decided: those of squares, and those of magnitudes.
pub(super) struct Found<V> {
    pub(super) sums: Sums<V>,
    pub(super) squares_known: Set,
    pub(super) areas_known: Set,
}

/// The integrals over a stretch; `so_far` are the sums they are added to. `left` is storage.
#[inline(always)]
pub(super) fn integrals<V: Lanes>(
    stretch: &Stretch<'_, V>,
    so_far: Sums<V>,
    left: &mut [Remainder<V>; 2],
) -> Found<V> {
    let ((ise, errors_known), (energy, outputs_known)) = squares(stretch, (so_far.ise, so_far.energy), left);
    let ((iae, itae), areas_known) = areas(stretch, (so_far.iae, so_far.itae), &mut left[0]);
    Found { sums: Sums { iae, ise, itae, energy }, squares_known: errors_known & outputs_known, areas_known }
}

/// The integrals of each loop so far.
pub(super) struct Integrals<V> {
    sums: Sums<V>,
    /// Storage.
    left: [Remainder<V>; 2],
}

impl<V: Lanes> Integrals<V> {
    pub(super) fn new(token: V::Token) -> Self {
        let zero = V::zero(token);
        let sums = Sums { iae: zero, ise: zero, itae: zero, energy: zero };
        Self { sums, left: [Remainder::new(token), Remainder::new(token)] }
    }

    /// IAE, ISE, ITAE and control energy of the first so many loops.
    pub(super) fn finish(&self, count: usize) -> Vec<[f64; 4]> {
        let Sums { iae, ise, itae, energy } = self.sums;
        (0..count.min(V::COUNT)).map(|l| [iae[l], ise[l], itae[l], energy[l]]).collect()
    }

    /// What [`Measure`] makes of one lane of a stretch.
    #[cold]
    fn add_one(&mut self, stretch: &Stretch<'_, V>, l: usize, of: impl Fn(&mut Measure, &Segment<'_>)) {
        let sums = &mut self.sums;
        let mut measure = Measure::new(None);
        (measure.ise, measure.energy) = (sums.ise[l], sums.energy[l]);
        (measure.iae, measure.itae) = (sums.iae[l], sums.itae[l]);
        of_one(stretch, l, |segment| of(&mut measure, segment));
        (sums.ise[l], sums.energy[l]) = (measure.ise, measure.energy);
        (sums.iae[l], sums.itae[l]) = (measure.iae, measure.itae);
    }
}

/// Does this with one lane of a stretch.
#[cold]
pub(super) fn of_one<V: Lanes>(stretch: &Stretch<'_, V>, l: usize, of: impl FnOnce(&Segment<'_>)) {
    let (mut error, mut manipulated) = (Signal::ZERO, Signal::ZERO);
    stretch.deviation.of_loop(l, -1.0, stretch.terms, &mut error);
    stretch.manipulated.of_loop(l, 1.0, stretch.terms, &mut manipulated);
    of(&Segment {
        start: stretch.start[l],
        length: stretch.length[l],
        setpoint: stretch.setpoint,
        rate: stretch.rate[l],
        terms: stretch.terms,
        error: &error,
        manipulated: &manipulated,
        load_estimate: None,
    });
}

impl<V: Lanes> Follow<V> for Integrals<V> {
    #[inline(always)]
    fn stretch(&mut self, stretch: &Stretch<'_, V>) {
        let Found { sums: more, squares_known, areas_known } = integrals(stretch, self.sums, &mut self.left);
        let sums = &mut self.sums;
        sums.ise = (sums.ise + more.ise).only_in(squares_known, sums.ise);
        sums.energy = (sums.energy + more.energy).only_in(squares_known, sums.energy);
        sums.iae = (sums.iae + more.iae).only_in(areas_known, sums.iae);
        sums.itae = (sums.itae + more.itae).only_in(areas_known, sums.itae);
        for l in (V::every() & !squares_known).iter() {
            self.add_one(stretch, l, Measure::add_squares);
        }
        for l in (V::every() & !areas_known).iter() {
            self.add_one(stretch, l, Measure::add_areas);
        }
    }
}
