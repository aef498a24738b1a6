//! A figure laid out on paper: lines, discs and texts in pixels, which [`super::svg`] and [`super::png`] paint.
use super::figure::{Figure, Panel};
use super::palette::{NEUTRAL, Swatch};
use super::series::{Line, Mark, Reference, Series};
use super::text::columns;
use super::ticks::Tick;
use super::view::{View, views};

/// Width of a figure [px].
pub(super) const WIDTH: f64 = 800.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 22.0;
const LEGEND_ROW: f64 = 22.0;
const SMALL: f64 = 12.5;
const NORMAL: f64 = 13.5;
const LARGE: f64 = 17.0;

/// What lines and discs are painted with. All but the curves' colours follow the page, light or dark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Ink {
    /// Lines behind the curves.
    Grid,
    /// Border of a panel.
    Frame,
    /// A curve.
    Curve([u8; 3]),
}

/// Where a text's place is in the text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A text; its place is on the base line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Text {
    pub(super) at: (f64, f64),
    pub(super) words: String,
    pub(super) size: f64,
    pub(super) bold: bool,
    pub(super) anchor: Anchor,
    /// Reads from bottom to top.
    pub(super) upright: bool,
    /// With a border in the colour of the paper, to be read on top of lines.
    pub(super) lifted: bool,
}

/// One thing to paint.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    Stroke { points: Vec<(f64, f64)>, ink: Ink, width: f64, dash: &'static [f64] },
    Disc { centre: (f64, f64), radius: f64, ink: Ink },
    Text(Text),
}

/// All there is to paint, from back to front.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scene {
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) shapes: Vec<Shape>,
}

/// The dashes of a line, in pixels on and off; empty is solid.
fn dash(line: Line) -> &'static [f64] {
    match line {
        Line::Automatic | Line::None | Line::Solid => &[],
        Line::Dashed => &[8.0, 5.0],
        Line::Dotted => &[2.0, 4.0],
        Line::DashDotted => &[9.0, 4.0, 2.0, 4.0],
        Line::LongDashed => &[16.0, 5.0],
    }
}

/// Height of all panels together without legend and title [px].
pub(super) fn panels_height(figure: &Figure) -> f64 {
    match figure.panels() {
        [only] if only.is_equal_aspect() => 520.0,
        [_] => 330.0,
        several => several.iter().map(|_| 220.0).sum(),
    }
}

/// Lays the figure out; `titled` reserves room for its title.
pub(super) fn lay_out(figure: &Figure, titled: bool) -> Scene {
    let mut scene = Scene { width: WIDTH, height: 0.0, shapes: Vec::new() };
    let mut top = 14.0;
    if titled && !figure.title().is_empty() {
        // A title that is too long is made smaller: nothing breaks lines here.
        let size = LARGE.min(LARGE * (WIDTH - 40.0) / text_width(figure.title(), LARGE));
        scene.text((LEFT.min(20.0), 30.0), figure.title(), size, Anchor::Start).bold = true;
        top = 48.0;
    }
    let several = figure.panels().len();
    let gap = if several > 1 { 16.0 } else { 0.0 };
    let height = panels_height(figure) / f64::from(u32::try_from(several).unwrap_or(1)) - gap;
    let width = WIDTH - LEFT - RIGHT;
    for (index, (panel, view)) in figure.panels().iter().zip(views(figure, height, width)).enumerate() {
        let frame = Frame { left: LEFT, top, width, height };
        scene.panel(figure, panel, view, frame, index + 1 == several);
        top += height + gap;
    }
    top += 46.0 - gap;
    scene.height = scene.legend(figure, top);
    scene
}

#[derive(Debug, Clone, Copy)]
struct Frame {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl Frame {
    fn at(self, (x, y): (f64, f64)) -> (f64, f64) {
        (self.left + x * self.width, self.top + (1.0 - y) * self.height)
    }

    fn bottom(self) -> f64 {
        self.top + self.height
    }
}

impl Scene {
    fn text(&mut self, at: (f64, f64), words: &str, size: f64, anchor: Anchor) -> &mut Text {
        let text =
            Text { at, words: words.to_owned(), size, bold: false, anchor, upright: false, lifted: false };
        self.shapes.push(Shape::Text(text));
        match self.shapes.last_mut() {
            Some(Shape::Text(text)) => text,
            _ => unreachable!("a text was pushed one line above"),
        }
    }

    fn stroke(&mut self, points: Vec<(f64, f64)>, ink: Ink, width: f64, dash: &'static [f64]) {
        self.shapes.push(Shape::Stroke { points, ink, width, dash });
    }

    fn panel(&mut self, figure: &Figure, panel: &Panel, view: View, frame: Frame, lowest: bool) {
        let wide = if panel.is_equal_aspect() { 11 } else { 7 };
        let x_ticks = view.x.ticks(wide, figure.panels().last().and_then(|lowest| lowest.x().tick_step()));
        self.x_axis(&x_ticks, view, frame, lowest.then(|| panel.x().label()));
        let count = if frame.height > 400.0 {
            9
        } else if frame.height > 250.0 {
            8
        } else {
            5
        };
        self.y_axis(&view.y.ticks(count, panel.y().tick_step()), view, frame, panel.y().label());
        for reference in panel.references() {
            for line in view.reference(reference) {
                let points = line.into_iter().map(|point| frame.at(point)).collect();
                self.stroke(points, Ink::Curve(NEUTRAL.rgb), 1.3, &[5.0, 4.0]);
            }
        }
        for series in panel.series() {
            self.curve(series, figure.look(series), view, frame);
        }
        for reference in panel.references() {
            self.reference_label(reference, view, frame);
        }
        let (low, high) = (frame.at((0.0, 0.0)), frame.at((1.0, 1.0)));
        let border = vec![low, (high.0, low.1), high, (low.0, high.1), low];
        self.stroke(border, Ink::Frame, 1.0, &[]);
    }

    fn x_axis(&mut self, ticks: &[Tick], view: View, frame: Frame, label: Option<&str>) {
        for tick in ticks {
            let Some(place) = view.x.place(tick.at) else { continue };
            let (x, bottom) = frame.at((place, 0.0));
            self.stroke(vec![(x, frame.top), (x, bottom)], Ink::Grid, 1.0, &[]);
            if label.is_some() && !tick.label.is_empty() {
                self.stroke(vec![(x, bottom), (x, bottom + 5.0)], Ink::Frame, 1.0, &[]);
                self.text((x, bottom + 19.0), &tick.label, SMALL, Anchor::Middle);
            }
        }
        if let Some(label) = label {
            let middle = frame.left + 0.5 * frame.width;
            self.text((middle, frame.bottom() + 38.0), label, NORMAL, Anchor::Middle);
        }
    }

    fn y_axis(&mut self, ticks: &[Tick], view: View, frame: Frame, label: &str) {
        for tick in ticks {
            let Some(place) = view.y.place(tick.at) else { continue };
            let (left, y) = frame.at((0.0, place));
            self.stroke(vec![(left, y), (left + frame.width, y)], Ink::Grid, 1.0, &[]);
            if !tick.label.is_empty() {
                self.stroke(vec![(left - 5.0, y), (left, y)], Ink::Frame, 1.0, &[]);
                self.text((left - 9.0, y + 0.35 * SMALL), &tick.label, SMALL, Anchor::End);
            }
        }
        let size = NORMAL.min(NORMAL * frame.height / text_width(label, NORMAL));
        self.text((20.0, frame.top + 0.5 * frame.height), label, size, Anchor::Middle).upright = true;
    }

    fn curve(&mut self, series: &Series, look: Swatch, view: View, frame: Frame) {
        let ink = Ink::Curve(look.rgb);
        if look.line != Line::None {
            for stroke in view.strokes(series) {
                let points = thinned(stroke.into_iter().map(|point| frame.at(point)));
                self.stroke(points, ink, series.width(), dash(look.line));
            }
        }
        if let Some(mark) = series.mark() {
            for place in view.marks(series) {
                self.mark(mark, frame.at(place), ink);
            }
        }
    }

    fn mark(&mut self, mark: Mark, (x, y): (f64, f64), ink: Ink) {
        match mark {
            Mark::Disc => self.shapes.push(Shape::Disc { centre: (x, y), radius: 3.5, ink }),
            Mark::Cross => {
                self.stroke(vec![(x - 5.0, y - 5.0), (x + 5.0, y + 5.0)], ink, 2.0, &[]);
                self.stroke(vec![(x - 5.0, y + 5.0), (x + 5.0, y - 5.0)], ink, 2.0, &[]);
            }
        }
    }

    fn reference_label(&mut self, reference: &Reference, view: View, frame: Frame) {
        let shown = |place: &f64| (0.0..=1.0).contains(place);
        match reference {
            Reference::Horizontal { at, label } => {
                let Some(place) = view.y.place(*at).filter(shown) else { return };
                let (right, y) = frame.at((1.0, place));
                let y = if y - frame.top < 18.0 { y + 15.0 } else { y - 5.0 };
                self.text((right - 6.0, y), label, SMALL, Anchor::End).lifted = true;
            }
            Reference::Vertical { at, label } => {
                let Some(place) = view.x.place(*at).filter(shown) else { return };
                let (x, top) = frame.at((place, 1.0));
                let (x, anchor) =
                    if place > 0.75 { (x - 5.0, Anchor::End) } else { (x + 5.0, Anchor::Start) };
                self.text((x, top + 15.0), label, SMALL, anchor).lifted = true;
            }
            Reference::Circle { .. } => {}
        }
    }

    /// Draws the legend below everything, in as many rows as it needs, and returns where it ends.
    fn legend(&mut self, figure: &Figure, top: f64) -> f64 {
        let entries = legend_entries(figure);
        if entries.is_empty() {
            return top + 4.0;
        }
        let (mut x, mut y) = (LEFT, top + 16.0);
        for entry in entries {
            let width = 40.0 + text_width(&entry.name, NORMAL);
            if x > LEFT && x + width > WIDTH - RIGHT {
                (x, y) = (LEFT, y + LEGEND_ROW);
            }
            if entry.look.line != Line::None {
                let sample = vec![(x, y - 4.5), (x + 32.0, y - 4.5)];
                self.stroke(sample, Ink::Curve(entry.look.rgb), entry.width, entry.dash);
            }
            if let Some(mark) = entry.mark {
                self.mark(mark, (x + 16.0, y - 4.5), Ink::Curve(entry.look.rgb));
            }
            self.text((x + 40.0, y), &entry.name, NORMAL, Anchor::Start);
            x += width + 26.0;
        }
        y + 16.0
    }
}

struct Entry {
    name: String,
    look: Swatch,
    dash: &'static [f64],
    width: f64,
    mark: Option<Mark>,
}

fn legend_entries(figure: &Figure) -> Vec<Entry> {
    let curve = |series: &Series| {
        let look = figure.look(series);
        let name = series.name().to_owned();
        Entry { name, look, dash: dash(look.line), width: series.width(), mark: series.mark() }
    };
    let circle = |reference: &Reference| match reference {
        Reference::Circle { label, .. } if !label.is_empty() => {
            Some(Entry { name: label.clone(), look: NEUTRAL, dash: &[5.0, 4.0], width: 1.3, mark: None })
        }
        _ => None,
    };
    let circles = figure.panels().iter().flat_map(Panel::references).filter_map(circle);
    figure.named().into_iter().map(curve).chain(circles).collect()
}

/// About the width of the text in the font of the figures [px]; other fonts are rarely wider.
fn text_width(text: &str, size: f64) -> f64 {
    let narrow = text.chars().filter(|c| "iljtfrI.,:;'|!()[] ".contains(*c)).count();
    let wide = text.chars().filter(|c| "mwMWOQ%@—".contains(*c)).count();
    let float = |count: usize| f64::from(u32::try_from(count).unwrap_or(u32::MAX));
    size * (0.63 * float(columns(text)) - 0.24 * float(narrow) + 0.3 * float(wide)).max(0.1)
}

/// The line without the points that no eye misses: those within a quarter of a pixel of their predecessor, then
/// those within a tenth of a pixel of the line without them (Ramer, Douglas and Peucker's method).
fn thinned(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut near: Vec<(f64, f64)> = Vec::new();
    let mut skipped = None;
    for point in points {
        match near.last() {
            Some(last) if (last.0 - point.0).hypot(last.1 - point.1) < 0.25 => skipped = Some(point),
            _ => {
                near.push(point);
                skipped = None;
            }
        }
    }
    near.extend(skipped);
    let Some(last) = near.len().checked_sub(1) else { return near };
    let mut kept = vec![false; near.len()];
    (kept[0], kept[last]) = (true, true);
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let distances = (from + 1..to).map(|index| (index, distance(near[index], near[from], near[to])));
        if let Some((index, far)) = distances.max_by(|a, b| a.1.total_cmp(&b.1))
            && far > 0.1
        {
            kept[index] = true;
            open.extend([(from, index), (index, to)]);
        }
    }
    near.into_iter().zip(kept).filter_map(|(point, kept)| kept.then_some(point)).collect()
}

/// Distance of the point from the segment.
fn distance(point: (f64, f64), from: (f64, f64), to: (f64, f64)) -> f64 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 { ((point.0 - from.0) * dx + (point.1 - from.1) * dy) / length } else { 0.0 };
    let along = along.clamp(0.0, 1.0);
    (point.0 - from.0 - along * dx).hypot(point.1 - from.1 - along * dy)
}
