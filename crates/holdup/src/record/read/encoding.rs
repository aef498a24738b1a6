//! Bytes of a file to bytes of text: byte-order marks, UTF-16, and what is no text at all.

use std::borrow::Cow;

use super::ReadError;

/// Bytes that are looked at to tell text from what is none.
const SAMPLE: usize = 64 << 10;

/// First bytes of files that people save beside their text exports.
const KNOWN: [(&[u8], &str); 5] = [
    (b"PK\x03\x04", "an Excel workbook or another zip archive"),
    (b"\xd0\xcf\x11\xe0", "an Excel workbook of the old format"),
    (b"\x1f\x8b", "a gzip archive"),
    (b"\x28\xb5\x2f\xfd", "a zstd archive"),
    (b"\x89HDF", "an HDF5 file"),
];

/// The text in the bytes of a file, and how it was encoded. Separators are ASCII in what is returned; letters
/// beyond ASCII are UTF-8, or Latin-1 where the file has them so.
pub(super) fn text(bytes: &[u8]) -> Result<(Cow<'_, [u8]>, &'static str), ReadError> {
    if bytes.is_empty() {
        return Err(ReadError::Empty);
    }
    if let Some((_, what)) = KNOWN.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return Err(ReadError::NoText { what });
    }
    let sample = &bytes[..bytes.len().min(SAMPLE)];
    let (text, encoding) = if let Some(rest) = bytes.strip_prefix(b"\xef\xbb\xbf") {
        (Cow::Borrowed(rest), "UTF-8 with byte-order mark")
    } else if let Some(rest) = bytes.strip_prefix(b"\xff\xfe") {
        (Cow::Owned(wide(rest, u16::from_le_bytes)), "UTF-16 little-endian")
    } else if let Some(rest) = bytes.strip_prefix(b"\xfe\xff") {
        (Cow::Owned(wide(rest, u16::from_be_bytes)), "UTF-16 big-endian")
    } else if zeros(sample, 1) {
        (Cow::Owned(wide(bytes, u16::from_le_bytes)), "UTF-16 little-endian")
    } else if zeros(sample, 0) {
        (Cow::Owned(wide(bytes, u16::from_be_bytes)), "UTF-16 big-endian")
    } else {
        let whole = std::str::from_utf8(bytes).is_ok();
        let encoding = match (whole, bytes.is_ascii()) {
            (_, true) => "ASCII",
            (true, false) => "UTF-8",
            (false, false) => "Latin-1",
        };
        (Cow::Borrowed(bytes), encoding)
    };
    let sample = &text[..text.len().min(SAMPLE)];
    if sample.iter().all(u8::is_ascii_whitespace) && text.iter().all(u8::is_ascii_whitespace) {
        return Err(ReadError::Empty);
    }
    let control = |byte: &&u8| byte.is_ascii_control() && !byte.is_ascii_whitespace();
    // A few stray control characters are a historian's; one in twenty is no text.
    if sample.contains(&0) || sample.iter().filter(control).count() * 20 > sample.len() {
        return Err(ReadError::NoText { what: "binary data" });
    }
    Ok((text, encoding))
}

/// Whether nearly every second byte from `offset` is zero and the others are not: UTF-16 of Latin text.
fn zeros(sample: &[u8], offset: usize) -> bool {
    let zero = |from: usize| sample.iter().skip(from).step_by(2).filter(|byte| **byte == 0).count();
    let pairs = sample.len() / 2;
    pairs >= 4 && zero(offset) * 10 > pairs * 7 && zero(1 - offset) * 10 < pairs
}

/// UTF-16 as UTF-8; what is no character becomes U+FFFD.
fn wide(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Vec<u8> {
    let units = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
    char::decode_utf16(units)
        .map(|character| character.unwrap_or(char::REPLACEMENT_CHARACTER))
        .collect::<String>()
        .into_bytes()
}

/// A cell for people: UTF-8 as it is, anything else as Latin-1.
pub(super) fn readable(cell: &[u8]) -> String {
    match std::str::from_utf8(cell) {
        Ok(text) => text.to_owned(),
        Err(_) => cell.iter().map(|&byte| char::from(byte)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(bytes).collect()
    }

    #[test]
    fn every_encoding_gives_the_same_text() {
        let plain = "time;Füllstand\n0;1,5\n1;1,6\n";
        let little = utf16(plain, u16::to_le_bytes);
        let big = utf16(plain, u16::to_be_bytes);
        let marked = |mark: &[u8], rest: &[u8]| [mark, rest].concat();
        for bytes in [
            plain.as_bytes().to_vec(),
            marked(b"\xef\xbb\xbf", plain.as_bytes()),
            marked(b"\xff\xfe", &little),
            marked(b"\xfe\xff", &big),
            little,
            big,
        ] {
            assert_eq!(&*text(&bytes).unwrap().0, plain.as_bytes());
        }
    }

    #[test]
    fn what_is_no_text_is_named() {
        for (bytes, part) in [
            (&b""[..], "empty"),
            (b" \r\n\t", "empty"),
            (b"PK\x03\x04rest", "Excel"),
            (b"\x1f\x8b\x08", "gzip"),
            (b"\x01\x02\x03\x04\x05\x06,\x07", "binary"),
            (b"time,pv\n0,\0\n", "binary"),
        ] {
            let error = text(bytes).unwrap_err().to_string();
            assert!(error.contains(part), "{bytes:?}: {error}");
        }
    }

    #[test]
    fn letters_that_are_not_utf_8_are_latin_1() {
        assert_eq!(readable(b"F\xfcllstand"), "Füllstand");
        assert_eq!(readable("水位".as_bytes()), "水位");
    }
}
