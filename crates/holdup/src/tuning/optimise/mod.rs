//! The best controller of a structure under limits on its robustness.
//!
//! Margins, peaks and integrals are the exact ones of [`crate::analysis`]; the integrals are over all time, with a proven
//! bound on the part that is left out. The search is nested: for given times and ratios the allowed gains are intervals,
//! whose ends are exact, and the best gain lies in one of them; about that a search runs from many starts that does not stop
//! on the kinks where two peaks are equally high. That the optimum is global is not proven but shown: [`Optimum`] says how
//! many starts agree and what a sweep over the whole space found. For an integrator with dead time the optima under a limit on
//! the sensitivity peak alone are in a [`table`], too.

mod curve;
mod design;
mod filter;
mod gain;
mod infeasible;
mod kink;
pub mod level;
mod limits;
mod objective;
mod progress;
mod quasi_newton;
mod ridge;
mod search;
mod simplex;
pub mod table;
mod task;
mod trade_off;
mod widest;

pub use design::Structure;
pub use filter::Filter;
pub use infeasible::Conflict;
pub use limits::{Limit, Limits, Quantity};
pub use objective::Objective;
pub use progress::WHOLE;
pub use search::{OptimiseError, Optimum, optimise};
pub use task::Task;
pub use trade_off::{Point, between, trade_off};
