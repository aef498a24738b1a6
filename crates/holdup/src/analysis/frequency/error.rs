//! What keeps a loop from being analysed.

use thiserror::Error;

/// The numbers of the loop are out of the reach of double precision.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum FrequencyError {
    /// A coefficient of the characteristic equation overflows, underflows or is not a number.
    #[error("{quantity} is {value:e}: the frequency analysis reaches from 1e-100 to 1e100")]
    OutOfReach {
        /// Which quantity, time counted in dead times of the process.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// The loop has more states, or more delayed signals, than the determinant is expanded for.
    #[error("the loop has {states} states and {channels} delays: the frequency analysis takes 15 and 4")]
    TooLarge {
        /// Number of states.
        states: usize,
        /// Number of delayed signals.
        channels: usize,
    },
    /// A sampled loop has more samples in a dead time than it is analysed for.
    #[error("the dead time has {samples:.0} samples: the frequency analysis of a sampled loop takes {most}")]
    TooManySamples {
        /// Samples in the dead time.
        samples: f64,
        /// How many it may have.
        most: u32,
    },
}
