//! Runs as CSV: numbers with all digits, empty where there is none.

use std::io::{self, BufWriter, Write};

use super::{FIRST, names, values};
use crate::study::output::WholeFile;
use crate::tuning::robust::Run;

#[derive(Debug)]
pub(super) struct Rows {
    file: BufWriter<WholeFile>,
}

impl Rows {
    pub(super) fn new(file: WholeFile) -> io::Result<Self> {
        let mut file = BufWriter::with_capacity(1 << 16, file);
        let heading: Vec<&str> = FIRST.into_iter().chain(names()).collect();
        writeln!(file, "{}", heading.join(","))?;
        Ok(Self { file })
    }

    pub(super) fn append(&mut self, runs: &[Run]) -> io::Result<()> {
        for run in runs {
            let (gain, dead_time) = (run.process.process_gain(), run.process.dead_time());
            write!(self.file, "{},{gain},{dead_time},{}", run.index, run.margins.stable)?;
            for value in values(run) {
                match value {
                    Some(value) => write!(self.file, ",{value}")?,
                    None => self.file.write_all(b",")?,
                }
            }
            self.file.write_all(b"\n")?;
        }
        Ok(())
    }

    pub(super) fn finish(self) -> io::Result<()> {
        self.file.into_inner().map_err(io::IntoInnerError::into_error)?.commit()
    }
}
