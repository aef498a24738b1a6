//! What the equations of a loop are made of: a number, or one for each of several loops.

#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the instruction set chosen at run time"
)]

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

/// A number, or one for each of several loops of one structure.
pub(super) trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
{
    /// Says which instructions there are.
    type Token: Copy;

    fn token(self) -> Self::Token;

    /// The same number for all.
    fn all(token: Self::Token, value: f64) -> Self;

    /// The number of each loop.
    fn from_fn(token: Self::Token, of: impl Fn(usize) -> f64) -> Self;

    fn abs(self) -> Self;

    /// The larger of each two numbers.
    fn max(self, other: Self) -> Self;

    /// The smallest of the numbers.
    fn smallest(self) -> f64;

    /// Whether all are 0.
    fn is_zero(self) -> bool;

    #[inline(always)]
    fn zero(token: Self::Token) -> Self {
        Self::all(token, 0.0)
    }

    /// Another number for all, computed with the same instructions.
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self::all(self.token(), value)
    }

    /// Whether all are finite.
    #[inline(always)]
    fn is_finite(self) -> bool {
        // What is infinite or no number becomes no number.
        (self * self.like(0.0)).is_zero()
    }
}

impl Number for f64 {
    type Token = ();

    #[inline(always)]
    fn token(self) {}

    #[inline(always)]
    fn all((): (), value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn from_fn((): (), of: impl Fn(usize) -> f64) -> Self {
        of(0)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self::abs(self)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self::max(self, other)
    }

    #[inline(always)]
    fn smallest(self) -> f64 {
        self
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        self == 0.0
    }
}
