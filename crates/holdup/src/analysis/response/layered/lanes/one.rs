//! A single loop.

use std::ops::{Add, AddAssign, Div, Index, IndexMut, Mul, Neg, Sub};

use super::{Lanes, Set};
use crate::analysis::widest;

/// A single loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in super::super) struct One(pub(in super::super) f64);

impl Index<usize> for One {
    type Output = f64;
    #[inline(always)]
    fn index(&self, _: usize) -> &f64 {
        &self.0
    }
}

impl IndexMut<usize> for One {
    #[inline(always)]
    fn index_mut(&mut self, _: usize) -> &mut f64 {
        &mut self.0
    }
}

macro_rules! operation {
    ($of:ident, $name:ident, $sign:tt) => {
        impl $of for One {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Self(self.0 $sign other.0)
            }
        }
    };
}
operation!(Add, add, +);
operation!(Sub, sub, -);
operation!(Mul, mul, *);
operation!(Div, div, /);

impl Mul<f64> for One {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        Self(self.0 * other)
    }
}

impl AddAssign for One {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.0 += other.0;
    }
}

impl Neg for One {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Lanes for One {
    type Token = ();
    const COUNT: usize = 1;

    #[inline(always)]
    fn token(self) {}

    #[inline(always)]
    fn all((): (), value: f64) -> Self {
        Self(value)
    }

    #[inline(always)]
    fn widest<R>((): (), job: impl FnOnce() -> R) -> R {
        widest(job)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if other.0 > self.0 { other } else { self }
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if other.0 < self.0 { other } else { self }
    }

    #[inline(always)]
    fn times_plus(self, factor: Self, plus: Self) -> Self {
        Self(self.0 * factor.0 + plus.0)
    }

    #[inline(always)]
    fn scaled_plus(self, factor: f64, plus: Self) -> Self {
        Self(self.0 * factor + plus.0)
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> Set {
        Set::from_bits(u8::from(self.0 <= other.0))
    }

    #[inline(always)]
    fn below(self, other: Self) -> Set {
        Set::from_bits(u8::from(self.0 < other.0))
    }

    #[inline(always)]
    fn only_in(self, set: Set, other: Self) -> Self {
        if set.has(0) { self } else { other }
    }

    #[inline(always)]
    fn decayed(self) -> Self {
        Self((-self.0).exp())
    }
}
