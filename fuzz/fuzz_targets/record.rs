#![no_main]
//! `cargo +nightly fuzz run record`: no bytes make the reader or the survey panic or say more than a line, and what is
//! read is written and read back the same.

use holdup::record::{ReadOptions, Record, Survey, read_bytes};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| match read_bytes(bytes, &ReadOptions::default()) {
    Ok(reading) => {
        assert!(Survey::of(&reading.record).text().lines().all(|line| line.chars().count() <= 80));
        // Longer records hold times that differ by less than the reader tells apart.
        if reading.record.time().last().is_none_or(|last| *last > 1e5) {
            return;
        }
        let options = ReadOptions { time_unit: Some(1.0), ..ReadOptions::default() };
        let again = read_bytes(written(&reading.record).as_bytes(), &options).expect("what was written is read");
        assert_eq!(again.record.controlled_variable(), reading.record.controlled_variable());
    }
    Err(error) => assert!(!error.to_string().contains('\n')),
});

fn written(record: &Record) -> String {
    let rows = record.time().iter().zip(record.controlled_variable()).zip(record.manipulated_variable());
    let row = |((time, pv), op): ((&f64, &f64), &f64)| format!("{time},{pv:e},{op:e}\n");
    "time_s,pv,op\n".to_owned() + &rows.map(row).collect::<String>()
}
