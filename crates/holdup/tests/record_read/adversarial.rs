//! What plants do to an export, all at once: the same record comes out, and every repair is counted.

use holdup::record::{ReadOptions, RepairKind, read_bytes};
use proptest::prelude::*;

/// Rows a minute apart: long enough for the hour that the clock repeats.
const ROWS: usize = 200;

/// How a file is written.
#[derive(Debug, Clone)]
#[expect(clippy::struct_excessive_bools, reason = "independent choices")]
struct Sheet {
    delimiter: char,
    comma: bool,
    thousands: bool,
    percent: bool,
    quoted_heading: bool,
    trailing: bool,
    end: &'static str,
    encoding: usize,
    clock: usize,
    autumn: bool,
    reversed: bool,
    units: bool,
    preamble: usize,
    footer: bool,
    bad: bool,
    gap: bool,
    twice: bool,
}

fn sheet() -> impl Strategy<Value = Sheet> {
    let text = (prop::sample::select(vec![',', ';', '\t', '|']), prop::array::uniform5(any::<bool>()));
    let file = (prop::sample::select(vec!["\n", "\r\n", "\r"]), 0_usize..5, 0_usize..6, 0_usize..4);
    (text, file, prop::array::uniform7(any::<bool>())).prop_map(
        |((delimiter, text), (end, encoding, clock, preamble), rows)| {
            let [comma, thousands, percent, quoted_heading, trailing] = text;
            let [autumn, reversed, units, footer, bad, gap, twice] = rows;
            Sheet {
                delimiter,
                comma,
                thousands,
                percent,
                quoted_heading,
                trailing,
                end,
                encoding,
                clock,
                autumn,
                reversed,
                units,
                preamble,
                footer,
                bad,
                gap,
                twice,
            }
        },
    )
}

fn level(row: usize) -> f64 {
    f64::from(u32::try_from(row * 37 % 400).unwrap()) / 16.0 + 10.0
}

fn valve(row: usize) -> f64 {
    if (row / 30).is_multiple_of(2) { 1234.5 } else { 20.25 }
}

/// Minutes after midnight on the wall: the clock goes from 3:00 back to 2:00.
fn wall(sheet: &Sheet, row: usize) -> usize {
    let minute = if sheet.autumn { 110 + row } else { 660 + row };
    if sheet.autumn && minute >= 180 { minute - 60 } else { minute }
}

impl Sheet {
    /// The cells of a time: the day is 27 October 2024, which can be read in one order only.
    fn time(&self, row: usize) -> Vec<String> {
        let minute = wall(self, row);
        let (hour, minute) = (minute / 60, minute % 60);
        let clock = format!("{hour:02}:{minute:02}:00");
        let half = if hour < 12 { "AM" } else { "PM" };
        let of_twelve = format!("{}:{minute:02}:00 {half}", (hour + 11) % 12 + 1);
        match self.clock {
            0 => vec![format!("2024-10-27 {clock}")],
            1 => vec!["2024-10-27".to_owned(), clock],
            2 => vec![format!("27.10.24 {clock}")],
            3 => vec![format!("10/27/2024 {of_twelve}")],
            4 => vec!["10/27/24".to_owned(), of_twelve],
            _ => vec![format!("27-Oct-24 {clock}")],
        }
    }

    fn number(&self, value: f64) -> String {
        let (point, thousand) = if self.comma { (",", ".") } else { (".", ",") };
        let (whole, fraction) = value.to_string().split_once('.').map_or_else(
            || (value.to_string(), String::new()),
            |(whole, fraction)| (whole.to_owned(), format!("{point}{fraction}")),
        );
        let whole = if self.thousands && whole.len() > 3 {
            format!("{}{thousand}{}", &whole[..whole.len() - 3], &whole[whole.len() - 3..])
        } else {
            whole
        };
        let text = format!("{whole}{fraction}{}", if self.percent { " %" } else { "" });
        if text.contains(self.delimiter) { format!("\"{text}\"") } else { text }
    }

    fn line(&self, cells: &[String]) -> String {
        let mut text = cells.join(&self.delimiter.to_string());
        if self.trailing {
            text.push(self.delimiter);
        }
        text
    }

    fn is_bad(&self, row: usize) -> bool {
        self.bad && row % 41 == 17
    }

    fn is_absent(&self, row: usize) -> bool {
        self.gap && (92..97).contains(&row)
    }

    fn is_twice(&self, row: usize) -> bool {
        self.twice && row % 53 == 20
    }

    fn rows(&self) -> Vec<usize> {
        (0..ROWS).filter(|row| !self.is_absent(*row)).collect()
    }

    fn text(&self) -> String {
        let timed = self.time(0).len() == 2;
        let names = if timed { vec!["Date", "Time"] } else { vec!["Timestamp"] };
        let own = |cells: [&'static str; 2]| [names.clone(), cells.to_vec()].concat();
        let mut heading: Vec<String> = own(["LIC7.PV", "LIC7.OP"]).into_iter().map(str::to_owned).collect();
        if self.quoted_heading {
            heading = heading.iter().map(|name| format!("\"{name}\"")).collect();
        }
        let mut lines: Vec<String> = ["Report of tank 7", "Plant: north", "Made by hand"][..self.preamble]
            .iter()
            .map(ToString::to_string)
            .collect();
        lines.push(self.line(&heading));
        if self.units {
            let blank = names.iter().map(|_| String::new());
            lines.push(self.line(&blank.chain(["%".to_owned(), "%".to_owned()]).collect::<Vec<_>>()));
        }
        let mut rows = Vec::new();
        for row in self.rows() {
            let level = if self.is_bad(row) { "Bad".to_owned() } else { self.number(level(row)) };
            let line = self.line(&[self.time(row), vec![level, self.number(valve(row))]].concat());
            if self.is_twice(row) {
                rows.push(line.clone());
            }
            rows.push(line);
        }
        if self.reversed {
            rows.reverse();
        }
        lines.extend(rows);
        if self.footer {
            lines.push("End of report".to_owned());
        }
        lines.join(self.end) + self.end
    }

    fn bytes(&self) -> Vec<u8> {
        let text = self.text();
        let wide = |mark: &[u8], of: fn(u16) -> [u8; 2]| {
            mark.iter().copied().chain(text.encode_utf16().flat_map(of)).collect()
        };
        match self.encoding {
            1 => [b"\xef\xbb\xbf", text.as_bytes()].concat(),
            2 => wide(b"\xff\xfe", u16::to_le_bytes),
            3 => wide(b"\xfe\xff", u16::to_be_bytes),
            4 => wide(b"", u16::to_le_bytes),
            _ => text.into_bytes(),
        }
    }

    /// The repairs that say what was changed, with their rows.
    fn repairs(&self) -> Vec<(RepairKind, usize)> {
        let rows = self.rows();
        let twice = rows.iter().filter(|row| self.is_twice(**row)).count();
        let bad = rows
            .iter()
            .map(|row| usize::from(self.is_bad(*row)) * (1 + usize::from(self.is_twice(*row))))
            .sum();
        let kept: Vec<usize> = rows.iter().copied().filter(|row| !self.is_bad(*row)).collect();
        let of = |row: &usize| 1 + usize::from(self.is_twice(*row));
        // Row 70 is the first after the clock went back.
        let moved = kept.iter().filter(|row| **row >= 70).map(of).sum();
        let all = kept.iter().map(of).sum();
        let mut expected = vec![
            (RepairKind::SkippedLines, self.preamble),
            (RepairKind::UnevenRows, usize::from(self.footer)),
            (RepairKind::NoTime, usize::from(self.footer)),
            (RepairKind::NoValue, bad),
            (RepairKind::NewestFirst, if self.reversed { all } else { 0 }),
            (RepairKind::ClockBack, if self.autumn { moved } else { 0 }),
            (RepairKind::IdenticalRows, twice),
        ];
        expected.retain(|(_, rows)| *rows > 0);
        expected
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, ..ProptestConfig::default() })]
    #[test]
    fn whatever_is_done_to_an_export_the_record_is_the_same_and_every_repair_is_counted(sheet in sheet()) {
        let bytes = sheet.bytes();
        let reading = read_bytes(&bytes, &ReadOptions::default());
        let reading = reading.map_err(|error| TestCaseError::fail(format!("{error}\n{}", &sheet.text()[..300])))?;
        let kept: Vec<usize> = sheet.rows().into_iter().filter(|row| !sheet.is_bad(*row)).collect();
        let minutes = |row: &usize| f64::from(u32::try_from(row - kept[0]).unwrap()) * 60.0;
        prop_assert_eq!(reading.record.time(), kept.iter().map(minutes).collect::<Vec<f64>>(), "{:?}", reading.repairs);
        let column = |of: fn(usize) -> f64| kept.iter().map(|row| of(*row)).collect::<Vec<f64>>();
        prop_assert_eq!(reading.record.controlled_variable(), column(level));
        prop_assert_eq!(reading.record.manipulated_variable(), column(valve));
        let repairs: Vec<(RepairKind, usize)> =
            reading.repairs.iter().map(|repair| (repair.kind, repair.rows)).collect();
        prop_assert_eq!(repairs, sheet.repairs(), "{:?}", reading.repairs);
    }
}
