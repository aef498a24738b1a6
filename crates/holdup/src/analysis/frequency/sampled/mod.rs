//! What a sampled loop achieves: exact margins on |ω| ≤ π/h, of the law as `holdup-control` computes it, with hold and
//! fractional dead time.
//!
//! The loop is a quotient of polynomials in z; nothing in it is approximated. Crossings and peaks on the half circle
//! are isolated by the proofs that serve the continuous loop, and the stability verdict is the argument principle. The
//! dead time of the process varies exactly too: [`Margins::delay_margin`] is the one at which the sampled loop,
//! computed anew for that dead time, loses its stability.

mod circle;
mod delay;
mod margins;
mod period;
mod pulse;
mod winding;

pub(crate) use margins::is_stable;
pub use margins::{SampledMargins, sampled_margins};
pub(crate) use period::largest_stable_period;
pub use period::{LargestPeriod, PeriodError, largest_sample_period};

#[cfg(doc)]
use super::Margins;
