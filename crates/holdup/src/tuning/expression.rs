//! The formulas of the rules, evaluated as they are printed: the text that is shown is the text that is computed.
//!
//! Numbers, names, `+ - * / ^`, parentheses, `pi`, and the functions `sqrt`, `exp`, `ln`, `atan`, `tan`, `abs`,
//! `min(x, y)`, `row(x, x1, y1, x2, y2, …)`, which is the y of the row whose x is the given one, and `near(x, …)`,
//! which is that of the nearest row.

use thiserror::Error;

/// Why a formula has no value.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ExpressionError {
    /// The text is not a formula.
    #[error("formula `{text}`: {expected} expected at character {position}")]
    Syntax {
        /// The whole formula.
        text: String,
        /// What should stand there.
        expected: &'static str,
        /// Where, counted from 0 in bytes.
        position: usize,
    },
    /// A name stands for nothing.
    #[error("formula: nothing is called `{name}`")]
    UnknownName {
        /// The name.
        name: String,
    },
    /// A table has no row for the value.
    #[error("formula: the table has no row {value}")]
    NoRow {
        /// The value looked up.
        value: f64,
    },
}

/// The value of a formula; `lookup` gives the value of a name.
///
/// # Errors
/// [`ExpressionError`] where the text is no formula, or a name or a row is unknown.
///
/// ```
/// use holdup::tuning::evaluate;
/// let value = evaluate("20*d/3", &|name| (name == "d").then_some(6.0))?;
/// assert_eq!(value, 40.0);
/// # Ok::<(), holdup::tuning::ExpressionError>(())
/// ```
pub fn evaluate(text: &str, lookup: &dyn Fn(&str) -> Option<f64>) -> Result<f64, ExpressionError> {
    let mut reader = Reader { text, position: 0, depth: 0, lookup };
    let value = reader.sum()?;
    match reader.peek() {
        None => Ok(value),
        Some(_) => Err(reader.expected("an operator or the end")),
    }
}

struct Reader<'a> {
    text: &'a str,
    position: usize,
    depth: u8,
    lookup: &'a dyn Fn(&str) -> Option<f64>,
}

impl Reader<'_> {
    fn peek(&mut self) -> Option<u8> {
        while self.text.as_bytes().get(self.position).is_some_and(u8::is_ascii_whitespace) {
            self.position += 1;
        }
        self.text.as_bytes().get(self.position).copied()
    }

    fn take(&mut self, symbol: u8) -> bool {
        let found = self.peek() == Some(symbol);
        self.position += usize::from(found);
        found
    }

    fn expected(&self, expected: &'static str) -> ExpressionError {
        ExpressionError::Syntax { text: self.text.to_owned(), expected, position: self.position }
    }

    fn sum(&mut self) -> Result<f64, ExpressionError> {
        self.depth += 1;
        if self.depth > 50 {
            return Err(self.expected("a shallower formula"));
        }
        let mut value = self.product()?;
        loop {
            if self.take(b'+') {
                value += self.product()?;
            } else if self.take(b'-') {
                value -= self.product()?;
            } else {
                self.depth -= 1;
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<f64, ExpressionError> {
        let negative = self.take(b'-');
        let mut value = self.power()?;
        if negative {
            value = -value;
        }
        loop {
            if self.take(b'*') {
                value *= self.power()?;
            } else if self.take(b'/') {
                value /= self.power()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn power(&mut self) -> Result<f64, ExpressionError> {
        let base = self.atom()?;
        if !self.take(b'^') {
            return Ok(base);
        }
        let exponent = self.atom()?;
        // Small whole powers by multiplication, as a reader would do it.
        Ok(if exponent == 2.0 {
            base * base
        } else if exponent == 3.0 {
            base * base * base
        } else {
            base.powf(exponent)
        })
    }

    fn atom(&mut self) -> Result<f64, ExpressionError> {
        match self.peek() {
            Some(b'(') => {
                self.position += 1;
                let value = self.sum()?;
                if self.take(b')') { Ok(value) } else { Err(self.expected("`)`")) }
            }
            Some(c) if c.is_ascii_digit() || c == b'.' => self.number(),
            Some(c) if c.is_ascii_alphabetic() => self.name(),
            _ => Err(self.expected("a number, a name or `(`")),
        }
    }

    fn number(&mut self) -> Result<f64, ExpressionError> {
        let start = self.position;
        let bytes = self.text.as_bytes();
        while let Some(&c) = bytes.get(self.position) {
            let exponent_sign = matches!(c, b'+' | b'-')
                && matches!(bytes[self.position - 1], b'e' | b'E')
                && self.position > start;
            let exponent = matches!(c, b'e' | b'E')
                && bytes.get(self.position + 1).is_some_and(|n| !n.is_ascii_alphabetic());
            if !(c.is_ascii_digit() || c == b'.' || exponent || exponent_sign) {
                break;
            }
            self.position += 1;
        }
        self.text[start..self.position].parse().map_err(|_| self.expected("a number"))
    }

    fn name(&mut self) -> Result<f64, ExpressionError> {
        let start = self.position;
        while self.text.as_bytes().get(self.position).is_some_and(|c| c.is_ascii_alphanumeric() || *c == b'_')
        {
            self.position += 1;
        }
        let name = &self.text[start..self.position];
        if !self.take(b'(') {
            let value = if name == "pi" { Some(std::f64::consts::PI) } else { (self.lookup)(name) };
            return value.ok_or_else(|| ExpressionError::UnknownName { name: name.to_owned() });
        }
        let mut arguments = vec![self.sum()?];
        while self.take(b',') {
            arguments.push(self.sum()?);
        }
        if !self.take(b')') {
            return Err(self.expected("`,` or `)`"));
        }
        call(name, &arguments)
    }
}

fn call(name: &str, arguments: &[f64]) -> Result<f64, ExpressionError> {
    match (name, arguments) {
        ("sqrt", [x]) => Ok(x.sqrt()),
        ("exp", [x]) => Ok(x.exp()),
        ("ln", [x]) => Ok(x.ln()),
        ("atan", [x]) => Ok(x.atan()),
        ("tan", [x]) => Ok(x.tan()),
        ("abs", [x]) => Ok(x.abs()),
        ("min", [x, y]) => Ok(x.min(*y)),
        ("row", [x, rows @ ..]) => {
            let found = rows.chunks_exact(2).find(|row| row[0] == *x);
            found.map(|row| row[1]).ok_or(ExpressionError::NoRow { value: *x })
        }
        ("near", [x, rows @ ..]) => {
            let distance = |row: &&[f64]| (row[0] - x).abs();
            let found = rows.chunks_exact(2).min_by(|a, b| distance(a).total_cmp(&distance(b)));
            found.map(|row| row[1]).ok_or(ExpressionError::NoRow { value: *x })
        }
        _ => Err(ExpressionError::UnknownName { name: format!("{name}(…)") }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Result<f64, ExpressionError> {
        evaluate(text, &|name| match name {
            "K" => Some(0.5),
            "d" => Some(4.0),
            _ => None,
        })
    }

    #[test]
    fn operators_bind_as_in_print() {
        assert_eq!(value("1 + 2*d - 6/K^2"), Ok(1.0 + 8.0 - 24.0));
        assert_eq!(value("-d^2/(K*d)"), Ok(-8.0));
        assert_eq!(value("2e-1 + exp(0)"), Ok(1.2));
        assert_eq!(value("sqrt(d) + min(3, K)"), Ok(2.5));
        assert_eq!(value("d/2/2"), Ok(1.0));
    }

    #[test]
    fn a_table_gives_its_row_and_no_value_between_rows() {
        assert_eq!(value("row(d, 2, 0.5, 4, 0.25)/K"), Ok(0.5));
        assert_eq!(value("row(3, 2, 0.5, 4, 0.25)"), Err(ExpressionError::NoRow { value: 3.0 }));
    }

    #[test]
    fn what_is_not_a_formula_is_said_not_panicked() {
        for text in
            ["", "1+", "(", "1 2", "K d", "f(1)", "1..2", "e", "sqrt()", "row()", "ü", "1e", "\u{1f600}+1"]
        {
            assert!(value(text).is_err(), "{text}");
        }
        assert!(value(&"(".repeat(100_000)).is_err());
    }
}
