//! Many loops at once: slices of processes or controllers in, arrays of metrics or margins out, on all cores.
//!
//! Every loop is answered by itself: the results do not depend on the number of threads, nor on what else is in the
//! slice.
//!
//! [`over_processes`] and [`over_controllers`] simulate each loop. [`margins_of_processes`] and
//! [`margins_of_controllers`] find the margins of the plain shapes in vector lanes, on the instruction set of the machine
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
mod kernel;
mod lanes;
mod margins;
mod mesh;
mod peak;
mod response;

pub use margins::{ManyMargins, Robustness, margins_of_controllers, margins_of_processes};
pub use response::{over_controllers, over_processes};
