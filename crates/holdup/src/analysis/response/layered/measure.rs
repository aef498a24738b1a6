//! The metrics of one segment: integrals in closed form, everything else by a bound or by monotony where that decides, and
//! by polynomials on parts of the segment where it does not.

use super::super::legendre::{Poly, TERMS, ends, from_powers, square_integral};
use super::super::measure::{BANDS, Measure};
use super::super::roots::sign_changes;
use super::areas::areas;
use super::extrema::{Extrema, extrema};
use super::lanes::Lanes;
use super::segment::{Part, Segment, dot, layer_at, layer_slope_at};
use super::signal::{Signal, sum_of_magnitudes};
use super::squares::squares;
use super::tables::{INVERSE, TABLES};

/// A layer whose part of a sum is below this is left out: rounding.
const ROUNDING: f64 = 1e-17;

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
        if self.integrals_only {
            self.add_integrals(segment);
            return;
        }
        let mut errors = Parts::new(segment, segment.error);
        let mut outputs = Parts::new(segment, segment.manipulated);
        self.segment_squares(segment, &mut errors, &mut outputs);
        self.segment_integrals(segment, &mut errors);
        self.segment_variation(segment, &mut outputs);
        self.segment_extremes(segment, &mut errors);
        self.segment_tracking(segment, &mut errors);
        self.last.0 = segment.setpoint - segment.ends(segment.error).1;
    }

    /// Adds the integrals of a segment, and nothing else.
    pub(super) fn add_integrals(&mut self, segment: &Segment<'_>) {
        self.add_squares(segment);
        self.add_areas(segment);
    }

    /// Adds ISE and control energy of a segment.
    pub(super) fn add_squares(&mut self, segment: &Segment<'_>) {
        let mut outputs = Parts::new(segment, segment.manipulated);
        self.segment_squares(segment, &mut Parts::new(segment, segment.error), &mut outputs);
    }

    /// Adds IAE and ITAE of a segment.
    pub(super) fn add_areas(&mut self, segment: &Segment<'_>) {
        self.segment_integrals(segment, &mut Parts::new(segment, segment.error));
    }

    /// ∫e² and ∫u².
    fn segment_squares(&mut self, segment: &Segment<'_>, errors: &mut Parts<'_>, outputs: &mut Parts<'_>) {
        let so_far = (Lanes([self.ise]), Lanes([self.energy]));
        let known = segment.stretch.map_or(([None], [None]), |stretch| squares(stretch, so_far));
        self.ise += known.0[0].unwrap_or_else(|| square(segment, errors, self.ise));
        self.energy += known.1[0].unwrap_or_else(|| square(segment, outputs, self.energy));
    }

    /// ∫|e| and ∫t·|e|.
    fn segment_integrals(&mut self, segment: &Segment<'_>, errors: &mut Parts<'_>) {
        let so_far = (Lanes([self.iae]), Lanes([self.itae]));
        if let Some((area, moment)) = segment.stretch.and_then(|stretch| areas(stretch, so_far)[0]) {
            self.iae += area;
            self.itae += moment;
            return;
        }
        let e = segment.error;
        let layer = e.layer_size(segment.terms);
        let swing = sum_of_magnitudes(&e.smooth) - e.smooth[0].abs();
        let one_sign = e.smooth[0].abs() >= swing + layer;
        if segment.layers_end_inside() && (one_sign || segment.monotone(e)) {
            let (total, moment) = totals(segment, e);
            let (start, end) = if one_sign { (1.0, 1.0) } else { segment.ends(e) };
            if (start < 0.0) == (end < 0.0) {
                self.iae += total.abs();
                self.itae += moment.abs();
                return;
            }
            let root = only_root(segment, e, start, end);
            let (area, weighted) = integrals(segment, e, root);
            self.iae += area.abs() + (total - area).abs();
            self.itae += weighted.abs() + (moment - weighted).abs();
            return;
        }
        if segment.layers_end_inside() && self.integrals_between_roots(segment, layer) {
            return;
        }
        for part in errors.get() {
            self.absolute_integrals((part.start, part.length), &part.poly);
        }
    }

    /// ∫|e| and ∫t·|e| of a segment whose error, proven, does not change sign while its layer lasts; whether it is one.
    fn integrals_between_roots(&mut self, segment: &Segment<'_>, layer: f64) -> bool {
        let e = segment.error;
        // What is left of the layer, and noise of the series, changes the sums by less than rounding does.
        let floor = ROUNDING * (self.iae / segment.length).min(self.itae / segment.length.powi(2));
        let over = if layer > floor { segment.layer_below(e, floor) } else { 0.0 };
        let mut from = -1.0;
        if over > 0.0 {
            let start = segment.expansion(e, over);
            let (mut swing, mut power) = (layer, 1.0);
            for (i, c) in start[1..].iter().enumerate() {
                power *= over * INVERSE[i + 1];
                swing += c.abs() * power;
            }
            if start[0].abs() <= swing || over >= segment.theta() {
                return false;
            }
            from = 2.0 * over / segment.theta() - 1.0;
        }
        let roots = sign_changes(&from_powers(&e.smooth), floor);
        let mut before = (0.0, 0.0);
        let total = totals(segment, e);
        let pieces = roots.as_slice().iter().filter(|s| **s > from).map(|&s| integrals(segment, e, s));
        for until in pieces.chain([total]) {
            self.iae += (until.0 - before.0).abs();
            self.itae += (until.1 - before.1).abs();
            before = until;
        }
        true
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

/// `∫x²` over the segment [unit² · s]; `so_far` is the sum it is added to.
fn square(segment: &Segment<'_>, parts: &mut Parts<'_>, so_far: f64) -> f64 {
    let x = parts.signal;
    let smooth = 0.5 * segment.length * smooth_square(x);
    let layer = x.layer_size(segment.terms);
    if layer == 0.0 {
        return smooth;
    }
    let closed = segment.layers_end_inside().then(|| product(segment, x, smooth + so_far)).flatten();
    closed.map_or_else(
        || parts.get().iter().map(|part| 0.5 * part.length * square_integral(&part.poly)).sum(),
        |product| smooth + product + layer_square(segment, x, smooth + so_far),
    )
}

/// `∫ smooth² ds`, exact: 24 Gauss nodes for a degree of 46.
#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
fn smooth_square(x: &Signal) -> f64 {
    const HALF: usize = TERMS / 2;
    let (nodes, weights) = (&TABLES.nodes, &TABLES.weights);
    let squares: [f64; HALF] = std::array::from_fn(|k| nodes[k] * nodes[k]);
    let (mut even, mut odd) = ([0.0; HALF], [0.0; HALF]);
    for j in (0..HALF).rev() {
        for k in 0..HALF {
            even[k] = even[k] * squares[k] + x.smooth[2 * j];
            odd[k] = odd[k] * squares[k] + x.smooth[2 * j + 1];
        }
    }
    let mut terms = [0.0; HALF];
    for k in 0..HALF {
        terms[k] = 2.0 * weights[k] * (even[k] * even[k] + squares[k] * (odd[k] * odd[k]));
    }
    terms.iter().sum()
}

/// `2·∫ smooth·layer dt`; `None` where the smooth part, expanded about the start, does not converge over the layer.
fn product(segment: &Segment<'_>, x: &Signal, so_far: f64) -> Option<f64> {
    let floor = ROUNDING * so_far * segment.rate;
    let layer = x.layer_size(segment.terms);
    if 2.0 * layer * sum_of_magnitudes(&x.smooth) <= floor {
        return Some(0.0);
    }
    let sum = product_sum(&x.smooth, &x.layer[..segment.terms], 2.0 / segment.theta(), floor)?;
    Some(2.0 * sum / segment.rate)
}

#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
fn product_sum(smooth: &Poly, layer: &[f64], per_theta: f64, floor: f64) -> Option<f64> {
    let (mut sum, mut scale, mut before) = (0.0, 1.0, f64::INFINITY);
    for (row, moments) in TABLES.at_start.iter().zip(&TABLES.moments) {
        let term = scale * dot(smooth, row) * dot(layer, moments);
        sum += term;
        let size = term.abs();
        if size.max(before) <= (1e-16 * f64::abs(sum)).max(floor) {
            return Some(sum);
        }
        before = size;
        scale *= per_theta;
    }
    None
}

/// `∫ layer² dt`.
fn layer_square(segment: &Segment<'_>, x: &Signal, so_far: f64) -> f64 {
    let floor = ROUNDING * so_far * segment.rate;
    square_sum(&x.layer[..segment.terms], x.layer_size(segment.terms), floor) / segment.rate
}

#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
fn square_sum(layer: &[f64], size: f64, floor: f64) -> f64 {
    let mut sum = 0.0;
    for (q, row) in layer.iter().zip(&TABLES.squares) {
        // Coefficients of the product are at most 1/2.
        if q.abs() * size > floor {
            sum += q * dot(layer, row);
        }
    }
    sum
}

/// `∫x dt` and `∫t·x dt` over the segment.
fn totals(segment: &Segment<'_>, x: &Signal) -> (f64, f64) {
    let half = 0.5 * segment.length;
    let area = 2.0 * half * dot(&x.smooth, &TABLES.areas);
    let about_middle = 2.0 * half * half * dot(&x.smooth, &TABLES.moments_about_middle);
    with_layer(segment, x, f64::INFINITY, (area, (segment.start + half) * area + about_middle))
}

/// `∫x dt` and `∫t·x dt` from the start of the segment to `s`.
fn integrals(segment: &Segment<'_>, x: &Signal, s: f64) -> (f64, f64) {
    let half = 0.5 * segment.length;
    // Primitives of x and of s·x in powers of s, at s and at −1.
    let (mut area, mut moment) = ([0.0; 2], [0.0; 2]);
    let points = [s, -1.0];
    for j in (0..TERMS).rev() {
        for k in 0..2 {
            area[k] = (area[k] + x.smooth[j] * INVERSE[j + 1]) * points[k];
            moment[k] = (moment[k] + x.smooth[j] * INVERSE[j + 2]) * points[k];
        }
    }
    let area = half * (area[0] - area[1]);
    let about_middle = half * half * (moment[0] * s + moment[1]);
    let theta = 0.5 * segment.theta() * (1.0 + s);
    with_layer(segment, x, theta, (area, (segment.start + half) * area + about_middle))
}

/// Adds to the integrals of the smooth part those of the layer up to `theta`.
fn with_layer(segment: &Segment<'_>, x: &Signal, theta: f64, (area, moment): (f64, f64)) -> (f64, f64) {
    if segment.terms == 0 {
        return (area, moment);
    }
    let (all, first) = layer_integrals(x, theta, segment.terms);
    let all = all / segment.rate;
    (area + all, moment + segment.start * all + first / (segment.rate * segment.rate))
}

/// `∫ layer dθ` and `∫ θ·layer dθ` from 0 to `theta`.
fn layer_integrals(x: &Signal, theta: f64, terms: usize) -> (f64, f64) {
    // From θ to infinity: sums T_j of the coefficients from j on, and for θ·layer, whose coefficient j is j·q_(j−1).
    let mut tail = Signal::ZERO;
    let (mut all, mut first, mut index) = (0.0, 0.0, 0.0);
    for q in &x.layer[..terms] {
        index += 1.0;
        all += q;
        first += index * q;
    }
    if super::signal::has_decayed(theta, terms) {
        return (all, first);
    }
    let (mut from, mut sum) = (0.0, 0.0);
    for j in (0..terms).rev() {
        sum += x.layer[j];
        tail.layer[j] = sum;
    }
    let beyond = layer_at(&tail, theta, terms);
    let mut weighted = [0.0; super::signal::LAYER_TERMS + 1];
    for j in (0..terms).rev() {
        from += index * x.layer[j];
        weighted[j + 1] = from;
        index -= 1.0;
    }
    weighted[0] = from;
    let mut value = 0.0;
    for j in (0..=terms).rev() {
        value = value * theta * if j < terms { INVERSE[j + 1] } else { 0.0 } + weighted[j];
    }
    (all - beyond, first - value * (-theta).exp())
}

/// The root of a monotone signal with these values (of opposite sign) at its ends.
fn only_root(segment: &Segment<'_>, x: &Signal, start: f64, end: f64) -> f64 {
    let (mut low, mut high) = (-1.0, 1.0);
    let half_theta = 0.5 * segment.theta();
    let mut s = -1.0 - start * (2.0 / (end - start));
    for _ in 0..100 {
        if !(s > low && s < high) {
            s = 0.5 * (low + high);
        }
        let (mut value, mut slope) = (0.0, 0.0);
        for c in x.smooth.iter().rev() {
            slope = slope * s + value;
            value = value * s + c;
        }
        let theta = half_theta * (1.0 + s);
        value += layer_at(x, theta, segment.terms);
        slope += half_theta * layer_slope_at(x, theta, segment.terms);
        if (value < 0.0) == (start < 0.0) {
            low = s;
        } else {
            high = s;
        }
        let next = s - value / slope;
        // The error of an integral is of second order in that of the root, and Newton squares the latter: 1e-9 becomes rounding.
        if (next - s).abs() < 1e-9 || high - low < 1e-12 {
            return next.clamp(low, high);
        }
        s = next;
    }
    s
}
