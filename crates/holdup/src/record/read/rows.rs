//! Text to rows of cells.
//!
//! One splitter for every delimiter, blanks included: it allocates nothing per row, ends lines at LF, CRLF or a lone
//! CR, and keeps bytes as they are, whatever their encoding. A test compares it with the crate `csv`.

use std::borrow::Cow;

/// The greatest number of columns: more is no record of a loop.
pub(super) const MOST_COLUMNS: usize = 16_384;

/// The longest cell in quotes [bytes]: a quote that does not close before is a character like others.
const LONGEST_QUOTE: usize = 64 << 10;

/// What stands between cells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Delimiter {
    /// One character.
    Byte(u8),
    /// Any number of spaces and tabs.
    Blank,
}

impl Delimiter {
    /// Its name for people.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Byte(b',') => "comma",
            Self::Byte(b';') => "semicolon",
            Self::Byte(b'\t') => "tab",
            Self::Byte(b'|') => "pipe",
            Self::Byte(_) => "character",
            Self::Blank => "blanks",
        }
    }

    #[inline]
    fn is(self, byte: u8) -> bool {
        match self {
            Self::Byte(own) => byte == own,
            Self::Blank => byte == b' ' || byte == b'\t',
        }
    }
}

/// Where a cell stands in the text, blanks and quotes around it left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Cell {
    start: usize,
    end: usize,
    doubled: bool,
}

impl Cell {
    /// The bytes of the cell; `""` inside quotes is one quote.
    pub(super) fn of(self, text: &[u8]) -> Cow<'_, [u8]> {
        let raw = &text[self.start..self.end];
        if !self.doubled {
            return Cow::Borrowed(raw);
        }
        let mut single = Vec::with_capacity(raw.len());
        let mut bytes = raw.iter().copied().peekable();
        while let Some(byte) = bytes.next() {
            single.push(byte);
            if byte == b'"' {
                bytes.next_if_eq(&b'"');
            }
        }
        Cow::Owned(single)
    }

    /// Whether nothing stands in it.
    pub(super) fn is_empty(self) -> bool {
        self.start == self.end
    }
}

/// The rows of a text, one after the other.
#[derive(Debug, Clone)]
pub(super) struct Rows<'b> {
    text: &'b [u8],
    at: usize,
    line: usize,
    delimiter: Delimiter,
}

impl<'b> Rows<'b> {
    /// The rows from the start of the text.
    pub(super) fn new(text: &'b [u8], delimiter: Delimiter) -> Self {
        Self { text, at: 0, line: 1, delimiter }
    }

    /// The rows from this byte, which is the first of this line.
    pub(super) fn from(text: &'b [u8], delimiter: Delimiter, at: usize, line: usize) -> Self {
        Self { text, at, line, delimiter }
    }

    /// Byte and line at which the next row starts.
    pub(super) fn place(&self) -> (usize, usize) {
        (self.at, self.line)
    }

    /// Puts the cells of the next row that is not blank into `cells` and gives its line, from 1. Cells beyond
    /// [`MOST_COLUMNS`] are left out.
    pub(super) fn next(&mut self, cells: &mut Vec<Cell>) -> Option<usize> {
        loop {
            cells.clear();
            if self.at >= self.text.len() {
                return None;
            }
            let line = self.line;
            self.row(cells);
            if cells.len() > 1 || cells.first().is_some_and(|cell| !cell.is_empty()) {
                return Some(line);
            }
        }
    }

    fn row(&mut self, cells: &mut Vec<Cell>) {
        loop {
            let cell = self.cell();
            let behind_last = cell.is_empty() && self.delimiter == Delimiter::Blank && self.at_end();
            if cells.len() < MOST_COLUMNS && !behind_last {
                cells.push(cell);
            }
            match self.text.get(self.at) {
                Some(b'\r') => {
                    self.at += if self.text.get(self.at + 1) == Some(&b'\n') { 2 } else { 1 };
                    self.line += 1;
                    return;
                }
                Some(b'\n') => {
                    self.at += 1;
                    self.line += 1;
                    return;
                }
                Some(_) => self.at += 1,
                None => return,
            }
        }
    }

    fn at_end(&self) -> bool {
        self.text.get(self.at).is_none_or(|byte| matches!(byte, b'\r' | b'\n'))
    }

    /// The cell that starts here; afterwards `at` is on what ends it.
    fn cell(&mut self) -> Cell {
        while self.text.get(self.at).is_some_and(|&byte| self.is_padding(byte)) {
            self.at += 1;
        }
        let start = self.at;
        if self.text.get(start) == Some(&b'"')
            && let Some((close, doubled)) = self.closing(start + 1)
        {
            self.at = close + 1;
            let tail = self.plain();
            if self.text[close + 1..tail].iter().all(u8::is_ascii_whitespace) {
                let inside = &self.text[start + 1..close];
                self.line += breaks(inside);
                return Cell { start: start + 1, end: close, doubled };
            }
            return Cell { start, end: tail, doubled: false };
        }
        Cell { start, end: self.plain(), doubled: false }
    }

    /// Blanks before a cell; a tab is none where it separates.
    fn is_padding(&self, byte: u8) -> bool {
        match self.delimiter {
            Delimiter::Byte(b'\t') => byte == b' ',
            Delimiter::Byte(_) | Delimiter::Blank => byte == b' ' || byte == b'\t',
        }
    }

    /// Moves to what ends an unquoted cell; gives the end of the cell without blanks behind it.
    fn plain(&mut self) -> usize {
        let start = self.at;
        let rest = &self.text[start..];
        let ends = |byte: &u8| matches!(byte, b'\r' | b'\n') || self.delimiter.is(*byte);
        let length = rest.iter().position(ends).unwrap_or(rest.len());
        self.at = start + length;
        start + rest[..length].trim_ascii_end().len()
    }

    /// The quote that closes, and whether there are doubled ones before it.
    fn closing(&self, from: usize) -> Option<(usize, bool)> {
        let until = self.text.len().min(from + LONGEST_QUOTE);
        let (mut at, mut doubled) = (from, false);
        loop {
            at += self.text.get(at..until)?.iter().position(|&byte| byte == b'"')?;
            if self.text.get(at + 1) != Some(&b'"') {
                return Some((at, doubled));
            }
            doubled = true;
            at += 2;
        }
    }
}

/// Line breaks inside a quoted cell.
fn breaks(inside: &[u8]) -> usize {
    let pair = |window: &[u8]| window == b"\r\n";
    let single = inside.iter().filter(|byte| matches!(byte, b'\r' | b'\n')).count();
    single - inside.windows(2).filter(|window| pair(window)).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn split(text: &[u8], delimiter: Delimiter) -> Vec<(usize, Vec<String>)> {
        let mut rows = Rows::new(text, delimiter);
        let mut cells = Vec::new();
        let mut found = Vec::new();
        while let Some(line) = rows.next(&mut cells) {
            let texts = cells.iter().map(|cell| String::from_utf8_lossy(&cell.of(text)).into_owned());
            found.push((line, texts.collect()));
        }
        found
    }

    #[test]
    fn quotes_blanks_and_every_line_end_are_understood() {
        let text = b"a, \"b, c\" ,\"d \"\"e\"\"\"\r\n\r1,,\n \"two\nlines\" ,3\" x,\"open\n4";
        let rows = split(text, Delimiter::Byte(b','));
        let expected: [(usize, &[&str]); 4] = [
            (1, &["a", "b, c", "d \"e\""]),
            (3, &["1", "", ""]),
            (4, &["two\nlines", "3\" x", "\"open"]),
            (6, &["4"]),
        ];
        for ((line, cells), (expected_line, texts)) in rows.iter().zip(expected) {
            assert_eq!(
                (*line, cells.iter().map(String::as_str).collect::<Vec<_>>()),
                (expected_line, texts.to_vec())
            );
        }
        assert_eq!(rows.len(), 4);
    }

    #[test]
    fn blanks_are_one_delimiter() {
        let rows = split(b"  1.5  2\t3 \n4 5 6", Delimiter::Blank);
        assert_eq!(rows[0].1, ["1.5", "2", "3"]);
        assert_eq!(rows[1].1, ["4", "5", "6"]);
    }

    proptest! {
        /// The crate `csv` 1.4 is the independent reader: it trims nothing, hence the blanks are left out.
        #[test]
        fn rows_are_those_of_another_reader(
            rows in prop::collection::vec(prop::collection::vec("[a-z0-9.,;\"é\n-]{0,6}", 1..5), 1..8),
            delimiter in prop::sample::select(b",;\t|".to_vec()),
            crlf in any::<bool>(),
        ) {
            let mut writer = csv::WriterBuilder::new().delimiter(delimiter).flexible(true)
                .terminator(if crlf { csv::Terminator::CRLF } else { csv::Terminator::Any(b'\n') })
                .from_writer(Vec::new());
            for row in &rows {
                writer.write_record(row).unwrap();
            }
            let bytes = writer.into_inner().unwrap();
            let mut reader = csv::ReaderBuilder::new().delimiter(delimiter).flexible(true).has_headers(false)
                .from_reader(bytes.as_slice());
            let theirs: Vec<Vec<String>> = reader.records()
                .map(|record| record.unwrap().iter().map(|cell| cell.trim_end_matches('\n').to_owned()).collect())
                .filter(|row: &Vec<String>| row.len() > 1 || !row[0].is_empty())
                .collect();
            let ours: Vec<Vec<String>> = split(&bytes, Delimiter::Byte(delimiter)).into_iter()
                .map(|(_, row)| row.into_iter().map(|cell| cell.trim_end_matches('\n').to_owned()).collect())
                .filter(|row: &Vec<String>| row.len() > 1 || !row[0].is_empty())
                .collect();
            prop_assert_eq!(ours, theirs);
        }

        #[test]
        fn no_bytes_make_it_panic_or_leave_the_text(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            for delimiter in [Delimiter::Byte(b','), Delimiter::Byte(b'\t'), Delimiter::Blank] {
                let lines = split(&bytes, delimiter).len();
                prop_assert!(lines <= bytes.len());
            }
        }
    }
}
