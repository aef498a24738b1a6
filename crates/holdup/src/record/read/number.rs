//! Cells to numbers: decimal mark, thousands separators, signs.

use super::column::TextColumn;

/// What separates the whole from the fraction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DecimalMark {
    /// 1.5
    Point,
    /// 1,5
    Comma,
}

/// The longest cell that can be a number [bytes].
const LONGEST: usize = 48;

/// The decimal mark of a file, from all its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Marks {
    /// What separates the fraction.
    pub(super) mark: DecimalMark,
    /// Whether the numbers would be others, but also numbers, with the other mark.
    pub(super) assumed: bool,
}

/// What the commas of a column can be.
#[derive(Debug, Default)]
struct Evidence {
    decimal: usize,
    thousands: usize,
    either: usize,
    plain: usize,
}

/// Decides from whole columns. A comma is the decimal mark where one cell can be read no other way (`1,5`, `0,125`,
/// `1.234,5`), and separates thousands where one can be read only so (`1,234.5`, `1,234,567`). Where every comma has
/// three digits behind it, `45,123` beside `45` means thousands, but a column in which every number has them is
/// one of three decimals.
pub(super) fn marks(columns: &[&TextColumn]) -> Marks {
    let mut evidence = Evidence::default();
    for column in columns.iter().filter(|column| column.has(b',')) {
        for cell in column.cells() {
            weigh(cell, &mut evidence);
        }
    }
    let Evidence { decimal, thousands, either, plain } = evidence;
    let mark = match (decimal > thousands, thousands > 0) {
        (true, _) => DecimalMark::Comma,
        (false, false) if either > 0 && plain == 0 => DecimalMark::Comma,
        _ => DecimalMark::Point,
    };
    Marks { mark, assumed: either > 0 && decimal == 0 && thousands == 0 }
}

fn weigh(cell: &[u8], evidence: &mut Evidence) {
    if cell.is_empty() || cell.len() > LONGEST || !plausible(cell) {
        return;
    }
    let Some(last) = cell.iter().rposition(|byte| *byte == b',') else {
        evidence.plain += 1;
        return;
    };
    let point = cell.iter().rposition(|byte| *byte == b'.');
    let before = cell[..last].iter().filter(|byte| byte.is_ascii_digit()).count();
    let behind = cell[last + 1..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let leading_zero = before == 1 && cell[..last].contains(&b'0');
    match point {
        Some(point) if point < last => evidence.decimal += 1,
        Some(_) => evidence.thousands += 1,
        None if cell[..last].contains(&b',') => evidence.thousands += 1,
        None if behind != 3 || before > 3 || before == 0 || leading_zero => evidence.decimal += 1,
        None => evidence.either += 1,
    }
}

/// Whether a cell may be a number under some decimal mark: digits, and only what numbers are written with.
pub(super) fn plausible(cell: &[u8]) -> bool {
    let first = cell.iter().find(|byte| !matches!(byte, b'+' | b'-' | b' '));
    let start = first.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b','));
    start
        && cell.len() <= LONGEST
        && cell.iter().any(u8::is_ascii_digit)
        && [DecimalMark::Point, DecimalMark::Comma].into_iter().any(|mark| number(cell, mark).is_some())
}

/// The number in a cell; none where there is none, or no finite one.
pub(super) fn number(cell: &[u8], mark: DecimalMark) -> Option<f64> {
    let simple = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+' | b'e' | b'E');
    if cell.iter().all(simple) && (mark == DecimalMark::Point || !cell.contains(&b'.')) {
        return finite(cell);
    }
    if cell.len() > LONGEST {
        return None;
    }
    let mut plain = [0_u8; LONGEST];
    let length = normalised(cell, mark, &mut plain)?;
    finite(&plain[..length])
}

fn finite(digits: &[u8]) -> Option<f64> {
    let value: f64 = std::str::from_utf8(digits).ok()?.parse().ok()?;
    value.is_finite().then_some(value)
}

/// Writes the number with a point and without separators; none where the separators are not in their places.
fn normalised(cell: &[u8], mark: DecimalMark, plain: &mut [u8; LONGEST]) -> Option<usize> {
    let (point, thousand) = match mark {
        DecimalMark::Point => (b'.', b','),
        DecimalMark::Comma => (b',', b'.'),
    };
    let cell = cell.strip_suffix(b"%").map_or(cell, <[u8]>::trim_ascii_end);
    // The minus sign of typesetting, U+2212.
    let (sign, mut rest) = match cell.strip_prefix("\u{2212}".as_bytes()) {
        Some(rest) => (Some(b'-'), rest),
        None => (None, cell),
    };
    let mut length = 0;
    let mut push = |byte: u8| {
        plain[length] = byte;
        length += 1;
    };
    if let Some(sign) = sign {
        push(sign);
    }
    // Digits since the last separator of thousands; none before the first.
    let (mut group, mut grouped, mut whole) = (0_usize, false, true);
    let mut separator = None;
    while let Some((&byte, behind)) = rest.split_first() {
        let gap =
            [&b" "[..], b"'", "\u{a0}".as_bytes(), "\u{202f}".as_bytes(), "\u{2019}".as_bytes(), b"\xa0"]
                .into_iter()
                .find(|gap| rest.starts_with(gap));
        if whole && (byte == thousand || gap.is_some()) {
            let width = gap.map_or(1, <[u8]>::len);
            let wrong_group = if grouped { group != 3 } else { group == 0 || group > 3 };
            if wrong_group || separator.is_some_and(|own| own != &rest[..width]) {
                return None;
            }
            separator = Some(&rest[..width]);
            (grouped, group, rest) = (true, 0, &rest[width..]);
            continue;
        }
        match byte {
            b'0'..=b'9' => {
                group += 1;
                push(byte);
            }
            _ if byte == point && whole => {
                if grouped && group != 3 {
                    return None;
                }
                whole = false;
                push(b'.');
            }
            b'-' | b'+' | b'e' | b'E' => {
                if grouped && whole && group != 3 {
                    return None;
                }
                whole &= !matches!(byte, b'e' | b'E');
                push(byte);
            }
            _ => return None,
        }
        rest = behind;
    }
    (!(grouped && whole && group != 3)).then_some(length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_under_both_marks_and_nothing_else_is() {
        for (cell, mark, value) in [
            ("1.5", DecimalMark::Point, Some(1.5)),
            ("-1,234.5", DecimalMark::Point, Some(-1234.5)),
            ("1,234,567", DecimalMark::Point, Some(1_234_567.0)),
            ("1 234.5", DecimalMark::Point, Some(1234.5)),
            ("1'234'567.25", DecimalMark::Point, Some(1_234_567.25)),
            ("45.2 %", DecimalMark::Point, Some(45.2)),
            ("\u{2212}3.5", DecimalMark::Point, Some(-3.5)),
            ("1,5", DecimalMark::Comma, Some(1.5)),
            ("1.234,5", DecimalMark::Comma, Some(1234.5)),
            ("1,5E-3", DecimalMark::Comma, Some(0.0015)),
            (",5", DecimalMark::Comma, Some(0.5)),
            ("1\u{202f}234,5", DecimalMark::Comma, Some(1234.5)),
            ("1,5", DecimalMark::Point, None),
            ("12,34,567", DecimalMark::Point, None),
            ("1,234 567", DecimalMark::Point, None),
            ("1.5", DecimalMark::Comma, None),
            ("nan", DecimalMark::Point, None),
            ("inf", DecimalMark::Point, None),
            ("1e999", DecimalMark::Point, None),
            ("0x10", DecimalMark::Point, None),
            ("", DecimalMark::Point, None),
            ("-", DecimalMark::Comma, None),
        ] {
            assert_eq!(number(cell.as_bytes(), mark), value, "{cell}");
        }
    }

    #[test]
    fn the_mark_is_decided_from_the_whole_column() {
        for (cells, mark, assumed) in [
            (&["1.5", "2"][..], DecimalMark::Point, false),
            (&["1,5", "2"], DecimalMark::Comma, false),
            (&["45,123", "45,1"], DecimalMark::Comma, false),
            (&["1,234", "1,234.5"], DecimalMark::Point, false),
            (&["1,234", "1,234,567"], DecimalMark::Point, false),
            (&["1,234", "999"], DecimalMark::Point, true),
            (&["45,123", "45,124", "Bad"], DecimalMark::Comma, true),
            (&["0,125", "45,124"], DecimalMark::Comma, false),
            (&["1.234,5", "12,500"], DecimalMark::Comma, false),
        ] {
            let mut column = TextColumn::default();
            for cell in cells {
                column.push(cell.as_bytes());
            }
            assert_eq!(marks(&[&column]), Marks { mark, assumed }, "{cells:?}");
        }
    }
}
