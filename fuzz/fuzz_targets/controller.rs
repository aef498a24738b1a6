#![no_main]
//! `cargo +nightly fuzz run controller`: whatever comes in, the output is finite and within its limits.

#[path = "../drive/controller.rs"]
mod controller;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    controller::drive(data);
});
