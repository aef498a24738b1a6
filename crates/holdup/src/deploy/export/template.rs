//! Templates: source text with marks such as `@integral_time@` that are filled in; and the text of numbers.

use super::Float;

/// What stands for a mark.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    /// A number of the target's precision.
    Number(f64),
    /// A number of a term that may be absent.
    Optional(Option<f64>),
    /// Whether a term is there.
    Flag(bool),
    /// Text as it is; of several lines each gets what stands before the mark on its line.
    Text(String),
}

/// A mark without its at-signs, and what stands for it.
pub(super) type Mark = (&'static str, Value);

/// Fills in a template: `write` is the text of numbers and flags in the template's language.
///
/// A mark that nothing stands for stays, with its at-signs, where the tests of every language see it.
pub(super) fn fill(template: &str, marks: &[Mark], write: impl Fn(&Value) -> String) -> String {
    let mut filled = String::with_capacity(template.len() * 2);
    for line in template.lines() {
        let mut rest = line;
        let mut done = String::new();
        while let Some((before, mark, after)) = next_mark(rest) {
            done += before;
            match marks.iter().find(|(name, _)| *name == mark) {
                Some((_, Value::Text(text))) => {
                    let prefix = done.clone();
                    done += &text.lines().collect::<Vec<_>>().join(&format!("\n{prefix}"));
                }
                Some((_, value)) => done += &write(value),
                None => done += &format!("@{mark}@"),
            }
            rest = after;
        }
        done += rest;
        // What stands before a mark of several lines may end in a space; an empty line is empty.
        for line in done.split('\n') {
            filled += line.trim_end();
            filled.push('\n');
        }
    }
    filled
}

/// The text before the next mark, the mark, and the text behind it.
fn next_mark(line: &str) -> Option<(&str, &str, &str)> {
    let (before, rest) = line.split_once('@')?;
    let (mark, after) = rest.split_once('@')?;
    Some((before, mark, after))
}

/// A number as C99 writes it exactly: hexadecimal, with its decimal in a comment.
pub(super) fn hexadecimal(value: f64, float: Float) -> String {
    let (suffix, decimal) = match float {
        Float::Double => ("", format!("{value:?}")),
        Float::Single => ("f", format!("{:?}", narrow(value))),
    };
    if value == 0.0 {
        return format!("{}0.0{suffix}", if value.is_sign_negative() { "-" } else { "" });
    }
    let bits = value.to_bits();
    let sign = if value.is_sign_negative() { "-" } else { "" };
    let fraction = bits & ((1 << 52) - 1);
    let biased = i32::try_from((bits >> 52) & 0x7ff).unwrap_or_default();
    // A subnormal number has no leading 1 and the exponent of the smallest normal one.
    let (lead, exponent) = if biased == 0 { (0, -1022) } else { (1, biased - 1023) };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{lead}{point}{digits}p{exponent:+}{suffix} /* {decimal} */")
}

/// A number as the shortest decimal that reads back to the same bits, with a point and, where it has one, a whole
/// exponent behind a capital E: a literal of Structured Text and of Rust.
pub(super) fn decimal(value: f64, float: Float) -> String {
    let shortest = match float {
        Float::Double => format!("{value:?}"),
        Float::Single => format!("{:?}", narrow(value)),
    };
    match shortest.split_once('e') {
        Some((mantissa, exponent)) if mantissa.contains('.') => format!("{mantissa}E{exponent}"),
        Some((mantissa, exponent)) => format!("{mantissa}.0E{exponent}"),
        None => shortest,
    }
}

fn narrow(value: f64) -> f32 {
    holdup_control::Scalar::from_f64(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_filled_and_the_rest_stays() {
        let marks =
            [("a", Value::Number(1.0)), ("b", Value::Text("x\n\ny".to_owned())), ("c", Value::Flag(true))];
        let write = |value: &Value| format!("<{value:?}>");
        assert_eq!(
            fill("f(@a@, @c@)\n * @b@\n@d@\n", &marks, write),
            "f(<Number(1.0)>, <Flag(true)>)\n * x\n *\n * y\n@d@\n"
        );
    }

    #[test]
    fn a_hexadecimal_number_is_the_number() {
        // Exact by definition of the notation; f64::MAX and the subnormals from C99's DBL_MAX and DBL_TRUE_MIN.
        for (value, text) in [
            (1.0, "0x1p+0 /* 1.0 */"),
            (-0.75, "-0x1.8p-1 /* -0.75 */"),
            (0.1, "0x1.999999999999ap-4 /* 0.1 */"),
            (f64::MAX, "0x1.fffffffffffffp+1023 /* 1.7976931348623157e308 */"),
            (f64::from_bits(1), "0x0.0000000000001p-1022 /* 5e-324 */"),
            (0.0, "0.0"),
            (-0.0, "-0.0"),
        ] {
            assert_eq!(hexadecimal(value, Float::Double), text);
        }
        assert_eq!(hexadecimal(f64::from(0.1_f32), Float::Single), "0x1.99999ap-4f /* 0.1 */");
    }

    #[test]
    fn a_decimal_reads_back_to_the_same_bits() {
        for value in [1.0, -0.75, 0.1, 1e-7, 1.25e300, f64::MAX, f64::from_bits(1)] {
            let text = decimal(value, Float::Double);
            assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits(), "{text}");
            assert!(text.contains('.') && !text.contains('e'), "{text}");
        }
        assert_eq!(decimal(f64::from(1e-7_f32), Float::Single), "1.0E-7");
        assert_eq!(decimal(f64::from(0.1_f32), Float::Single), "0.1");
    }
}
