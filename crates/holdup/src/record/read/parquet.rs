//! Parquet files: columns of numbers, times and text.

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, TimestampNanosecondType};
use arrow_array::{Array, ArrayRef, RecordBatch};
use arrow_cast::cast;
use arrow_schema::{DataType, Schema, TimeUnit};
use parquet::arrow::ProjectionMask;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::file::metadata::ParquetMetaData;

use super::assemble::{self, File};
use super::column::{Column, Heading, Kind, Table, TextColumn};
use super::dialect::{kind, split_unit};
use super::error::ReadError;
use super::reading::Reading;
use super::rows::MOST_COLUMNS;
use super::{PARQUET_THREAD, ReadOptions, long, roles};

/// Rows of the sample that says what text columns hold.
const SAMPLE: usize = 200;

/// The greatest number of rows: what a file says it has is not what it takes on the disk.
const MOST_ROWS: i64 = 1 << 28;

fn refuse(error: impl std::fmt::Display) -> ReadError {
    ReadError::Parquet(error.to_string())
}

/// Reads a Parquet file, on a thread of its own: the decoder stops with a panic on some damaged files, which ends that
/// thread and becomes an error here.
pub(super) fn reading(bytes: &[u8], options: &ReadOptions) -> Result<Reading, ReadError> {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().name(PARQUET_THREAD.to_owned());
        let decoder = thread.spawn_scoped(scope, || decoded(bytes, options))?;
        decoder.join().unwrap_or_else(|_| Err(refuse("it is damaged")))
    })
}

fn decoded(bytes: &[u8], options: &ReadOptions) -> Result<Reading, ReadError> {
    let bytes = bytes::Bytes::copy_from_slice(bytes);
    let open = || ParquetRecordBatchReaderBuilder::try_new(bytes.clone()).map_err(refuse);
    let builder = open()?;
    check(builder.metadata(), bytes.len())?;
    let schema = builder.schema().clone();
    let rows = builder.metadata().file_metadata().num_rows();
    if rows > MOST_ROWS || schema.fields().len() > MOST_COLUMNS {
        return Err(refuse(format!(
            "it has {rows} rows and {} columns, which is too many",
            schema.fields().len()
        )));
    }
    let sample =
        builder.with_batch_size(SAMPLE).build().map_err(refuse)?.next().transpose().map_err(refuse)?;
    let headings = headings(&schema, sample.as_ref())?;
    let mut repairs = Vec::new();
    if let Some(layout) = long::Layout::of(&headings, options, &mut repairs)? {
        let table = table(open()?, &layout.needed())?;
        let about = long::About { format: "parquet", encoding: None, delimiter: None, heading_line: None };
        let file = layout.file(&about, &headings, &table, options, &mut repairs)?;
        return assemble::reading(&file, options, repairs);
    }
    let roles = roles::roles(&headings, options, &mut repairs)?;
    let table = table(open()?, &roles.needed())?;
    let rows = table.rows;
    let file = File {
        format: "parquet",
        layout: "columns",
        encoding: None,
        delimiter: None,
        heading_line: None,
        headings,
        roles,
        table,
        times: None,
        rows,
    };
    assemble::reading(&file, options, repairs)
}

/// The cells of the columns in `needed`.
fn table(
    builder: ParquetRecordBatchReaderBuilder<bytes::Bytes>,
    needed: &[usize],
) -> Result<Table, ReadError> {
    let mask = ProjectionMask::roots(builder.parquet_schema(), needed.iter().copied());
    let batches: Vec<RecordBatch> =
        builder.with_projection(mask).build().map_err(refuse)?.collect::<Result<_, _>>().map_err(refuse)?;
    let mut table = Table { rows: batches.iter().map(RecordBatch::num_rows).sum(), ..Table::default() };
    for (place, &number) in needed.iter().enumerate() {
        let parts = batches.iter().map(|batch| column(batch.column(place))).collect::<Result<Vec<_>, _>>()?;
        table.columns.push((number, joined(parts)));
    }
    Ok(table)
}

/// Checks that every column lies in the file: the reader takes that for granted.
fn check(metadata: &ParquetMetaData, size: usize) -> Result<(), ReadError> {
    let size = i64::try_from(size).unwrap_or(i64::MAX);
    for group in metadata.row_groups() {
        for column in group.columns() {
            let first = column.dictionary_page_offset().unwrap_or_else(|| column.data_page_offset());
            let inside = |at: i64| (0..=size).contains(&at);
            let length = column.compressed_size();
            let lies = inside(first)
                && inside(column.data_page_offset())
                && inside(length)
                && inside(first.saturating_add(length))
                && column.num_values() >= 0
                && column.uncompressed_size() >= 0;
            if !lies {
                return Err(refuse("a column lies outside the file"));
            }
        }
        if group.num_rows() < 0 {
            return Err(refuse("its number of rows is negative"));
        }
    }
    Ok(())
}

fn headings(schema: &Schema, sample: Option<&RecordBatch>) -> Result<Vec<Heading>, ReadError> {
    let heading = |(number, field): (usize, &std::sync::Arc<arrow_schema::Field>)| {
        let cells = sample.map(|batch| column(batch.column(number))).transpose()?;
        let (kind, rises) = match cells {
            Some(Column::Instants(..)) => {
                let day = matches!(field.data_type(), DataType::Date32 | DataType::Date64);
                let clock = matches!(field.data_type(), DataType::Time32(_) | DataType::Time64(_));
                (
                    if day {
                        Kind::Date
                    } else if clock {
                        Kind::Clock
                    } else {
                        Kind::Instant
                    },
                    true,
                )
            }
            Some(Column::Numbers(values)) => {
                (Kind::Number, values.len() > 1 && values.windows(2).all(|pair| pair[1] > pair[0]))
            }
            Some(Column::Text(cells)) => (usual(&cells), false),
            None => (Kind::Missing, false),
        };
        Ok(Heading { kind, rises, ..split_unit(field.name()) })
    };
    schema.fields().iter().enumerate().map(heading).collect()
}

/// What most cells of a text column look like.
fn usual(cells: &TextColumn) -> Kind {
    let kinds: Vec<Kind> = cells.cells().map(kind).filter(|kind| *kind != Kind::Missing).collect();
    let count = |wanted: Kind| kinds.iter().filter(|kind| **kind == wanted).count();
    let all = [Kind::Number, Kind::Instant, Kind::Date, Kind::Clock, Kind::Text];
    all.into_iter().filter(|kind| count(*kind) > 0).max_by_key(|kind| count(*kind)).unwrap_or(Kind::Missing)
}

/// The cells of one array; a type that is neither time nor number becomes text.
fn column(array: &ArrayRef) -> Result<Column, ReadError> {
    let nanoseconds = || DataType::Timestamp(TimeUnit::Nanosecond, None);
    match array.data_type() {
        DataType::Timestamp(_, zone) => {
            Ok(Column::Instants(instants(array, &nanoseconds())?, zone.is_some()))
        }
        DataType::Date32 | DataType::Date64 => Ok(Column::Instants(instants(array, &nanoseconds())?, false)),
        DataType::Time32(_) | DataType::Time64(_) => {
            let nanos = cast(array, &DataType::Time64(TimeUnit::Nanosecond)).map_err(refuse)?;
            let nanos = cast(&nanos, &DataType::Int64).map_err(refuse)?;
            Ok(Column::Instants(instants(&nanos, &nanoseconds())?, false))
        }
        kind if kind.is_numeric() => {
            let numbers = cast(array, &DataType::Float64).map_err(refuse)?;
            let numbers = numbers.as_primitive::<Float64Type>();
            Ok(Column::Numbers(numbers.iter().map(|value| value.unwrap_or(f64::NAN)).collect()))
        }
        kind if kind.is_nested() => Ok(Column::Numbers(vec![f64::NAN; array.len()])),
        _ => {
            let texts = cast(array, &DataType::LargeUtf8).map_err(refuse)?;
            let mut cells = TextColumn::default();
            for text in texts.as_string::<i64>() {
                cells.push(text.unwrap_or_default().trim().as_bytes());
            }
            Ok(Column::Text(cells))
        }
    }
}

fn instants(array: &ArrayRef, nanoseconds: &DataType) -> Result<Vec<Option<i64>>, ReadError> {
    let nanos = cast(array, nanoseconds).map_err(refuse)?;
    Ok(nanos.as_primitive::<TimestampNanosecondType>().iter().collect())
}

/// The parts of one column, in a row.
fn joined(parts: Vec<Column>) -> Column {
    let mut parts = parts.into_iter();
    let mut whole = parts.next().unwrap_or(Column::Numbers(Vec::new()));
    for part in parts {
        match (&mut whole, part) {
            (Column::Numbers(whole), Column::Numbers(part)) => whole.extend(part),
            (Column::Instants(whole, _), Column::Instants(part, _)) => whole.extend(part),
            (Column::Text(whole), Column::Text(part)) => part.cells().for_each(|cell| whole.push(cell)),
            // All parts have the type of the file's column.
            _ => {}
        }
    }
    whole
}
