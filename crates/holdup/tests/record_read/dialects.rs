//! Every way to write a record reads back to the same record.

use holdup::record::{DateOrder, ReadOptions, Record, read_bytes};
use proptest::prelude::*;

use crate::sample::{ROWS, START, Style, clock, comma, iso, manipulated, record, seconds};

fn local(row: usize, date: &str, half_days: bool) -> String {
    let (hour, minute, second) = clock(row);
    if half_days {
        format!("{date} {}:{minute:02}:{second:02} PM", hour - 12)
    } else {
        format!("{date} {hour:02}:{minute:02}:{second:02}")
    }
}

fn utf16(text: &str, mark: &[u8], bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    mark.iter().copied().chain(text.encode_utf16().flat_map(bytes)).collect()
}

/// The variants: name, bytes, options. All hold the same record.
#[expect(clippy::too_many_lines, reason = "a table")]
fn variants() -> Vec<(&'static str, Vec<u8>, ReadOptions)> {
    let none = ReadOptions::default;
    let plain = Style::PLAIN;
    let style = |name: &'static str, style: Style| (name, style.text().into_bytes(), none());
    let german = || Style {
        heading: "Zeit;Sollwert;Istwert;Stellwert;Betriebsart",
        between: ";",
        number: comma,
        ..Style::PLAIN
    };
    let text = plain.text();
    let named = |heading| Style { heading, ..Style::PLAIN };
    let timed = |time| Style { time, ..Style::PLAIN };
    let bare = |time: fn(usize) -> String| Style { heading: "t,sp,pv,op,mode", time, ..Style::PLAIN };
    let with = |name, style: Style, options| (name, style.text().into_bytes(), options);
    vec![
        style("plain", Style::PLAIN),
        style("semicolons, decimal comma", german()),
        style("tabs", Style { heading: "timestamp\tsp\tpv\top\tmode", between: "\t", ..Style::PLAIN }),
        style("pipes", Style { heading: "timestamp|sp|pv|op|mode", between: " | ", ..Style::PLAIN }),
        style(
            "blanks, date and time of day in two columns",
            Style { heading: "date time sp pv op mode", between: "  ", ..Style::PLAIN },
        ),
        style(
            "blanks, one name for date and time of day",
            Style { heading: "time   sp  pv  op  mode", between: "   ", ..Style::PLAIN },
        ),
        style("CRLF", Style { end: "\r\n", ..Style::PLAIN }),
        style("lone CR", Style { end: "\r", ..Style::PLAIN }),
        style(
            "trailing commas",
            Style { heading: "timestamp,sp,pv,op,mode,,", behind: ",,", ..Style::PLAIN },
        ),
        ("byte-order mark", [b"\xef\xbb\xbf", text.as_bytes()].concat(), none()),
        ("UTF-16 little-endian", utf16(&text, b"\xff\xfe", u16::to_le_bytes), none()),
        ("UTF-16 big-endian", utf16(&text, b"\xfe\xff", u16::to_be_bytes), none()),
        ("UTF-16 without mark", utf16(&text, b"", u16::to_le_bytes), none()),
        ("Latin-1 letters", [b"timestamp,sp,pv [\xb0C],op,mode\n", &text.as_bytes()[24..]].concat(), none()),
        style("quoted heading", named("\"timestamp\",\"sp\",\"pv\",\"op\",\"mode\"")),
        style("a line break in a quoted name", named("timestamp,sp,\"tank\nPV\",op,mode")),
        style(
            "quoted cells with decimal commas",
            Style { number: |value| format!("\"{}\"", comma(value)), ..Style::PLAIN },
        ),
        style("units in brackets", named("Time,Level SP [%],Level PV (%),Valve OP {%},Mode")),
        style("tags", named("Timestamp,2411LIC30501.SV,2411LIC30501.PV,2411LIC30501.MV,2411LIC30501.MODE")),
        style("tags with underscores", named("Timestamp,LIC101_SP,LIC101_PV,LIC101_OP,LIC101_MODE")),
        style("long names", named("DateTime,setPoint,ProcessValue,Controller Output,Auto/Man")),
        style("CV beside PV is the output", named("time,sp,pv,cv,mode")),
        style("CV beside MV is the controlled variable", named("time,sp,cv,mv,mode")),
        style("input and output of the process", named("time,reference,output,input,mode")),
        style("a row of units", named("timestamp,sp,pv,op,mode\n,%,m,%,-")),
        style(
            "lines before the heading",
            named("Historian export\nPlant: 7, Unit: 3\n\n# made at noon\ntimestamp,sp,pv,op,mode"),
        ),
        style("a commented heading", named("# a comment\n# timestamp,sp,pv,op,mode")),
        style(
            "two rows of names",
            named("tagname,L.SV,L.PV,L.MV,L.MODE\ndesc,tank sp,tank level,tank valve,auto"),
        ),
        style("T and Z", timed(|row| iso(row).replace(' ', "T") + "Z")),
        style("offset and fraction", timed(|row| iso(row) + ".000+01:00")),
        style("day first with slashes", timed(|row| local(row, "31/01/2024", false))),
        style("month first, short year, PM", timed(|row| local(row, "01/31/24", true))),
        style("day first with dots", timed(|row| local(row, "31.01.2024", false))),
        style("named month", timed(|row| local(row, "31-Jan-24", false))),
        style("no leading zeros", timed(|row| local(row, "1/31/2024", true))),
        style("fourteen digits", bare(|row| iso(row).replace(['-', ' ', ':'], ""))),
        style("seconds since 1970", bare(|row| (START + row * 10).to_string())),
        style("milliseconds since 1970", bare(|row| ((START + row * 10) * 1000).to_string())),
        style("microseconds since 1970", bare(|row| ((START + row * 10) * 1_000_000).to_string())),
        style("nanoseconds since 1970", bare(|row| ((START + row * 10) * 1_000_000_000).to_string())),
        style(
            "days of a spreadsheet",
            bare(|row| {
                #[expect(clippy::cast_precision_loss, reason = "small numbers")]
                let days = 25_569.0 + (START + row * 10) as f64 / 86_400.0;
                format!("{days:.8}")
            }),
        ),
        style("seconds", bare(|row| seconds(row).to_string())),
        style("seconds not from 0", bare(|row| format!("{:.2}", 1234.56 + seconds(row)))),
        style(
            "unit behind the name",
            Style { heading: "time_ms,sp,pv,op,mode", ..bare(|row| format!("{}000", row * 10)) },
        ),
        style(
            "unit in brackets",
            Style {
                heading: "Time (min),sp,pv,op,mode",
                ..bare(|row| format!("{:.9}", seconds(row) / 60.0))
            },
        ),
        with(
            "unit by option",
            bare(|row| format!("{:.9}", seconds(row) / 60.0)),
            ReadOptions { time_unit: Some(60.0), ..none() },
        ),
        style("time of day", bare(|row| iso(row)[11..].to_owned())),
        style("numeric mode", Style { mode: ["0", "1"], ..Style::PLAIN }),
        style("cascade", Style { mode: ["IMAN", "RCAS"], ..Style::PLAIN }),
        with(
            "mode by option",
            Style { mode: ["RUN 2", "RUN 7"], ..Style::PLAIN },
            ReadOptions { automatic: vec!["run 7".to_owned()], ..none() },
        ),
        style(
            "thousands separated",
            Style {
                between: ";",
                heading: "timestamp;sp;pv;op;mode",
                number: |value| {
                    let text = value.to_string();
                    if value >= 1000.0 { format!("{},{}", &text[..1], &text[1..]) } else { text }
                },
                ..Style::PLAIN
            },
        ),
        style(
            "thousands separated by points",
            Style {
                number: |value| {
                    let text = comma(value);
                    if value >= 1000.0 { format!("{}.{}", &text[..1], &text[1..]) } else { text }
                },
                ..german()
            },
        ),
        style("percent signs", Style { number: |value| format!("{value} %"), ..Style::PLAIN }),
        with(
            "no heading",
            Style { heading: "", ..Style::PLAIN },
            ReadOptions {
                setpoint: Some("2".to_owned()),
                controlled_variable: Some("3".to_owned()),
                manipulated_variable: Some("col4".to_owned()),
                mode: Some("5".to_owned()),
                ..none()
            },
        ),
        with(
            "columns by name",
            named("x,w1,level of tank 7,q,k"),
            ReadOptions {
                time: Some("X".to_owned()),
                setpoint: Some("w1".to_owned()),
                controlled_variable: Some("level of tank 7".to_owned()),
                manipulated_variable: Some("q".to_owned()),
                mode: Some("K".to_owned()),
                ..none()
            },
        ),
        with(
            "no time column",
            Style { heading: "n,sp,pv,op,mode", ..bare(|_| "x".to_owned()) },
            ReadOptions { sample_period: Some(10.0), ..none() },
        ),
        with(
            "date order by option",
            timed(|row| local(row, "31/01/24", false)),
            ReadOptions { date_order: Some(DateOrder::DayMonthYear), ..none() },
        ),
    ]
}

#[test]
fn every_dialect_holds_the_same_record() {
    for (name, bytes, options) in variants() {
        let reading = read_bytes(&bytes, &options)
            .unwrap_or_else(|error| panic!("{name}: {error}\n{}", String::from_utf8_lossy(&bytes[..200])));
        assert_eq!(reading.record, record(), "{name}: {:?}", reading.found);
        assert_eq!((reading.found.rows, reading.found.rows_in_file), (ROWS, ROWS), "{name}");
    }
}

#[test]
fn spans_scale_to_percent() {
    let options = ReadOptions {
        controlled_span: Some((50.0, 55.0)),
        manipulated_span: Some((20.5, 1234.25)),
        ..ReadOptions::default()
    };
    let read = read_bytes(Style::PLAIN.text().as_bytes(), &options).unwrap().record;
    assert_eq!(read.manipulated_variable()[0], 0.0);
    assert_eq!(read.manipulated_variable()[ROWS - 1], 100.0);
    assert_eq!(read.setpoint().unwrap()[ROWS - 1], 50.0);
    assert_eq!(manipulated(ROWS - 1), 1234.25);
}

/// How a property writes a record.
#[derive(Debug, Clone)]
#[expect(clippy::struct_excessive_bools, reason = "independent choices")]
struct Dialect {
    delimiter: char,
    comma: bool,
    end: &'static str,
    quoted: bool,
    reversed: bool,
    blank_lines: bool,
    bom: bool,
}

fn dialect() -> impl Strategy<Value = Dialect> {
    let delimiter = prop::sample::select(vec![',', ';', '\t', '|']);
    let end = prop::sample::select(vec!["\n", "\r\n", "\r"]);
    (delimiter, any::<bool>(), end, any::<bool>(), any::<bool>(), any::<bool>(), any::<bool>()).prop_map(
        |(delimiter, comma, end, quoted, reversed, blank_lines, bom)| Dialect {
            delimiter,
            comma: comma && (delimiter != ',' || quoted),
            end,
            quoted,
            reversed,
            blank_lines,
            bom,
        },
    )
}

fn write(record: &Record, dialect: &Dialect) -> String {
    let cell = |text: String| {
        let text = if dialect.comma { text.replace('.', ",") } else { text };
        if dialect.quoted { format!("\"{text}\"") } else { text }
    };
    let between = dialect.delimiter.to_string();
    let mut rows: Vec<String> = (0..record.len())
        .map(|row| {
            let values =
                [record.time()[row], record.controlled_variable()[row], record.manipulated_variable()[row]];
            values.map(|value| cell(value.to_string())).join(&between)
        })
        .collect();
    if dialect.reversed {
        rows.reverse();
    }
    rows.insert(0, ["time_s", "pv", "op"].join(&between));
    let end = if dialect.blank_lines { dialect.end.repeat(2) } else { dialect.end.to_owned() };
    format!("{}{}{end}", if dialect.bom { "\u{feff}" } else { "" }, rows.join(&end))
}

/// Any double of sensible size, as text of up to 17 digits.
fn value() -> impl Strategy<Value = f64> {
    prop_oneof![-1e6..1e6_f64, (-1_000_000..1_000_000_i32).prop_map(|k| f64::from(k) / 1000.0), Just(0.0)]
}

proptest! {
    /// Times are multiples of a nanosecond below 1e6 s, which a double and the reader hold exactly.
    #[test]
    fn a_record_in_any_dialect_reads_back_to_the_same_bits(
        dialect in dialect(),
        steps in prop::collection::vec(1_u32..4_000_000, 2..40),
        values in prop::collection::vec((value(), value()), 40),
    ) {
        let mut nanos = 0_u64;
        let mut time = vec![0.0];
        for step in &steps {
            nanos += u64::from(*step) * 100;
            #[expect(clippy::cast_precision_loss, reason = "below 2^53")]
            time.push(nanos as f64 / 1e9);
        }
        let (pv, op) = values[..time.len()].iter().copied().unzip();
        let record = Record::new(time, pv, op).unwrap();
        let mark = dialect.comma.then_some(holdup::record::DecimalMark::Comma);
        let options = ReadOptions { decimal_mark: mark, ..ReadOptions::default() };
        let read = read_bytes(write(&record, &dialect).as_bytes(), &options);
        prop_assert_eq!(read.map(|reading| reading.record).map_err(|error| error.to_string()), Ok(record));
    }

    #[test]
    fn no_bytes_make_the_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        if let Err(error) = read_bytes(&bytes, &ReadOptions::default()) {
            prop_assert!(!error.to_string().contains(['\n', '\r']));
        }
    }

    #[test]
    fn no_table_makes_the_reader_panic(text in "(time|date|pv|op|[0-9./:,; \n\t\"-]{1,8}){0,40}") {
        if let Err(error) = read_bytes(text.as_bytes(), &ReadOptions::default()) {
            prop_assert!(!error.to_string().contains(['\n', '\r']));
        }
    }

    #[test]
    fn a_damaged_file_is_read_or_refused_in_one_line(
        at in 0_usize..1500, with in prop::collection::vec(any::<u8>(), 0..20), cut in 0_usize..60,
    ) {
        let mut bytes = Style::PLAIN.text().into_bytes();
        let at = at.min(bytes.len());
        let end = (at + cut).min(bytes.len());
        bytes.splice(at..end, with);
        if let Err(error) = read_bytes(&bytes, &ReadOptions::default()) {
            prop_assert!(!error.to_string().contains(['\n', '\r']), "{}", error);
        }
    }
}
