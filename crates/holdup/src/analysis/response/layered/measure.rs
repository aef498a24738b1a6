//! The metrics of one segment: by a bound or by monotony where that decides, and by polynomials on parts of the segment where
//! neither does. Integrals in closed form are found several segments at a time (`gathered.rs`).

use super::super::legendre::{ends, square_integral};
use super::super::measure::{BANDS, Measure};
use super::extrema::{Extrema, extrema};
use super::segment::{Part, Segment};
use super::signal::{Signal, sum_of_magnitudes};

/// The parts of a signal, made when first asked for.
struct Parts<'a> {
    segment: &'a Segment<'a>,
    signal: &'a Signal,
    list: Option<Vec<Part>>,
}

impl<'a> Parts<'a> {
    fn new(segment: &'a Segment<'a>, signal: &'a Signal) -> Self {
        Self { segment, signal, list: None }
    }

    fn get(&mut self) -> &[Part] {
        self.list.get_or_insert_with(|| self.segment.parts(self.signal))
    }
}

impl Measure {
    /// Adds a segment.
    pub(in super::super) fn add_segment(&mut self, segment: &Segment<'_>) {
        self.add_integrals(segment);
        if self.integrals_only {
            return;
        }
        let mut errors = Parts::new(segment, segment.error);
        let mut outputs = Parts::new(segment, segment.manipulated);
        self.segment_variation(segment, &mut outputs);
        self.segment_extremes(segment, &mut errors);
        self.segment_tracking(segment, &mut errors);
        self.last.0 = segment.setpoint - segment.ends(segment.error).1;
    }

    /// Adds ISE and control energy of a segment, part by part.
    pub(super) fn add_squares(&mut self, segment: &Segment<'_>) {
        self.ise += square(&segment.parts(segment.error));
        self.energy += square(&segment.parts(segment.manipulated));
    }

    /// Adds IAE and ITAE of a segment, part by part.
    pub(super) fn add_areas(&mut self, segment: &Segment<'_>) {
        for part in segment.parts(segment.error) {
            self.absolute_integrals((part.start, part.length), &part.poly);
        }
    }

    fn segment_variation(&mut self, segment: &Segment<'_>, outputs: &mut Parts<'_>) {
        let u = segment.manipulated;
        let (start, end) = segment.ends(u);
        let extrema =
            if segment.monotone(u) { Some(Extrema::NONE) } else { extrema(segment, u, self.variation) };
        if let Some(extrema) = extrema {
            let mut before = self.last.1;
            for &value in [start].iter().chain(extrema.values()).chain(&[end]) {
                self.variation += (value - before).abs();
                before = value;
            }
            self.last.1 = end;
            return;
        }
        for part in outputs.get() {
            self.variation_of(&part.poly);
        }
    }

    fn segment_extremes(&mut self, segment: &Segment<'_>, errors: &mut Parts<'_>) {
        let e = segment.error;
        let swing = sum_of_magnitudes(&e.smooth) - e.smooth[0].abs() + e.layer_size(segment.terms);
        let peak_bound = (segment.setpoint - e.smooth[0]).abs() + swing;
        let end_time = segment.start + segment.length;
        let overshoot_decided = self.tracking.as_ref().is_none_or(|t| {
            end_time <= t.start() || (-e.smooth[0] / t.size()) + swing / t.size().abs() <= t.overshoot
        });
        if peak_bound <= self.peak && overshoot_decided {
            return;
        }
        // Changes below 1e-15 of the peak so far, or of an end, are nothing.
        let (start, end) = segment.ends(e);
        let size = self.peak.max(start.abs()).max(end.abs());
        if let Some(extrema) = extrema(segment, e, size) {
            for &error in [start, end].iter().chain(extrema.values()) {
                self.peak = self.peak.max((segment.setpoint - error).abs());
                if let Some(tracking) = self.tracking.as_mut().filter(|t| end_time > t.start()) {
                    tracking.overshoot = tracking.overshoot.max(-error / tracking.size());
                }
            }
            return;
        }
        for part in errors.get() {
            self.extremes((part.start, part.length), segment.setpoint, &part.poly, ends(&part.poly));
        }
    }

    fn segment_tracking(&mut self, segment: &Segment<'_>, errors: &mut Parts<'_>) {
        let Some(tracking) = &mut self.tracking else { return };
        if segment.setpoint == 0.0 {
            return; // before the move
        }
        let e = segment.error;
        if tracking.first_at.iter().all(Option::is_some) {
            let bound = sum_of_magnitudes(&e.smooth) + e.layer_size(segment.terms);
            let end = segment.ends(e).1.abs();
            if bound <= BANDS[0] * tracking.size().abs() {
                tracking.inside = [true; 2];
                return;
            }
            if end > BANDS[1] * tracking.size().abs() {
                tracking.inside = [false; 2];
                tracking.last_outside = [segment.start + segment.length; 2];
                return;
            }
        }
        for part in errors.get() {
            tracking.part((part.start, part.length), segment.setpoint, &part.poly, ends(&part.poly));
        }
    }
}

/// `∫x²` over the segment [unit² · s], part by part.
fn square(parts: &[Part]) -> f64 {
    parts.iter().map(|part| 0.5 * part.length * square_integral(&part.poly)).sum()
}
