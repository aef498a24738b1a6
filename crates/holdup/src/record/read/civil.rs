//! One timestamp: date and time of day as people and historians write them.
//!
//! Dates are those of the proleptic Gregorian calendar (days from civil: H. Hinnant, chrono-compatible low-level
//! date algorithms, 2014). Where day and month are both numbers, only the whole column can say which is which, so
//! the parts are kept apart here.

/// Nanoseconds in a second.
pub(super) const SECOND: i64 = 1_000_000_000;
/// Nanoseconds in a day.
pub(super) const DAY: i64 = 86_400 * SECOND;

const MONTHS: [&str; 12] =
    ["jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec"];
const WEEKDAYS: [&str; 7] = ["mon", "tue", "wed", "thu", "fri", "sat", "sun"];

/// Names of zones with their offset from UTC [h]. Names with several meanings (`IST`) are left out.
const ZONES: [(&str, i64); 17] = [
    ("z", 0),
    ("utc", 0),
    ("gmt", 0),
    ("wet", 0),
    ("bst", 1),
    ("cet", 1),
    ("cest", 2),
    ("eet", 2),
    ("eest", 3),
    ("jst", 9),
    ("est", -5),
    ("edt", -4),
    ("cst", -6),
    ("cdt", -5),
    ("mst", -7),
    ("mdt", -6),
    ("pst", -8),
];

/// The three numbers of a date, in the order of the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Date {
    /// The numbers.
    pub(super) parts: [i32; 3],
    /// Whether the text itself says their order: the year has four digits and comes first, or the month is a name.
    pub(super) order: Option<DateOrder>,
    /// The character between the first two.
    pub(super) separator: u8,
}

/// Which of the numbers of a date is which.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DateOrder {
    /// 2024-01-31
    YearMonthDay,
    /// 31/01/2024
    DayMonthYear,
    /// 01/31/2024
    MonthDayYear,
}

/// What a cell says of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Stamp {
    /// The date, where there is one.
    pub(super) date: Option<Date>,
    /// Time of day [ns], where there is one.
    pub(super) clock: Option<i64>,
    /// Offset from UTC [ns], where there is one.
    pub(super) offset: Option<i64>,
}

impl Date {
    /// Days since 1970-01-01 under an order; none where there is no such day.
    pub(super) fn days(self, order: DateOrder) -> Option<i64> {
        let [a, b, c] = self.parts;
        let (year, month, day) = match self.order.unwrap_or(order) {
            DateOrder::YearMonthDay => (a, b, c),
            DateOrder::DayMonthYear => (c, b, a),
            DateOrder::MonthDayYear => (c, a, b),
        };
        // Four digits say the century; of two, only those behind day and month are taken as a year.
        let year = match year {
            _ if self.order == Some(DateOrder::YearMonthDay) => year,
            0..=69 => year + 2000,
            70..=99 => year + 1900,
            _ => year,
        };
        // Nanoseconds in 64 bits reach from 1677 to 2262.
        let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
        let length = match month {
            2 if leap => 29,
            2 => 28,
            4 | 6 | 9 | 11 => 30,
            _ => 31,
        };
        let exists =
            (1700..=2200).contains(&year) && (1..=12).contains(&month) && (1..=length).contains(&day);
        exists.then(|| days_from_civil(i64::from(year), i64::from(month), i64::from(day)))
    }
}

/// Days from 1970-01-01 to a date.
fn days_from_civil(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let year_of_era = year - era * 400;
    let day_of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year - 719_468
}

/// Year, month and day of a day since 1970-01-01.
pub(super) fn civil_from_days(days: i64) -> (i64, i64, i64) {
    let shifted = days + 719_468;
    let era = shifted.div_euclid(146_097);
    let day_of_era = shifted - era * 146_097;
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted_month = (5 * day_of_year + 2) / 153;
    let month = if shifted_month < 10 { shifted_month + 3 } else { shifted_month - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    (year, month, day_of_year - (153 * shifted_month + 2) / 5 + 1)
}

/// An instant [ns] as ISO 8601 without zone, fractions only where there are some.
pub(super) fn iso(instant: i64) -> String {
    let (year, month, day) = civil_from_days(instant.div_euclid(DAY));
    let clock = instant.rem_euclid(DAY);
    let (seconds, fraction) = (clock / SECOND, clock % SECOND);
    let mut text = format!(
        "{year:04}-{month:02}-{day:02}T{:02}:{:02}:{:02}",
        seconds / 3600,
        seconds / 60 % 60,
        seconds % 60
    );
    if fraction != 0 {
        text += format!(".{fraction:09}").trim_end_matches('0');
    }
    text
}

/// Reads a timestamp; none where the text is something else. A bare number is something else.
pub(super) fn stamp(cell: &[u8]) -> Option<Stamp> {
    if cell.len() < 3 || cell.len() > 48 || !cell.iter().any(u8::is_ascii_digit) {
        return None;
    }
    let mut cursor = Cursor { rest: cell };
    cursor.weekday();
    let date = if cursor.is_clock() { None } else { Some(cursor.date()?) };
    let clock = if date.is_none() || cursor.gap() { Some(cursor.clock()?) } else { None };
    let offset = if clock.is_some() { cursor.offset().ok()? } else { None };
    cursor.rest.is_empty().then_some(Stamp { date, clock, offset })
}

struct Cursor<'c> {
    rest: &'c [u8],
}

impl Cursor<'_> {
    /// Digits here, as their value and their number; at most nine.
    fn digits(&mut self) -> Option<(i32, usize)> {
        let count = self.rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        if count == 0 || count > 9 {
            return None;
        }
        let value = self.rest[..count].iter().fold(0, |value, byte| value * 10 + i32::from(byte - b'0'));
        self.rest = &self.rest[count..];
        Some((value, count))
    }

    fn eat(&mut self, byte: u8) -> bool {
        let here = self.rest.first() == Some(&byte);
        if here {
            self.rest = &self.rest[1..];
        }
        here
    }

    fn blanks(&mut self) {
        self.rest = self.rest.trim_ascii_start();
    }

    /// A word of letters, in small letters; at most nine.
    fn word(&mut self, buffer: &mut [u8; 9]) -> usize {
        let count = self.rest.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
        if count > buffer.len() {
            return 0;
        }
        for (small, byte) in buffer.iter_mut().zip(&self.rest[..count]) {
            *small = byte.to_ascii_lowercase();
        }
        self.rest = &self.rest[count..];
        count
    }

    fn weekday(&mut self) {
        let before = self.rest;
        let mut buffer = [0; 9];
        let count = self.word(&mut buffer);
        if count >= 3 && WEEKDAYS.iter().any(|day| buffer.starts_with(day.as_bytes())) {
            self.eat(b'.');
            self.eat(b',');
            self.blanks();
        } else {
            self.rest = before;
        }
    }

    fn is_clock(&self) -> bool {
        let digits = self.rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        (1..=2).contains(&digits) && self.rest.get(digits) == Some(&b':')
    }

    /// The month that is named here, from 1.
    fn month(&mut self) -> Option<i32> {
        let mut buffer = [0; 9];
        let count = self.word(&mut buffer);
        self.eat(b'.');
        let named = MONTHS.iter().position(|month| count >= 3 && buffer.starts_with(month.as_bytes()))?;
        i32::try_from(named + 1).ok()
    }

    fn separator(&mut self) -> Option<u8> {
        let separator = *self.rest.first().filter(|byte| matches!(byte, b'-' | b'/' | b'.' | b' ' | b','))?;
        self.rest = &self.rest[1..];
        if matches!(separator, b' ' | b',' | b'.') {
            self.blanks();
        }
        Some(separator)
    }

    fn date(&mut self) -> Option<Date> {
        if self.rest.first()?.is_ascii_alphabetic() {
            let month = self.month()?;
            self.blanks();
            let separator = if self.eat(b'-') { b'-' } else { b' ' };
            let day = self.digits().filter(|(_, count)| *count <= 2)?.0;
            self.separator()?;
            let year = self.year()?;
            return Some(Date { parts: [month, day, year], order: Some(DateOrder::MonthDayYear), separator });
        }
        let (first, count) = self.digits()?;
        if count == 8 {
            let parts = [first / 10_000, first / 100 % 100, first % 100];
            return Some(Date { parts, order: Some(DateOrder::YearMonthDay), separator: b'-' });
        }
        if count == 3 || count > 4 {
            return None;
        }
        let separator = self.separator()?;
        let named = self.rest.first()?.is_ascii_alphabetic();
        let second = if named { self.month()? } else { self.digits().filter(|(_, count)| *count <= 2)?.0 };
        let again = self.separator()?;
        let alike = again == separator || named;
        if !alike || (separator == b' ' && !named) {
            return None;
        }
        let order = match (count, named) {
            (4, _) => Some(DateOrder::YearMonthDay),
            (_, true) => Some(DateOrder::DayMonthYear),
            _ => None,
        };
        let third = if count == 4 { self.digits().filter(|(_, n)| *n <= 2)?.0 } else { self.year()? };
        Some(Date { parts: [first, second, third], order, separator })
    }

    fn year(&mut self) -> Option<i32> {
        self.digits().filter(|(_, count)| *count <= 2 || *count == 4).map(|(year, _)| year)
    }

    /// What stands between date and time of day; false at the end.
    fn gap(&mut self) -> bool {
        let before = self.rest.len();
        if !(self.eat(b'T') || self.eat(b't') || self.eat(b'_') || self.eat(b':')) {
            self.eat(b',');
            self.blanks();
        }
        self.rest.len() < before && !self.rest.is_empty()
    }

    fn clock(&mut self) -> Option<i64> {
        let (hour, count) = self.digits()?;
        let mut hour = i64::from(hour);
        let minute;
        let mut second;
        match count {
            6 => (hour, minute, second) = (hour / 10_000, hour / 100 % 100, hour % 100),
            4 => (hour, minute, second) = (hour / 100, hour % 100, 0),
            1 | 2 => {
                if !self.eat(b':') {
                    return None;
                }
                minute = i64::from(self.digits().filter(|(_, count)| *count <= 2)?.0);
                second = 0;
                if self.eat(b':') {
                    second = i64::from(self.digits().filter(|(_, count)| *count <= 2)?.0);
                }
            }
            _ => return None,
        }
        let fraction = if self.eat(b'.') || self.eat(b',') { self.fraction()? } else { 0 };
        self.half_day(&mut hour)?;
        let valid = hour <= 24 && minute <= 59 && second <= 60;
        valid.then_some((hour * 3600 + minute * 60 + second) * SECOND + fraction)
    }

    /// Digits behind the seconds [ns]; beyond the ninth they are cut.
    fn fraction(&mut self) -> Option<i64> {
        let count = self.rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let digits = self.rest[..count].iter().chain(std::iter::repeat(&b'0'));
        let value = digits.take(9).fold(0, |value, byte| value * 10 + i64::from(byte - b'0'));
        self.rest = &self.rest[count..];
        (count > 0).then_some(value)
    }

    /// AM or PM; none where the hour does not go with it.
    fn half_day(&mut self, hour: &mut i64) -> Option<()> {
        let before = self.rest;
        self.blanks();
        let half = self.rest.first().map(u8::to_ascii_lowercase);
        let dots = usize::from(self.rest.get(1) == Some(&b'.'));
        let m = self.rest.get(1 + dots).map(u8::to_ascii_lowercase);
        if !matches!(half, Some(b'a' | b'p')) || m != Some(b'm') {
            self.rest = before;
            return Some(());
        }
        self.rest = &self.rest[2 + dots..];
        self.eat(b'.');
        if !(1..=12).contains(hour) {
            return None;
        }
        *hour = *hour % 12 + if half == Some(b'p') { 12 } else { 0 };
        Some(())
    }

    /// The offset from UTC behind the time of day; an error where something else stands there.
    fn offset(&mut self) -> Result<Option<i64>, ()> {
        self.blanks();
        let Some(&first) = self.rest.first() else { return Ok(None) };
        if first.is_ascii_alphabetic() {
            let mut buffer = [0; 9];
            let count = self.word(&mut buffer);
            let zone = ZONES.iter().find(|(name, _)| name.as_bytes() == &buffer[..count]).ok_or(())?;
            return Ok(Some(zone.1 * 3600 * SECOND));
        }
        let sign = match first {
            b'+' => 1,
            b'-' => -1,
            _ => return Err(()),
        };
        self.rest = &self.rest[1..];
        let (value, count) = self.digits().ok_or(())?;
        let (hours, minutes) = match count {
            4 => (value / 100, value % 100),
            1 | 2 if self.eat(b':') => (value, self.digits().filter(|(_, count)| *count == 2).ok_or(())?.0),
            1 | 2 => (value, 0),
            _ => return Err(()),
        };
        let valid = hours <= 15 && minutes <= 59;
        valid.then_some(Some(sign * i64::from(hours * 60 + minutes) * 60 * SECOND)).ok_or(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn instant(text: &str, order: DateOrder) -> Option<i64> {
        let stamp = stamp(text.as_bytes())?;
        Some(stamp.date?.days(order)? * DAY + stamp.clock.unwrap_or(0) - stamp.offset.unwrap_or(0))
    }

    #[test]
    fn one_instant_is_read_from_every_way_to_write_it() {
        use DateOrder::{DayMonthYear, MonthDayYear, YearMonthDay};
        // `date -u -d '2024-01-31 13:05:06' +%s` (GNU coreutils).
        let expected = 1_706_706_306 * SECOND;
        for (text, order) in [
            ("2024-01-31 13:05:06", YearMonthDay),
            ("2024-01-31T13:05:06", YearMonthDay),
            ("2024-01-31T13:05:06Z", YearMonthDay),
            ("2024-01-31T14:05:06+01:00", YearMonthDay),
            ("2024-01-31 08:05:06 -0500", YearMonthDay),
            ("2024-01-31T15:05:06.000000+02", YearMonthDay),
            ("2024/1/31 13:05:06", YearMonthDay),
            ("20240131T130506Z", YearMonthDay),
            ("20240131 130506", YearMonthDay),
            ("31/01/2024 13:05:06", DayMonthYear),
            ("31.01.2024 13:05:06", DayMonthYear),
            ("31.1.24 13:05:06", DayMonthYear),
            ("31-Jan-24 13:05:06", DayMonthYear),
            ("31-JAN-2024 13:05:06.0", DayMonthYear),
            ("31 January 2024 1:05:06 PM", DayMonthYear),
            ("Wed, 31 Jan 2024 13:05:06 GMT", DayMonthYear),
            ("31/Jan/2024:13:05:06 +0000", DayMonthYear),
            ("01/31/24 1:05:06 PM", MonthDayYear),
            ("1/31/2024, 1:05:06 p.m.", MonthDayYear),
            ("Jan 31, 2024 13:05:06", MonthDayYear),
            ("2024-01-31 14:05:06 CET", YearMonthDay),
        ] {
            assert_eq!(instant(text, order), Some(expected), "{text}");
        }
        assert_eq!(instant("2024-01-31T13:05:06.25", YearMonthDay), Some(expected + SECOND / 4));
        assert_eq!(instant("2024-01-31T13:05:06,123456789", YearMonthDay), Some(expected + 123_456_789));
        assert_eq!(instant("01/31/24 12:00 AM", MonthDayYear), instant("2024-01-31", YearMonthDay));
        assert_eq!(instant("2024-01-31 24:00", YearMonthDay), instant("2024-02-01", YearMonthDay));
    }

    #[test]
    fn what_is_no_timestamp_is_none() {
        for text in [
            "",
            "12",
            "1.5",
            "45292.5",
            "1706706306",
            "abc",
            "PV",
            "2024-01-31 25:00:00",
            "31/01/2024 13:60",
            "1.2.3.4",
            "2024-01-31T13:05:06 XYZ",
            "13/13",
            "0:61",
            "2024-01",
            "13:00 PM",
            "1-2",
            "10.5 20.5",
            "Mon",
            "May",
            "31 1 2024",
        ] {
            assert_eq!(stamp(text.as_bytes()), None, "{text}");
        }
        for text in ["2023-02-29", "2024-13-01", "2024-00-10", "0000-01-01"] {
            assert_eq!(instant(text, DateOrder::YearMonthDay), None, "{text}");
        }
    }

    proptest! {
        #[test]
        fn days_and_dates_are_inverse(days in -80_000_i64..80_000) {
            let (year, month, day) = civil_from_days(days);
            prop_assert_eq!(days_from_civil(year, month, day), days);
        }

        #[test]
        fn an_iso_timestamp_comes_back(seconds in -8_000_000_000_i64..7_000_000_000, fraction in 0_i64..1_000_000_000) {
            let instant_ns = seconds * SECOND + fraction;
            prop_assert_eq!(instant(&iso(instant_ns), DateOrder::YearMonthDay), Some(instant_ns));
        }

        #[test]
        fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..30), text in "[0-9:/. TZ+-]{0,24}") {
            let _ = (stamp(&bytes), stamp(text.as_bytes()));
        }
    }
}
