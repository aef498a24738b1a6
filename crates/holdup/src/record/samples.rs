//! A record of a loop in operation, checked.

use thiserror::Error;

/// Who moved the actuator in a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    /// The operator.
    Manual,
    /// The controller, on its own setpoint or on one of another controller.
    Automatic,
    /// The row does not say.
    Unknown,
}

/// Why rows are no record.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RecordError {
    /// Too few rows.
    #[error("the record has {found} usable rows: at least {needed} are needed")]
    TooShort {
        /// Rows that are there.
        found: usize,
        /// Rows that are needed.
        needed: usize,
    },
    /// Columns of different length.
    #[error("column {column} has {found} rows, the time column {expected}")]
    Lengths {
        /// The column.
        column: &'static str,
        /// Its rows.
        found: usize,
        /// Rows of the time column.
        expected: usize,
    },
    /// A value that is no finite number.
    #[error("column {column}, row {row}: {value} is not a finite number")]
    NotFinite {
        /// The column.
        column: &'static str,
        /// The row, from 0.
        row: usize,
        /// The value.
        value: f64,
    },
    /// Times that do not increase.
    #[error("time does not increase at row {row}: {time} s after {before} s")]
    Order {
        /// The row, from 0.
        row: usize,
        /// Its time [s].
        time: f64,
        /// The time of the row before [s].
        before: f64,
    },
}

/// A record of a loop in operation: rows with strictly increasing times and finite values.
///
/// The manipulated variable of a row holds until the next row; values are in the units of the source, or in percent
/// of their spans where spans were given when it was read. Rows need not be evenly spaced.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    time: Vec<f64>,
    controlled_variable: Vec<f64>,
    manipulated_variable: Vec<f64>,
    setpoint: Option<Vec<f64>>,
    operation: Option<Vec<Operation>>,
}

impl Record {
    /// Checks the columns: `time` \[s\] strictly increasing, all values finite, at least three rows.
    ///
    /// # Errors
    ///
    /// Names the first column and row at fault.
    ///
    /// ```
    /// use holdup::record::Record;
    ///
    /// let record = Record::new(vec![0.0, 1.0, 2.5], vec![4.0, 4.1, 4.2], vec![50.0, 50.0, 60.0])?;
    /// assert_eq!(record.len(), 3);
    /// # Ok::<(), holdup::record::RecordError>(())
    /// ```
    pub fn new(
        time: Vec<f64>,
        controlled_variable: Vec<f64>,
        manipulated_variable: Vec<f64>,
    ) -> Result<Self, RecordError> {
        const NEEDED: usize = 3;
        if time.len() < NEEDED {
            return Err(RecordError::TooShort { found: time.len(), needed: NEEDED });
        }
        finite("time", &time)?;
        for row in 1..time.len() {
            if time[row] <= time[row - 1] {
                return Err(RecordError::Order { row, time: time[row], before: time[row - 1] });
            }
        }
        column("controlled_variable", &controlled_variable, time.len())?;
        column("manipulated_variable", &manipulated_variable, time.len())?;
        Ok(Self { time, controlled_variable, manipulated_variable, setpoint: None, operation: None })
    }

    /// The same record with a setpoint column.
    ///
    /// # Errors
    ///
    /// As [`Record::new`].
    pub fn with_setpoint(mut self, setpoint: Vec<f64>) -> Result<Self, RecordError> {
        column("setpoint", &setpoint, self.time.len())?;
        self.setpoint = Some(setpoint);
        Ok(self)
    }

    /// The same record with a column that says who moved the actuator.
    ///
    /// # Errors
    ///
    /// Where its length is another one.
    pub fn with_operation(mut self, operation: Vec<Operation>) -> Result<Self, RecordError> {
        if operation.len() != self.time.len() {
            let (found, expected) = (operation.len(), self.time.len());
            return Err(RecordError::Lengths { column: "mode", found, expected });
        }
        self.operation = Some(operation);
        Ok(self)
    }

    /// Number of rows, at least three.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a record is never empty")]
    pub fn len(&self) -> usize {
        self.time.len()
    }

    /// Times [s], strictly increasing.
    #[must_use]
    pub fn time(&self) -> &[f64] {
        &self.time
    }

    /// The controlled variable at each time.
    #[must_use]
    pub fn controlled_variable(&self) -> &[f64] {
        &self.controlled_variable
    }

    /// The manipulated variable from each time to the next.
    #[must_use]
    pub fn manipulated_variable(&self) -> &[f64] {
        &self.manipulated_variable
    }

    /// The setpoint at each time, where the source has it.
    #[must_use]
    pub fn setpoint(&self) -> Option<&[f64]> {
        self.setpoint.as_deref()
    }

    /// Who moved the actuator, where the source says it.
    #[must_use]
    pub fn operation(&self) -> Option<&[Operation]> {
        self.operation.as_deref()
    }

    /// The rows from `from` to before `to`.
    ///
    /// # Errors
    ///
    /// Where fewer than three rows are left.
    pub fn rows(&self, from: usize, to: usize) -> Result<Self, RecordError> {
        let to = to.min(self.len());
        let from = from.min(to);
        let part = Self::new(
            self.time[from..to].to_vec(),
            self.controlled_variable[from..to].to_vec(),
            self.manipulated_variable[from..to].to_vec(),
        )?;
        Ok(Self {
            setpoint: self.setpoint.as_ref().map(|values| values[from..to].to_vec()),
            operation: self.operation.as_ref().map(|values| values[from..to].to_vec()),
            ..part
        })
    }
}

fn column(name: &'static str, values: &[f64], expected: usize) -> Result<(), RecordError> {
    if values.len() != expected {
        return Err(RecordError::Lengths { column: name, found: values.len(), expected });
    }
    finite(name, values)
}

fn finite(column: &'static str, values: &[f64]) -> Result<(), RecordError> {
    match values.iter().position(|value| !value.is_finite()) {
        Some(row) => Err(RecordError::NotFinite { column, row, value: values[row] }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_out_of_order_not_finite_or_too_few_are_named() {
        let order = Record::new(vec![0.0, 1.0, 1.0], vec![0.0; 3], vec![0.0; 3]).unwrap_err();
        assert_eq!(order, RecordError::Order { row: 2, time: 1.0, before: 1.0 });
        let value = Record::new(vec![0.0, 1.0, 2.0], vec![0.0, f64::INFINITY, 0.0], vec![0.0; 3]);
        assert!(value.unwrap_err().to_string().contains("controlled_variable, row 1: inf"));
        let short = Record::new(vec![0.0, 1.0], vec![0.0; 2], vec![0.0; 2]).unwrap_err();
        assert_eq!(short, RecordError::TooShort { found: 2, needed: 3 });
        let lengths = Record::new(vec![0.0, 1.0, 2.0], vec![0.0; 3], vec![0.0; 2]).unwrap_err();
        assert_eq!(lengths, RecordError::Lengths { column: "manipulated_variable", found: 2, expected: 3 });
    }

    #[test]
    fn a_part_keeps_all_columns() {
        let record = Record::new((0..5).map(f64::from).collect(), vec![1.0; 5], vec![2.0; 5])
            .unwrap()
            .with_setpoint(vec![0.0, 1.0, 2.0, 3.0, 4.0])
            .unwrap()
            .with_operation(vec![Operation::Manual; 5])
            .unwrap();
        let part = record.rows(1, 4).unwrap();
        assert_eq!(part.setpoint(), Some([1.0, 2.0, 3.0].as_slice()));
        assert_eq!(part.operation().map(<[_]>::len), Some(3));
        assert!(record.rows(3, 4).is_err());
    }
}
