//! The corpora of the fuzz targets, replayed: every text is read or refused in one line, and what is read comes
//! back as it was written.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use std::path::Path;

use holdup::model::events::read_events;
use holdup::model::loop_file::{read_loop, write_loop};
use holdup::model::notation::{read_controller, read_process, write_controller, write_process};
use holdup::record::{ReadOptions, Survey, read_bytes};
use holdup::study::read_study;

/// Calls `check` with every file of a corpus.
fn replay_bytes(target: &str, check: impl Fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus").join(target);
    let files: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    assert!(files.len() >= 5, "{files:?}");
    for file in files {
        check(&std::fs::read(file).unwrap());
    }
}

/// Calls `check` with every text of a corpus.
fn replay(target: &str, check: impl Fn(&str)) {
    replay_bytes(target, |bytes| {
        if let Ok(text) = std::str::from_utf8(bytes) {
            check(text);
        }
    });
}

fn one_line(error: &impl ToString) {
    let line = error.to_string();
    assert!(!line.is_empty() && !line.contains(['\n', '\r']), "{line}");
}

#[test]
fn study_files_are_read_or_refused_in_one_line() {
    replay("study_file", |text| {
        read_study(text)
            .map_or_else(|error| one_line(&error), |study| assert!(!study.controllers.is_empty()));
    });
}

#[test]
fn loop_files_come_back_as_they_were_written() {
    replay("loop_file", |text| match read_loop(text) {
        Ok(read) => assert_eq!(read_loop(&write_loop(&read.0, &read.1)), Ok(read)),
        Err(error) => one_line(&error),
    });
}

#[test]
fn compact_strings_come_back_as_they_were_written() {
    replay("compact_strings", |text| {
        match read_process(text) {
            Ok(process) => assert_eq!(read_process(&write_process(&process)), Ok(process)),
            Err(error) => one_line(&error),
        }
        match read_controller(text) {
            Ok(controller) => assert_eq!(read_controller(&write_controller(&controller)), Ok(controller)),
            Err(error) => one_line(&error),
        }
        if let Err(error) = read_events("--setpoint", text) {
            one_line(&error);
        }
    });
}

#[test]
fn records_are_read_and_looked_at_or_refused_in_one_line() {
    replay_bytes("record", |bytes| match read_bytes(bytes, &ReadOptions::default()) {
        Ok(reading) => assert!(!Survey::of(&reading.record).text().is_empty()),
        Err(error) => one_line(&error),
    });
}
