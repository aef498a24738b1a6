//! Lanes as the numbers that the equations of loops are made of.

use super::super::super::number::Number;
use super::Lanes;

impl<V: Lanes> Number for V {
    type Token = <V as Lanes>::Token;

    #[inline(always)]
    fn token(self) -> Self::Token {
        Lanes::token(self)
    }

    #[inline(always)]
    fn same(token: Self::Token, value: f64) -> Self {
        V::all(token, value)
    }

    #[inline(always)]
    fn each(token: Self::Token, of: impl Fn(usize) -> f64) -> Self {
        V::from_fn(token, of)
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
        self.smallest()
    }

    #[inline(always)]
    fn is_zero(self) -> bool {
        self.abs().all_at_most(self.like(0.0))
    }
}
