//! What to run in the plant, or to type there: the controller as source code, the numbers for a vendor's block.

pub mod conversion;
pub mod export;
mod vendors;
