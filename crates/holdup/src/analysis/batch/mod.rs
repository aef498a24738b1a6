//! Many loops at once: slices of processes or controllers in, arrays of metrics or margins out, on all cores.
//!
//! The results do not depend on the number of threads, nor, but for the last digits where it is said, on what else is in
//! the slice.
//!
//! [`over_processes`] and [`over_controllers`] simulate each loop. [`integrals_over_processes`] and
//! [`integrals_over_controllers`] find the four integrals alone, eight loops in a vector where the same happens to them in
//! the same order; which loops go together depends on the slice, and with it the last digits. [`margins_of_processes`] and
//! [`margins_of_controllers`] find the margins of the plain shapes in vector lanes (with
//! [`robustness_of_processes`] and [`robustness_of_controllers`] the complementary sensitivity peak beside them), on the instruction set of the machine
//! that runs them, and give an answer only where it is proven to be that of the exact analysis; the others are analysed
//! one by one.

#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the instruction set chosen at run time"
)]
#![expect(
    clippy::needless_bitwise_bool,
    reason = "a lazy operator is a branch, and branches keep loops from being vectors"
)]

mod crossovers;
mod form;
mod integrals;
mod kernel;
mod lanes;
mod margins;
mod mesh;
mod peak;
mod response;

pub use integrals::{integrals_over_controllers, integrals_over_processes};
pub use margins::{
    ManyMargins, Robustness, margins_of, margins_of_controllers, margins_of_processes,
    robustness_of_controllers, robustness_of_processes,
};
pub use response::{over_controllers, over_processes};
