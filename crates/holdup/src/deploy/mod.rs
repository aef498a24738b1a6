//! What to run or to type: the numbers for a vendor's controller block.

pub mod conversion;
mod vendors;
