//! The worst sensitivity peak of a family of processes, with proof.
//!
//! A factor k on the gain and a factor δ on the dead time of the process turn the loop L into
//! `k·e^(−jω(δ − 1)d)·L(jω)`: at one frequency the family is a sector of an annulus, whose distance from −1 is closed
//! form. Only the frequency is left to be searched, by branch and bound: a band is discarded when the distance is proven
//! to stay above the least one found. The worst case may lie on an edge of the box or inside it, not in a corner.
//!
//! A sensitivity peak is finite for an unstable loop, too. The verdict comes from zero exclusion: one member is
//! stable by the argument principle, and no member of the connected family has a pole on the imaginary axis. For neutral
//! loops that needs k·|L(j∞)| < 1 for the greatest k.

mod faces;
mod search;
mod sector;
mod shape;

pub use search::{Goal, Member, WorstCase, worst_case};
pub(crate) use sector::Sector;
pub use shape::{Family, FamilyError};
