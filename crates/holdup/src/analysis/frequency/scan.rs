//! One pass over the frequencies that finds every crossover and the highest peaks, with proof.
//!
//! Bands of frequency are halved until each question is settled on each of them: the function concerned has no
//! zero there, or exactly one (which is then polished), or stays below the peak already found. Wide bands are
//! settled by the [`Envelope`], narrow ones by Taylor polynomials with a bound of their rest.

use std::f64::consts::{PI, TAU};

use super::envelope::{Modulus, Steady};
use super::functions::{Bounds, Curve, Peak, Point, imaginary, real};
use super::lifted::{Lifted, Question};
use super::taylor::{Zeros, root, zeros};

/// Longest list of phase crossovers.
pub(super) const LISTED: usize = 32;
/// Longest list of gain crossovers.
const GAIN_LISTED: usize = 1000;
/// Relative difference below which one peak is not told from another; the one kept is polished to rounding.
const PEAK_TOLERANCE: f64 = 1e-11;
/// Bands examined before the search is given up and said to be unfinished.
const WORK: usize = 4_000_000;

/// The questions open on a band of frequencies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "four independent questions")]
struct Open {
    gain: bool,
    phase: bool,
    sensitivity: bool,
    complementary: bool,
}

impl Open {
    fn any(self) -> bool {
        self.gain || self.phase || self.sensitivity || self.complementary
    }
}

/// A peak and where it was found; no frequency where it is a limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Highest {
    pub(super) value: f64,
    pub(super) omega: Option<f64>,
}

/// What the scan found, in radians per dead time.
#[derive(Debug, Clone)]
pub(super) struct Findings {
    pub(super) gain_crossovers: Vec<f64>,
    /// The first phase crossovers.
    pub(super) phase_crossovers: Vec<f64>,
    /// Greatest |L| < 1 over all phase crossovers, and its limit |L(j∞)|.
    pub(super) below_one: f64,
    /// Least |L| > 1 over all phase crossovers.
    pub(super) above_one: Option<f64>,
    pub(super) sensitivity: Highest,
    pub(super) complementary: Highest,
    /// The search was given up from this frequency on.
    pub(super) unfinished_from: Option<f64>,
    /// Bands and boxes examined.
    pub(super) work: usize,
}

pub(super) struct Scan<'a, C, M> {
    functions: &'a C,
    envelope: &'a M,
    steady: Option<&'a Steady<'a>>,
    lifted: Option<&'a Lifted>,
    stable: bool,
    /// L does not vanish at infinite frequency.
    neutral: bool,
    found: Findings,
}

impl<'a, C: Curve, M: Modulus> Scan<'a, C, M> {
    /// A scan of the imaginary axis.
    pub(super) fn new(
        functions: &'a C,
        envelope: &'a M,
        steady: &'a Steady<'a>,
        lifted: Option<&'a Lifted>,
        limit: f64,
        stable: bool,
    ) -> Self {
        // At ω → 0 the integrator makes S = 0 and T = 1; at ω → ∞ |L| is at most `limit`, its supremum.
        let at_infinity = |numerator: f64| if limit < 1.0 { numerator / (1.0 - limit) } else { 1.0 };
        let found = Findings {
            gain_crossovers: Vec::new(),
            phase_crossovers: Vec::with_capacity(LISTED),
            below_one: limit.min(1.0),
            above_one: None,
            sensitivity: Highest { value: at_infinity(1.0).max(1.0), omega: None },
            complementary: Highest { value: at_infinity(limit), omega: None },
            unfinished_from: None,
            work: 0,
        };
        let steady = Some(steady);
        let mut scan = Self { functions, envelope, steady, lifted, stable, neutral: limit > 0.0, found };
        let origin = functions.at(0.0).peak_value(Peak::Complementary);
        if origin >= scan.found.complementary.value {
            scan.found.complementary = Highest { value: origin, omega: Some(0.0) };
        }
        scan
    }

    /// A scan of the upper half of the unit circle, from z = 1, where L has a pole, to z = −1.
    pub(super) fn of_circle(functions: &'a C, envelope: &'a M, stable: bool) -> Self {
        let nowhere = Highest { value: 0.0, omega: None };
        let found = Findings {
            gain_crossovers: Vec::new(),
            phase_crossovers: Vec::with_capacity(LISTED),
            below_one: 0.0,
            above_one: None,
            sensitivity: nowhere,
            complementary: nowhere,
            unfinished_from: None,
            work: 0,
        };
        Self { functions, envelope, steady: None, lifted: None, stable, neutral: false, found }
    }

    /// Runs the search round the half circle.
    pub(super) fn run_round(mut self) -> Findings {
        // Peaks may lie at either end, where every function is even.
        for omega in [0.0, PI] {
            let point = self.functions.at(omega);
            for peak in [Peak::Sensitivity, Peak::Complementary] {
                let value = point.peak_value(peak);
                if value > self.highest(peak).value {
                    *self.highest(peak) = Highest { value, omega: Some(omega) };
                }
            }
        }
        let open = Open { gain: true, phase: true, sensitivity: self.stable, complementary: self.stable };
        let (mut from, mut to) = (0.0, 1.0);
        while from < PI {
            self.band(from, to, open);
            if self.found.work > WORK {
                self.found.unfinished_from = Some(from);
                break;
            }
            from = to;
            to = (2.0 * to).min(PI);
        }
        if self.functions.direction(PI)[0].re < 0.0 {
            self.phase_crossover(PI);
        }
        self.polish_peaks();
        for peak in [Peak::Sensitivity, Peak::Complementary] {
            let highest = self.highest(peak);
            // Uphill may have led over the end.
            highest.omega = highest.omega.map(|omega| if omega > PI { TAU - omega } else { omega });
        }
        self.found
    }

    /// Runs the search from ω = 0 until nothing is open up to infinity.
    pub(super) fn run(mut self) -> Findings {
        let (mut from, mut to) = (0.0, 1.0);
        loop {
            let all = Open { gain: true, phase: true, sensitivity: self.stable, complementary: self.stable };
            if self.found.phase_crossovers.len() < LISTED
                && self.steady.is_some_and(|steady| steady.beyond(from))
            {
                self.list_steady_crossovers(from);
            }
            let open = self.open_by_envelope(all, from, f64::INFINITY);
            let open = if self.neutral { self.open_by_lifting(open, from, f64::INFINITY) } else { open };
            if !open.any() {
                break;
            }
            if self.found.work > WORK || to > 1e110 {
                self.found.unfinished_from = Some(from);
                break;
            }
            let open = self.open_by_envelope(open, from, to);
            let open = self.open_by_lifting(open, from, to);
            self.band(from, to, open);
            from = to;
            to *= 2.0;
        }
        self.polish_peaks();
        self.found
    }

    /// What the envelope leaves open on [from, to].
    fn open_by_envelope(&self, open: Open, from: f64, to: f64) -> Open {
        let below = |bound: f64| from > 0.0 && self.envelope.gain_is_below(bound, from, to);
        let found = &self.found;
        let listed = found.phase_crossovers.len() >= LISTED;
        let peak = |level: f64| level * (1.0 + PEAK_TOLERANCE);
        Open {
            gain: open.gain
                && found.gain_crossovers.len() < GAIN_LISTED
                && !below(1.0)
                && !self.envelope.gain_is_above_one(from, to),
            phase: open.phase
                && !(listed && (!self.stable || below(found.below_one * (1.0 + PEAK_TOLERANCE)))),
            // |S| ≤ 1/(1 − A) and |T| ≤ A/(1 − A) where |L| ≤ A < 1.
            sensitivity: open.sensitivity && !below(1.0 - 1.0 / peak(found.sensitivity.value)),
            complementary: open.complementary && {
                let level = peak(found.complementary.value);
                !below(level / (1.0 + level))
            },
        }
    }

    /// What frequency and phase as two variables leave open on [from, to]; the pieces of the axis on which they
    /// prove nothing are searched at once.
    fn open_by_lifting(&mut self, mut open: Open, from: f64, to: f64) -> Open {
        let Some(lifted) = self.lifted.filter(|lifted| lifted.applies(from, to)) else { return open };
        let none = Open { gain: false, phase: false, sensitivity: false, complementary: false };
        let functions = self.functions;
        for peak in [Peak::Sensitivity, Peak::Complementary] {
            let asked = match peak {
                Peak::Sensitivity => &mut open.sensitivity,
                Peak::Complementary => &mut open.complementary,
            };
            if !std::mem::take(asked) {
                continue;
            }
            let question =
                |scan: &mut Self| Question::Below(peak, scan.highest(peak).value * (1.0 + PEAK_TOLERANCE));
            let first = question(self);
            let rest = lifted.open(first, from, to, |omega| {
                self.offer(peak, &functions.at(omega));
                question(self)
            });
            let only = match peak {
                Peak::Sensitivity => Open { sensitivity: true, ..none },
                Peak::Complementary => Open { complementary: true, ..none },
            };
            if !self.search_pieces(rest, only) {
                match peak {
                    Peak::Sensitivity => open.sensitivity = true,
                    Peak::Complementary => open.complementary = true,
                }
            }
        }
        if open.phase && self.stable && self.found.phase_crossovers.len() >= LISTED {
            let question = Question::RealAxis(self.found.below_one * (1.0 + PEAK_TOLERANCE));
            let rest = lifted.open(question, from, to, |_| question);
            open.phase = !self.search_pieces(rest, Open { phase: true, ..none });
        }
        open
    }

    /// Searches what a proof left; false where the proof was given up.
    fn search_pieces(&mut self, (pieces, work): (Option<Vec<(f64, f64)>>, usize), open: Open) -> bool {
        self.found.work += work;
        let Some(pieces) = pieces else { return false };
        for (a, b) in pieces {
            self.band(a, b, open);
        }
        true
    }

    fn band(&mut self, from: f64, to: f64, open: Open) {
        let mut stack = vec![(from, to, open)];
        while let Some((a, b, open)) = stack.pop() {
            self.found.work += 1;
            if self.found.work > WORK {
                return;
            }
            let (middle, radius) = (f64::midpoint(a, b), 0.5 * (b - a));
            let wide = radius * self.functions.longest_delay() > 1.0;
            let listed = self.found.phase_crossovers.len() >= LISTED;
            let mut open = open;
            if wide || listed {
                open = self.open_by_envelope(open, a, b);
            }
            if open.gain && radius * self.functions.spread() <= 1.0 {
                open.gain = !self.gain_settled(a, b);
            }
            if !wide && open.any() {
                open = self.narrow(a, b, open);
            }
            // Beyond 1e15 radians of delay the phase is lost in rounding.
            if !open.any() || radius <= 2.0 * f64::EPSILON * b || b < 1e-300 {
                continue;
            }
            stack.push((middle, b, open));
            stack.push((a, middle, open));
        }
    }

    /// Whether Taylor polynomials settle the gain crossovers on [a, b]. |L| does not turn with the shortest delay:
    /// with one delay the band may be as wide as it likes.
    fn gain_settled(&mut self, a: f64, b: f64) -> bool {
        let (middle, radius) = (f64::midpoint(a, b), 0.5 * (b - a));
        let (excess, third, rounding) = self.functions.gain_excess(middle, b);
        let roots = zeros(excess, third, rounding, radius);
        let functions = self.functions;
        if let Some(root) = root(roots, a, b, |omega| functions.gain_excess(omega, omega).0) {
            push_apart(&mut self.found.gain_crossovers, root);
        }
        roots != Zeros::Unknown
    }

    /// Settles what Taylor polynomials can settle on [a, b]; returns what stays open.
    fn narrow(&mut self, a: f64, b: f64, mut open: Open) -> Open {
        let (middle, radius) = (f64::midpoint(a, b), 0.5 * (b - a));
        let point = self.functions.at(middle);
        let bounds = self.functions.bounds(b);
        if open.phase {
            let direction = self.functions.direction_at(&point);
            let (third, rounding) = self.functions.direction_bounds(&bounds, b);
            let rest = third * radius.powi(3) / 6.0 + rounding;
            if real(&direction).range(radius).0 > rest {
                open.phase = false;
            } else {
                let roots = zeros(imaginary(&direction), third, rounding, radius);
                open.phase = roots == Zeros::Unknown;
                // Next to ω = 0 the function may vanish with the frequency: not a crossing.
                let vanishing = roots == Zeros::Touching && radius > 1e-3 * b;
                let functions = self.functions;
                let along = |omega: f64| imaginary(&functions.direction(omega));
                let negative = |omega: &f64| !vanishing && functions.direction(*omega)[0].re < 0.0;
                if let Some(root) = root(roots, a, b, along).filter(negative) {
                    self.phase_crossover(root);
                }
            }
        }
        if open.sensitivity {
            open.sensitivity = !self.peak_settled(Peak::Sensitivity, &point, &bounds, radius);
        }
        if open.complementary {
            open.complementary = !self.peak_settled(Peak::Complementary, &point, &bounds, radius);
        }
        open
    }

    /// Fills the list of phase crossovers where L is proven to turn one way from `from` on: each turn has one.
    fn list_steady_crossovers(&mut self, from: f64) {
        let functions = self.functions;
        // Angle still to go until L points at −1, and the rate at which L turns towards it.
        let turn = |omega: f64| {
            let direction = functions.direction(omega);
            let rate = -(direction[1] / direction[0]).im;
            ((-direction[0]).arg(), rate)
        };
        let (angle, rate) = turn(from);
        let first = from + angle.rem_euclid(TAU) / rate;
        // The next one by the parabola through the last three, the first time through equal steps.
        let mut last = [first - TAU / rate, first - 2.0 * TAU / rate, first - 3.0 * TAU / rate];
        let mut found = Vec::with_capacity(LISTED);
        while self.found.phase_crossovers.len() + found.len() <= LISTED {
            let mut omega = 3.0 * (last[0] - last[1]) + last[2];
            let mut speed = rate;
            for _ in 0..20 {
                let (angle, rate) = turn(omega);
                speed = rate;
                omega += angle / rate;
                // The rate changes by less than C/ω² per radian: the next step would be 1e-12·C.
                if (angle / rate).abs() <= 1e-6 * omega {
                    break;
                }
            }
            // One turn from the last, not none and not two: else the search goes on band by band.
            let turns = (omega - last[0]) * speed / TAU;
            if !(turns > 0.5 && turns < 1.5 || found.is_empty() && omega.is_finite()) {
                return;
            }
            found.push(omega);
            last = [omega, last[0], last[1]];
        }
        for omega in found {
            self.phase_crossover(omega);
        }
    }

    fn phase_crossover(&mut self, omega: f64) {
        let gain = self.functions.gain(omega);
        if gain < 1.0 {
            self.found.below_one = self.found.below_one.max(gain);
        } else {
            let least = self.found.above_one.map_or(gain, |least| least.min(gain));
            self.found.above_one = Some(least);
        }
        if self.found.phase_crossovers.len() < LISTED {
            push_apart(&mut self.found.phase_crossovers, omega);
        }
    }

    fn highest(&mut self, peak: Peak) -> &mut Highest {
        match peak {
            Peak::Sensitivity => &mut self.found.sensitivity,
            Peak::Complementary => &mut self.found.complementary,
        }
    }

    fn offer(&mut self, peak: Peak, point: &Point) {
        let value = point.peak_value(peak);
        if value > self.highest(peak).value * (1.0 + PEAK_TOLERANCE) {
            *self.highest(peak) = self.climb(peak, point);
        }
    }

    /// The local maximum uphill of a point: the higher the peak known, the less is left to prove.
    fn climb(&self, peak: Peak, from: &Point) -> Highest {
        let mut best = *from;
        let mut value = best.peak_value(peak);
        let mut reach = (0.3 * from.omega).min(0.5);
        for _ in 0..40 {
            let (first, second) = best.logarithmic(peak);
            let uphill = reach.copysign(first);
            let newton = -first / second;
            let step = if second < 0.0 && newton.abs() <= reach { newton } else { uphill };
            let next = self.functions.at((best.omega + step).max(0.0));
            let higher = next.peak_value(peak);
            if higher > value {
                value = higher;
                best = next;
            } else {
                // Beyond the maximum, or at it to rounding.
                reach = 0.25 * step.abs();
            }
            if step.abs() <= 1e-9 * best.omega || reach <= 1e-9 * best.omega {
                break;
            }
        }
        Highest { value, omega: Some(best.omega) }
    }

    /// Whether the peak is proven to be no higher on [middle − radius, middle + radius] than the highest found;
    /// raises the highest found where the band holds a higher one.
    fn peak_settled(&mut self, peak: Peak, point: &Point, bounds: &Bounds, radius: f64) -> bool {
        self.offer(peak, point);
        let mut at = *point;
        for _ in 0..8 {
            let level = self.highest(peak).value * (1.0 + PEAK_TOLERANCE);
            let q = point.below(peak, level);
            let (third, rounding) = bounds.below(peak, level, point);
            if q.range(radius).0 > third * radius.powi(3) / 6.0 - rounding {
                return true;
            }
            // Least curvature on the band: where it is positive the function is convex, and lies above its
            // tangent at any point by that much.
            let curvature = q.ddf - third * radius;
            if curvature <= 0.0 {
                return false;
            }
            let here = at.below(peak, level);
            let noise = bounds.below(peak, level, &at).1;
            if here.f - 0.5 * here.df * here.df / curvature > -noise {
                return true;
            }
            let target = at.omega - here.df / here.ddf;
            let next = target.clamp((point.omega - radius).max(0.0), point.omega + radius);
            if next == at.omega || next.is_nan() {
                // The least value lies at an end of the band.
                return here.f > -noise;
            }
            at = self.functions.at(next);
            self.offer(peak, &at);
        }
        false
    }

    /// Newton on the logarithmic derivative from the best points found.
    fn polish_peaks(&mut self) {
        for peak in [Peak::Sensitivity, Peak::Complementary] {
            let Some(mut omega) = self.highest(peak).omega.filter(|&omega| omega > 0.0) else { continue };
            for _ in 0..6 {
                let (first, second) = self.functions.at(omega).logarithmic(peak);
                let next = omega - first / second;
                if second >= 0.0 || (next - omega).abs() > 1e-2 * omega || next.is_nan() {
                    break;
                }
                let settled = (next - omega).abs() <= 1e-10 * omega;
                omega = next;
                if settled {
                    break;
                }
            }
            let point = self.functions.at(omega);
            let value = point.peak_value(peak);
            let highest = self.highest(peak);
            if value >= highest.value * (1.0 - PEAK_TOLERANCE) && value.is_finite() {
                *highest = Highest { value: value.max(highest.value), omega: Some(omega) };
            }
        }
    }
}

/// Appends a zero unless it is the last one found once more (on the border of two bands).
fn push_apart(list: &mut Vec<f64>, omega: f64) {
    if list.last().is_none_or(|&last| (omega - last).abs() > 1e-12 * omega) {
        list.push(omega);
    }
}
