//! holdup designs, proves and simulates control loops of integrating processes with dead time.

pub mod analysis;
pub mod model;
pub mod study;
pub mod tuning;
