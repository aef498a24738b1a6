//! The range of a parameter, as text that is shown and checked.

use super::expression::{ExpressionError, evaluate};

/// Whether `value` lies in the range, which is `any`, `low..high` (both ends included), a choice `0.26 | 0.44`,
/// or comparisons joined by `and`: `> 0 and < 1`. Ends are formulas.
pub(crate) fn contains(
    range: &str,
    value: f64,
    lookup: &dyn Fn(&str) -> Option<f64>,
) -> Result<bool, ExpressionError> {
    if range == "any" {
        return Ok(value.is_finite());
    }
    if let Some((low, high)) = range.split_once("..") {
        return Ok(value >= evaluate(low, lookup)? && value <= evaluate(high, lookup)?);
    }
    if range.starts_with(['<', '>']) {
        for part in range.split(" and ") {
            let (operator, bound) =
                part.split_at(part.find(|c| c != '<' && c != '>' && c != '=').unwrap_or(0));
            let bound = evaluate(bound, lookup)?;
            let inside = match operator {
                "<" => value < bound,
                "<=" => value <= bound,
                ">" => value > bound,
                _ => value >= bound,
            };
            if !inside || !value.is_finite() {
                return Ok(false);
            }
        }
        return Ok(true);
    }
    for choice in range.split('|') {
        if evaluate(choice, lookup)? == value {
            return Ok(true);
        }
    }
    Ok(false)
}

#[cfg(test)]
mod tests {
    use super::contains;

    fn inside(range: &str, value: f64) -> bool {
        contains(range, value, &|name| (name == "d").then_some(2.0)).unwrap()
    }

    #[test]
    fn every_kind_of_range_is_read() {
        assert!(inside("1..2*d", 1.0) && inside("1..2*d", 4.0) && !inside("1..2*d", 4.1));
        assert!(
            inside("> 0 and < pi/d", 1.0) && !inside("> 0 and < pi/d", 0.0) && !inside("> 0 and < pi/d", 2.0)
        );
        assert!(inside(">= d", 2.0) && !inside(">= d", 1.9) && !inside(">= d", f64::NAN));
        assert!(!inside("> 0", f64::INFINITY) && inside("any", -3.0) && !inside("any", f64::NAN));
        assert!(inside("0.26 | 0.44", 0.44) && !inside("0.26 | 0.44", 0.3));
    }
}
