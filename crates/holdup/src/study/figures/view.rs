//! The part of the plane that a panel shows, and the curves cut to it.
//!
//! Everything is placed in fractions of the panel: (0, 0) is the lower left corner, (1, 1) the upper right.
use super::figure::{Axis, Figure, Panel, Scale};
use super::series::{Reference, Series, around};
use super::ticks::{self, Tick};

/// Points that are joined.
pub(super) type Stroke = Vec<(f64, f64)>;

/// The ends of an axis, in decades where it is logarithmic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    scale: Scale,
    low: f64,
    high: f64,
}

impl Span {
    fn fitted(axis: &Axis, values: impl Iterator<Item = f64>, padding: f64) -> Self {
        let scale = axis.scale();
        if let Some((low, high)) = axis.range() {
            return Self { scale, low: on(scale, low).unwrap_or(0.0), high: on(scale, high).unwrap_or(1.0) };
        }
        let (low, high) = values
            .filter_map(|v| on(scale, v))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        if low > high {
            return Self { scale, low: 0.0, high: 1.0 };
        }
        let least = 1e-9 * low.abs().max(high.abs());
        let padding = if high - low > least { padding * (high - low) } else { (0.1 * high.abs()).max(0.5) };
        Self { scale, low: low - padding, high: high + padding }
    }

    fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high), ..self }
    }

    /// The span `factor` times as long around the same middle.
    fn widened(self, factor: f64) -> Self {
        let (middle, half) = (f64::midpoint(self.low, self.high), 0.5 * factor * (self.high - self.low));
        Self { low: middle - half, high: middle + half, ..self }
    }

    fn length(self) -> f64 {
        self.high - self.low
    }

    /// The ends as plotly.js wants them: decades on a logarithmic axis.
    #[cfg(feature = "report")]
    pub(super) fn ends(self) -> [f64; 2] {
        [self.low, self.high]
    }

    /// Where the value stands: 0 at the low end, 1 at the high end. `None` where the axis does not have it.
    pub(super) fn place(self, value: f64) -> Option<f64> {
        // Far outside is far enough: products of larger places overflow.
        on(self.scale, value).map(|v| ((v - self.low) / self.length()).clamp(-1e9, 1e9))
    }

    /// About `count` ticks.
    pub(super) fn ticks(self, count: usize, step: Option<f64>) -> Vec<Tick> {
        match self.scale {
            Scale::Linear => ticks::linear(self.low, self.high, count, step),
            Scale::Logarithmic => ticks::logarithmic(10_f64.powf(self.low), 10_f64.powf(self.high), count),
        }
    }
}

fn on(scale: Scale, value: f64) -> Option<f64> {
    match scale {
        Scale::Linear => Some(value),
        Scale::Logarithmic => (value > 0.0).then(|| value.log10()),
    }
}

/// What a panel shows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    pub(super) x: Span,
    pub(super) y: Span,
}

/// The view of each panel, of a shape of `height` over `width`.
pub(super) fn views(figure: &Figure, height: f64, width: f64) -> Vec<View> {
    let panels = figure.panels();
    let Some(lowest) = panels.last() else { return Vec::new() };
    let x = panels.iter().map(|panel| x_span(panel, lowest)).reduce(Span::joined);
    let Some(x) = x else { return Vec::new() };
    let view = |panel: &Panel| {
        let view = View { x, y: y_span(panel, x) };
        if panel.is_equal_aspect() { view.equal(height / width) } else { view }
    };
    panels.iter().map(view).collect()
}

fn x_span(panel: &Panel, lowest: &Panel) -> Span {
    let values = panel.series().iter().flat_map(Series::points).flatten().map(|(x, _)| x);
    let references = panel.references().iter().flat_map(|reference| match reference {
        Reference::Horizontal { .. } => vec![],
        Reference::Vertical { at, .. } => vec![*at],
        Reference::Circle { centre, radius, .. } => vec![centre.0 - radius, centre.0 + radius],
    });
    Span::fitted(
        &lowest.x().clone(),
        values.chain(references),
        if panel.is_equal_aspect() { 0.04 } else { 0.0 },
    )
}

fn y_span(panel: &Panel, x: Span) -> Span {
    let shown = |at: &(f64, f64)| x.place(at.0).is_some_and(|place| (-1e-9..=1.0 + 1e-9).contains(&place));
    let values = panel.series().iter().flat_map(Series::points).flatten().filter(shown).map(|(_, y)| y);
    let references = panel.references().iter().flat_map(|reference| match reference {
        Reference::Horizontal { at, .. } => vec![*at],
        Reference::Vertical { .. } => vec![],
        Reference::Circle { centre, radius, .. } => vec![centre.1 - radius, centre.1 + radius],
    });
    Span::fitted(panel.y(), values.chain(references), 0.05)
}

impl View {
    fn equal(self, shape: f64) -> Self {
        let ratio = self.x.length() * shape / self.y.length();
        if ratio > 1.0 {
            Self { y: self.y.widened(ratio), ..self }
        } else {
            Self { x: self.x.widened(1.0 / ratio), ..self }
        }
    }

    fn place(self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        Some((self.x.place(x)?, self.y.place(y)?))
    }

    /// The line of the series, in pieces where it has gaps or leaves the panel.
    pub(super) fn strokes(self, series: &Series) -> Vec<Stroke> {
        let mut strokes = vec![Stroke::new()];
        for point in series.points() {
            match (point.and_then(|point| self.place(point)), strokes.last_mut()) {
                (Some(place), Some(stroke)) => {
                    if let (true, Some(&last)) = (series.is_held(), stroke.last()) {
                        stroke.push((place.0, last.1));
                    }
                    stroke.push(place);
                }
                _ => strokes.push(Stroke::new()),
            }
        }
        strokes.iter().flat_map(|stroke| cut_to_panel(stroke)).collect()
    }

    /// The points of the series that the panel shows.
    pub(super) fn marks(self, series: &Series) -> Stroke {
        let inside = |at: &(f64, f64)| (0.0..=1.0).contains(&at.0) && (0.0..=1.0).contains(&at.1);
        series.points().flatten().filter_map(|point| self.place(point)).filter(inside).collect()
    }

    /// The line of a reference.
    pub(super) fn reference(self, reference: &Reference) -> Vec<Stroke> {
        let line = match reference {
            Reference::Horizontal { at, .. } => self.y.place(*at).map(|y| vec![(0.0, y), (1.0, y)]),
            Reference::Vertical { at, .. } => self.x.place(*at).map(|x| vec![(x, 0.0), (x, 1.0)]),
            Reference::Circle { centre, radius, .. } => {
                Some(around(*centre, *radius).into_iter().filter_map(|point| self.place(point)).collect())
            }
        };
        line.map(|line| cut_to_panel(&line)).unwrap_or_default()
    }
}

/// The parts of the line that lie in the panel.
fn cut_to_panel(line: &[(f64, f64)]) -> Vec<Stroke> {
    let mut parts: Vec<Stroke> = Vec::new();
    for pair in line.windows(2) {
        let Some((from, to)) = cut_to_square(pair[0], pair[1]) else { continue };
        match parts.last_mut() {
            Some(part) if part.last() == Some(&from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
    }
    parts
}

/// Liang and Barsky's clipping of one segment, here to the unit square.
fn cut_to_square(from: (f64, f64), to: (f64, f64)) -> Option<((f64, f64), (f64, f64))> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (step, room) in [(-dx, from.0), (dx, 1.0 - from.0), (-dy, from.1), (dy, 1.0 - from.1)] {
        if step == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if step < 0.0 {
            enter = enter.max(room / step);
        } else {
            leave = leave.min(room / step);
        }
    }
    let at = |t: f64| (from.0 + t * dx, from.1 + t * dy);
    // An end that is not cut stays as it is, so that pieces are recognised as joined.
    let start = if enter == 0.0 { from } else { at(enter) };
    let end = if leave == 1.0 { to } else { at(leave) };
    (enter <= leave).then_some((start, end))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::figures::Axis;

    fn square() -> Panel {
        let axis = || Axis::linear("a").with_range(0.0, 10.0).unwrap();
        Panel::new(axis(), axis())
    }

    fn strokes_of(panel: &Panel, series: &Series) -> Vec<Stroke> {
        let figure = Figure::new("a", vec![panel.clone()]).unwrap();
        views(&figure, 1.0, 1.0)[0].strokes(series)
    }

    #[test]
    fn a_gap_parts_the_line() {
        let nan = f64::NAN;
        let series =
            Series::new("a", vec![0.0, 5.0, 6.0, 7.0, 10.0], vec![0.0, 5.0, nan, 5.0, 10.0]).unwrap();
        let expected = [vec![(0.0, 0.0), (0.5, 0.5)], vec![(0.7, 0.5), (1.0, 1.0)]];
        assert_eq!(strokes_of(&square(), &series), expected);
    }

    #[test]
    fn a_line_that_leaves_the_panel_ends_at_its_border() {
        let series = Series::new("a", vec![0.0, 5.0, 10.0], vec![0.0, 20.0, 0.0]).unwrap();
        let expected = [vec![(0.0, 0.0), (0.25, 1.0)], vec![(0.75, 1.0), (1.0, 0.0)]];
        assert_eq!(strokes_of(&square(), &series), expected);
    }

    #[test]
    fn a_held_series_is_a_staircase() {
        let series = Series::new("a", vec![0.0, 5.0, 10.0], vec![0.0, 10.0, 10.0]).unwrap().held();
        let expected = [vec![(0.0, 0.0), (0.5, 0.0), (0.5, 1.0), (1.0, 1.0), (1.0, 1.0)]];
        assert_eq!(strokes_of(&square(), &series), expected);
    }

    #[test]
    fn a_logarithmic_axis_has_no_place_for_zero() {
        let span = Span { scale: Scale::Logarithmic, low: -1.0, high: 1.0 };
        assert_eq!(span.place(0.0), None);
        assert_eq!(span.place(1.0), Some(0.5));
    }

    #[test]
    fn equal_aspect_gives_one_unit_the_same_length_on_both_axes() {
        let figure = Figure::new("a", vec![square().with_equal_aspect()]).unwrap();
        let view = views(&figure, 300.0, 600.0)[0];
        assert_eq!(view.x.length() / 600.0, view.y.length() / 300.0);
    }

    #[test]
    fn a_response_that_explodes_has_finite_places() {
        let series = Series::new("a", vec![0.0, 1.0], vec![-1e300, 1e300]).unwrap();
        let panel = Panel::new(Axis::linear("a"), Axis::linear("b")).with_series(series.clone());
        let places = strokes_of(&panel, &series);
        assert!(!places.is_empty());
        assert!(places.iter().flatten().all(|(x, y)| x.is_finite() && y.is_finite()));
        assert!(strokes_of(&square(), &series).iter().flatten().all(|(x, y)| x.is_finite() && y.is_finite()));
    }
}
