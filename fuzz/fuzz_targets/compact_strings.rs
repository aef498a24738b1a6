#![no_main]
//! `cargo +nightly fuzz run compact_strings`: what is read is written and read back the same; errors are one line.

use holdup::model::notation::{read_controller, read_process, write_controller, write_process};

libfuzzer_sys::fuzz_target!(|text: &str| {
    match read_process(text) {
        Ok(process) => assert_eq!(read_process(&write_process(&process)), Ok(process)),
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
    match read_controller(text) {
        Ok(controller) => assert_eq!(read_controller(&write_controller(&controller)), Ok(controller)),
        Err(error) => assert!(!error.to_string().contains('\n')),
    }
    let _ = holdup::model::events::read_events("--setpoint", text);
});
