//! Colours that people with any colour vision tell apart, on white and on black.
//!
//! M. Okabe and K. Ito, "Color Universal Design" (2002, revised 2008). Yellow and black are left out: the one
//! vanishes on white, the other on a dark page. The order puts the colours with most contrast to both first.
use super::series::Line;

/// A colour and the line that goes with it, so that lines are told apart without colour too.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Swatch {
    /// Red, green and blue.
    pub(super) rgb: [u8; 3],
    /// Line of a series whose line is automatic.
    pub(super) line: Line,
    /// Nearest of the 256 colours of a terminal.
    pub(super) terminal: u8,
}

const fn swatch(rgb: [u8; 3], line: Line, terminal: u8) -> Swatch {
    Swatch { rgb, line, terminal }
}

/// Blue, vermillion, bluish green, reddish purple, orange, sky blue.
const SWATCHES: [Swatch; 6] = [
    swatch([0x00, 0x72, 0xb2], Line::Solid, 32),
    swatch([0xd5, 0x5e, 0x00], Line::Dashed, 166),
    swatch([0x00, 0x9e, 0x73], Line::DashDotted, 36),
    swatch([0xcc, 0x79, 0xa7], Line::LongDashed, 175),
    swatch([0xe6, 0x9f, 0x00], Line::Dotted, 178),
    swatch([0x56, 0xb4, 0xe9], Line::Solid, 74),
];

/// What belongs to no controller: setpoints, circles, borders. Grey with contrast on white and on dark.
pub(super) const NEUTRAL: Swatch = swatch([0x80, 0x80, 0x80], Line::Solid, 245);

/// The look number `slot`; they begin again after the last.
pub(super) fn look(slot: Option<usize>) -> Swatch {
    slot.map_or(NEUTRAL, |slot| SWATCHES[slot % SWATCHES.len()])
}

/// The colour as CSS writes it.
#[cfg(feature = "report")]
pub(super) fn css(rgb: [u8; 3]) -> String {
    let [r, g, b] = rgb;
    format!("#{r:02x}{g:02x}{b:02x}")
}
