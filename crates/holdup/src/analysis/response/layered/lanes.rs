//! One number for each of the loops that are computed together.

use std::ops::{Add, AddAssign, BitAnd, BitOr, Div, Index, IndexMut, Mul, Neg, Not, Sub};

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x8};

use super::tables::INVERSE;
use crate::analysis::widest;

/// Most loops that are computed together: the numbers of one register of the widest instruction set.
pub(in super::super) const MOST: usize = 8;

/// A number for each of some loops; what is done with it is done for each loop by itself.
pub(super) trait Lanes:
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
        Set(u8::MAX >> (MOST - Self::COUNT))
    }

    /// Whether `self <= other` everywhere.
    #[inline(always)]
    fn all_at_most(self, other: Self) -> bool {
        self.at_most(other) == Self::every()
    }
}

/// 1.5·2^52: a number added to it is rounded to an integer.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// ln 2 in two parts, so that a small integer times the first is exact.
const LN_2: (f64, f64) = (0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10);
/// 1/j!
const TAYLOR: [f64; 14] = {
    let mut table = [1.0; 14];
    let mut j = 1;
    while j < 14 {
        table[j] = table[j - 1] * INVERSE[j];
        j += 1;
    }
    table
};

/// Some of the loops.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Set(u8);

impl Set {
    pub(super) const NONE: Self = Self(0);

    #[inline(always)]
    pub(super) fn has(self, loop_number: usize) -> bool {
        self.0 >> loop_number & 1 == 1
    }

    /// The numbers of the loops.
    #[inline(always)]
    pub(super) fn iter(self) -> impl Iterator<Item = usize> {
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

/// What is true of every loop, or `None` where the loops differ.
pub(super) fn agreed(count: usize, of: impl Fn(usize) -> bool) -> Option<bool> {
    let first = of(0);
    (1..count).all(|l| of(l) == first).then_some(first)
}

/// A single loop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct One(pub(super) f64);

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
        Set(u8::from(self.0 <= other.0))
    }

    #[inline(always)]
    fn below(self, other: Self) -> Set {
        Set(u8::from(self.0 < other.0))
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

impl<S: Simd> Lanes for f64x8<S> {
    type Token = S;
    const COUNT: usize = 8;

    #[inline(always)]
    fn token(self) -> S {
        self.simd
    }

    #[inline(always)]
    fn all(token: S, value: f64) -> Self {
        Self::splat(token, value)
    }

    #[inline(always)]
    fn widest<R>(token: S, job: impl FnOnce() -> R) -> R {
        token.vectorize(job)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        SimdBase::abs(self)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        SimdBase::max(self, other)
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        SimdBase::min(self, other)
    }

    #[inline(always)]
    fn times_plus(self, factor: Self, plus: Self) -> Self {
        SimdFloat::mul_add(self, factor, plus)
    }

    #[inline(always)]
    fn scaled_plus(self, factor: f64, plus: Self) -> Self {
        SimdFloat::mul_add(self, Self::splat(self.simd, factor), plus)
    }

    #[inline(always)]
    fn at_most(self, other: Self) -> Set {
        Set(bits(self.simd_le(other)))
    }

    #[inline(always)]
    fn below(self, other: Self) -> Set {
        Set(bits(self.simd_lt(other)))
    }

    #[inline(always)]
    fn only_in(self, set: Set, other: Self) -> Self {
        <Self as SimdBase<S>>::Mask::from_bitmask(self.simd, u64::from(set.0)).select(self, other)
    }

    #[inline(always)]
    fn decayed(self) -> Self {
        exponential(-self)
    }

    #[inline(always)]
    fn largest(self) -> f64 {
        self.reduce_max()
    }

    #[inline(always)]
    fn smallest(self) -> f64 {
        self.reduce_min()
    }
}

/// `e^x` for x from −700 to 0: 2^k times a Taylor polynomial on |r| ≤ ln(2)/2, whose next term is below 1e-17.
#[inline(always)]
fn exponential<S: Simd>(x: f64x8<S>) -> f64x8<S> {
    // Adding 1.5·2^52 rounds to an integer, which then stands in the lowest bits.
    let shifted = x.scaled_plus(std::f64::consts::LOG2_E, x.like(ROUND));
    let k = shifted - x.like(ROUND);
    let r = k.scaled_plus(-LN_2.1, k.scaled_plus(-LN_2.0, x));
    let mut sum = x.like(TAYLOR[13]);
    for c in TAYLOR[..13].iter().rev() {
        sum = sum.times_plus(r, x.like(*c));
    }
    let power: f64x8<S> = ((shifted.to_bits() + 1023) << 52).bitcast();
    sum * power
}

#[expect(clippy::cast_possible_truncation, reason = "eight lanes")]
#[inline(always)]
fn bits<S: Simd>(mask: impl SimdMask<S>) -> u8 {
    mask.to_bitmask() as u8
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    /// For a token, what is computed with it for all θ.
    fn decayed<S: Simd>(token: S, theta: &[f64; 8]) -> [f64; 8] {
        let lanes = <f64x8<S> as Lanes>::from_fn(token, |l| theta[l]).decayed();
        std::array::from_fn(|l| lanes[l])
    }

    #[test]
    fn exponentials_are_those_of_the_standard_library() {
        for block in 0..800 {
            let theta = std::array::from_fn(|l| 0.109_31 * f64::from(block * 8 + i32::try_from(l).unwrap()));
            let found = dispatch!(Level::new(), simd => decayed(simd, &theta));
            for (found, theta) in found.iter().zip(theta) {
                // 1e-15: a few roundings.
                assert!((found / (-theta).exp() - 1.0).abs() < 1e-15, "{theta}");
            }
        }
    }

    fn compared<V: Lanes>(token: V::Token) {
        let rising = V::from_fn(token, |l| f64::from(u8::try_from(l).unwrap()) - 2.0);
        let below = rising.below(V::zero(token));
        let upto = rising.at_most(V::zero(token));
        for l in 0..V::COUNT {
            assert_eq!((below.has(l), upto.has(l)), (l < 2, l <= 2));
            assert_eq!(rising.only_in(below, V::all(token, 9.0))[l], if l < 2 { rising[l] } else { 9.0 });
        }
        let places: Vec<usize> = (V::every() & upto & !below).iter().collect();
        assert_eq!(places, if V::COUNT > 2 { vec![2] } else { vec![] });
        assert_eq!((rising.smallest(), rising.largest()), (-2.0, rising[V::COUNT - 1]));
        assert!((below | upto) == upto && rising.all_at_most(V::all(token, 5.0)));
    }

    #[test]
    fn sets_hold_the_lanes_that_they_are_made_of() {
        compared::<One>(());
        dispatch!(Level::new(), simd => compared::<f64x8<_>>(simd));
    }
}
