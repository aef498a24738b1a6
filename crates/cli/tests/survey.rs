//! `holdup survey`: what was read, repaired and seen, and bad input in one line.

mod common;

use common::{folder, json, refused, run};
use serde_json::json;

/// A loop in automatic with a setpoint move, as an exporter with decimal commas writes it.
fn record(rows: usize) -> String {
    let row = |k: usize| {
        let setpoint = if k < rows / 2 { 50 } else { 52 };
        let (minute, second) = (k / 6 % 60, k % 6 * 10);
        let wiggle = (k * 37) % 64;
        format!(
            "31.01.2024 13:{minute:02}:{second:02};{setpoint};{setpoint},{wiggle:02};3{},5;AUTO\n",
            (k * 7) % 10
        )
    };
    "Zeit;Sollwert;Füllstand [%];Ventil [%];Betriebsart\n".to_owned()
        + &(0..rows).map(row).collect::<String>()
}

#[test]
fn it_says_what_was_read_repaired_and_seen_in_80_columns() {
    let folder = folder("survey");
    let path = folder.join("level.csv");
    std::fs::write(&path, record(120) + "Ende des Exports;;;;\n").unwrap();
    let file = path.to_str().unwrap();
    let output = run(&["survey", file]);
    let text = String::from_utf8(output.stdout).unwrap();
    for part in [
        "120 rows",
        "semicolon",
        "2024-01-31T13:00:00",
        "Ventil",
        "1 row without a readable time",
        "50 → 52 at 600 s",
    ] {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
    assert!(text.lines().skip(1).all(|line| line.chars().count() <= 80), "{text}");
    let found = json(&["survey", file]);
    assert_eq!(found["found"]["decimal_mark"], "comma");
    assert_eq!(
        found["found"]["columns"][2],
        json!({"number": 3, "name": "Füllstand", "unit": "%", "used_as": "controlled_variable"})
    );
    assert_eq!(found["repairs"][0]["kind"], "no-time");
    assert_eq!(found["repairs"][0]["rows"], 1);
    assert_eq!(found["survey"]["setpoint_moves"][0]["at_s"], 600.0);
    assert_eq!(found["survey"]["window"]["to"], 120);
    let part = json(&["survey", file, "--from", "13:05", "--to", "900"]);
    assert_eq!(part["given_window"], json!({"from": 30, "to": 91}));
    assert_eq!(part["survey"]["rows"], 61);
    for kind in ["svg", "png", "html"] {
        let picture = folder.join(format!("record.{kind}"));
        assert!(run(&["survey", file, "--plot", picture.to_str().unwrap()]).status.success());
        assert!(std::fs::metadata(&picture).unwrap().len() > 1000, "{kind}");
    }
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn each_fault_names_the_file_or_the_option() {
    let folder = folder("survey-faults");
    let path = folder.join("level.csv");
    std::fs::write(&path, record(60)).unwrap();
    let file = path.to_str().unwrap();
    for (words, parts) in [
        (&["--pv", "levl"][..], &["level.csv", "--pv", "levl", "3 'Füllstand [%]'"][..]),
        (&["--pv-span", "5"], &["--pv-span", "5", "low:high"]),
        (&["--pv-span", "5:5"], &["--pv-span", "5:5"]),
        (&["--time-unit", "week"], &["--time-unit", "week", "min"]),
        (&["--date-order", "dym"], &["--date-order", "dym", "dmy"]),
        (&["--decimal", "dot"], &["--decimal", "dot", "comma"]),
        (&["--from", "25:99"], &["--from", "25:99", "13:05"]),
        (&["--from", "500", "--to", "100"], &["--to", "100", "three rows"]),
        (&["--sample-period", "0"], &["--sample-period", "0"]),
        (&["--plot", "a.gif"], &["--plot", "a.gif"]),
    ] {
        let error = refused(&[&["survey", file], words].concat());
        for part in parts {
            assert!(error.contains(part), "{words:?}: {error}");
        }
    }
    let damaged = folder.join("damaged.parquet");
    std::fs::write(&damaged, b"PAR1 and nothing more").unwrap();
    assert!(refused(&["survey", damaged.to_str().unwrap()]).contains("damaged.parquet: is a Parquet file"));
    assert!(refused(&["survey", folder.to_str().unwrap()]).contains("folder"));
    assert!(refused(&["survey", "absent.csv"]).contains("absent.csv: cannot be read: no such file"));
    std::fs::remove_dir_all(folder).unwrap();
}
