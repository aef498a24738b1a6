//! A single loop, shown to those who look at one loop.

use fearless_simd::Simd;

use super::super::cell::Watch;
use super::lanes::One;
use super::propagate::{Follow, Stretch};
use super::segment::Segment;
use super::signal::Signal;

/// Hands the segments of the only loop on to `watch`.
pub(super) struct Alone<'w> {
    watch: &'w mut dyn Watch,
    error: Signal,
    manipulated: Signal,
    load_estimate: Signal,
}

impl<'w> Alone<'w> {
    pub(super) fn new(watch: &'w mut dyn Watch) -> Self {
        Self { watch, error: Signal::ZERO, manipulated: Signal::ZERO, load_estimate: Signal::ZERO }
    }
}

impl<S: Simd> Follow<One<S>> for Alone<'_> {
    fn stretch(&mut self, stretch: &Stretch<'_, One<S>>) {
        let terms = stretch.terms;
        stretch.deviation.of_loop(0, -1.0, terms, &mut self.error);
        stretch.manipulated.of_loop(0, 1.0, terms, &mut self.manipulated);
        if let Some(estimate) = stretch.load_estimate {
            estimate.of_loop(0, 1.0, terms, &mut self.load_estimate);
        }
        self.watch.segment(&Segment {
            start: stretch.start[0],
            length: stretch.length[0],
            setpoint: stretch.setpoint,
            rate: stretch.rate[0],
            terms,
            error: &self.error,
            manipulated: &self.manipulated,
            load_estimate: stretch.load_estimate.map(|_| &self.load_estimate),
        });
    }
}
