//! A part of a record by its times, as people write them.

use std::ops::Range;

use super::civil::{DAY, DateOrder, stamp};
use super::clock::TimeFormat;
use super::{ReadError, Reading};
use crate::model::quantity::read_time;
use crate::model::text::one_line;

/// What a window's end may be.
const ALLOWED: &str = "a time in the record: seconds from its start (300, 5min), a time of day (13:05) or a date and time (2024-01-31T13:05)";

impl Reading {
    /// The rows from one time to another, both included; an end that is not given is that of the record.
    ///
    /// A bare number, or one with a unit of time, counts from the first row; where the file has dates or times of day,
    /// a date and time or a time of day is understood too, a time of day as its first one after the start of the
    /// record.
    ///
    /// # Errors
    /// [`ReadError::Option`] where a text is no time, or fewer than three rows are left.
    ///
    /// ```
    /// use holdup::record::{ReadOptions, read_bytes};
    ///
    /// let file = b"time,pv,op\n13:00,1,2\n13:01,1,2\n13:02,1,3\n13:03,1,3\n13:04,1,3\n";
    /// let reading = read_bytes(file, &ReadOptions::default())?;
    /// assert_eq!(reading.window(Some("13:01"), Some("3min"))?, 1..4);
    /// assert_eq!(reading.window(None, None)?, 0..5);
    /// assert!(reading.window(Some("14:00"), None).is_err());
    /// # Ok::<(), holdup::record::ReadError>(())
    /// ```
    pub fn window(&self, from: Option<&str>, to: Option<&str>) -> Result<Range<usize>, ReadError> {
        let time = self.record.time();
        let place = |option: &'static str, given: Option<&str>| {
            given.map(|given| self.seconds(option, given)).transpose()
        };
        let (first, last) = (place("--from", from)?, place("--to", to)?);
        let begin = first.map_or(0, |first| time.partition_point(|time| *time < first));
        let end = last.map_or(time.len(), |last| time.partition_point(|time| *time <= last));
        if end < begin + 3 {
            let (option, given) = if to.is_some() { ("--to", to) } else { ("--from", from) };
            let allowed = "such that at least three rows lie between --from and --to";
            return Err(ReadError::Option { option, given: one_line(given.unwrap_or_default()), allowed });
        }
        Ok(begin..end)
    }

    /// Seconds from the first row [s].
    fn seconds(&self, option: &'static str, given: &str) -> Result<f64, ReadError> {
        let refuse = || ReadError::Option { option, given: one_line(given), allowed: ALLOWED };
        let given = given.trim();
        if let Ok(seconds) = read_time(option, given) {
            return Ok(seconds);
        }
        let stamp = stamp(given.as_bytes()).ok_or_else(refuse)?;
        let format = self.found.time_format;
        let order = match format {
            TimeFormat::Local { date_order } | TimeFormat::Zoned { date_order } => date_order,
            _ => DateOrder::YearMonthDay,
        };
        let clock = stamp.clock.unwrap_or(0) - stamp.offset.unwrap_or(0);
        let instant = match stamp.date {
            Some(date) if format.has_date() => date.days(order).ok_or_else(refuse)? * DAY + clock,
            None if format.has_date() || format == TimeFormat::TimeOfDay => {
                let today = self.start.div_euclid(DAY) * DAY + clock;
                if today < self.start { today + DAY } else { today }
            }
            _ => return Err(refuse()),
        };
        let span = self.record.time().last().copied().unwrap_or(0.0);
        #[expect(clippy::cast_precision_loss, reason = "a time is compared with rows, not counted with")]
        let seconds = (instant - self.start) as f64 / 1e9;
        // A time of day before the first is the next day's: where that lies behind the record it was no time in it.
        if (0.0..=span).contains(&seconds) || stamp.date.is_some() { Ok(seconds) } else { Err(refuse()) }
    }
}
