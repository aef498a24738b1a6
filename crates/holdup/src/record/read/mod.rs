//! Reading a file: whatever a plant has, to a [`Record`](crate::record::Record).
//!
//! What is not told by [`ReadOptions`] is found out: the encoding, the delimiter, where the data begin and which row
//! names the columns, the decimal mark, how times are written, which column is which. What has to be repaired or
//! assumed on the way stands in [`Reading::repairs`] with the number of rows that it concerns. A row of the file is one of
//! the record, or one reading of a tag: then the tags take the place of the columns.

mod assemble;
mod civil;
mod clock;
mod column;
mod delimited;
mod dialect;
mod encoding;
mod error;
mod long;
mod mode;
mod names;
mod number;
mod options;
mod order;
#[cfg(feature = "parquet")]
mod parquet;
mod pivot;
mod reading;
mod roles;
mod rows;
mod values;
mod window;

use std::fs::File;
use std::io::Read;
use std::path::Path;

pub use civil::DateOrder;
pub use clock::TimeFormat;
pub use column::Place;
pub use error::ReadError;
pub use number::DecimalMark;
pub use options::ReadOptions;
pub use reading::{Found, FoundColumn, Reading, Repair, RepairKind};

/// The greatest file that is read [bytes]: 1 GiB.
pub const GREATEST: u64 = 1 << 30;

/// Name of the thread that decodes Parquet files. A panic there is no defect but a damaged file, and comes back as a
/// [`ReadError::Parquet`]: a program that prints panics may keep silent about this one.
pub const PARQUET_THREAD: &str = "parquet decoder";

/// Reads a file: CSV and its relatives, or Parquet, told apart by their content.
///
/// # Errors
/// [`ReadError`] where the file is no record: one line that names column, line, value and what is allowed.
///
/// ```
/// use holdup::record::{ReadOptions, read};
///
/// let path = std::env::temp_dir().join(format!("holdup-read-{}.csv", std::process::id()));
/// std::fs::write(&path, "Zeit;Füllstand;Ventil\n31.01.2024 13:05;50,5;20\n31.01.2024 13:06;50,4;20\n31.01.2024 13:07;50,2;25\n")?;
/// let reading = read(&path, &ReadOptions::default())?;
/// assert_eq!(reading.record.time(), [0.0, 60.0, 120.0]);
/// assert_eq!(reading.record.controlled_variable(), [50.5, 50.4, 50.2]);
/// std::fs::remove_file(&path)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(path: &Path, options: &ReadOptions) -> Result<Reading, ReadError> {
    let about = std::fs::metadata(path)?;
    if about.is_dir() {
        return Err(ReadError::Folder);
    }
    if about.len() > GREATEST {
        return Err(ReadError::Size { size: about.len(), limit: GREATEST });
    }
    let mut bytes = Vec::with_capacity(usize::try_from(about.len()).unwrap_or(0) + 1);
    // A pipe does not tell its size beforehand.
    File::open(path)?.take(GREATEST + 1).read_to_end(&mut bytes)?;
    read_bytes(&bytes, options)
}

/// Reads a file that is in memory.
///
/// # Errors
/// As [`read`].
///
/// ```
/// use holdup::record::{ReadOptions, read_bytes};
///
/// let reading = read_bytes(b"time,LIC1.PV,LIC1.OP\n0,50.0,20\n10,50.1,20\n20,Bad,20\n30,50.4,22\n", &ReadOptions::default())?;
/// assert_eq!(reading.record.len(), 3);
/// assert_eq!(reading.repairs[0].rows, 4); // the unit of the times is assumed
/// assert_eq!(reading.repairs[1].rows, 1); // "Bad" is no number
/// # Ok::<(), holdup::record::ReadError>(())
/// ```
pub fn read_bytes(bytes: &[u8], options: &ReadOptions) -> Result<Reading, ReadError> {
    let size = u64::try_from(bytes.len()).unwrap_or(u64::MAX);
    if size > GREATEST {
        return Err(ReadError::Size { size, limit: GREATEST });
    }
    options.check()?;
    if bytes.starts_with(b"PAR1") {
        return read_parquet(bytes, options);
    }
    let (text, encoding) = encoding::text(bytes)?;
    let dialect = dialect::dialect(&text)?;
    let mut repairs = Vec::new();
    if let Some(layout) = long::Layout::of(&dialect.headings, options, &mut repairs)? {
        let table = delimited::table(&text, &dialect, &layout.needed(), &mut repairs);
        let about = long::About {
            format: "csv",
            encoding: Some(encoding),
            delimiter: Some(dialect.delimiter.name()),
            heading_line: dialect.heading_line,
        };
        let file = layout.file(&about, &dialect.headings, &table, options, &mut repairs)?;
        return assemble::reading(&file, options, repairs);
    }
    let roles = roles::roles(&dialect.headings, options, &mut repairs)?;
    let table = delimited::table(&text, &dialect, &roles.needed(), &mut repairs);
    let rows = table.rows;
    let file = assemble::File {
        format: "csv",
        layout: "columns",
        encoding: Some(encoding),
        delimiter: Some(dialect.delimiter.name()),
        heading_line: dialect.heading_line,
        headings: dialect.headings,
        roles,
        table,
        times: None,
        rows,
    };
    assemble::reading(&file, options, repairs)
}

#[cfg(feature = "parquet")]
fn read_parquet(bytes: &[u8], options: &ReadOptions) -> Result<Reading, ReadError> {
    parquet::reading(bytes, options)
}

#[cfg(not(feature = "parquet"))]
fn read_parquet(_: &[u8], _: &ReadOptions) -> Result<Reading, ReadError> {
    Err(ReadError::Parquet("this build has no reader for it: save the table as CSV".to_owned()))
}
