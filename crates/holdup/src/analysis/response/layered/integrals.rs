//! The integrals of several loops, stretch by stretch: in closed form for all lanes at once, and for a lane alone where the
//! sign of its error or the convergence of a series is not decided at once.

use super::super::measure::Measure;
use super::areas::areas;
use super::lanes::Lanes;
use super::propagate::{Follow, Stretch};
use super::segment::Segment;
use super::signal::Signal;
use super::squares::squares;

/// A part of a sum below this is left out: a hundred of them are 2e-12.
pub(super) const ROUNDING: f64 = 2e-14;

/// ISE, control energy, IAE and ITAE of each loop so far.
pub(super) struct Integrals<V> {
    ise: V,
    energy: V,
    iae: V,
    itae: V,
    /// One lane, where it goes alone.
    alone: (Signal, Signal),
}

impl<V: Lanes> Integrals<V> {
    pub(super) fn new(token: V::Token) -> Self {
        let zero = V::zero(token);
        Self { ise: zero, energy: zero, iae: zero, itae: zero, alone: (Signal::ZERO, Signal::ZERO) }
    }

    /// IAE, ISE, ITAE and control energy of each loop.
    pub(super) fn finish(&self) -> Vec<[f64; 4]> {
        (0..V::COUNT).map(|l| [self.iae[l], self.ise[l], self.itae[l], self.energy[l]]).collect()
    }

    /// What [`Measure`] makes of one lane of a stretch.
    #[cold]
    fn of_one(&mut self, stretch: &Stretch<'_, V>, l: usize, of: impl Fn(&mut Measure, &Segment<'_>)) {
        let terms = stretch.terms;
        stretch.deviation.of_loop(l, -1.0, terms, &mut self.alone.0);
        stretch.manipulated.of_loop(l, 1.0, terms, &mut self.alone.1);
        let segment = Segment {
            start: stretch.start[l],
            length: stretch.length[l],
            setpoint: stretch.setpoint,
            rate: stretch.rate[l],
            terms,
            error: &self.alone.0,
            manipulated: &self.alone.1,
            load_estimate: None,
            stretch: None,
        };
        let mut measure = Measure::new(None);
        (measure.ise, measure.energy) = (self.ise[l], self.energy[l]);
        (measure.iae, measure.itae) = (self.iae[l], self.itae[l]);
        of(&mut measure, &segment);
        (self.ise[l], self.energy[l]) = (measure.ise, measure.energy);
        (self.iae[l], self.itae[l]) = (measure.iae, measure.itae);
    }
}

impl<V: Lanes> Follow<V> for Integrals<V> {
    #[inline(always)]
    fn stretch(&mut self, stretch: &Stretch<'_, V>) {
        let (errors, outputs) = squares(stretch, (self.ise, self.energy));
        let known = errors.1 & outputs.1;
        self.ise = (self.ise + errors.0).only_in(known, self.ise);
        self.energy = (self.energy + outputs.0).only_in(known, self.energy);
        for l in (V::every() & !known).iter() {
            self.of_one(stretch, l, Measure::add_squares);
        }
        let ((area, moment), known) = areas(stretch, (self.iae, self.itae));
        self.iae = (self.iae + area).only_in(known, self.iae);
        self.itae = (self.itae + moment).only_in(known, self.itae);
        for l in (V::every() & !known).iter() {
            self.of_one(stretch, l, Measure::add_areas);
        }
    }
}
