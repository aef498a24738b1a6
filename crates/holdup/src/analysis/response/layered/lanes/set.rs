//! Some of the loops that are computed together.

use std::ops::{BitAnd, BitOr, Not};

use super::MOST;

/// Some of the loops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super::super) struct Set(u8);

impl Set {
    pub(in super::super) const NONE: Self = Self(0);

    /// Those in the places whose bits are set.
    #[inline(always)]
    pub(super) fn from_bits(bits: u8) -> Self {
        Self(bits)
    }

    #[inline(always)]
    pub(super) fn bits(self) -> u8 {
        self.0
    }

    /// The first so many.
    #[inline(always)]
    pub(super) fn first(count: usize) -> Self {
        Self(u8::MAX >> (MOST - count))
    }

    #[inline(always)]
    pub(in super::super) fn has(self, loop_number: usize) -> bool {
        self.0 >> loop_number & 1 == 1
    }

    /// The numbers of the loops.
    #[inline(always)]
    pub(in super::super) fn iter(self) -> impl Iterator<Item = usize> {
        let mut left = self.0;
        std::iter::from_fn(move || {
            let next = left.trailing_zeros() as usize;
            left &= left.wrapping_sub(1);
            (next < MOST).then_some(next)
        })
    }
}

impl BitAnd for Set {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl BitOr for Set {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl Not for Set {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}
