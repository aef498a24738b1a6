//! Round numbers along an axis.

/// One tick: where it stands and what is written there; an empty label is a minor tick.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub(super) at: f64,
    pub(super) label: String,
}

/// Ticks at multiples of 1, 2 or 5 times a power of ten, or of `fixed`, about `count` of them.
pub(super) fn linear(low: f64, high: f64, count: usize, fixed: Option<f64>) -> Vec<Tick> {
    let least = (high - low) / as_float(count.max(1));
    if least <= 0.0 || !least.is_finite() {
        return Vec::new();
    }
    let step = fixed.map_or_else(|| round_step(least), |step| doubled(step, least / 1.5));
    let first = (low / step - 1e-6).ceil();
    let ticks = (0..=count * 4).map(|k| (first + as_float(k)) * step);
    let at: Vec<f64> = ticks.take_while(|&at| at <= high + 1e-6 * step).collect();
    let digits = digits_for(step);
    let largest = low.abs().max(high.abs());
    at.into_iter().map(|at| Tick { at, label: number(at, step, digits, largest) }).collect()
}

/// Ticks at the powers of ten, thinned to about `count`; with fewer than two decades also at 2 and 5.
pub(super) fn logarithmic(low: f64, high: f64, count: usize) -> Vec<Tick> {
    let (first, last) = (low.log10().floor(), high.log10().ceil());
    let inside = |at: &f64| *at >= low * (1.0 - 1e-9) && *at <= high * (1.0 + 1e-9);
    let labelled = |at: f64| Tick { at, label: power_label(at) };
    let exponents = (0..700).map(|k| first + f64::from(k)).take_while(|e| *e <= last);
    let decades: Vec<f64> = exponents.clone().map(|e| 10_f64.powf(e)).filter(inside).collect();
    if decades.len() >= 3 {
        let every = decades.len().div_ceil(count.max(2));
        let chosen = decades.iter().enumerate();
        return chosen
            .map(|(k, &at)| if k % every == 0 { labelled(at) } else { Tick { at, label: String::new() } })
            .collect();
    }
    let steps = [1.0, 2.0, 5.0];
    let between: Vec<f64> =
        exponents.flat_map(|e| steps.map(|s| s * 10_f64.powf(e))).filter(inside).collect();
    if between.len() >= 2 {
        return between.into_iter().map(labelled).collect();
    }
    linear(low, high, count, None)
}

fn as_float(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}

fn round_step(least: f64) -> f64 {
    let power = 10_f64.powf(least.log10().floor());
    let factor = [1.0, 2.0, 5.0].into_iter().find(|f| f * power >= least * (1.0 - 1e-9)).unwrap_or(10.0);
    factor * power
}

fn doubled(step: f64, least: f64) -> f64 {
    let doublings = (least / step).log2().ceil().max(0.0);
    step * 2_f64.powf(doublings)
}

/// Decimals that show the step in full.
fn digits_for(step: f64) -> usize {
    let whole = |digits: &usize| {
        let scaled = step * 10_f64.powi(i32::try_from(*digits).unwrap_or(0));
        (scaled - scaled.round()).abs() < 1e-6 * scaled
    };
    (0..9).find(whole).unwrap_or(9)
}

fn number(at: f64, step: f64, digits: usize, largest: f64) -> String {
    let at = if at.abs() < step * 1e-6 { 0.0 } else { at };
    if at != 0.0 && (largest >= 1e6 || step < 1e-5) {
        let spread = (largest.log10().floor() - step.log10().floor()).clamp(0.0, 6.0);
        let digits = (0..7).find(|d| f64::from(*d) >= spread).unwrap_or(6);
        let digits = usize::try_from(digits).unwrap_or(0);
        return minus(&trimmed(&format!("{at:.digits$e}")));
    }
    minus(&format!("{at:.digits$}"))
}

/// `1.500e7` becomes `1.5e7`.
fn trimmed(scientific: &str) -> String {
    match scientific.split_once('e') {
        Some((mantissa, exponent)) if mantissa.contains('.') => {
            format!("{}e{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
        }
        _ => scientific.to_owned(),
    }
}

fn power_label(at: f64) -> String {
    let plain = (1e-4..1e6).contains(&(at * (1.0 + 1e-9)));
    // Rounding to a few digits takes the error of the power away: 0.20000000000000001.
    let rounded: f64 = format!("{at:.6e}").parse().unwrap_or(at);
    minus(&if plain { rounded.to_string() } else { format!("{rounded:e}") })
}

/// The text with a minus sign as wide as a digit in place of each hyphen.
fn minus(text: &str) -> String {
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &[Tick]) -> Vec<&str> {
        ticks.iter().map(|tick| tick.label.as_str()).collect()
    }

    #[test]
    fn linear_ticks_are_round_and_inside() {
        assert_eq!(labels(&linear(0.0, 300.0, 6, None)), ["0", "50", "100", "150", "200", "250", "300"]);
        assert_eq!(labels(&linear(-0.31, 0.62, 5, None)), ["−0.2", "0.0", "0.2", "0.4", "0.6"]);
        assert_eq!(labels(&linear(-180.0, 0.0, 5, Some(45.0))), ["−180", "−135", "−90", "−45", "0"]);
        assert_eq!(labels(&linear(0.0, 2e7, 2, None)), ["0", "1e7", "2e7"]);
    }

    #[test]
    fn a_fixed_step_is_doubled_where_ticks_would_be_crowded() {
        assert_eq!(labels(&linear(-720.0, 0.0, 4, Some(45.0))), ["−720", "−540", "−360", "−180", "0"]);
    }

    #[test]
    fn logarithmic_ticks_are_decades_or_finer() {
        assert_eq!(labels(&logarithmic(0.001, 10.0, 8)), ["0.001", "0.01", "0.1", "1", "10"]);
        assert_eq!(labels(&logarithmic(0.15, 3.0, 8)), ["0.2", "0.5", "1", "2"]);
        assert_eq!(labels(&logarithmic(1e-6, 1e-3, 8)), ["1e−6", "1e−5", "0.0001", "0.001"]);
        let thinned = logarithmic(1e-10, 1e10, 5);
        assert_eq!(thinned.iter().filter(|tick| !tick.label.is_empty()).count(), 5);
    }

    #[test]
    fn extreme_ranges_neither_hang_nor_fail() {
        for (low, high) in [(-1e300, 1e300), (0.0, 1e-300), (1e15, 1e15 + 1.0), (1.0, 1.0)] {
            assert!(linear(low, high, 6, None).len() <= 25);
        }
        assert!(logarithmic(1e-300, 1e300, 6).len() <= 700);
    }
}
