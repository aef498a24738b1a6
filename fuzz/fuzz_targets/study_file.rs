#![no_main]
//! `cargo +nightly fuzz run study_file`: no text makes the reader of study files panic or say more than a line.

libfuzzer_sys::fuzz_target!(|text: &str| {
    if let Err(error) = holdup::study::read_study(text) {
        assert!(!error.to_string().contains('\n'));
    }
});
