//! What the metrics are made of, gathered cell by cell: integrals, variation, extrema, crossings.

use super::cell::{Cell, Watch};
use super::layered::{Gathered, Segment};
use super::legendre::{
    Poly, derivative, ends, magnitude, primitives, significant, square_integral, swing, value,
};
use super::roots::{Roots, sign_changes};

/// A setpoint move that overshoot, rise and settling are about.
#[derive(Debug, Clone, Copy)]
pub(super) struct Move {
    pub(super) time: f64,
    pub(super) size: f64,
}

/// First crossing of the levels, last time outside the bands, largest overshoot.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tracking {
    step: Move,
    /// Largest error beyond the setpoint, as a ratio of the move.
    pub(super) overshoot: f64,
    /// First time at 10 % and at 90 % of the move [s].
    pub(super) first_at: [Option<f64>; 2],
    /// Last time outside 2 % and 5 % of the move [s].
    pub(super) last_outside: [f64; 2],
    /// Whether the error is inside 2 % and 5 % at the end.
    pub(super) inside: [bool; 2],
}

pub(super) const LEVELS: [f64; 2] = [0.1, 0.9];
pub(super) const BANDS: [f64; 2] = [0.02, 0.05];

/// All sums and extremes of one run.
#[derive(Debug)]
pub(super) struct Measure {
    pub(super) iae: f64,
    pub(super) ise: f64,
    pub(super) itae: f64,
    pub(super) energy: f64,
    pub(super) variation: f64,
    pub(super) peak: f64,
    pub(super) tracking: Option<Tracking>,
    /// Whether nothing is asked for but the integrals.
    pub(super) integrals_only: bool,
    /// Segments whose integrals are not in the sums yet; see [`Self::settle`].
    pub(super) gathered: Gathered,
    /// Controlled variable (relative to the initial level) and controller output at the end.
    pub(super) last: (f64, f64),
}

impl Measure {
    pub(super) fn new(step: Option<Move>) -> Self {
        let tracking = step.map(|step| Tracking {
            step,
            overshoot: 0.0,
            first_at: [None; 2],
            last_outside: [step.time; 2],
            inside: [false; 2],
        });
        Self {
            iae: 0.0,
            ise: 0.0,
            itae: 0.0,
            energy: 0.0,
            variation: 0.0,
            peak: 0.0,
            tracking,
            integrals_only: false,
            gathered: Gathered::default(),
            last: (0.0, 0.0),
        }
    }

    /// Measures the integrals and nothing else.
    pub(super) fn integrals_only() -> Self {
        Self { integrals_only: true, ..Self::new(None) }
    }

    /// `∫|e|` and `∫t·|e|` over a cell that starts at `start`.
    pub(super) fn absolute_integrals(&mut self, (start, length): (f64, f64), e: &Poly) {
        let half = 0.5 * length;
        let middle = start + half;
        let bound = 2.0 * half * magnitude(e);
        // Too small to change the sums by a rounding error: its sign does not matter.
        let negligible = bound <= 1e-18 * self.iae && bound * (start + length) <= 1e-18 * self.itae;
        if negligible || e[0].abs() >= swing(e) {
            let sign = if e[0] < 0.0 { -1.0 } else { 1.0 };
            let (area, moment) = (2.0 * e[0], e[1] * (2.0 / 3.0));
            self.iae += sign * half * area;
            self.itae += sign * half * (middle * area + half * moment);
            return;
        }
        // Noise below this changes the sums by less than rounding does.
        let floor = 1e-17 * (self.iae / length).min(self.itae / (length * (start + length)));
        let roots = sign_changes(e, floor);
        let (area, moment) = primitives(e);
        let (mut area_before, mut moment_before) = (0.0, 0.0);
        for &s in roots.as_slice().iter().chain(&[1.0]) {
            let (area_here, moment_here) = (value(&area, s), value(&moment, s));
            let (a, m) = (area_here - area_before, moment_here - moment_before);
            self.iae += half * a.abs();
            let weighted = half * (middle * a + half * m);
            self.itae += if a < 0.0 { -weighted } else { weighted };
            (area_before, moment_before) = (area_here, moment_here);
        }
    }

    /// Total variation of the controller output, the jump to the start of the cell included.
    pub(super) fn variation_of(&mut self, u: &Poly) {
        let (start, end) = ends(u);
        let mut before = self.last.1;
        self.variation += (start - before).abs();
        before = start;
        let mut smooth = *u;
        smooth[significant(u, 1e-14 * self.variation)..].fill(0.0);
        let slope = derivative(&smooth);
        if slope[0].abs() < swing(&slope) {
            for &s in sign_changes(&slope, 0.0).as_slice() {
                let here = value(u, s);
                self.variation += (here - before).abs();
                before = here;
            }
        }
        self.variation += (end - before).abs();
        self.last.1 = end;
    }

    /// Peak and overshoot; `start` and `end` are the values of the error at the ends of the cell.
    pub(super) fn extremes(
        &mut self,
        (from, length): (f64, f64),
        setpoint: f64,
        e: &Poly,
        (start, end): (f64, f64),
    ) {
        let reach = swing(e);
        let mut extrema: Option<Roots> = None;
        let mut largest = |of: &dyn Fn(f64) -> f64, bound: f64, so_far: f64| {
            if bound <= so_far {
                return so_far;
            }
            let mut most = so_far.max(of(start)).max(of(end));
            if bound > most {
                let extrema = extrema.get_or_insert_with(|| {
                    let mut smooth = *e;
                    smooth[significant(e, 1e-16 * so_far)..].fill(0.0);
                    sign_changes(&derivative(&smooth), 0.0)
                });
                for &s in extrema.as_slice() {
                    most = most.max(of(value(e, s)));
                }
            }
            most
        };
        let moved = |error: f64| (setpoint - error).abs();
        self.peak = largest(&moved, moved(e[0]) + reach, self.peak);
        if let Some(tracking) = self.tracking.as_mut().filter(|t| from + length > t.step.time) {
            let beyond = |error: f64| -error / tracking.step.size;
            let bound = beyond(e[0]) + reach / tracking.step.size.abs();
            tracking.overshoot = largest(&beyond, bound, tracking.overshoot);
        }
    }
}

impl Tracking {
    /// Time of the setpoint move [s].
    pub(super) fn start(&self) -> f64 {
        self.step.time
    }

    /// Size of the setpoint move.
    pub(super) fn size(&self) -> f64 {
        self.step.size
    }

    /// Adds a cell; `start` and `end` are the values of the error at its ends.
    pub(super) fn part(
        &mut self,
        (from, length): (f64, f64),
        setpoint: f64,
        e: &Poly,
        (start, end): (f64, f64),
    ) {
        if setpoint == 0.0 {
            return; // before the move
        }
        let size = self.step.size;
        let reach = swing(e);
        let time = |s: f64| from + 0.5 * length * (1.0 + s);
        for (level, first) in LEVELS.iter().zip(&mut self.first_at) {
            if first.is_none() {
                // Positive until the level is reached.
                let to_go = |error: f64| (error - size * (1.0 - level)) / size;
                if to_go(start) <= 0.0 {
                    *first = Some(from);
                } else if to_go(e[0]) <= reach / size.abs() {
                    let mut shifted = *e;
                    shifted[0] -= size * (1.0 - level);
                    *first = sign_changes(&shifted, 1e-16 * size.abs()).as_slice().first().map(|&s| time(s));
                    if first.is_none() && to_go(end) <= 0.0 {
                        *first = Some(time(1.0));
                    }
                }
            }
        }
        for (index, band) in BANDS.iter().map(|b| b * size.abs()).enumerate() {
            self.inside[index] = end.abs() <= band;
            if !self.inside[index] {
                self.last_outside[index] = time(1.0);
            } else if e[0].abs() + reach > band {
                let last = |shift: f64| {
                    let mut shifted = *e;
                    shifted[0] += shift;
                    sign_changes(&shifted, 1e-16 * size.abs()).as_slice().last().copied()
                };
                let latest = last(-band).into_iter().chain(last(band)).fold(f64::NEG_INFINITY, f64::max);
                if latest >= -1.0 {
                    self.last_outside[index] = time(latest);
                } else if start.abs() > band {
                    self.last_outside[index] = from;
                }
            }
        }
    }
}

impl Watch for Measure {
    fn cell(&mut self, cell: &Cell<'_>) {
        let error_ends = ends(cell.error);
        self.ise += 0.5 * cell.length * square_integral(cell.error);
        self.energy += 0.5 * cell.length * square_integral(cell.manipulated);
        let place = (cell.start, cell.length);
        self.absolute_integrals(place, cell.error);
        if self.integrals_only {
            return;
        }
        self.variation_of(cell.manipulated);
        self.extremes(place, cell.setpoint, cell.error, error_ends);
        if let Some(tracking) = &mut self.tracking {
            tracking.part(place, cell.setpoint, cell.error, error_ends);
        }
        self.last.0 = cell.setpoint - error_ends.1;
    }

    fn segment(&mut self, segment: &Segment<'_>) {
        self.add_segment(segment);
    }

    fn restart(&mut self) {
        *self = Self { integrals_only: self.integrals_only, ..Self::new(self.tracking.map(|t| t.step)) };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::response::legendre::TERMS;

    #[test]
    fn integrals_of_a_line_that_changes_sign_are_those_of_two_triangles() {
        let mut error: Poly = [0.0; TERMS];
        (error[0], error[1]) = (-0.5, 1.0); // e = s − 1/2 on a cell from 2 to 6: root at t = 5
        let cell = Cell {
            start: 2.0,
            length: 4.0,
            setpoint: 1.0,
            error: &error,
            manipulated: &error,
            load_estimate: None,
        };
        let mut measure = Measure::new(None);
        measure.cell(&cell);
        // ∫|e| = (9 + 1)/4; ∫t|e| = ∫ t(5−t)/2 over 2…5 + ∫ t(t−5)/2 over 5…6; 1e-15: a few roundings.
        assert!((measure.iae - 2.5).abs() < 1e-15 * 4.0);
        assert!((measure.itae - (6.75 + 17.0 / 12.0)).abs() < 1e-14);
        assert!((measure.ise - (27.0 + 1.0) / 12.0).abs() < 1e-15 * 4.0);
        assert!((measure.variation - (1.5 + 2.0)).abs() < 1e-15 * 4.0);
        assert_eq!(measure.peak, 2.5);
    }
}
