//! The figure, its panels and their axes.
use super::FigureError;
use super::palette::{self, Swatch};
use super::series::{Line, Reference, Series, Tone, finite};
use super::text::clean;

/// How values are laid out along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scale {
    /// Equal steps for equal differences.
    #[default]
    Linear,
    /// Equal steps for equal ratios; values that are not above 0 are gaps.
    Logarithmic,
}

/// An axis: what it shows with its unit in brackets, as in `time [s]`, its scale and its range.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    label: String,
    scale: Scale,
    range: Option<(f64, f64)>,
    tick_step: Option<f64>,
}

impl Axis {
    /// A linear axis that fits its data.
    #[must_use]
    pub fn linear(label: impl AsRef<str>) -> Self {
        Self { label: clean(label.as_ref()), scale: Scale::Linear, range: None, tick_step: None }
    }

    /// A logarithmic axis that fits its data.
    #[must_use]
    pub fn logarithmic(label: impl AsRef<str>) -> Self {
        Self { scale: Scale::Logarithmic, ..Self::linear(label) }
    }

    /// The axis from `low` to `high`; what lies outside is cut off.
    ///
    /// # Errors
    /// [`FigureError::Value`] unless `low` < `high`, both finite, and above 0 on a logarithmic axis.
    pub fn with_range(self, low: f64, high: f64) -> Result<Self, FigureError> {
        finite("the lower end of an axis", low)?;
        finite("the upper end of an axis", high)?;
        if self.scale == Scale::Logarithmic && low <= 0.0 {
            let requirement = "above 0 on a logarithmic axis";
            return Err(FigureError::Value { name: "the lower end of an axis", value: low, requirement });
        }
        if low < high {
            Ok(Self { range: Some((low, high)), ..self })
        } else {
            let requirement = "above the lower end";
            Err(FigureError::Value { name: "the upper end of an axis", value: high, requirement })
        }
    }

    /// The axis with ticks at multiples of this step, such as 45 for angles in degrees. Where they would stand
    /// too close, at multiples of 2, 4, … steps. A logarithmic axis keeps its decades.
    ///
    /// # Errors
    /// [`FigureError::Value`] unless the step is finite and above 0.
    pub fn with_tick_step(self, step: f64) -> Result<Self, FigureError> {
        if finite("the tick step of an axis", step)? > 0.0 {
            Ok(Self { tick_step: Some(step), ..self })
        } else {
            let requirement = "above 0";
            Err(FigureError::Value { name: "the tick step of an axis", value: step, requirement })
        }
    }

    /// What the axis shows.
    #[must_use]
    pub fn label(&self) -> &str {
        &self.label
    }

    /// How values are laid out.
    #[must_use]
    pub fn scale(&self) -> Scale {
        self.scale
    }

    /// Fixed ends; `None` fits the data.
    #[must_use]
    pub fn range(&self) -> Option<(f64, f64)> {
        self.range
    }

    /// Fixed distance of the ticks; `None` chooses round numbers.
    #[must_use]
    pub fn tick_step(&self) -> Option<f64> {
        self.tick_step
    }
}

/// One pair of axes with its curves.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    x: Axis,
    y: Axis,
    series: Vec<Series>,
    references: Vec<Reference>,
    equal_aspect: bool,
}

impl Panel {
    /// An empty panel.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Self {
        Self { x, y, series: Vec::new(), references: Vec::new(), equal_aspect: false }
    }

    /// The panel with one more curve, drawn over the earlier ones.
    #[must_use]
    pub fn with_series(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// The panel with one more reference, drawn under the curves.
    #[must_use]
    pub fn with_reference(mut self, reference: Reference) -> Self {
        self.references.push(reference);
        self
    }

    /// The panel with one unit as long on x as on y, as a Nyquist plot needs: a range is widened where the
    /// shape of the picture asks for it.
    #[must_use]
    pub fn with_equal_aspect(self) -> Self {
        Self { equal_aspect: true, ..self }
    }

    /// The horizontal axis.
    #[must_use]
    pub fn x(&self) -> &Axis {
        &self.x
    }

    /// The vertical axis.
    #[must_use]
    pub fn y(&self) -> &Axis {
        &self.y
    }

    /// The curves, in the order of drawing.
    #[must_use]
    pub fn series(&self) -> &[Series] {
        &self.series
    }

    /// What the curves are compared with.
    #[must_use]
    pub fn references(&self) -> &[Reference] {
        &self.references
    }

    /// Whether one unit is as long on x as on y.
    #[must_use]
    pub fn is_equal_aspect(&self) -> bool {
        self.equal_aspect
    }
}

/// A title and one or more panels, stacked with a common x axis.
///
/// # Examples
/// ```
/// use holdup::study::figures::{Axis, Figure, Panel, Series, terminal};
///
/// let level = Series::new("level", vec![0.0, 6.0, 30.0], vec![0.0, 0.0, 1.0])?;
/// let panel = Panel::new(Axis::linear("time [s]"), Axis::linear("level [m]")).with_series(level);
/// let figure = Figure::new("A tank", vec![panel])?;
/// print!("{}", terminal::chart(&figure, 80, false));
/// # Ok::<(), holdup::study::figures::FigureError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    title: String,
    panels: Vec<Panel>,
}

impl Figure {
    /// A figure of these panels, from top to bottom. The lowest panel's x axis is everybody's.
    ///
    /// # Errors
    /// [`FigureError::Empty`] without panels; [`FigureError::Stack`] when stacked panels differ in the scale of
    /// x or one of them asks for an equal aspect.
    pub fn new(title: impl AsRef<str>, panels: Vec<Panel>) -> Result<Self, FigureError> {
        let figure = clean(title.as_ref());
        let Some(first) = panels.first() else {
            return Err(FigureError::Empty { figure });
        };
        if panels.iter().any(|panel| panel.x.scale != first.x.scale) {
            return Err(FigureError::Stack { figure, requirement: "have the same scale of x" });
        }
        if panels.len() > 1 && panels.iter().any(|panel| panel.equal_aspect) {
            return Err(FigureError::Stack { figure, requirement: "not ask for an equal aspect" });
        }
        Ok(Self { title: figure, panels })
    }

    /// What the figure shows.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The panels from top to bottom.
    #[must_use]
    pub fn panels(&self) -> &[Panel] {
        &self.panels
    }

    /// Each name of the legend once, with the first series that has it.
    pub(super) fn named(&self) -> Vec<&Series> {
        let mut named: Vec<&Series> = Vec::new();
        for series in self.panels.iter().flat_map(|panel| &panel.series) {
            if !series.name().is_empty() && !named.iter().any(|other| other.name() == series.name()) {
                named.push(series);
            }
        }
        named
    }

    /// Place of the series in the palette; `None` is neutral.
    pub(super) fn slot(&self, series: &Series) -> Option<usize> {
        match series.tone() {
            Tone::Neutral => None,
            Tone::Slot(slot) => Some(slot),
            Tone::Automatic => {
                let automatic = |other: &&Series| other.tone() == Tone::Automatic;
                self.named()
                    .into_iter()
                    .filter(automatic)
                    .position(|other| other.name() == series.name())
                    .or(Some(0))
            }
        }
    }

    /// Colour and line of the series as drawn.
    pub(super) fn look(&self, series: &Series) -> Swatch {
        let look = palette::look(self.slot(series));
        match series.line() {
            Line::Automatic => look,
            line => Swatch { line, ..look },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn panel() -> Panel {
        Panel::new(Axis::linear("time [s]"), Axis::linear("level [m]"))
    }

    fn series(name: &str) -> Series {
        Series::new(name, vec![0.0, 1.0], vec![0.0, 1.0]).unwrap()
    }

    #[test]
    fn lengths_that_differ_are_an_error() {
        let error = Series::new("level", vec![0.0, 1.0], vec![0.0]).unwrap_err();
        assert_eq!(error.to_string(), "series \"level\" has 2 values on the x axis and 1 on the y axis");
    }

    #[test]
    fn values_that_are_not_finite_are_gaps() {
        let x = vec![0.0, 1.0, 2.0, f64::INFINITY, 4.0];
        let y = vec![0.0, f64::NAN, 2.0, 3.0, 1e301];
        let points: Vec<_> = Series::new("level", x, y).unwrap().points().collect();
        assert_eq!(points, [Some((0.0, 0.0)), None, Some((2.0, 2.0)), None, None]);
    }

    #[test]
    fn a_figure_without_panels_and_panels_that_do_not_stack_are_errors() {
        assert!(matches!(Figure::new("a", vec![]), Err(FigureError::Empty { .. })));
        let logarithmic = Panel::new(Axis::logarithmic("frequency [rad/s]"), Axis::linear("phase [°]"));
        assert!(matches!(Figure::new("a", vec![panel(), logarithmic]), Err(FigureError::Stack { .. })));
        assert!(Figure::new("a", vec![panel(), panel().with_equal_aspect()]).is_err());
        assert!(Figure::new("a", vec![panel().with_equal_aspect()]).is_ok());
    }

    #[test]
    fn ranges_and_references_that_cannot_be_drawn_are_errors() {
        assert!(Axis::linear("a").with_range(1.0, 1.0).is_err());
        assert!(Axis::linear("a").with_range(f64::NAN, 1.0).is_err());
        assert!(Axis::logarithmic("a").with_range(0.0, 1.0).is_err());
        assert!(Axis::linear("a").with_tick_step(0.0).is_err());
        assert!(Reference::horizontal(f64::NAN, "").is_err());
        assert!(Reference::circle((-1.0, 0.0), 0.0, "").is_err());
        assert!(series("a").with_width(0.0).is_err());
    }

    #[test]
    fn one_name_has_one_colour_in_all_panels_and_neutral_takes_none() {
        let setpoint = series("setpoint").with_tone(Tone::Neutral);
        let upper = panel().with_series(setpoint.clone()).with_series(series("A")).with_series(series("B"));
        let lower = panel().with_series(series("B"));
        let figure = Figure::new("a", vec![upper, lower]).unwrap();
        assert_eq!(figure.slot(&setpoint), None);
        assert_eq!(figure.slot(&series("A")), Some(0));
        assert_eq!(figure.slot(&series("B")), Some(1));
        assert_eq!(figure.named().len(), 3);
    }
}
