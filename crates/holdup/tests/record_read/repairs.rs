//! Every repair is done, and reported with its row count.

use holdup::record::{ReadOptions, Reading, RepairKind, read_bytes};

use crate::sample::{ROWS, Style, iso, record};

fn read(text: &str) -> Reading {
    read_bytes(text.as_bytes(), &ReadOptions::default()).unwrap()
}

/// The repairs, without those that only say how times were read.
fn repairs(reading: &Reading) -> Vec<(RepairKind, usize)> {
    let told = |kind| kind != RepairKind::TimeUnitAssumed;
    reading
        .repairs
        .iter()
        .filter(|repair| told(repair.kind))
        .map(|repair| (repair.kind, repair.rows))
        .collect()
}

fn lines() -> Vec<String> {
    Style::PLAIN.text().lines().map(str::to_owned).collect()
}

#[test]
fn repairs_that_lose_nothing_give_the_same_record() {
    let mut newest_first = lines();
    newest_first[1..].reverse();
    let mut shuffled = lines();
    shuffled.swap(3, 4);
    let mut twice = lines();
    twice.insert(7, twice[6].clone());
    twice.insert(20, twice[19].clone());
    let mut commented = lines();
    commented.insert(9, "# somebody's note".to_owned());
    commented.insert(12, ",,,,".to_owned());
    let mut footer = lines();
    footer.push("End of export,,,,".to_owned());
    let mut sparse = lines();
    for row in (2..sparse.len()).filter(|row| *row != 18) {
        let mut cells: Vec<String> = sparse[row].split(',').map(str::to_owned).collect();
        cells[3].clear();
        if row != 26 {
            cells[1].clear();
        }
        sparse[row] = cells.join(",");
    }
    let rewritten = |lines: Vec<String>| lines.join("\n");
    for (name, text, expected) in [
        ("plain", rewritten(lines()), vec![]),
        ("newest first", rewritten(newest_first), vec![(RepairKind::NewestFirst, ROWS)]),
        ("out of order", rewritten(shuffled), vec![(RepairKind::OutOfOrder, 1)]),
        ("twice", rewritten(twice), vec![(RepairKind::IdenticalRows, 2)]),
        ("comments", rewritten(commented), vec![(RepairKind::CommentLines, 1), (RepairKind::EmptyRows, 1)]),
        ("footer", rewritten(footer), vec![(RepairKind::NoTime, 1)]),
        (
            "on change",
            rewritten(sparse),
            vec![(RepairKind::HeldValues, ROWS - 2), (RepairKind::HeldValues, ROWS - 3)],
        ),
    ] {
        let reading = read(&text);
        assert_eq!(repairs(&reading), expected, "{name}: {:?}", reading.repairs);
        assert_eq!(reading.record, record(), "{name}");
    }
}

#[test]
fn cells_without_a_value_leave_their_row_out_and_are_named() {
    for word in [
        "",
        "NULL",
        "Bad",
        "No Data",
        "I/O Timeout",
        "#N/A",
        "[-11059] No Good Data For Calculation",
        "nan",
        "inf",
        "--",
    ] {
        let mut lines = lines();
        for row in [4, 11] {
            let cells: Vec<&str> = lines[row].split(',').collect();
            lines[row] = [cells[0], cells[1], word, cells[3], cells[4]].join(",");
        }
        let reading = read(&lines.join("\n"));
        assert_eq!(repairs(&reading), [(RepairKind::NoValue, 2)], "{word}");
        assert_eq!(reading.record.len(), ROWS - 2, "{word}");
        let text = &reading.repairs[0].text;
        assert!(text.contains("pv") && text.contains(if word.is_empty() { "empty" } else { word }), "{text}");
    }
}

#[test]
fn rows_of_bad_quality_are_left_out() {
    for (name, good, bad) in [("PV quality", "Good", "Bad - comm failure"), ("pv.Status", "192", "24")] {
        let mut lines = lines();
        lines[0] += &format!(",{name}");
        for (row, line) in lines.iter_mut().enumerate().skip(1) {
            *line += &format!(",{}", if row % 10 == 3 { bad } else { good });
        }
        let reading = read(&lines.join("\n"));
        assert_eq!(repairs(&reading), [(RepairKind::BadQuality, 4)], "{name}");
        assert_eq!(reading.found.columns[5].used_as, Some("quality"));
    }
}

#[test]
fn a_corrected_row_replaces_the_first_and_is_reported() {
    let mut lines = lines();
    let cells: Vec<&str> = lines[6].split(',').collect();
    let corrected = [cells[0], cells[1], "99", cells[3], cells[4]].join(",");
    lines.insert(7, corrected);
    let reading = read(&lines.join("\n"));
    assert_eq!(repairs(&reading), [(RepairKind::SameTime, 1)]);
    assert_eq!(reading.record.controlled_variable()[5], 99.0);
}

#[test]
fn minutes_without_seconds_are_spread_evenly() {
    let text = Style { time: |row| iso(row)[..16].to_owned(), ..Style::PLAIN }.text();
    let reading = read(&text);
    assert_eq!(repairs(&reading), [(RepairKind::CoarseClock, ROWS)]);
    assert_eq!(reading.record.time(), record().time());
}

#[test]
fn the_end_of_summer_time_and_its_start_are_reported() {
    // Central Europe 2024: back on 27 October at 03:00, forward on 31 March at 02:00.
    let wall = |day: &'static str, shift: i64| {
        let row = move |k: i64| {
            let seconds = 2 * 3600 - 600 + k * 20;
            let seconds = if shift < 0 && seconds >= 3 * 3600 { seconds - 3600 } else { seconds };
            let seconds = if shift > 0 && seconds >= 2 * 3600 { seconds + 3600 } else { seconds };
            format!(
                "2024-{day} {:02}:{:02}:{:02},5{},20",
                seconds / 3600,
                seconds / 60 % 60,
                seconds % 60,
                k % 10
            )
        };
        "time,pv,op\n".to_owned() + &(0..400).map(row).collect::<Vec<_>>().join("\n")
    };
    let back = read(&wall("10-27", -1));
    assert_eq!(repairs(&back), [(RepairKind::ClockBack, 190)]);
    assert!(back.record.time().windows(2).all(|pair| pair[1] - pair[0] == 20.0));
    let forward = read(&wall("03-31", 1));
    assert_eq!(repairs(&forward), [(RepairKind::ClockForward, 1)]);
    assert!(forward.record.time().windows(2).any(|pair| pair[1] - pair[0] == 3620.0));
}

#[test]
fn what_is_assumed_is_said() {
    let day = |k: usize| format!("0{}/02/2024 12:00:00,5{k},20", k % 9 + 1);
    let text = "time,pv,op\n".to_owned()
        + &[day(3), day(3).replace("12:00:00", "12:00:10"), day(3).replace("12:00:00", "12:00:20")]
            .join("\n");
    let reading = read(&text);
    assert_eq!(repairs(&reading), [(RepairKind::DateOrderAssumed, 3)]);
    assert!(reading.repairs[0].text.contains("--date-order"));
    let reading = read("t;pv;op\n0;45,123;20\n1;45,124;20\n2;45,125;20\n");
    assert!(reading.repairs.iter().any(|repair| repair.kind == RepairKind::DecimalMarkAssumed));
    assert!(
        reading
            .repairs
            .iter()
            .any(|repair| repair.kind == RepairKind::TimeUnitAssumed && repair.text.contains("--time-unit"))
    );
    let midnight = read("time,pv,op\n23:59:40,1,2\n23:59:50,1,2\n00:00:00,1,2\n00:00:10,1,3\n");
    assert_eq!(midnight.record.time(), [0.0, 10.0, 20.0, 30.0]);
    assert_eq!(repairs(&midnight), [(RepairKind::MidnightPassed, 1)]);
}
