//! Percentiles of any number of values in bounded memory.

use std::collections::BTreeMap;

/// Bits of the mantissa that a bucket keeps: values of one bucket differ by less than 2⁻¹³ of their size.
const KEPT: u32 = 13;

/// Counts of values in buckets of a constant relative width, 1.2e-4: percentiles are right to 6.1e-5 of their value.
///
/// The least and the greatest value are exact. The order in which values come does not matter.
///
/// ```
/// use holdup::tuning::robust::Quantiles;
/// let mut quantiles = Quantiles::default();
/// for i in 1..=1000 {
///     quantiles.add(f64::from(i));
/// }
/// assert!((quantiles.at(0.5).unwrap() / 500.0 - 1.0).abs() < 6.2e-5);
/// assert_eq!(quantiles.at(1.0), Some(1000.0));
/// ```
#[derive(Debug, Clone, Default)]
pub struct Quantiles {
    buckets: BTreeMap<i64, u64>,
    count: u64,
    range: Option<[f64; 2]>,
}

impl Quantiles {
    /// Adds a value; one that is not a number is left out.
    pub fn add(&mut self, value: f64) {
        if value.is_nan() {
            return;
        }
        *self.buckets.entry(bucket(value)).or_default() += 1;
        self.count += 1;
        let [low, high] = self.range.unwrap_or([value; 2]);
        self.range = Some([low.min(value), high.max(value)]);
    }

    /// Number of values.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The value that this share (0 to 1) of the values does not exceed; `None` where there are no values.
    #[must_use]
    pub fn at(&self, share: f64) -> Option<f64> {
        let [low, high] = self.range?;
        #[expect(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "counts below 2⁵³"
        )]
        let rank = ((share.clamp(0.0, 1.0) * self.count as f64).ceil() as u64).max(1);
        if rank >= self.count {
            return Some(high);
        }
        let mut seen = 0;
        for (&key, &count) in &self.buckets {
            seen += count;
            if seen >= rank {
                return Some(middle(key).clamp(low, high));
            }
        }
        Some(high)
    }
}

/// The bits of a number, read as an integer, rise with its modulus.
fn bucket(value: f64) -> i64 {
    let modulus = (value.abs().to_bits() >> (52 - KEPT)).cast_signed();
    if value < 0.0 { -1 - modulus } else { modulus }
}

fn middle(key: i64) -> f64 {
    let modulus = if key < 0 { -1 - key } else { key };
    let low = f64::from_bits(modulus.cast_unsigned() << (52 - KEPT));
    let high = f64::from_bits((modulus + 1).cast_unsigned() << (52 - KEPT));
    let middle = if high.is_finite() { f64::midpoint(low, high) } else { low };
    if key < 0 { -middle } else { middle }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_those_of_the_sorted_list() {
        let values: Vec<f64> =
            (0..10_001_i32).map(|i| f64::from((i * 7919) % 10_007 - 5000) * 0.37).collect();
        let mut sorted = values.clone();
        sorted.sort_by(f64::total_cmp);
        let mut quantiles = Quantiles::default();
        for value in &values {
            quantiles.add(*value);
        }
        for (share, index) in [(0.0, 0), (0.05, 500), (0.25, 2500), (0.5, 5000), (0.95, 9500), (1.0, 10_000)]
        {
            let (found, exact) = (quantiles.at(share).unwrap(), sorted[index]);
            // Half a bucket; and the list steps by 0.37 at most 0.75.
            assert!((found - exact).abs() <= 6.2e-5 * exact.abs() + 0.75, "{share}: {found} {exact}");
        }
        assert_eq!(quantiles.at(1.0), Some(sorted[10_000]));
    }

    #[test]
    fn zero_infinity_and_no_value_are_answers() {
        let mut quantiles = Quantiles::default();
        assert_eq!(quantiles.at(0.5), None);
        quantiles.add(f64::NAN);
        assert_eq!(quantiles.count(), 0);
        quantiles.add(0.0);
        assert_eq!(quantiles.at(0.5), Some(0.0));
        for _ in 0..3 {
            quantiles.add(f64::INFINITY);
        }
        assert_eq!(quantiles.at(0.5), Some(f64::INFINITY));
    }
}
