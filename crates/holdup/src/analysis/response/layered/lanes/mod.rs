//! One number for each of the loops that are computed together.

mod eight;
mod number;
mod one;
mod set;
#[cfg(test)]
mod tests;

use std::ops::{Add, AddAssign, Div, Index, IndexMut, Mul, Neg, Sub};

pub(in super::super) use eight::exponential;
pub(super) use one::One;
pub(super) use set::Set;

/// Most loops that are computed together: the numbers of one register of the widest instruction set.
pub(in super::super) const MOST: usize = 8;

/// A number for each of some loops; what is done with it is done for each loop by itself.
pub(in super::super) trait Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Mul<f64, Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + Index<usize, Output = f64>
    + IndexMut<usize>
{
    /// Says which instructions there are.
    type Token: Copy;
    /// Number of loops.
    const COUNT: usize;

    fn token(self) -> Self::Token;

    /// The same number for all.
    fn all(token: Self::Token, value: f64) -> Self;

    /// Does this with the widest instructions there are: to be called with closures that are inlined, as all they call is.
    fn widest<R>(token: Self::Token, job: impl FnOnce() -> R) -> R;

    fn abs(self) -> Self;

    /// The larger of each two numbers.
    fn max(self, other: Self) -> Self;

    /// The smaller of each two numbers.
    fn min(self, other: Self) -> Self;

    /// `self·factor + plus`, rounded once or twice.
    fn times_plus(self, factor: Self, plus: Self) -> Self;

    /// `self·factor + plus`, rounded once or twice.
    fn scaled_plus(self, factor: f64, plus: Self) -> Self;

    /// Where `self <= other`.
    fn at_most(self, other: Self) -> Set;

    /// Where `self < other`.
    fn below(self, other: Self) -> Set;

    /// `self` in these places, `other` in those that are not in the set.
    fn only_in(self, set: Set, other: Self) -> Self;

    /// `e^(−self)` for numbers from 0 to 700.
    fn decayed(self) -> Self;

    #[inline(always)]
    fn zero(token: Self::Token) -> Self {
        Self::all(token, 0.0)
    }

    /// Another number for all, computed with the same instructions.
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self::all(self.token(), value)
    }

    #[inline(always)]
    fn from_fn(token: Self::Token, of: impl Fn(usize) -> f64) -> Self {
        let mut lanes = Self::zero(token);
        for l in 0..Self::COUNT {
            lanes[l] = of(l);
        }
        lanes
    }

    /// The largest of the numbers.
    #[inline(always)]
    fn largest(self) -> f64 {
        (0..Self::COUNT).fold(f64::NEG_INFINITY, |most, l| if self[l] > most { self[l] } else { most })
    }

    /// The smallest of the numbers.
    #[inline(always)]
    fn smallest(self) -> f64 {
        (0..Self::COUNT).fold(f64::INFINITY, |least, l| if self[l] < least { self[l] } else { least })
    }

    /// Every loop.
    #[inline(always)]
    fn every() -> Set {
        Set::first(Self::COUNT)
    }

    /// Whether `self <= other` everywhere.
    #[inline(always)]
    fn all_at_most(self, other: Self) -> bool {
        self.at_most(other) == Self::every()
    }
}

/// What is true of every loop, or `None` where the loops differ.
pub(super) fn agreed(count: usize, of: impl Fn(usize) -> bool) -> Option<bool> {
    let first = of(0);
    (1..count).all(|l| of(l) == first).then_some(first)
}
