//! One record as a least-squares problem: for a dead time and a lag the rest is linear.

use super::input::{Input, Shape};
use super::kind::{Hold, Kind, Load};
use super::noise::Whitener;
use super::squares::{Basis, dot};
use crate::record::Record;

/// What is fitted: the rows that count, in blocks where there are very many, and the input that all rows share.
///
/// A mean over a block of rows is taken of the response and of every column alike, so that it leaves the model exact.
#[derive(Debug, Clone)]
pub(crate) struct Problem<'r> {
    input: Input<'r>,
    sample_times: &'r [f64],
    block: usize,
    /// Times of the rows, or of the middles of the blocks [s].
    pub(crate) times: Vec<f64>,
    /// The controlled variable in them.
    pub(crate) response: Vec<f64>,
    /// What is known of the load beside its random part.
    pub(crate) load: Load,
    /// Where the load steps.
    pub(crate) load_steps: Vec<StepTime>,
}

/// When a load steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StepTime {
    /// Time [s].
    pub(crate) time: f64,
    /// Whether the time is itself uncertain: then what a small change of it does is a column of its own.
    pub(crate) uncertain: bool,
}

impl<'r> Problem<'r> {
    /// The rows of a record from row `from` on, in blocks of so many.
    pub(crate) fn new(record: &'r Record, from: usize, block: usize, hold: Hold, load: Load) -> Self {
        let input = Input::new(record.time(), record.manipulated_variable(), hold);
        let sample_times = &record.time()[from..];
        let block = block.max(1);
        let (times, response, load_steps) = (Vec::new(), Vec::new(), Vec::new());
        let mut problem = Self { input, sample_times, block, times, response, load, load_steps };
        problem.times = problem.in_blocks(sample_times.to_vec());
        problem.response = problem.in_blocks(record.controlled_variable()[from..].to_vec());
        problem
    }

    /// The same rows with another input.
    pub(crate) fn with_input(&self, record: &'r Record, samples: &[f64]) -> Self {
        Self { input: Input::new(record.time(), samples, Hold::Constant), ..self.clone() }
    }

    /// A shape of another input of the same record, so much later.
    pub(crate) fn column_of(&self, record: &Record, samples: &[f64], shape: Shape, delay: f64) -> Vec<f64> {
        let input = Input::new(record.time(), samples, Hold::Constant);
        self.in_blocks(input.column(shape, delay, self.sample_times))
    }

    fn in_blocks(&self, rows: Vec<f64>) -> Vec<f64> {
        if self.block == 1 {
            return rows;
        }
        #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
        rows.chunks_exact(self.block).map(|block| block.iter().sum::<f64>() / self.block as f64).collect()
    }

    /// A shape of the input, so much later.
    pub(crate) fn column(&self, shape: Shape, delay: f64) -> Vec<f64> {
        self.in_blocks(self.input.column(shape, delay, self.sample_times))
    }

    /// A shape of the input, so much later, at any times in order.
    pub(crate) fn at_times(&self, shape: Shape, delay: f64, times: &[f64]) -> Vec<f64> {
        self.input.column(shape, delay, times)
    }

    /// The columns of the initial state and of the load; those of its steps stand last.
    pub(crate) fn own_columns(&self, kind: Kind, lag: f64) -> Vec<Vec<f64>> {
        let mut columns = kind.own_columns(self.load, &self.times, lag);
        for step in &self.load_steps {
            let [level, rate] = self.load_column(kind, lag, step.time);
            columns.push(level);
            if step.uncertain {
                columns.push(rate);
            }
        }
        columns
    }

    /// What a load that steps up by one at a time makes of the rows, before the gain, and the rate of it.
    pub(crate) fn load_column(&self, kind: Kind, lag: f64, time: f64) -> [Vec<f64>; 2] {
        [0, 1].map(|which| {
            let rows = self.sample_times.iter().map(|row| kind.load_response(lag, row - time)[which]);
            self.in_blocks(rows.collect())
        })
    }

    /// The same with another step of the load.
    pub(crate) fn with_load_step(&self, step: StepTime) -> Self {
        let mut next = self.clone();
        next.load_steps.push(step);
        next
    }

    /// Number of rows.
    pub(crate) fn len(&self) -> usize {
        self.times.len()
    }

    /// From the first to the last row [s].
    pub(crate) fn span(&self) -> f64 {
        self.times[self.times.len() - 1] - self.times[0]
    }

    /// Mean distance of the rows [s].
    pub(crate) fn step(&self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
        let steps = (self.len() - 1) as f64;
        self.span() / steps
    }
}

/// A dead time, a lag where the kind has one, and what fits best with them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fit {
    pub(crate) kind: Kind,
    /// Dead time [s].
    pub(crate) dead_time: f64,
    /// Lag [s]; 0 where the kind has none.
    pub(crate) lag: f64,
    /// Coefficient of the input's column.
    pub(crate) gain: f64,
    /// Sum of the squared whitened residuals.
    pub(crate) squares: f64,
    /// Sum of the squares of the whitened column outside the columns of initial state and load.
    pub(crate) column_squares: f64,
}

impl Fit {
    /// The same in the convention of K: the slope that a unit input starts.
    pub(crate) fn process_gain(&self) -> f64 {
        if self.kind == Kind::FirstOrder { self.gain / self.lag } else { self.gain }
    }
}

/// A problem under a noise model and a kind.
#[derive(Debug, Clone)]
pub(crate) struct Whitened<'p, 'r> {
    pub(crate) problem: &'p Problem<'r>,
    pub(crate) whitener: &'p Whitener,
    pub(crate) kind: Kind,
    /// Columns and response of a kind without lag, which no dead time changes.
    fixed: Option<(Basis, Vec<f64>)>,
}

impl<'p, 'r> Whitened<'p, 'r> {
    pub(crate) fn new(problem: &'p Problem<'r>, whitener: &'p Whitener, kind: Kind) -> Self {
        let mut whitened = Self { problem, whitener, kind, fixed: None };
        if !kind.has_lag() {
            whitened.fixed = Some(whitened.rest(1.0));
        }
        whitened
    }

    /// The basis of initial state and load, and the response outside it.
    pub(crate) fn rest(&self, lag: f64) -> (Basis, Vec<f64>) {
        if let Some(fixed) = &self.fixed {
            return fixed.clone();
        }
        let own = self.problem.own_columns(self.kind, lag);
        let basis = Basis::of(own.into_iter().map(|column| self.whitener.whiten(column)));
        let response = basis.projected(self.whitener.whiten(self.problem.response.clone()));
        (basis, response)
    }

    /// The whitened column of a shape of the input.
    pub(crate) fn column(&self, shape: Shape, delay: f64) -> Vec<f64> {
        self.whitener.whiten(self.problem.column(shape, delay))
    }

    /// The best with this dead time and lag.
    pub(crate) fn at(&self, dead_time: f64, lag: f64) -> Fit {
        if let Some((basis, response)) = &self.fixed {
            return self.at_with(basis, response, dead_time, lag);
        }
        let (basis, response) = self.rest(lag);
        self.at_with(&basis, &response, dead_time, lag)
    }

    /// The best with this dead time and lag, from what [`Whitened::rest`] gives for the lag.
    pub(crate) fn at_with(&self, basis: &Basis, response: &[f64], dead_time: f64, lag: f64) -> Fit {
        let (column, column_squares) = basis.outside(self.column(self.kind.shape(lag), dead_time));
        let gain = if column_squares > 0.0 { dot(&column, response) / column_squares } else { 0.0 };
        let squares = column.iter().zip(response).map(|(v, y)| (y - gain * v).powi(2)).sum();
        Fit { kind: self.kind, dead_time, lag, gain, squares, column_squares }
    }
}
