//! Numbers in sentences, with the digits that they deserve.

/// A number of three significant digits.
pub(crate) fn three(value: f64) -> String {
    with_digits(value, 2)
}

/// A number of four significant digits, as tables have them.
pub(crate) fn four(value: f64) -> String {
    with_digits(value, 3)
}

/// A number of one more significant digit than `digits`.
fn with_digits(value: f64, digits: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    // The exponent after rounding: 999.6 is 1.00e3, one digit longer.
    let scientific = format!("{value:.*e}", usize::try_from(digits).unwrap_or(0));
    let exponent: i32 = scientific.split('e').nth(1).and_then(|text| text.parse().ok()).unwrap_or(0);
    if !(-4..6).contains(&exponent) {
        return scientific;
    }
    let decimals = usize::try_from(digits - exponent).unwrap_or(0);
    format!("{value:.decimals$}")
}

/// The ends of an interval, rounded outwards to two digits of its width.
pub(crate) fn ends([low, high]: [f64; 2]) -> [String; 2] {
    let width = high - low;
    if !(width > 0.0 && width.is_finite()) {
        return [four(low), four(high)];
    }
    // 0.01 of a decade: a width of exactly 10^k has not fallen below it by rounding.
    #[expect(clippy::cast_possible_truncation, reason = "the exponent of a number")]
    let decimals = (1 - (width.log10() + 0.01).floor() as i32).clamp(0, 12);
    let unit = 10.0_f64.powi(decimals);
    // A millionth of the last digit: an end that is a round number stays.
    let [low, high] = [(low * unit + 1e-6).floor() / unit, (high * unit - 1e-6).ceil() / unit];
    let decimals = usize::try_from(decimals).unwrap_or(0);
    // No negative zero.
    [low + 0.0, high + 0.0].map(|end| format!("{end:.decimals$}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_significant_digits() {
        for (value, text) in
            [(296.6693, "297"), (9.3333, "9.33"), (0.0, "0"), (999.6, "1000"), (0.000_499_155, "0.000499")]
        {
            assert_eq!(three(value), text);
        }
        assert_eq!(three(-4.991e-7), "-4.99e-7");
    }

    #[test]
    fn the_ends_of_an_interval_are_rounded_outwards_to_two_digits_of_its_width() {
        for (ends_of, low, high) in [
            ([0.0, 9.333_298], "0.0", "9.4"),
            ([288.375, 304.9636], "288", "305"),
            ([100.312, 100.398], "100.312", "100.398"),
            ([-0.2, 7.0], "-0.2", "7.0"),
        ] {
            assert_eq!(ends(ends_of), [low, high]);
        }
    }
}
