//! One number for each of the loops that are computed together.

mod eight;
mod one;
mod set;
#[cfg(test)]
mod tests;

use std::ops::{Index, IndexMut, Mul};

use super::super::number::Number;

pub(in super::super) use eight::exponential;
pub(super) use one::One;
pub(super) use set::Set;

/// Most loops that are computed together: the numbers of one register of the widest instruction set.
pub(in super::super) const MOST: usize = 8;

/// A number for each of some loops; what is done with it is done for each loop by itself.
pub(in super::super) trait Lanes:
    Number + Mul<f64, Output = Self> + Index<usize, Output = f64> + IndexMut<usize>
{
    /// Number of loops.
    const COUNT: usize;

    /// Does this with the widest instructions there are: to be called with closures that are inlined, as all they call is.
    fn widest<R>(token: Self::Token, job: impl FnOnce() -> R) -> R;

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

    /// The largest of the numbers.
    #[inline(always)]
    fn largest(self) -> f64 {
        (0..Self::COUNT).fold(f64::NEG_INFINITY, |most, l| if self[l] > most { self[l] } else { most })
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
