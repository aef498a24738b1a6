//! The curves of a panel, and what they are compared with.
use super::FigureError;
use super::text::clean;

/// Values beyond this are gaps: their differences must stay finite.
const LARGEST: f64 = 1e300;

/// How a series is joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Line {
    /// The line that goes with the colour of the series.
    #[default]
    Automatic,
    /// Not joined: marks only.
    None,
    /// ————
    Solid,
    /// – – –
    Dashed,
    /// · · ·
    Dotted,
    /// – · –
    DashDotted,
    /// — — —
    LongDashed,
}

/// How each point of a series is marked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// A filled disc.
    Disc,
    /// A diagonal cross.
    Cross,
}

/// Where a series gets its colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Tone {
    /// The next free colour of the figure. Series of one name share one, in all panels.
    #[default]
    Automatic,
    /// A fixed place in the palette: gives a controller one colour in all figures of a report.
    Slot(usize),
    /// Grey: setpoints and other things that belong to no controller.
    Neutral,
}

/// One curve: a name, its points and how it is drawn.
///
/// # Examples
/// ```
/// use holdup::study::figures::{Line, Series};
///
/// let level = Series::new("level", vec![0.0, 6.0, 12.0], vec![0.0, 0.0, 0.3])?.with_line(Line::Solid);
/// assert_eq!(level.name(), "level");
/// assert!(Series::new("level", vec![0.0, 6.0], vec![0.0]).is_err());
/// # Ok::<(), holdup::study::figures::FigureError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    name: String,
    x: Vec<f64>,
    y: Vec<f64>,
    line: Line,
    mark: Option<Mark>,
    tone: Tone,
    width: f64,
    held: bool,
    labels: Vec<String>,
}

impl Series {
    /// A curve through the points. A value that is not finite (or beyond 1e300) is a gap in the line.
    ///
    /// # Errors
    /// [`FigureError::Lengths`] when `x` and `y` differ in length.
    pub fn new(name: impl AsRef<str>, x: Vec<f64>, y: Vec<f64>) -> Result<Self, FigureError> {
        let name = clean(name.as_ref());
        if x.len() != y.len() {
            return Err(FigureError::Lengths { series: name, x: x.len(), y: y.len() });
        }
        Ok(Self {
            name,
            x,
            y,
            line: Line::Automatic,
            mark: None,
            tone: Tone::Automatic,
            width: 2.0,
            held: false,
            labels: Vec::new(),
        })
    }

    /// The series joined by this line.
    #[must_use]
    pub fn with_line(self, line: Line) -> Self {
        Self { line, ..self }
    }

    /// The series with each point marked.
    #[must_use]
    pub fn with_mark(self, mark: Mark) -> Self {
        Self { mark: Some(mark), ..self }
    }

    /// The series as marks that are not joined.
    #[must_use]
    pub fn as_marks(self, mark: Mark) -> Self {
        self.with_mark(mark).with_line(Line::None)
    }

    /// The series as a staircase: each value is held until the next.
    #[must_use]
    pub fn held(self) -> Self {
        Self { held: true, ..self }
    }

    /// The series with a text for each point, shown beside the pointer.
    ///
    /// # Errors
    /// [`FigureError::Lengths`] unless there is one label for each point.
    pub fn with_labels(self, labels: &[String]) -> Result<Self, FigureError> {
        if labels.len() != self.x.len() {
            return Err(FigureError::Lengths { series: self.name, x: self.x.len(), y: labels.len() });
        }
        Ok(Self { labels: labels.iter().map(|label| clean(label)).collect(), ..self })
    }

    /// The series in this colour.
    #[must_use]
    pub fn with_tone(self, tone: Tone) -> Self {
        Self { tone, ..self }
    }

    /// The series drawn with this width in pixels.
    ///
    /// # Errors
    /// [`FigureError::Value`] unless 0 < width ≤ 20.
    pub fn with_width(self, width: f64) -> Result<Self, FigureError> {
        if width > 0.0 && width <= 20.0 {
            Ok(Self { width, ..self })
        } else {
            Err(FigureError::Value { name: "width", value: width, requirement: "above 0 and at most 20" })
        }
    }

    /// Name that the legend shows; without a name the series is not in the legend.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Line as it was asked for.
    #[must_use]
    pub fn line(&self) -> Line {
        self.line
    }

    /// The text of each point; empty where points have none.
    #[must_use]
    pub fn labels(&self) -> &[String] {
        &self.labels
    }

    /// Mark of each point.
    #[must_use]
    pub fn mark(&self) -> Option<Mark> {
        self.mark
    }

    /// Colour as it was asked for.
    #[must_use]
    pub fn tone(&self) -> Tone {
        self.tone
    }

    /// Width of the line in pixels.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Whether each value is held until the next.
    #[must_use]
    pub fn is_held(&self) -> bool {
        self.held
    }

    /// The points in order, `None` where the line has a gap.
    pub fn points(&self) -> impl Iterator<Item = Option<(f64, f64)>> + '_ {
        let drawn = |v: f64| v.abs() <= LARGEST;
        self.x.iter().zip(&self.y).map(move |(&x, &y)| (drawn(x) && drawn(y)).then_some((x, y)))
    }
}

/// What curves are compared with.
#[derive(Debug, Clone, PartialEq)]
pub enum Reference {
    /// A line across the panel at this value of y, such as a steady state or a bound.
    Horizontal {
        /// Value of y.
        at: f64,
        /// Text beside the line; may be empty.
        label: String,
    },
    /// A line from bottom to top at this value of x, such as an event.
    Vertical {
        /// Value of x.
        at: f64,
        /// Text beside the line; may be empty.
        label: String,
    },
    /// A circle, such as that of a sensitivity peak in a Nyquist plot. Its label stands in the legend.
    Circle {
        /// Centre, x and y.
        centre: (f64, f64),
        /// Radius in units of the axes.
        radius: f64,
        /// Name in the legend; may be empty.
        label: String,
    },
}

impl Reference {
    /// A horizontal line.
    ///
    /// # Errors
    /// [`FigureError::Value`] unless `at` is finite.
    pub fn horizontal(at: f64, label: impl AsRef<str>) -> Result<Self, FigureError> {
        Ok(Self::Horizontal {
            at: finite("the place of a horizontal line", at)?,
            label: clean(label.as_ref()),
        })
    }

    /// A vertical line.
    ///
    /// # Errors
    /// [`FigureError::Value`] unless `at` is finite.
    pub fn vertical(at: f64, label: impl AsRef<str>) -> Result<Self, FigureError> {
        Ok(Self::Vertical { at: finite("the place of a vertical line", at)?, label: clean(label.as_ref()) })
    }

    /// A circle around `centre`.
    ///
    /// # Errors
    /// [`FigureError::Value`] unless the centre is finite and the radius finite and above 0.
    pub fn circle(centre: (f64, f64), radius: f64, label: impl AsRef<str>) -> Result<Self, FigureError> {
        finite("the centre of a circle", centre.0)?;
        finite("the centre of a circle", centre.1)?;
        if finite("the radius of a circle", radius)? <= 0.0 {
            let requirement = "finite and above 0";
            return Err(FigureError::Value { name: "the radius of a circle", value: radius, requirement });
        }
        Ok(Self::Circle { centre, radius, label: clean(label.as_ref()) })
    }
}

pub(super) fn finite(name: &'static str, value: f64) -> Result<f64, FigureError> {
    if value.abs() <= LARGEST {
        Ok(value)
    } else {
        Err(FigureError::Value { name, value, requirement: "a finite number" })
    }
}

/// The circle as a closed polygon, fine enough to look round.
pub(super) fn around(centre: (f64, f64), radius: f64) -> Vec<(f64, f64)> {
    (0..=180_u32)
        .map(|step| {
            let (sin, cos) = (f64::from(step) * std::f64::consts::PI / 90.0).sin_cos();
            (centre.0 + radius * cos, centre.1 + radius * sin)
        })
        .collect()
}
