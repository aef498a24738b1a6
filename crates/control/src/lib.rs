//! Control laws that run in the plant.
#![no_std]
