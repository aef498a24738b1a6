//! Parquet files hold the same record.

#![cfg(feature = "parquet")]

use std::sync::Arc;

use arrow_array::{
    ArrayRef, Date32Array, Float32Array, Float64Array, Int64Array, RecordBatch, StringArray,
    Time64MicrosecondArray, TimestampMicrosecondArray, TimestampMillisecondArray,
};
use holdup::record::{Operation, ReadOptions, RepairKind, read_bytes};
use parquet::arrow::ArrowWriter;
use parquet::basic::{Compression, ZstdLevel};
use parquet::file::properties::WriterProperties;
use proptest::prelude::*;

use crate::sample::{ROWS, START, controlled, iso, manipulated, operation, record, seconds, setpoint};

fn bytes(columns: Vec<(&str, ArrayRef)>, compression: Compression) -> Vec<u8> {
    let batch = RecordBatch::try_from_iter(columns).unwrap();
    let properties = WriterProperties::builder().set_compression(compression).build();
    let mut bytes = Vec::new();
    let mut writer = ArrowWriter::try_new(&mut bytes, batch.schema(), Some(properties)).unwrap();
    writer.write(&batch).unwrap();
    writer.close().unwrap();
    bytes
}

fn floats(of: fn(usize) -> f64) -> ArrayRef {
    Arc::new(Float64Array::from_iter_values((0..ROWS).map(of)))
}

fn epoch(row: usize, factor: i64) -> i64 {
    i64::try_from(START + row * 10).unwrap() * factor
}

fn with_time(name: &'static str, time: ArrayRef) -> Vec<(&'static str, ArrayRef)> {
    let mode = (0..ROWS).map(|row| if operation(row) == Operation::Manual { "MAN" } else { "AUTO" });
    vec![
        (name, time),
        (
            "sp",
            Arc::new(Float32Array::from_iter_values((0..ROWS).map(|row| if row < 25 { 50.0 } else { 52.5 }))),
        ),
        ("LIC.pv", floats(controlled)),
        ("LIC.op", floats(manipulated)),
        ("LIC.mode", Arc::new(StringArray::from_iter_values(mode))),
    ]
}

#[test]
fn every_type_of_time_and_every_compression_holds_the_same_record() {
    let millis = || {
        Arc::new(TimestampMillisecondArray::from_iter_values((0..ROWS).map(|row| epoch(row, 1000))))
            as ArrayRef
    };
    let micros = TimestampMicrosecondArray::from_iter_values((0..ROWS).map(|row| epoch(row, 1_000_000)))
        .with_timezone("UTC");
    let zstd = Compression::ZSTD(ZstdLevel::try_new(3).unwrap());
    for (name, columns, compression) in [
        ("milliseconds", with_time("timestamp", millis()), Compression::UNCOMPRESSED),
        ("snappy", with_time("ts", millis()), Compression::SNAPPY),
        ("microseconds with zone, zstd", with_time("time", Arc::new(micros)), zstd),
        (
            "integers",
            with_time("time", Arc::new(Int64Array::from_iter_values((0..ROWS).map(|row| epoch(row, 1000))))),
            zstd,
        ),
        ("seconds", with_time("time_s", floats(seconds)), zstd),
        ("text", with_time("time", Arc::new(StringArray::from_iter_values((0..ROWS).map(iso)))), zstd),
        (
            "date and time of day",
            [
                vec![("day", Arc::new(Date32Array::from_iter_values((0..ROWS).map(|_| 19_753))) as ArrayRef)],
                with_time(
                    "clock",
                    Arc::new(Time64MicrosecondArray::from_iter_values(
                        (0..ROWS).map(|row| epoch(row, 1) % 86_400 * 1_000_000),
                    )),
                ),
            ]
            .concat(),
            zstd,
        ),
    ] {
        let reading = read_bytes(&bytes(columns, compression), &ReadOptions::default())
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(reading.record, record(), "{name}");
        assert_eq!(reading.found.format, "parquet");
    }
}

#[test]
fn nulls_are_rows_without_a_number() {
    let mut columns = with_time("time_s", floats(seconds));
    columns[2].1 =
        Arc::new((0..ROWS).map(|row| (row != 7).then(|| controlled(row))).collect::<Float64Array>());
    let reading = read_bytes(&bytes(columns, Compression::SNAPPY), &ReadOptions::default()).unwrap();
    assert_eq!(reading.record.len(), ROWS - 1);
    assert_eq!(
        reading.repairs.iter().map(|repair| (repair.kind, repair.rows)).collect::<Vec<_>>(),
        [(RepairKind::NoValue, 1)]
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]
    #[test]
    fn a_damaged_file_is_read_or_refused_in_one_line(at in 0_usize..4000, with in any::<u8>(), cut in any::<bool>()) {
        let mut file = bytes(with_time("time_s", floats(seconds)), Compression::SNAPPY);
        let at = at % file.len();
        file[at] = with;
        if cut {
            file.truncate(at.max(4));
        }
        if let Err(error) = read_bytes(&file, &ReadOptions::default()) {
            prop_assert!(!error.to_string().contains(['\n', '\r']), "{}", error);
        }
    }
}

#[test]
fn readings_of_tags_are_put_together_as_in_text_files() {
    let tags = (0..3 * ROWS).map(|row| ["LIC7.PV", "LIC7.OP", "LIC7.SP"][row % 3]);
    let value = |row: usize| match row % 3 {
        0 => controlled(row / 3),
        1 => manipulated(row / 3),
        _ => setpoint(row / 3),
    };
    let times = TimestampMillisecondArray::from_iter_values((0..3 * ROWS).map(|row| epoch(row / 3, 1000)));
    let columns: Vec<(&'static str, ArrayRef)> = vec![
        ("t_stamp", Arc::new(times)),
        ("tagpath", Arc::new(StringArray::from_iter_values(tags))),
        ("value", Arc::new(Float64Array::from_iter_values((0..3 * ROWS).map(value)))),
        ("dataintegrity", Arc::new(Int64Array::from_iter_values((0..3 * ROWS).map(|_| 192)))),
    ];
    let reading = read_bytes(&bytes(columns, Compression::UNCOMPRESSED), &ReadOptions::default()).unwrap();
    assert_eq!(reading.record.controlled_variable(), record().controlled_variable());
    assert_eq!(reading.record.manipulated_variable(), record().manipulated_variable());
    assert_eq!(reading.record.setpoint(), record().setpoint());
    let kinds: Vec<_> = reading.repairs.iter().map(|repair| (repair.kind, repair.rows)).collect();
    assert_eq!(kinds, [(RepairKind::PutTogether, 3 * ROWS)]);
}
