//! Eight loops, as vectors of the instructions that a token stands for.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x8};

use super::super::super::number::Number;
use super::super::tables::INVERSE;
use super::{Lanes, Set};

/// 1.5·2^52: a number added to it is rounded to an integer, which then stands in the lowest bits.
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

impl<S: Simd> Number for f64x8<S> {
    type Token = S;

    #[inline(always)]
    fn token(self) -> S {
        self.simd
    }

    #[inline(always)]
    fn all(token: S, value: f64) -> Self {
        Self::splat(token, value)
    }

    #[inline(always)]
    fn from_fn(token: S, of: impl Fn(usize) -> f64) -> Self {
        let mut lanes = Self::splat(token, 0.0);
        for l in 0..Self::COUNT {
            lanes[l] = of(l);
        }
        lanes
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
    fn smallest(self) -> f64 {
        self.reduce_min()
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        Number::abs(self).all_at_most(self.like(0.0))
    }
}

impl<S: Simd> Lanes for f64x8<S> {
    const COUNT: usize = 8;

    #[inline(always)]
    fn widest<R>(token: S, job: impl FnOnce() -> R) -> R {
        token.vectorize(job)
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
        Set::from_bits(bits(self.simd_le(other)))
    }

    #[inline(always)]
    fn below(self, other: Self) -> Set {
        Set::from_bits(bits(self.simd_lt(other)))
    }

    #[inline(always)]
    fn only_in(self, set: Set, other: Self) -> Self {
        <Self as SimdBase<S>>::Mask::from_bitmask(self.simd, u64::from(set.bits())).select(self, other)
    }

    #[inline(always)]
    fn decayed(self) -> Self {
        exponential(-self)
    }

    #[inline(always)]
    fn largest(self) -> f64 {
        self.reduce_max()
    }
}

/// `e^x` for x from −700 to 0: 2^k times a Taylor polynomial on |r| ≤ ln(2)/2, whose next term is below 1e-17.
#[inline(always)]
pub(in super::super::super) fn exponential<S: Simd>(x: f64x8<S>) -> f64x8<S> {
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
