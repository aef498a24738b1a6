//! The text of every language.

use holdup::deploy::export::{Float, LANGUAGES};
use holdup::model::notation::{read_process, write_process};

use crate::sources::{LOOPS, export};

#[test]
fn every_source_is_ascii_with_every_mark_filled_and_the_header_of_the_loop() {
    for float in [Float::Single, Float::Double] {
        for described in LOOPS {
            let (export, _) = export("level_d205", described, float);
            for language in &LANGUAGES {
                let source = language.write(&export);
                assert!(source.is_ascii(), "{}", language.id);
                let left = source.lines().find(|line| line.contains('@'));
                assert_eq!(left, None, "{}: {described:?}", language.id);
                assert!(source.ends_with('\n') && !source.contains(" \n"), "{}", language.id);
                let process = write_process(&read_process(described.0).unwrap());
                for part in ["level_d205", "gain margin", "delay margin", &process] {
                    assert!(source.contains(part), "{}: {part}", language.id);
                }
                assert!(source.lines().all(|line| line.len() <= 200 || language.id == "plcopen"));
            }
        }
    }
}
