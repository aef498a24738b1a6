//! Optima of an integrator with dead time without a search: tables in normalised form, interpolated.
//!
//! With gain and dead time taken out (K·Kc·d, Ti/d, Td/d, K·Ko·d) the optimum under a limit on the sensitivity peak depends on
//! that limit alone. The optima at the knots come from [`Task`](super::Task); between them settings and value are interpolated
//! by a monotone cubic, whose error was measured between all knots and is stated with every answer. Outside of the range of a
//! table there is no answer.

#[cfg(test)]
mod compute;
mod file;

use std::fmt;
use std::sync::OnceLock;

use thiserror::Error;

use super::curve::Curve;
use super::design::Structure;
use super::filter::Filter;
use super::objective::Objective;
use crate::model::{Controller, ModelError, Observer, Process, Seconds};

/// The optima of a structure for an objective, for every limit on the sensitivity peak within a range.
#[derive(Debug, Clone)]
pub struct Table {
    /// The structure.
    pub structure: Structure,
    /// The filter of the derivative: none where there is no derivative, else held.
    pub filter: Filter,
    /// The objective.
    pub objective: Objective,
    /// The error of the interpolation.
    pub error: TableErrors,
    knots: Vec<f64>,
    curves: Vec<Curve>,
}

/// The greatest errors that were met between the knots, doubled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TableErrors {
    /// Of every setting, relative \[–\]. The optimum is flat: so much of a setting costs next to nothing.
    pub settings: f64,
    /// Of the value of the objective, and of what the interpolated controller loses against the optimum, relative \[–\].
    pub value: f64,
    /// By how much the sensitivity peak of the interpolated controller exceeds the limit, relative \[–\].
    pub sensitivity_peak: f64,
}

/// An optimum with gain and dead time taken out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Normalised {
    /// The limit on the sensitivity peak \[–\].
    pub sensitivity_peak: f64,
    /// K·Kc·d \[–\].
    pub gain: f64,
    /// Ti/d \[–\].
    pub integral_time: Option<f64>,
    /// Td/d \[–\].
    pub derivative_time: Option<f64>,
    /// K·Ko·d \[–\].
    pub observer_gain: Option<f64>,
    /// The value of the objective, in the unit of [`Table::unit`].
    pub value: f64,
}

/// Why a table has no answer.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum TableError {
    /// There is no such table.
    #[error("there is no table of {objective} for {structure}; there are {known}")]
    Unknown {
        /// The structure that was asked for.
        structure: &'static str,
        /// The objective that was asked for.
        objective: &'static str,
        /// What there is.
        known: String,
    },
    /// The sensitivity peak is outside of the table.
    #[error("a sensitivity peak of {value} must be from {low} to {high}: the table ends there")]
    Outside {
        /// The limit that was asked for \[–\].
        value: f64,
        /// The least limit of the table \[–\].
        low: f64,
        /// The greatest limit of the table \[–\].
        high: f64,
    },
    /// The process is not the one of the tables.
    #[error("the tables are for an integrator with dead time, without lag: this process must be searched")]
    Process,
    /// The settings are out of the range of a controller.
    #[error(transparent)]
    Model(#[from] ModelError),
}

/// Every table.
///
/// ```
/// use holdup::tuning::optimise::table::tables;
/// let pi = tables().iter().find(|table| table.name() == "pi load_iae").unwrap();
/// let at = pi.at(1.6)?;
/// // Kc = 0.40/(K·d), Ti = 5.73·d, IAE = 14.8·K·d².
/// assert!((at.gain - 0.4006).abs() < 5e-4 && (at.integral_time.unwrap() - 5.728).abs() < 5e-3);
/// # Ok::<(), holdup::tuning::optimise::table::TableError>(())
/// ```
///
/// # Panics
/// Never: the file of the tables is a part of the program, and a test reads it.
#[must_use]
pub fn tables() -> &'static [Table] {
    static TABLES: OnceLock<Vec<Table>> = OnceLock::new();
    TABLES.get_or_init(|| file::read(include_str!("tables.toml")).expect("a test reads the file"))
}

/// The table of a structure and an objective; with a filter of the derivative that is held, where there is a derivative.
///
/// # Errors
/// [`TableError::Unknown`], which names the tables that there are.
pub fn table(
    structure: Structure,
    filter: Filter,
    objective: Objective,
) -> Result<&'static Table, TableError> {
    let held = if structure.differentiates() { filter } else { Filter::None };
    let wanted =
        |table: &&Table| (table.structure, table.filter, table.objective) == (structure, held, objective);
    tables().iter().find(wanted).ok_or_else(|| TableError::Unknown {
        structure: structure.name(),
        objective: objective.name(),
        known: tables().iter().map(Table::name).collect::<Vec<_>>().join(", "),
    })
}

impl Table {
    /// Structure, filter and objective, such as `pid with Tf/Td = 0.1 load_iae`.
    #[must_use]
    pub fn name(&self) -> String {
        let filter = match self.filter {
            Filter::Held(ratio) => format!(" with Tf/Td = {ratio}"),
            _ => String::new(),
        };
        format!("{}{filter} {}", self.structure.name(), self.objective.name())
    }

    /// Least and greatest limit on the sensitivity peak \[–\].
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        [self.knots[0], self.knots[self.knots.len() - 1]]
    }

    /// The limits on the sensitivity peak at which the optimum was searched \[–\].
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// The unit of the normalised value: `K·d²` for instance.
    #[must_use]
    pub fn unit(&self) -> &'static str {
        match self.objective {
            Objective::LoadIae => "|K|·d²",
            Objective::LoadIse => "K²·d³",
            Objective::SetpointIae | Objective::SetpointIse => "d",
            _ => "",
        }
    }

    /// The optimum under this limit on the sensitivity peak, with gain and dead time taken out.
    ///
    /// # Errors
    /// [`TableError::Outside`].
    pub fn at(&self, sensitivity_peak: f64) -> Result<Normalised, TableError> {
        let [low, high] = self.range();
        if !(low..=high).contains(&sensitivity_peak) {
            return Err(TableError::Outside { value: sensitivity_peak, low, high });
        }
        let mut values = self.curves.iter().map(|curve| curve.at(sensitivity_peak));
        let mut next = |there: bool| if there { values.next() } else { None };
        let structure = self.structure;
        let [gain, integral_time, derivative_time, observer_gain, value] =
            [true, structure.integrates(), structure.differentiates(), structure.observes(), true]
                .map(&mut next);
        Ok(Normalised {
            sensitivity_peak,
            gain: gain.unwrap_or(f64::NAN),
            integral_time,
            derivative_time,
            observer_gain,
            value: value.unwrap_or(f64::NAN),
        })
    }

    /// The controller for a process under this limit.
    ///
    /// ```
    /// use holdup::model::{Process, Seconds};
    /// use holdup::tuning::optimise::table::table;
    /// use holdup::tuning::optimise::{Filter, Objective, Structure};
    /// let process = Process::integrating(0.0506, Seconds(6.0))?;
    /// let table = table(Structure::Pi, Filter::None, Objective::LoadIae)?;
    /// let pi = table.controller(&process, 1.6)?;
    /// assert!((pi.proportional_gain() - 1.3195).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`TableError::Outside`]; [`TableError::Process`] with a lag or two integrators.
    pub fn controller(&self, process: &Process, sensitivity_peak: f64) -> Result<Controller, TableError> {
        if process.lag().is_some() || process.integrators() != 1 {
            return Err(TableError::Process);
        }
        self.at(sensitivity_peak)?.controller(process, self.filter)
    }
}

impl Normalised {
    /// The controller for an integrator with dead time.
    fn controller(&self, process: &Process, filter: Filter) -> Result<Controller, TableError> {
        let time = process.dead_time();
        let gain = 1.0 / (process.process_gain() * time);
        let mut controller = Controller::proportional(self.gain * gain)?;
        if let Some(ratio) = self.integral_time {
            controller = controller.with_integral_time(Seconds(ratio * time))?;
        }
        if let Some(ratio) = self.derivative_time {
            controller = controller.with_derivative_time(Seconds(ratio * time))?;
            if let Filter::Held(held) = filter {
                controller = controller.with_filter_time(Seconds(held * ratio * time))?;
            }
        }
        if let Some(ratio) = self.observer_gain {
            controller = controller.with_observer(Observer::new(ratio * gain)?);
        }
        Ok(controller)
    }
}

impl fmt::Display for TableErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "settings within {} % of the optimum, its value within {} %, M_s within {} % of the limit",
            percent(self.settings),
            percent(self.value),
            percent(self.sensitivity_peak)
        )
    }
}

/// Two digits that count.
fn percent(ratio: f64) -> String {
    let value = 100.0 * ratio;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few digits, from 0")]
    let digits = (1.0 - value.log10().floor()).clamp(0.0, 12.0) as usize;
    format!("{value:.digits$}")
}
