//! A single loop.

use std::ops::{Add, AddAssign, Div, Index, IndexMut, Mul, Neg, Sub};

use fearless_simd::Simd;

use super::super::super::number::Number;
use super::{Lanes, Set};

/// A single loop, with the instructions that a token stands for.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct One<S> {
    value: f64,
    token: S,
}

impl<S> From<One<S>> for f64 {
    #[inline(always)]
    fn from(one: One<S>) -> Self {
        one.value
    }
}

impl<S> Index<usize> for One<S> {
    type Output = f64;
    #[inline(always)]
    fn index(&self, _: usize) -> &f64 {
        &self.value
    }
}

impl<S> IndexMut<usize> for One<S> {
    #[inline(always)]
    fn index_mut(&mut self, _: usize) -> &mut f64 {
        &mut self.value
    }
}

macro_rules! operation {
    ($of:ident, $name:ident, $sign:tt) => {
        impl<S> $of for One<S> {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Self { value: self.value $sign other.value, ..self }
            }
        }
    };
}
operation!(Add, add, +);
operation!(Sub, sub, -);
operation!(Mul, mul, *);
operation!(Div, div, /);

impl<S> Mul<f64> for One<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: f64) -> Self {
        Self { value: self.value * other, ..self }
    }
}

impl<S> AddAssign for One<S> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
    }
}

impl<S> Neg for One<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

/// Whether these instructions have a product and a sum in one: where they do not, that is a slow function.
#[inline(always)]
fn is_fused<S: Simd>(token: S) -> bool {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    return token.level().as_avx2().is_some();
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    return cfg!(target_arch = "aarch64") && !token.level().is_fallback();
}

impl<S: Simd> Number for One<S> {
    type Token = S;

    #[inline(always)]
    fn token(self) -> S {
        self.token
    }

    #[inline(always)]
    fn all(token: S, value: f64) -> Self {
        Self { value, token }
    }

    #[inline(always)]
    fn from_fn(token: S, of: impl Fn(usize) -> f64) -> Self {
        Self { value: of(0), token }
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.like(self.value.abs())
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if other.value > self.value { other } else { self }
    }

    #[inline(always)]
    fn smallest(self) -> f64 {
        self.value
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        self.value == 0.0
    }
}

impl<S: Simd> Lanes for One<S> {
    const COUNT: usize = 1;

    #[inline(always)]
    fn widest<R>(token: S, job: impl FnOnce() -> R) -> R {
        token.vectorize(job)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if other.value < self.value { other } else { self }
    }

    #[inline(always)]
    fn times_plus(self, factor: Self, plus: Self) -> Self {
        self.scaled_plus(factor.value, plus)
    }

    #[inline(always)]
    fn scaled_plus(self, factor: f64, plus: Self) -> Self {
        let fused = is_fused(self.token);
        self.like(if fused {
            self.value.mul_add(factor, plus.value)
        } else {
            self.value * factor + plus.value
        })
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> Set {
        Set::from_bits(u8::from(self.value <= other.value))
    }

    #[inline(always)]
    fn below(self, other: Self) -> Set {
        Set::from_bits(u8::from(self.value < other.value))
    }

    #[inline(always)]
    fn only_in(self, set: Set, other: Self) -> Self {
        if set.has(0) { self } else { other }
    }

    #[inline(always)]
    fn decayed(self) -> Self {
        self.like((-self.value).exp())
    }
}
