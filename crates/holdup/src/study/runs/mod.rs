//! The runs of a Monte Carlo as a file, written while they are computed: CSV or Parquet.

mod csv;
#[cfg(feature = "parquet")]
mod parquet;

use std::io;
use std::path::Path;

use super::output::WholeFile;
use crate::analysis::metrics::METRICS;
use crate::tuning::robust::{COLUMNS, Run};

/// The first columns: what the process was.
const FIRST: [&str; 4] = ["index", "process_gain", "dead_time_s", "stable"];

/// A file of runs: one row a run, in the order of their index.
#[derive(Debug)]
pub struct RunsFile {
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    Csv(csv::Rows),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::Rows>),
}

impl RunsFile {
    /// Opens the file; its name must end in `.csv`, or in `.parquet` where that feature is on. It appears when it is
    /// finished, and not before.
    ///
    /// # Errors
    /// `InvalidInput` for another ending; else whatever the file system says.
    pub fn create(path: &Path) -> io::Result<Self> {
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let kind = match ending.to_ascii_lowercase().as_str() {
            "csv" => Kind::Csv(csv::Rows::new(WholeFile::create(path)?)?),
            #[cfg(feature = "parquet")]
            "parquet" => Kind::Parquet(Box::new(parquet::Rows::new(WholeFile::create(path)?)?)),
            _ => {
                let allowed = if cfg!(feature = "parquet") { ".csv or .parquet" } else { ".csv" };
                return Err(io::Error::new(
                    io::ErrorKind::InvalidInput,
                    format!("the name must end in {allowed}"),
                ));
            }
        };
        Ok(Self { kind })
    }

    /// Appends these runs.
    ///
    /// # Errors
    /// Whatever the file system says.
    pub fn append(&mut self, runs: &[Run]) -> io::Result<()> {
        match &mut self.kind {
            Kind::Csv(rows) => rows.append(runs),
            #[cfg(feature = "parquet")]
            Kind::Parquet(rows) => rows.append(runs),
        }
    }

    /// Makes the file appear.
    ///
    /// # Errors
    /// Whatever the file system says.
    pub fn finish(self) -> io::Result<()> {
        match self.kind {
            Kind::Csv(rows) => rows.finish(),
            #[cfg(feature = "parquet")]
            Kind::Parquet(rows) => rows.finish(),
        }
    }
}

/// Names of the columns after the first four.
fn names() -> impl Iterator<Item = &'static str> {
    let metrics = METRICS.iter().map(|metric| metric.name);
    COLUMNS.iter().map(|column| column.name).chain(metrics)
}

/// Values of the columns after the first four.
fn values(run: &Run) -> impl Iterator<Item = Option<f64>> {
    let metrics = METRICS.iter().map(|metric| run.metrics.as_ref().and_then(metric.value));
    COLUMNS.iter().map(|column| (column.value)(run)).chain(metrics)
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::path::PathBuf;

    use super::*;
    use crate::analysis::frequency::family::Family;
    use crate::model::{Controller, Process, Seconds};
    use crate::tuning::robust::{Distribution, Draws, MonteCarlo};

    fn written(name: &str) -> (PathBuf, Vec<Run>) {
        let path = std::env::temp_dir().join(format!("holdup-runs-{}-{name}", std::process::id()));
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let controller = Controller::proportional(1.3).unwrap();
        let family = Family::ranges([0.8, 1.4], [0.8, 1.2]).unwrap();
        let draws = Draws::new(family, Distribution::Uniform, 1);
        let carlo = MonteCarlo { process, controller, draws, samples: 50, scenario: None, times: &[] };
        let (mut file, mut all) = (RunsFile::create(&path).unwrap(), Vec::new());
        carlo
            .run(|runs| {
                file.append(runs).unwrap();
                all.extend_from_slice(runs);
                ControlFlow::Continue(())
            })
            .unwrap();
        assert!(!path.exists());
        file.finish().unwrap();
        (path, all)
    }

    #[test]
    fn a_csv_file_has_every_number_to_its_last_digit() {
        let (path, runs) = written("all.csv");
        let mut reader = ::csv::Reader::from_path(&path).unwrap();
        let heading = reader.headers().unwrap().clone();
        let peak = heading.iter().position(|name| name == "sensitivity_peak").unwrap();
        let rows: Vec<::csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        assert_eq!(rows.len(), 50);
        for (row, run) in rows.iter().zip(&runs) {
            assert_eq!(row[1].parse::<f64>().unwrap(), run.process.process_gain());
            assert_eq!(row[3] == *"true", run.margins.stable);
            assert_eq!(row[peak].parse::<f64>().ok(), run.margins.sensitivity_peak);
        }
        assert!(runs.iter().any(|run| !run.margins.stable) && runs.iter().any(|run| run.margins.stable));
        std::fs::remove_file(path).unwrap();
    }

    #[cfg(feature = "parquet")]
    #[test]
    fn a_parquet_file_has_the_same_rows() {
        use ::parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
        use arrow_array::cast::AsArray;
        use arrow_array::types::Float64Type;

        let (path, runs) = written("all.parquet");
        let builder = ParquetRecordBatchReaderBuilder::try_new(std::fs::File::open(&path).unwrap()).unwrap();
        let mut index = 0;
        for batch in builder.build().unwrap() {
            let batch = batch.unwrap();
            let column = batch.column_by_name("sensitivity_peak").unwrap().as_primitive::<Float64Type>();
            for value in column {
                assert_eq!(value, runs[index].margins.sensitivity_peak);
                index += 1;
            }
        }
        assert_eq!(index, 50);
        std::fs::remove_file(path).unwrap();
    }

    #[test]
    fn another_ending_is_refused_and_a_file_that_is_not_finished_leaves_nothing() {
        let folder = std::env::temp_dir().join(format!("holdup-runs-folder-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        assert!(RunsFile::create(&folder.join("runs.xlsx")).is_err());
        drop(RunsFile::create(&folder.join("runs.csv")).unwrap());
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
        std::fs::remove_dir_all(folder).unwrap();
    }
}
