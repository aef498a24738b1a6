//! Exports with one row a reading of a tag hold the same record.

use std::fmt::Write as _;

use holdup::record::{Operation, ReadOptions, Reading, RepairKind, read_bytes};
use proptest::prelude::*;

use crate::sample::{ROWS, comma, iso, manipulated, operation, point, record, seconds, setpoint};

fn read(text: &str) -> Reading {
    read_bytes(text.as_bytes(), &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn repairs(reading: &Reading) -> Vec<(RepairKind, usize)> {
    reading.repairs.iter().map(|repair| (repair.kind, repair.rows)).collect()
}

/// A reading: row of the sample whose time it has, tag, value.
type Row = (usize, String, String);

/// All readings of the sample: PV in each row, the others where they change.
fn changes(number: fn(f64) -> String, tag: &str) -> Vec<Row> {
    let mut rows = Vec::new();
    for row in 0..ROWS {
        let mut add = |name: &str, value: String| rows.push((row, format!("{tag}{name}"), value));
        add("PV", number(crate::sample::controlled(row)));
        let new = |of: &dyn Fn(usize) -> bool| row == 0 || of(row);
        if new(&|row| manipulated(row) != manipulated(row - 1)) {
            add("OP", number(manipulated(row)));
        }
        if new(&|row| setpoint(row) != setpoint(row - 1)) {
            add("SP", number(setpoint(row)));
        }
        if new(&|row| operation(row) != operation(row - 1)) {
            add("MODE", if operation(row) == Operation::Automatic { "AUTO" } else { "MAN" }.to_owned());
        }
    }
    rows
}

fn text(heading: &str, between: &str, rows: &[Row], state: &str) -> String {
    let mut text = format!("{heading}\n");
    for (row, tag, value) in rows {
        _ = write!(text, "{}{between}{tag}{between}{value}", iso(*row));
        if !state.is_empty() {
            _ = write!(text, "{between}{state}");
        }
        text.push('\n');
    }
    text
}

/// What is held, as the sample has it: OP changes once, SP once, MODE twice.
const HELD: [(RepairKind, usize); 4] = [
    (RepairKind::HeldValues, ROWS - 2),
    (RepairKind::HeldValues, ROWS - 2),
    (RepairKind::HeldValues, ROWS - 3),
    (RepairKind::PutTogether, ROWS + 2 + 2 + 3),
];

#[test]
fn every_arrangement_of_the_readings_holds_the_same_record() {
    let plain = changes(point, "LIC205.");
    let mut by_tag = plain.clone();
    by_tag.sort_by(|a, b| a.1.cmp(&b.1));
    let reversed = |rows: &[Row]| rows.iter().rev().cloned().collect::<Vec<Row>>();
    let german = changes(comma, "2411LIC30501.");
    for (name, file, more) in [
        ("by time", text("Timestamp;Tag;Value;Status", ";", &plain, "Good"), None),
        ("by tag", text("Timestamp,TagName,Value", ",", &by_tag, ""), None),
        ("AspenTech", text("TS\tNAME\tVALUE\tSTATUS", "\t", &plain, "Good"), None),
        ("Ignition", text("t_stamp,tagpath,value,quality", ",", &plain, "192"), None),
        ("decimal commas", text("Zeit;Messstelle;Wert", ";", &german, ""), None),
        ("newest first", text("time;point;value", ";", &reversed(&plain), ""), Some(RepairKind::NewestFirst)),
        (
            "newest first by tag",
            text("time;point;value", ";", &reversed(&by_tag), ""),
            Some(RepairKind::NewestFirst),
        ),
    ] {
        let reading = read(&file);
        assert_eq!(reading.record, record(), "{name}: {:?}", reading.repairs);
        let mut expected: Vec<(RepairKind, usize)> =
            more.map(|kind| (kind, plain.len())).into_iter().collect();
        expected.extend(HELD);
        assert_eq!(repairs(&reading), expected, "{name}");
        assert_eq!(reading.found.layout, "readings");
        assert_eq!((reading.found.rows, reading.found.rows_in_file), (ROWS, plain.len()), "{name}");
        let role = |tag: &str| {
            let column = reading.found.columns.iter().find(|column| column.name.ends_with(tag));
            column.and_then(|column| column.used_as)
        };
        assert_eq!([role("PV"), role("MODE")], [Some("controlled_variable"), Some("mode")], "{name}");
    }
}

#[test]
fn bad_readings_are_left_out_and_what_was_good_before_is_held() {
    let rows = changes(point, "L.");
    // Between the rows of PV: an OP marked as bad, an OP that is no number, and one that is good.
    let mut file = text("Timestamp;Tag;Value;Status", ";", &rows, "Good");
    file += "2024-01-31 13:05:03;L.OP;77;Bad\n2024-01-31 13:05:04;L.OP;No Data;Good\n";
    file += "2024-01-31 13:05:05;L.OP;20.25;Good\n2024-01-31 13:05:06;L.OP;20.5;Good\n";
    file += "2024-01-31 13:05:20;L.PV;99;Bad\n";
    let reading = read(&file);
    let expected = [
        vec![(RepairKind::BadQuality, 2), (RepairKind::OutOfOrder, 3), (RepairKind::NoValue, 1)],
        vec![(RepairKind::HeldValues, ROWS - 2), (RepairKind::BetweenRows, 1)],
        vec![(RepairKind::HeldValues, ROWS - 2), (RepairKind::HeldValues, ROWS - 3)],
        vec![(RepairKind::PutTogether, ROWS + 4 + 2 + 3)],
    ]
    .concat();
    assert_eq!(repairs(&reading), expected, "{:?}", reading.repairs);
    assert_eq!(reading.record, record());
}

#[test]
fn rows_before_the_first_reading_of_the_output_are_left_out_and_counted() {
    let mut file = "time,tag,value\n".to_owned();
    for row in 0..ROWS {
        file += &format!("{},L.PV,{}\n", iso(row), row % 7);
        if row >= 3 {
            file += &format!("{},L.OP,{}\n", iso(row), row % 5);
        }
    }
    let reading = read(&file);
    assert_eq!(repairs(&reading), [(RepairKind::NoValue, 3), (RepairKind::PutTogether, ROWS + ROWS - 3)]);
    assert_eq!(reading.record.len(), ROWS - 3);
    assert_eq!(reading.record.time()[0], 0.0);
    assert_eq!(reading.record.manipulated_variable()[0], 3.0);
}

/// The hour that the clock repeats in autumn, the tags by time and tag by tag.
#[test]
fn a_clock_that_goes_back_is_undone_for_all_tags() {
    let wall = |k: usize| {
        let seconds = 2 * 3600 - 600 + k * 20;
        let seconds = if seconds >= 3 * 3600 { seconds - 3600 } else { seconds };
        format!("2024-10-27 {:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60)
    };
    let mut file = "Timestamp;Tag;Value\n".to_owned();
    for k in 0..400 {
        file += &format!("{};L.PV;{}\n", wall(k), 50 + k % 10);
        if k % 50 == 0 {
            file += &format!("{};L.OP;{k}\n", wall(k));
        }
    }
    let reading = read(&file);
    assert!(reading.record.time().windows(2).all(|pair| pair[1] - pair[0] == 20.0), "{:?}", reading.repairs);
    let held: Vec<f64> = (0..400_u32).map(|k| f64::from(k / 50 * 50)).collect();
    assert_eq!(reading.record.manipulated_variable(), held);
    assert_eq!(reading.repairs[0].kind, RepairKind::ClockBack);
}

#[test]
fn two_loops_in_one_file_are_listed_and_named_by_their_tags() {
    let mut rows = changes(point, "LIC205.");
    rows.extend(changes(point, "TIC7.").into_iter().map(|(row, tag, value)| {
        let value = if tag.ends_with("PV") { "33".to_owned() } else { value };
        (row, tag, value)
    }));
    rows.sort_by_key(|(row, ..)| *row);
    let file = text("Timestamp;Tag;Value;Status", ";", &rows, "Good");
    let error = read_bytes(file.as_bytes(), &ReadOptions::default()).unwrap_err().to_string();
    assert_eq!(
        error,
        "several tags may be the controlled variable: 'LIC205.PV', 'TIC7.PV'; name one with --pv"
    );
    let named =
        |name: &str| ReadOptions { controlled_variable: Some(name.to_owned()), ..ReadOptions::default() };
    let reading = read_bytes(file.as_bytes(), &named("lic205.pv")).unwrap();
    assert_eq!(reading.record, record());
    let error = read_bytes(file.as_bytes(), &named("LIC206.PV")).unwrap_err().to_string();
    for part in [
        "--pv: no tag LIC206.PV",
        "did you mean 'LIC205.PV'?",
        "tags: 'LIC205.PV', 'LIC205.OP'",
        "'TIC7.MODE'",
    ] {
        assert!(error.contains(part), "{error}");
    }
    assert!(!error.contains("Timestamp"), "{error}");
}

#[test]
fn tags_whose_names_say_nothing_are_listed_and_can_be_named() {
    let file = text(
        "Timestamp;Tag;Value",
        ";",
        &(0..ROWS)
            .flat_map(|row| {
                [
                    (row, "LT-205".to_owned(), point(seconds(row))),
                    (row, "FV-205".to_owned(), point(manipulated(row))),
                ]
            })
            .collect::<Vec<Row>>(),
        "",
    );
    let error = read_bytes(file.as_bytes(), &ReadOptions::default()).unwrap_err().to_string();
    assert_eq!(
        error,
        "no tag is known to be the controlled variable: name it with --pv; tags: 'LT-205', 'FV-205'"
    );
    let options = ReadOptions {
        controlled_variable: Some("LT-205".to_owned()),
        manipulated_variable: Some("fv-205".to_owned()),
        ..ReadOptions::default()
    };
    let reading = read_bytes(file.as_bytes(), &options).unwrap();
    assert_eq!(reading.record.controlled_variable(), record().time());
    assert_eq!(repairs(&reading), [(RepairKind::PutTogether, 2 * ROWS)]);
    let period = ReadOptions { sample_period: Some(1.0), ..options };
    let error = read_bytes(file.as_bytes(), &period).unwrap_err().to_string();
    assert!(error.contains("--sample-period: 1 s must be absent"), "{error}");
}

proptest! {
    #[test]
    fn a_damaged_export_is_read_or_refused_in_one_line(
        at in 0_usize..2500, with in prop::collection::vec(any::<u8>(), 0..20), cut in 0_usize..60,
    ) {
        let mut bytes = text("Timestamp;Tag;Value;Status", ";", &changes(point, "LIC205."), "Good").into_bytes();
        let at = at.min(bytes.len());
        let end = (at + cut).min(bytes.len());
        bytes.splice(at..end, with);
        match read_bytes(&bytes, &ReadOptions::default()) {
            Ok(reading) => {
                let time = reading.record.time();
                prop_assert!(time.windows(2).all(|pair| pair[1] > pair[0]));
                // A damaged tag is another tag, a damaged stamp another time: no more rows than readings.
                prop_assert!(reading.record.len() <= reading.found.rows_in_file);
            }
            Err(error) => prop_assert!(!error.to_string().contains(['\n', '\r']), "{}", error),
        }
    }

    /// Tags with times of their own, in any order of the tags at one time: each row has what was last written.
    #[test]
    fn the_last_value_before_each_row_is_held(
        steps in prop::collection::vec((1_i64..40, prop::collection::vec(0_usize..3, 1..4)), 5..60),
        comma in any::<bool>(), reversed in any::<bool>(), crlf in any::<bool>(),
    ) {
        let names = ["LIC1.PV", "LIC1.OP", "LIC1.SP"];
        let (mut now, mut last) = (1_706_706_300_i64, [None::<f64>; 3]);
        let (mut lines, mut rows) = (Vec::new(), Vec::new());
        let mut number = 0.0;
        for (step, tags) in &steps {
            now += step;
            let mut written = [false; 3];
            for &tag in tags.iter().filter(|tag| !std::mem::replace(&mut written[**tag], true)) {
                number += 1.25;
                last[tag] = Some(number);
                let value = if comma { number.to_string().replace('.', ",") } else { number.to_string() };
                lines.push(format!("{now};{};{value}", names[tag]));
            }
            if written[0] && last[1].is_some() {
                rows.push((now, last));
            }
        }
        if reversed {
            lines.reverse();
        }
        lines.insert(0, "epoch;tag;value".to_owned());
        let text = lines.join(if crlf { "\r\n" } else { "\n" });
        match read_bytes(text.as_bytes(), &ReadOptions::default()) {
            Ok(reading) => {
                let values = |tag: usize| rows.iter().map(|(_, last)| last[tag].unwrap()).collect::<Vec<f64>>();
                prop_assert_eq!(reading.record.controlled_variable(), values(0));
                prop_assert_eq!(reading.record.manipulated_variable(), values(1));
                if let Some(found) = reading.record.setpoint() {
                    let first = rows.iter().find_map(|(_, last)| last[2]);
                    for (found, (_, last)) in found.iter().zip(&rows) {
                        prop_assert!(last[2].is_none_or(|last| last == *found), "{:?}", first);
                    }
                }
                let zero = rows[0].0;
                for (time, (instant, _)) in reading.record.time().iter().zip(&rows) {
                    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
                    let expected = (instant - zero) as f64;
                    prop_assert_eq!(*time, expected);
                }
            }
            Err(error) => {
                let absent = |tag: usize| !lines.iter().any(|line| line.contains(names[tag]));
                prop_assert!(rows.len() < 3 || absent(0) || absent(1), "{}\n{}", error, text);
            }
        }
    }
}
