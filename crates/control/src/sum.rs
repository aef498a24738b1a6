//! A sum that does not lose small terms.

use crate::Scalar;

/// A compensated sum: what rounding drops from the value is kept beside it.
///
/// A plain `f32` sum of 1000.0 stops growing when terms fall below 0.00003; this one does not. (Knuth's two-sum, which
/// needs no comparison of magnitudes, with the rest renormalised: as Kahan's and Neumaier's sums, but the rest
/// itself is not rounded to the size of a term, so a million terms put in and taken out again leave nothing.)
///
/// ```
/// use holdup_control::Sum;
///
/// let mut sum = Sum::new(1000.0_f32);
/// for _ in 0..1_000_000 {
///     sum.add(1e-6);
/// }
/// assert!((sum.value() - 1001.0).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sum<T> {
    /// The sum so far, rounded.
    pub value: T,
    /// What the rounded value lacks: add it to have the sum so far.
    pub correction: T,
}

impl<T: Scalar> Sum<T> {
    /// A sum that starts at `value`.
    pub fn new(value: T) -> Self {
        Self { value, correction: T::ZERO }
    }

    /// Adds one term.
    pub fn add(&mut self, term: T) {
        let sum = self.value + term;
        let added = sum - self.value;
        let lost = (self.value - (sum - added)) + (term - added);
        let correction = self.correction + lost;
        self.value = sum + correction;
        self.correction = correction - (self.value - sum);
    }

    /// The sum so far, rounded.
    pub fn value(&self) -> T {
        self.value
    }

    /// `other` minus the sum so far, with the digits that the rounded value lacks.
    pub fn below(&self, other: T) -> T {
        (other - self.value) - self.correction
    }
}
