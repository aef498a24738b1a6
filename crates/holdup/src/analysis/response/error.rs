//! Why there is no response.

use thiserror::Error;

/// Why a response could not be computed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ResponseError {
    /// The horizon takes more cells than the budget allows.
    #[error(
        "--horizon is {horizon} s: the loop has not settled after {reached:.6} s, when the budget of {cells} steps \
         was spent; must be at most about {reached:.0} s for this loop"
    )]
    HorizonTooLong {
        /// The horizon [s].
        horizon: f64,
        /// How far the simulation came [s].
        reached: f64,
        /// The budget.
        cells: u64,
    },
    /// A requested time is outside 0 … horizon, or not a number.
    #[error("time {value} s is outside 0 to the horizon of {horizon} s")]
    TimeOutside {
        /// The time asked for [s].
        value: f64,
        /// The horizon [s].
        horizon: f64,
    },
}
