//! The spans with which a block scales its measurement and its output.

use crate::model::quantity::read_number;
use crate::model::text::{Problem, TextError};

/// The range of a signal in engineering units, its low end below its high end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    low: f64,
    high: f64,
}

impl Span {
    /// What the range of a signal must be.
    const ALLOWED: &'static str = "low:high, two finite numbers, the low one below the high one, such as 0:5";

    /// The range from `low` to `high` [unit of the signal].
    ///
    /// ```
    /// use holdup::deploy::conversion::Span;
    /// assert_eq!(Span::new(-50.0, 150.0)?.width(), 200.0);
    /// assert!(Span::new(5.0, 5.0).is_err());
    /// # Ok::<(), holdup::model::TextError>(())
    /// ```
    ///
    /// # Errors
    /// [`TextError`] unless both ends are finite, low is below high, and the width is neither too great nor too small
    /// for double precision.
    pub fn new(low: f64, high: f64) -> Result<Self, TextError> {
        let span = Self { low, high };
        let width = high - low;
        if width.is_finite() && width > 0.0 && (1.0 / width).is_finite() {
            Ok(span)
        } else {
            Err(TextError::value("span", format!("{low}:{high}"), Self::ALLOWED))
        }
    }

    /// Reads `low:high`.
    ///
    /// # Errors
    /// [`TextError`] under the name `key`, as [`Span::new`].
    pub fn read(key: &str, text: &str) -> Result<Self, TextError> {
        let wrong =
            || TextError::at(key, Problem::Value { value: text.to_owned(), allowed: Self::ALLOWED.into() });
        let (low, high) = text.split_once(':').ok_or_else(wrong)?;
        let number = |part: &str| read_number(key, part).map_err(|_| wrong());
        Self::new(number(low)?, number(high)?).map_err(|_| wrong())
    }

    /// Low end [unit of the signal].
    #[must_use]
    pub fn low(self) -> f64 {
        self.low
    }

    /// High end [unit of the signal].
    #[must_use]
    pub fn high(self) -> f64 {
        self.high
    }

    /// High end minus low end [unit of the signal], > 0.
    #[must_use]
    pub fn width(self) -> f64 {
        self.high - self.low
    }
}

/// What a block must be told about the plant besides the controller.
#[derive(Debug, Clone, PartialEq)]
pub struct Scaling {
    /// Range of the controlled variable (PV), in the units of the design.
    pub pv: Span,
    /// Range of the manipulated variable (the controller's output), in the units of the design.
    pub op: Span,
    /// Unit of the controlled variable for reading, `m` or `degC`; empty where it was not said.
    pub pv_unit: String,
    /// Period at which the block is executed [s], where it was said.
    pub sample_period: Option<f64>,
}

impl Scaling {
    /// A scaling by these spans, without unit and sample period.
    #[must_use]
    pub fn new(pv: Span, op: Span) -> Self {
        Self { pv, op, pv_unit: String::new(), sample_period: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_is_two_numbers_in_order() {
        assert_eq!(Span::read("--pv-span", "-50:150").unwrap(), Span { low: -50.0, high: 150.0 });
        for text in ["5:0", "5:5", "5", "", ":", "0:nan", "0:inf", "-1e308:1e308", "0:1:2", "0:1e-320", "a:b"]
        {
            let error = Span::read("--pv-span", text).unwrap_err().to_string();
            assert!(error.starts_with("--pv-span is ") && error.contains("low:high"), "{text}: {error}");
        }
    }
}
