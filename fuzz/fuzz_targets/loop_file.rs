#![no_main]
//! `cargo +nightly fuzz run loop_file`: what is read is written and read back the same; errors are one line.

use holdup::model::loop_file::{read_loop, write_loop};

libfuzzer_sys::fuzz_target!(|text: &str| match read_loop(text) {
    Ok((process, controller)) => {
        assert_eq!(read_loop(&write_loop(&process, &controller)), Ok((process, controller)));
    }
    Err(error) => assert!(!error.to_string().contains('\n')),
});
