//! Quantities with a unit: the two newtypes of the public edge, and the text of quantities.
//!
//! A number is written in decimal digits with an optional exponent. Times take `ms`, `s`, `min`, `h` (bare:
//! seconds), rates `/s`, `/min`, `/h` (bare: per second), angles `deg`, `rad` (bare: radians). A space may
//! stand before the unit. `nan`, `inf`, numbers too great for 64 bits and anything behind the unit are refused.

use std::f64::consts::PI;
use std::str::FromStr;

use super::text::TextError;

/// A time [s].
///
/// ```
/// use holdup::model::Seconds;
/// assert_eq!("6min".parse::<Seconds>()?, Seconds(360.0));
/// assert_eq!("40 s".parse::<Seconds>()?, Seconds(40.0));
/// assert!("40 parsecs".parse::<Seconds>().is_err());
/// # Ok::<(), holdup::model::TextError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Seconds(pub f64);

/// An angle [rad].
///
/// ```
/// use holdup::model::Radians;
/// assert_eq!("180deg".parse::<Radians>()?, Radians(std::f64::consts::PI));
/// # Ok::<(), holdup::model::TextError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Radians(pub f64);

impl Radians {
    /// The angle of so many degrees.
    #[must_use]
    pub fn from_degrees(degrees: f64) -> Self {
        Self(degrees.to_radians())
    }

    /// The angle in degrees [deg].
    #[must_use]
    pub fn degrees(self) -> f64 {
        self.0.to_degrees()
    }
}

/// A unit and how many of the base unit it holds, as factor and divisor, so that exact values stay exact.
type Unit = (&'static str, f64, f64);

const TIMES: [Unit; 4] = [("ms", 1.0, 1000.0), ("s", 1.0, 1.0), ("min", 60.0, 1.0), ("h", 3600.0, 1.0)];
const RATES: [Unit; 3] = [("/s", 1.0, 1.0), ("/min", 1.0, 60.0), ("/h", 1.0, 3600.0)];
const ANGLES: [Unit; 2] = [("deg", PI, 180.0), ("rad", 1.0, 1.0)];

impl FromStr for Seconds {
    type Err = TextError;

    fn from_str(text: &str) -> Result<Self, TextError> {
        read_time("time", text).map(Self)
    }
}

impl FromStr for Radians {
    type Err = TextError;

    fn from_str(text: &str) -> Result<Self, TextError> {
        read_angle("angle", text).map(Self)
    }
}

/// A plain number.
///
/// # Errors
/// [`TextError`] under the name `key` unless the text is one finite number.
pub fn read_number(key: &str, text: &str) -> Result<f64, TextError> {
    number(text).ok_or_else(|| TextError::value(key, text, "a finite number"))
}

/// A time [s].
///
/// # Errors
/// [`TextError`] under the name `key` unless the text is one finite time.
pub fn read_time(key: &str, text: &str) -> Result<f64, TextError> {
    quantity(text, &TIMES)
        .ok_or_else(|| TextError::value(key, text, "a time such as 40, 40s, 250ms, 6min or 1h"))
}

/// A rate [1/s].
///
/// # Errors
/// [`TextError`] under the name `key` unless the text is one finite rate.
pub fn read_rate(key: &str, text: &str) -> Result<f64, TextError> {
    quantity(text, &RATES)
        .ok_or_else(|| TextError::value(key, text, "a finite number, per second or with /s, /min or /h"))
}

/// An angle [rad].
///
/// # Errors
/// [`TextError`] under the name `key` unless the text is one finite angle.
pub fn read_angle(key: &str, text: &str) -> Result<f64, TextError> {
    quantity(text, &ANGLES)
        .ok_or_else(|| TextError::value(key, text, "an angle such as 3.14, 3.14rad or 180deg"))
}

/// A number bare or with one of all the units known here: what a rule's parameter may be given as.
///
/// # Errors
/// [`TextError`] under the name `key` unless the text is one finite number with at most one unit.
pub fn read_any(key: &str, text: &str) -> Result<f64, TextError> {
    [&TIMES[..], &RATES, &ANGLES].into_iter().find_map(|units| quantity(text, units)).ok_or_else(|| {
        TextError::value(key, text, "a finite number, bare or with a unit (ms s min h, /s /min /h, deg rad)")
    })
}

fn quantity(text: &str, units: &[Unit]) -> Option<f64> {
    number(text).or_else(|| {
        units.iter().find_map(|&(unit, factor, divisor)| {
            let bare = number(text.strip_suffix(unit)?.trim_end_matches(' '))?;
            let value = bare * factor / divisor;
            let lost = value == 0.0 && bare != 0.0;
            (value.is_finite() && !lost).then_some(value)
        })
    })
}

/// A finite decimal number; none for what Rust reads as infinite or not a number, nor where a number that is
/// not 0 would be read as 0.
fn number(text: &str) -> Option<f64> {
    if !text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'+' | b'-')) {
        return None;
    }
    let value: f64 = text.parse().ok()?;
    let mantissa = text.split(['e', 'E']).next().unwrap_or(text);
    let lost = value == 0.0 && mantissa.bytes().any(|b| matches!(b, b'1'..=b'9'));
    (value.is_finite() && !lost).then_some(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn every_unit_of_the_contract_is_read() {
        for (text, seconds) in [("40", 40.0), ("40s", 40.0), ("40 s", 40.0), ("250ms", 0.25), ("1h", 3600.0)]
        {
            assert_eq!(read_time("t", text).unwrap(), seconds, "{text}");
        }
        assert_eq!(read_rate("K", "3/min").unwrap(), 0.05);
        assert_eq!(read_rate("K", "-36/h").unwrap(), -0.01);
        assert_eq!(read_angle("a", "60deg").unwrap(), PI / 3.0);
        assert_eq!(read_any("a", "3.25rad").unwrap(), 3.25);
        assert_eq!(read_any("a", "1e3").unwrap(), 1000.0);
    }

    #[test]
    fn what_is_not_one_finite_number_is_refused() {
        for text in [
            "", " ", "s", "nan", "NaN", "inf", "-inf", "infinity", "1e400", "1e-400", "1e308h", "4 0",
            "40ss", "40s ", "0x10", "1_000", "40,5", "--1",
        ] {
            assert!(read_time("t", text).is_err(), "{text}");
            assert!(read_number("t", text).is_err(), "{text}");
        }
    }

    proptest! {
        #[test]
        fn the_shortest_text_of_a_number_reads_back_to_the_same_bits(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            let read = read_number("x", &value.to_string());
            prop_assert_eq!(read.ok(), value.is_finite().then_some(value));
        }

        #[test]
        fn no_text_makes_a_reader_panic(text in ".{0,12}") {
            let _ = (read_time("t", &text), read_rate("t", &text), read_angle("t", &text), read_any("t", &text));
        }
    }
}
