//! The integrals of several loops, stretch by stretch: in closed form for all lanes at once, and for a lane alone where the
//! sign of its error or the convergence of a series is not decided at once.

use super::super::measure::Measure;
use super::areas::areas;
use super::lanes::Lanes;
use super::propagate::{Follow, Stretch};
use super::segment::Segment;
use super::signal::Signal;
use super::squares::squares;

/// A part of a sum below this is left out: a hundred of them are 1e-13.
pub(super) const ROUNDING: f64 = 1e-15;

/// A result for each loop where it is decided.
pub(super) type PerLoop<T, const L: usize> = [Option<T>; L];

/// ISE, control energy, IAE and ITAE of each loop so far.
pub(super) struct Integrals<const L: usize> {
    ise: Lanes<L>,
    energy: Lanes<L>,
    iae: Lanes<L>,
    itae: Lanes<L>,
    /// One lane, where it goes alone.
    alone: (Signal, Signal),
}

impl<const L: usize> Integrals<L> {
    pub(super) fn new() -> Self {
        let zero = Lanes::ZERO;
        Self { ise: zero, energy: zero, iae: zero, itae: zero, alone: (Signal::ZERO, Signal::ZERO) }
    }

    /// IAE, ISE, ITAE and control energy of each loop.
    pub(super) fn finish(&self) -> [[f64; 4]; L] {
        let mut all = [[0.0; 4]; L];
        for (l, sums) in all.iter_mut().enumerate() {
            *sums = [self.iae.0[l], self.ise.0[l], self.itae.0[l], self.energy.0[l]];
        }
        all
    }

    /// What [`Measure`] makes of one lane of a stretch.
    fn of_one(&mut self, stretch: &Stretch<'_, L>, l: usize, of: impl Fn(&mut Measure, &Segment<'_>)) {
        let terms = stretch.terms;
        stretch.error.of_loop(l, terms, &mut self.alone.0);
        stretch.manipulated.of_loop(l, terms, &mut self.alone.1);
        let segment = Segment {
            start: stretch.start.0[l],
            length: stretch.length.0[l],
            setpoint: stretch.setpoint,
            rate: stretch.rate.0[l],
            terms,
            error: &self.alone.0,
            manipulated: &self.alone.1,
            load_estimate: None,
            stretch: None,
        };
        let mut measure = Measure::new(None);
        (measure.ise, measure.energy) = (self.ise.0[l], self.energy.0[l]);
        (measure.iae, measure.itae) = (self.iae.0[l], self.itae.0[l]);
        of(&mut measure, &segment);
        (self.ise.0[l], self.energy.0[l]) = (measure.ise, measure.energy);
        (self.iae.0[l], self.itae.0[l]) = (measure.iae, measure.itae);
    }
}

impl<const L: usize> Follow<L> for Integrals<L> {
    fn stretch(&mut self, stretch: &Stretch<'_, L>) {
        let (errors, outputs) = squares(stretch, (self.ise, self.energy));
        for l in 0..L {
            if let (Some(error), Some(output)) = (errors[l], outputs[l]) {
                self.ise.0[l] += error;
                self.energy.0[l] += output;
            } else {
                self.of_one(stretch, l, Measure::add_squares);
            }
        }
        let areas = areas(stretch, (self.iae, self.itae));
        for l in 0..L {
            if let Some((area, moment)) = areas[l] {
                self.iae.0[l] += area;
                self.itae.0[l] += moment;
            } else {
                self.of_one(stretch, l, Measure::add_areas);
            }
        }
    }
}
