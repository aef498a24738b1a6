//! Order statistics and counts as floating-point numbers.

/// A count as a number.
#[expect(clippy::cast_precision_loss, reason = "counts of rows stay far below 2^53")]
pub(super) fn real(count: usize) -> f64 {
    count as f64
}

/// The value below which a share of the values lies; 0 for none.
pub(super) fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let place = place(values.len(), share);
    *values.select_nth_unstable_by(place, f64::total_cmp).1
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a count is one")]
fn place(count: usize, share: f64) -> usize {
    ((real(count - 1) * share).round() as usize).min(count - 1)
}

/// The standard deviation of the normal distribution that has as many values within it: 68.3 % of the moduli. Where
/// these are 0, as with coarse quanta, the 95 % are taken.
pub(super) fn spread(values: impl Iterator<Item = f64>) -> f64 {
    let moduli: Vec<f64> = values.map(f64::abs).collect();
    let inner = quantile(moduli.clone(), 0.6827);
    if inner > 0.0 { inner } else { quantile(moduli, 0.95) / 1.96 }
}

/// The mean; 0 for none.
pub(super) fn mean(values: &[f64]) -> f64 {
    if values.is_empty() { 0.0 } else { values.iter().sum::<f64>() / real(values.len()) }
}

/// The differences of neighbours.
pub(super) fn differences(values: &[f64]) -> impl Iterator<Item = f64> + '_ {
    values.windows(2).map(|pair| pair[1] - pair[0])
}
