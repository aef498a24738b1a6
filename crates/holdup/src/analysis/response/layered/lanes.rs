//! One number for each of the loops that are computed together.

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A number for each of `L` loops; what is done with it is done for each loop by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lanes<const L: usize>(pub(super) [f64; L]);

impl<const L: usize> Lanes<L> {
    pub(super) const ZERO: Self = Self([0.0; L]);

    /// The same number for all.
    #[inline(always)]
    pub(super) const fn all(value: f64) -> Self {
        Self([value; L])
    }

    #[inline(always)]
    pub(super) fn map(mut self, of: impl Fn(f64) -> f64) -> Self {
        for value in &mut self.0 {
            *value = of(*value);
        }
        self
    }

    #[inline(always)]
    pub(super) fn with(mut self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        for l in 0..L {
            self.0[l] = of(self.0[l], other.0[l]);
        }
        self
    }

    #[inline(always)]
    pub(super) fn abs(self) -> Self {
        self.map(f64::abs)
    }

    /// The larger of each two numbers.
    #[inline(always)]
    pub(super) fn max(self, other: Self) -> Self {
        self.with(other, |a, b| if b > a { b } else { a })
    }

    /// The smaller of each two numbers.
    #[inline(always)]
    pub(super) fn min(self, other: Self) -> Self {
        self.with(other, |a, b| if b < a { b } else { a })
    }

    /// The largest of the numbers.
    #[inline(always)]
    pub(super) fn largest(self) -> f64 {
        self.0.iter().fold(f64::NEG_INFINITY, |most, &value| if value > most { value } else { most })
    }

    /// The smallest of the numbers.
    #[inline(always)]
    pub(super) fn smallest(self) -> f64 {
        self.0.iter().fold(f64::INFINITY, |least, &value| if value < least { value } else { least })
    }

    /// Whether this holds for every pair.
    #[inline(always)]
    pub(super) fn every(self, other: Self, holds: impl Fn(f64, f64) -> bool) -> bool {
        let mut every = true;
        for l in 0..L {
            every &= holds(self.0[l], other.0[l]);
        }
        every
    }
}

/// Stands in every loop over coefficients: it keeps the compiler from gathering one lane of several coefficients into a
/// vector, where the lanes of one coefficient are a vector already. A single lane is better off with that.
#[inline(always)]
pub(super) fn lane_by_lane<const L: usize>() {
    if L > 1 {
        std::hint::black_box(());
    }
}

/// What is true of every loop, or `None` where the loops differ.
pub(super) fn agreed<const L: usize>(of: impl Fn(usize) -> bool) -> Option<bool> {
    let first = of(0);
    (1..L).all(|l| of(l) == first).then_some(first)
}

macro_rules! operation {
    ($of:ident, $name:ident, $assign:tt) => {
        impl<const L: usize> $of for Lanes<L> {
            type Output = Self;
            #[inline(always)]
            fn $name(mut self, other: Self) -> Self {
                for l in 0..L {
                    self.0[l] $assign other.0[l];
                }
                self
            }
        }
        impl<const L: usize> $of<f64> for Lanes<L> {
            type Output = Self;
            #[inline(always)]
            fn $name(mut self, other: f64) -> Self {
                for l in 0..L {
                    self.0[l] $assign other;
                }
                self
            }
        }
    };
}
operation!(Add, add, +=);
operation!(Sub, sub, -=);
operation!(Mul, mul, *=);
operation!(Div, div, /=);

impl<const L: usize> AddAssign for Lanes<L> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|value| -value)
    }
}
