//! Identification on generated plants of every kind: the truth is known, and the plant is written without the library.
#![expect(clippy::unwrap_used, reason = "a test stops where a value is missing")]

mod controllers;
mod diagnosis;
mod load_steps;
mod plant;
mod processes;
mod refusals;
mod scaling;
