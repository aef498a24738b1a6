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
    fn same(token: Self::Token, value: f64) -> Self;

    /// The number of each loop.
    fn each(token: Self::Token, of: impl Fn(usize) -> f64) -> Self;

    fn magnitude(self) -> Self;

    /// The larger of each two numbers.
    fn larger(self, other: Self) -> Self;

    /// The smallest of the numbers.
    fn least(self) -> f64;

    /// Whether all are 0.
    fn is_zero(self) -> bool;

    /// Another number for all.
    #[inline(always)]
    fn alike(self, value: f64) -> Self {
        Self::same(self.token(), value)
    }

    /// Whether all are finite.
    #[inline(always)]
    fn is_finite(self) -> bool {
        // What is infinite or no number becomes no number.
        (self * self.alike(0.0)).is_zero()
    }
}

impl Number for f64 {
    type Token = ();

    #[inline(always)]
    fn token(self) {}

    #[inline(always)]
    fn same((): (), value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn each((): (), of: impl Fn(usize) -> f64) -> Self {
        of(0)
    }

    #[inline(always)]
    fn magnitude(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.max(other)
    }

    #[inline(always)]
    fn least(self) -> f64 {
        self
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        self == 0.0
    }
}
