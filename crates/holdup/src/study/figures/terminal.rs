//! A figure as text for the terminal.
//!
//! Curves are braille dots, eight to a character. Letters on the curves tell them apart without colour.
use super::figure::{Figure, Panel};
use super::series::{Mark, Series};
use super::text::{columns, cut};
use super::ticks::Tick;
use super::view::{Stroke, View, views};
use std::fmt::Write;

/// Narrower terminals show the title only.
const LEAST_WIDTH: usize = 24;

/// Draws the figure as lines of at most `width` columns, each ended by a line break.
///
/// With `colour`, curves and their names are coloured by escape sequences, which take no column.
///
/// # Examples
/// See [`Figure`].
#[must_use]
pub fn chart(figure: &Figure, width: usize, colour: bool) -> String {
    let mut text = String::new();
    push_line(&mut text, &cut(figure.title(), width));
    if width < LEAST_WIDTH {
        return text;
    }
    let rows = rows_of(figure, width);
    // A first estimate of the room for labels: the ticks do not depend on it.
    let views = views(figure, (rows * 4).into_float(), ((width - 10) * 2).into_float());
    let y_ticks: Vec<Vec<Tick>> =
        figure.panels().iter().zip(&views).map(|(p, v)| y_ticks(p, *v, rows)).collect();
    let widest = y_ticks.iter().flatten().map(|tick| columns(&tick.label)).max().unwrap_or(0).min(9);
    let names = names(figure);
    for ((panel, view), ticks) in figure.panels().iter().zip(&views).zip(&y_ticks) {
        push_line(&mut text, &cut(panel.y().label(), width));
        let mut canvas = Canvas::new(width - widest - 2, rows);
        canvas.draw(figure, panel, *view, names.len() > 1);
        canvas.write(&mut text, widest, ticks, *view, colour);
    }
    if let (Some(panel), Some(view)) = (figure.panels().last(), views.last()) {
        push_line(&mut text, &x_labels(panel, *view, widest + 2, width));
        let label = cut(panel.x().label(), width);
        push_line(&mut text, &format!("{}{label}", " ".repeat(width - columns(&label))));
    }
    push_legend(&mut text, &names, width, colour);
    text
}

fn rows_of(figure: &Figure, width: usize) -> usize {
    match figure.panels() {
        [only] if only.is_equal_aspect() => (width / 3).clamp(8, 26),
        [_] => (width / 5).clamp(6, 16),
        _ => (width / 8).clamp(5, 10),
    }
}

fn y_ticks(panel: &Panel, view: View, rows: usize) -> Vec<Tick> {
    view.y.ticks((rows / 3).max(2), panel.y().tick_step())
}

fn push_line(text: &mut String, line: &str) {
    text.push_str(line.trim_end());
    text.push('\n');
}

/// A name of the legend with the letter and the terminal colour of its curve.
struct Name {
    words: String,
    letter: char,
    colour: u8,
}

fn names(figure: &Figure) -> Vec<Name> {
    let name = |(order, series): (usize, &Series)| {
        let colour = figure.look(series).terminal;
        Name { words: series.name().to_owned(), letter: sign(series, order), colour }
    };
    figure.named().into_iter().enumerate().map(name).collect()
}

/// What stands on the curve and before its name in the legend.
fn sign(series: &Series, order: usize) -> char {
    match series.mark() {
        Some(Mark::Cross) => '×',
        Some(Mark::Disc) => '●',
        None => ('a'..='z').cycle().nth(order).unwrap_or('a'),
    }
}

/// The names in as many lines as they need.
fn push_legend(text: &mut String, names: &[Name], width: usize, colour: bool) {
    let (mut line, mut used) = (String::new(), 0);
    for Name { words, letter, colour: code } in names {
        let entry = if names.len() > 1 { format!("{letter} {words}") } else { words.clone() };
        let entry = cut(&entry, width);
        let needed = columns(&entry) + if used > 0 { 3 } else { 0 };
        if used > 0 && used + needed > width {
            push_line(text, &line);
            (line, used) = (String::new(), 0);
        }
        if used > 0 {
            line.push_str("   ");
            used += 3;
        }
        used += columns(&entry);
        push_coloured(&mut line, &entry, colour.then_some(*code));
    }
    if used > 0 {
        push_line(text, &line);
    }
}

/// The numbers under the axis, where they do not touch each other.
fn x_labels(panel: &Panel, view: View, left: usize, width: usize) -> String {
    let mut line = String::new();
    let room = (width - left - 1).into_float();
    for tick in view.x.ticks((width / 12).max(2), panel.x().tick_step()) {
        let Some(place) = view.x.place(tick.at) else { continue };
        let middle = left + cell(place * room);
        let taken = columns(&tick.label);
        let start = middle.saturating_sub(taken / 2).min(width.saturating_sub(taken));
        let free = columns(&line);
        if taken > 0 && (start > free || free == 0) {
            line.push_str(&" ".repeat(start - free));
            line.push_str(&tick.label);
        }
    }
    line
}

/// One character of the picture.
#[derive(Debug, Clone, Copy, Default)]
struct Cell {
    dots: u8,
    letter: Option<char>,
    colour: Option<u8>,
}

struct Canvas {
    columns: usize,
    rows: usize,
    cells: Vec<Cell>,
}

impl Canvas {
    fn new(columns: usize, rows: usize) -> Self {
        Self { columns, rows, cells: vec![Cell::default(); columns * rows] }
    }

    fn draw(&mut self, figure: &Figure, panel: &Panel, view: View, lettered: bool) {
        for stroke in panel.references().iter().flat_map(|reference| view.reference(reference)) {
            self.stroke(&stroke, 245, 2);
        }
        for series in panel.series() {
            let colour = figure.look(series).terminal;
            for stroke in view.strokes(series) {
                self.stroke(&stroke, colour, 1);
            }
            for place in view.marks(series).into_iter().filter(|_| series.mark().is_some()) {
                self.letter(place, sign(series, 0), colour);
            }
        }
        let named = figure.named();
        for series in panel.series().iter().filter(|series| lettered && series.mark().is_none()) {
            let Some(order) = named.iter().position(|other| other.name() == series.name()) else { continue };
            let letter = sign(series, order);
            let look = figure.look(series).terminal;
            for place in letter_places(&view.strokes(series), order, named.len()) {
                self.letter(place, letter, look);
            }
        }
    }

    fn stroke(&mut self, stroke: &Stroke, colour: u8, every: usize) {
        let (width, height) = ((self.columns * 2 - 1).into_float(), (self.rows * 4 - 1).into_float());
        let mut drawn = 0_usize;
        for pair in stroke.windows(2) {
            let ((x0, y0), (x1, y1)) = (pair[0], pair[1]);
            let (dx, dy) = ((x1 - x0) * width, (y1 - y0) * height);
            let steps = cell(dx.abs().max(dy.abs()).ceil()).max(1);
            for step in 0..=steps {
                let t = step.into_float() / steps.into_float();
                if drawn.is_multiple_of(every) {
                    self.dot(cell(x0 * width + t * dx), cell((1.0 - y0) * height - t * dy), colour);
                }
                drawn += 1;
            }
        }
    }

    fn dot(&mut self, x: usize, y: usize, colour: u8) {
        const BITS: [[u8; 4]; 2] = [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]];
        if let Some(cell) = self.cells.get_mut(y / 4 * self.columns + x / 2) {
            cell.dots |= BITS[x % 2][y % 4];
            cell.colour = Some(colour);
        }
    }

    /// Row and column of the character in which the place lies.
    fn character(&self, (x, y): (f64, f64)) -> (usize, usize) {
        let (width, height) = ((self.columns * 2 - 1).into_float(), (self.rows * 4 - 1).into_float());
        (cell((1.0 - y) * height) / 4, cell(x * width) / 2)
    }

    fn letter(&mut self, place: (f64, f64), letter: char, colour: u8) {
        let (row, column) = self.character(place);
        if let Some(cell) = self.cells.get_mut(row * self.columns + column) {
            cell.letter = Some(letter);
            cell.colour = Some(colour);
        }
    }

    fn write(&self, text: &mut String, widest: usize, ticks: &[Tick], view: View, colour: bool) {
        let row_of = |tick: &Tick| view.y.place(tick.at).map(|place| self.character((0.0, place)).0);
        for row in 0..self.rows {
            let tick = ticks.iter().find(|tick| !tick.label.is_empty() && row_of(tick) == Some(row));
            let label = tick.map_or("", |tick| &tick.label);
            let label = cut(label, widest);
            let mut line = format!(
                "{}{label} {}",
                " ".repeat(widest - columns(&label)),
                if tick.is_some() { '┤' } else { '│' }
            );
            for cell in &self.cells[row * self.columns..(row + 1) * self.columns] {
                cell.write(&mut line, colour);
            }
            push_line(text, &line);
        }
        push_line(text, &format!("{}└{}", " ".repeat(widest + 1), "─".repeat(self.columns)));
    }
}

impl Cell {
    fn write(self, line: &mut String, colour: bool) {
        let dots = char::from_u32(0x2800 + u32::from(self.dots)).filter(|_| self.dots > 0).unwrap_or(' ');
        let shown = self.letter.unwrap_or(dots);
        push_coloured(line, shown.encode_utf8(&mut [0; 4]), self.colour.filter(|_| colour));
    }
}

fn push_coloured(line: &mut String, text: &str, colour: Option<u8>) {
    match colour {
        // Writing to a string cannot fail.
        Some(code) => _ = write!(line, "\x1b[38;5;{code}m{text}\x1b[0m"),
        None => line.push_str(text),
    }
}

/// Three places along the drawn line, other ones for each series.
fn letter_places(strokes: &[Stroke], order: usize, series: usize) -> Vec<(f64, f64)> {
    let pairs = || strokes.iter().flat_map(|stroke| stroke.windows(2));
    let length = |pair: &[(f64, f64)]| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1);
    let total: f64 = pairs().map(length).sum();
    let place = |share: f64| {
        let mut left = share * total;
        pairs().find_map(|pair| {
            let step = length(pair);
            if left > step || step == 0.0 {
                left -= step;
                return None;
            }
            let t = left / step;
            Some((pair[0].0 + t * (pair[1].0 - pair[0].0), pair[0].1 + t * (pair[1].1 - pair[0].1)))
        })
    };
    let shares =
        (0..3_usize).map(|k| (k.into_float() + (order.into_float() + 0.5) / series.into_float()) / 3.0);
    shares.filter_map(place).collect()
}

trait IntoFloat {
    fn into_float(self) -> f64;
}

impl IntoFloat for usize {
    fn into_float(self) -> f64 {
        f64::from(u32::try_from(self).unwrap_or(u32::MAX))
    }
}

/// The number of the cell at this place; places left of the first are the first.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "places are fractions of a terminal"
)]
fn cell(place: f64) -> usize {
    place.round().max(0.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::figures::{Axis, Reference};

    fn figure() -> Figure {
        let x: Vec<f64> = (0..200).map(f64::from).collect();
        let wave = |f: f64| x.iter().map(|t| (t * f).sin() * 1e5).collect();
        let panel =
            Panel::new(Axis::linear("time [s]"), Axis::linear("controlled variable, rather long to say [m]"))
                .with_series(
                    Series::new("Wang–Cluett with β = 4 and more words", x.clone(), wave(0.05)).unwrap(),
                )
                .with_series(Series::new("水位制御 水位制御 水位制御", x.clone(), wave(0.03)).unwrap())
                .with_reference(Reference::horizontal(0.0, "zero").unwrap());
        Figure::new("A title that is longer than a narrow terminal is wide", vec![panel.clone(), panel])
            .unwrap()
    }

    #[test]
    fn no_line_is_wider_than_the_terminal() {
        for width in [0, 1, 10, 24, 25, 40, 79, 80, 81, 200] {
            for line in chart(&figure(), width, false).lines() {
                assert!(columns(line) <= width, "{width}: {line}");
            }
        }
    }

    #[test]
    fn plain_text_has_no_escape_sequence_and_coloured_text_resets_each() {
        assert!(!chart(&figure(), 80, false).contains('\x1b'));
        let coloured = chart(&figure(), 80, true);
        assert_eq!(coloured.matches("\x1b[38;5;").count(), coloured.matches("\x1b[0m").count());
        assert!(coloured.contains("\x1b[38;5;32m"));
    }

    #[test]
    fn names_units_and_numbers_are_shown() {
        let text = chart(&figure(), 80, false);
        for part in ["a Wang–Cluett", "b 水位制御", "time [s]", "[m]", " 100", " 0 ┤"] {
            assert!(text.contains(part), "{part} is missing in\n{text}");
        }
    }

    #[test]
    fn a_name_cannot_move_the_cursor() {
        let series = Series::new("\x1b[2Jevil", vec![0.0, 1.0], vec![0.0, 1.0]).unwrap();
        let panel = Panel::new(Axis::linear("x"), Axis::linear("y")).with_series(series);
        assert!(!chart(&Figure::new("\x07", vec![panel]).unwrap(), 80, false).contains(['\x1b', '\x07']));
    }

    #[test]
    fn a_panel_without_data_and_values_without_end_are_drawn() {
        let panel = |y: Vec<f64>| {
            let series = Series::new("a", vec![0.0, 1.0], y).unwrap();
            Panel::new(Axis::linear("x"), Axis::logarithmic("y")).with_series(series)
        };
        for y in [vec![f64::NAN, -1.0], vec![1e-300, 1e300], vec![0.0, 1.0]] {
            assert!(chart(&Figure::new("a", vec![panel(y)]).unwrap(), 60, false).lines().count() > 10);
        }
    }
}
