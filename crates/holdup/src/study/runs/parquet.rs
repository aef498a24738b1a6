//! Runs as Parquet: one row group for every few chunks, null where there is no number.

use std::fmt;
use std::io;
use std::sync::Arc;

use arrow_array::{ArrayRef, BooleanArray, Float64Array, RecordBatch, UInt64Array};
use arrow_schema::{DataType, Field, Schema};
use parquet::arrow::ArrowWriter;
use parquet::basic::{Compression, ZstdLevel};
use parquet::file::properties::WriterProperties;

use super::{FIRST, names, values};
use crate::study::output::WholeFile;
use crate::tuning::robust::Run;

/// Rows of a row group: what the writer holds in memory.
const ROW_GROUP: usize = 1 << 17;

pub(super) struct Rows {
    writer: ArrowWriter<WholeFile>,
    schema: Arc<Schema>,
}

impl fmt::Debug for Rows {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Rows").field("schema", &self.schema).finish_non_exhaustive()
    }
}

impl Rows {
    pub(super) fn new(file: WholeFile) -> io::Result<Self> {
        let types = [DataType::UInt64, DataType::Float64, DataType::Float64, DataType::Boolean];
        let first = FIRST.into_iter().zip(types).map(|(name, kind)| Field::new(name, kind, false));
        let rest = names().map(|name| Field::new(name, DataType::Float64, true));
        let schema = Arc::new(Schema::new(first.chain(rest).collect::<Vec<_>>()));
        let properties = WriterProperties::builder()
            .set_compression(Compression::ZSTD(ZstdLevel::default()))
            .set_max_row_group_row_count(Some(ROW_GROUP))
            .build();
        let writer =
            ArrowWriter::try_new(file, Arc::clone(&schema), Some(properties)).map_err(io::Error::other)?;
        Ok(Self { writer, schema })
    }

    pub(super) fn append(&mut self, runs: &[Run]) -> io::Result<()> {
        let mut columns: Vec<ArrayRef> = vec![
            Arc::new(runs.iter().map(|run| run.index).collect::<UInt64Array>()),
            Arc::new(runs.iter().map(|run| Some(run.process.process_gain())).collect::<Float64Array>()),
            Arc::new(runs.iter().map(|run| Some(run.process.dead_time())).collect::<Float64Array>()),
            Arc::new(runs.iter().map(|run| Some(run.margins.stable)).collect::<BooleanArray>()),
        ];
        let mut rest = vec![Vec::with_capacity(runs.len()); names().count()];
        for run in runs {
            for (column, value) in rest.iter_mut().zip(values(run)) {
                column.push(value);
            }
        }
        columns.extend(rest.into_iter().map(|column| Arc::new(Float64Array::from(column)) as ArrayRef));
        let batch = RecordBatch::try_new(Arc::clone(&self.schema), columns).map_err(io::Error::other)?;
        self.writer.write(&batch).map_err(io::Error::other)
    }

    pub(super) fn finish(self) -> io::Result<()> {
        self.writer.into_inner().map_err(io::Error::other)?.commit()
    }
}
