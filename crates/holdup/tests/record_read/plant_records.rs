//! Real records, which lie beside the project and are never part of it.

use std::path::PathBuf;

use holdup::record::{Operation, ReadOptions, Reading, RepairKind, read};

/// The folder of the records; a message where it is absent.
fn data(name: &str) -> Option<PathBuf> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data")).join(name);
    if !path.exists() {
        eprintln!("SKIPPED: {} is absent", path.display());
        return None;
    }
    Some(path)
}

fn reading(name: &str, options: &ReadOptions) -> Option<Reading> {
    data(name).map(|path| read(&path, options).unwrap_or_else(|error| panic!("{name}: {error}")))
}

fn named(pv: &str, op: &str) -> ReadOptions {
    ReadOptions {
        controlled_variable: Some(pv.to_owned()),
        manipulated_variable: Some(op.to_owned()),
        ..ReadOptions::default()
    }
}

fn even(reading: &Reading, period: f64) -> bool {
    reading.record.time().windows(2).all(|pair| pair[1] - pair[0] == period)
}

#[test]
fn the_export_of_the_historian_is_the_same_record_as_its_table() {
    let none = ReadOptions::default();
    let (Some(table), Some(export)) =
        (reading("level-d205.csv", &none), reading("level-d205-historian-export.txt", &none))
    else {
        return;
    };
    assert_eq!(table.repairs, []);
    assert_eq!((table.record.len(), export.record.len()), (751, 751));
    assert_eq!(table.record.time(), export.record.time());
    assert_eq!(table.record.operation(), export.record.operation());
    // The table was rounded to five decimals, and 1e-9 is rounding.
    let near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 0.5e-5 + 1e-9);
    assert!(near(table.record.controlled_variable(), export.record.controlled_variable()));
    assert!(near(table.record.manipulated_variable(), export.record.manipulated_variable()));
    assert!(near(table.record.setpoint().unwrap(), export.record.setpoint().unwrap()));
    assert_eq!(export.found.start.as_deref(), Some("2024-10-18T21:55:00"));
    assert_eq!(
        export.repairs.iter().map(|repair| (repair.kind, repair.rows)).collect::<Vec<_>>(),
        [(RepairKind::SkippedLines, 4)]
    );
    assert!(even(&table, 10.0));
    assert!(table.record.operation().unwrap().iter().all(|operation| *operation == Operation::Automatic));
}

#[test]
fn the_other_loops_are_read_without_repairs() {
    for name in ["level-oscillating.csv", "level-quiet.csv", "flow-stiction.csv"] {
        let Some(reading) = reading(name, &ReadOptions::default()) else { return };
        assert_eq!((reading.repairs.len(), reading.record.len()), (0, 751), "{name}");
        assert!(even(&reading, 10.0), "{name}");
    }
}

#[test]
fn the_rigs_are_read_by_their_names() {
    let none = ReadOptions::default();
    if let Some(lab) = reading("tclab-step.csv", &none) {
        assert_eq!(lab.record.len(), 571);
        assert_eq!(lab.record.time()[570], 572.14);
        assert_eq!(lab.record.manipulated_variable()[570], 150.0);
        assert_eq!(lab.record.controlled_variable()[0], 299.53);
    }
    if let Some(rig) = reading("labvolt-level.csv", &none) {
        assert_eq!(rig.record.len(), 711);
        assert_eq!(rig.record.controlled_variable()[0], 384.257_638_683_785_8);
        assert!(even(&rig, 10.0));
    }
    let tanks = ReadOptions { sample_period: Some(4.0), ..named("yEst", "uEst") };
    if let Some(tanks) = reading("cascaded-tanks.csv", &tanks) {
        assert_eq!(tanks.record.len(), 1024);
        assert!(even(&tanks, 4.0));
    }
}

#[test]
fn the_newest_row_first_is_reversed() {
    let Some(reading) = reading("newest-first.csv", &named("LV_106", "FT_115")) else { return };
    assert_eq!(
        reading.repairs.iter().map(|repair| repair.kind).collect::<Vec<_>>(),
        [RepairKind::NewestFirst]
    );
    assert_eq!(reading.found.start.as_deref(), Some("2024-11-27T19:01:00"));
    assert!(even(&reading, 60.0));
    assert_eq!(reading.record.controlled_variable()[reading.record.len() - 1], 44.980_697_631_835_9);
}

#[test]
fn a_plant_of_many_loops_asks_which_one() {
    let Some(path) = data("tennessee-eastman-normal.csv") else { return };
    let error = read(&path, &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("x12_sep_level") && error.contains("--pv"), "{error}");
    let reading = read(&path, &named("x12_sep_level", "mv7_sep_valve")).unwrap();
    assert_eq!(reading.record.len(), 960);
    assert!(even(&reading, 180.0));
}
