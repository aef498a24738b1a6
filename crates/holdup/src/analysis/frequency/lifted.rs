//! Bounds over bands on which L turns round many times: frequency and phase as two variables.
//!
//! Where every delay is a multiple of one delay τ, Δ and D are polynomials in x = 1/ω and in e^(−jθ) with
//! θ = τ·ω mod 2π. A function that is positive on the box [1/b, 1/a] × [0, 2π] is positive on the band [a, b],
//! b infinite included, however often θ goes round there. Boxes are halved until a Taylor polynomial, or
//! convexity and one tangent plane, proves each. A box that is left is a short piece of the frequency axis.
//!
//! The triangle inequality of the [`super::envelope`] misses a supremum at infinity by c/ω, this by rounding.

use std::f64::consts::TAU;

use num_complex::Complex;

use super::characteristic::Characteristic;
use super::functions::Peak;
use super::polynomial::Polynomial;
use super::series::{Majorant, Series, joint, magnitude};

mod terms;

use self::terms::{Term, sum};

/// Boxes after which a band is left to the search along the axis.
const BOXES: usize = 4000;

/// Relative rounding error of a value: Horner schemes of low degree, sines, a few products.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// What is to be shown positive on a band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Question {
    /// |S| or |T| stays below this level.
    Below(Peak, f64),
    /// |L| stays below this level wherever L is real and negative.
    RealAxis(f64),
}

/// N and D in x = 1/ω and θ, both divided by (jω)ⁿ.
#[derive(Debug, Clone)]
pub(super) struct Lifted {
    numerator: Vec<Term>,
    denominator: Vec<Term>,
    period: f64,
}

impl Lifted {
    /// `None` where the delays are not small multiples of one, or where N has one term only: the envelope is
    /// tight then.
    pub(super) fn new(characteristic: &Characteristic) -> Option<Self> {
        let Characteristic { numerator, denominator, order, .. } = characteristic;
        let shortest = numerator.shortest_delay();
        if numerator.terms().len() < 2 || shortest <= 0.0 {
            return None;
        }
        let term = |(delay, p): &(f64, Polynomial)| {
            let turns = (delay / shortest).round();
            let exact = turns <= 8.0 && turns * shortest == *delay;
            exact.then(|| Term::new(p, *order, turns))
        };
        Some(Self {
            numerator: numerator.terms().iter().map(term).collect::<Option<_>>()?,
            denominator: denominator.terms().iter().map(term).collect::<Option<_>>()?,
            period: TAU / shortest,
        })
    }

    /// Whether the band goes round often enough for this to be of use.
    pub(super) fn applies(&self, from: f64, to: f64) -> bool {
        from >= 2.0 * self.period && to - from > 2.0 * self.period
    }

    /// The pieces of [from, to] on which nothing is proven, all else is, in rising order; `None` if too much is
    /// left. Then the number of boxes examined. `probe` is told of frequencies where the answer may be no, and
    /// returns the question to go on with.
    pub(super) fn open(
        &self,
        mut question: Question,
        from: f64,
        to: f64,
        mut probe: impl FnMut(f64) -> Question,
    ) -> (Option<Vec<(f64, f64)>>, usize) {
        let (mut pieces, mut work) = (Vec::new(), 0);
        let eighth = TAU / 16.0;
        let (low, high) = (1.0 / to, 1.0 / from);
        let mut stack: Vec<Cell> = (0..8)
            .map(|i| Cell {
                x: f64::midpoint(low, high),
                theta: (2.0 * f64::from(i) + 1.0) * eighth,
                width: 0.5 * (high - low),
                height: eighth,
            })
            .collect();
        while let Some(cell) = stack.pop() {
            work += 1;
            if work > BOXES {
                return (None, work);
            }
            let (series, majorant, noise) = self.question(question, cell.x, cell.x + cell.width, cell.theta);
            if series.exceeds(noise, &majorant, cell.width, cell.height)
                || self.convex_and_positive(question, &series, &majorant, cell)
            {
                continue;
            }
            let (start, end) = (1.0 / (cell.x + cell.width), 1.0 / (cell.x - cell.width).max(0.0));
            if end - start < self.period - 2.0 * cell.height * self.period / TAU {
                pieces.extend(self.piece(cell, start.max(from), end.min(to)));
                continue;
            }
            if series.value() < 0.0 {
                // The frequency of this phase that is nearest.
                let offset = cell.theta / TAU;
                let omega = ((1.0 / cell.x / self.period - offset).round() + offset) * self.period;
                if omega >= from && omega <= to && omega < 1e12 {
                    question = probe(omega);
                }
            }
            stack.extend(cell.halves(&series, &majorant));
        }
        pieces.sort_by(|a, b| a.0.total_cmp(&b.0));
        (Some(pieces), work)
    }

    /// Where the frequency axis passes through a box of less than one turn.
    fn piece(&self, cell: Cell, start: f64, end: f64) -> Option<(f64, f64)> {
        let (low, high) = (cell.theta - cell.height, cell.theta + cell.height);
        let turn = ((end / self.period) - low / TAU).floor();
        // A few units of rounding wider than the box.
        let a = (turn + low / TAU) * self.period * (1.0 - 1e-15);
        let b = (turn + high / TAU) * self.period * (1.0 + 1e-15);
        (b >= start).then(|| (a.max(start), b.min(end)))
    }

    /// Of the function to be positive: Taylor series at the middle of a box, majorant on |x| ≤ `most`, rounding
    /// error of the value.
    fn question(&self, question: Question, x: f64, most: f64, theta: f64) -> (Series, Majorant, f64) {
        let (n, n_bound) = sum(&self.numerator, x, most, theta);
        let (d, d_bound) = sum(&self.denominator, x, most, theta);
        match question {
            Question::Below(peak, level) => {
                let closed: [Complex<f64>; 6] = std::array::from_fn(|i| n[i] + d[i]);
                let bound: [f64; 10] = std::array::from_fn(|i| n_bound[i] + d_bound[i]);
                let (top, top_bound) = match peak {
                    Peak::Sensitivity => (d, d_bound),
                    Peak::Complementary => (n, n_bound),
                };
                let square = level * level;
                let all = magnitude(&closed).scaled(square).plus(&magnitude(&top).scaled(-1.0));
                let majorant = Majorant(bound).squared().scaled(square);
                // Near the peak Δ is a small difference: the error of |Δ|² is that of Δ times |Δ|.
                let small = ROUNDING * bound[0] * (closed[0].norm() + ROUNDING * bound[0]);
                let noise = square * small + ROUNDING * top_bound[0] * top_bound[0];
                (all, majorant.plus(&Majorant(top_bound).squared()), noise)
            }
            Question::RealAxis(level) => {
                // Re(N·D̄)·|D|² + level·|D|⁴ + µ·Im(N·D̄)² is positive wherever Im(N·D̄) = 0 if L > −level there.
                let steep = 20.0 / level;
                let (real, imaginary) = joint(&n, &d);
                let square = magnitude(&d);
                let all = real.times(&square).plus(&square.times(&square).scaled(level));
                let all = all.plus(&imaginary.times(&imaginary).scaled(steep));
                let cross = Majorant(n_bound).times(&Majorant(d_bound));
                let square = Majorant(d_bound).squared();
                let majorant = cross.times(&square).plus(&square.squared().scaled(level));
                let majorant = majorant.plus(&cross.squared().scaled(steep));
                (all, majorant, ROUNDING * majorant.0[0])
            }
        }
    }

    /// Whether the function is convex on the box and above a tangent plane that is positive there.
    fn convex_and_positive(
        &self,
        question: Question,
        series: &Series,
        majorant: &Majorant,
        cell: Cell,
    ) -> bool {
        if !series.convex(majorant, cell.width, cell.height) {
            return false;
        }
        let (mut x, mut theta, mut here, mut noise) = (cell.x, cell.theta, *series, f64::INFINITY);
        for _ in 0..6 {
            let low = (cell.x - cell.width - x, cell.theta - cell.height - theta);
            let high = (cell.x + cell.width - x, cell.theta + cell.height - theta);
            if here.tangent_plane_exceeds(noise, low, high) {
                return true;
            }
            let (dx, dt) = here.step(low, high);
            x = (x + dx).max(0.0);
            theta += dt;
            (here, _, noise) = self.question(question, x, cell.x + cell.width, theta);
        }
        false
    }
}

/// A box of the plane (x, θ): middle and half widths.
#[derive(Debug, Clone, Copy)]
struct Cell {
    x: f64,
    theta: f64,
    width: f64,
    height: f64,
}

impl Cell {
    /// Cut across the direction in which the function is less certain.
    fn halves(self, series: &Series, majorant: &Majorant) -> [Self; 2] {
        let (along_x, along_theta) = series.uncertainty(majorant, self.width, self.height);
        if along_x > along_theta {
            let width = 0.5 * self.width;
            [self.x + width, self.x - width].map(|x| Self { x, width, ..self })
        } else {
            let height = 0.5 * self.height;
            [self.theta + height, self.theta - height].map(|theta| Self { theta, height, ..self })
        }
    }
}

#[cfg(test)]
mod tests;
