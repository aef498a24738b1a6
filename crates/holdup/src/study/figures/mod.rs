//! Figures as plain data, and what draws them.
//!
//! A [`Figure`] holds stacked [`Panel`]s of [`Series`] and knows nothing of controllers. It is drawn in the
//! terminal by [`terminal`] and, with the feature `report`, as SVG, PNG, interactive plot or HTML page.
mod figure;
mod palette;
mod series;
pub mod terminal;
mod text;
mod ticks;
mod view;

#[cfg(feature = "report")]
pub mod page;
#[cfg(feature = "report")]
pub mod plotly;
#[cfg(feature = "report")]
pub mod png;
#[cfg(feature = "report")]
mod scene;
#[cfg(feature = "report")]
pub mod svg;

pub use figure::{Axis, Figure, Panel, Scale};
pub use series::{Line, Mark, Reference, Series, Tone};

/// Why a figure could not be put together.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FigureError {
    /// A series has more values on one axis than on the other.
    #[error("series \"{series}\" has {x} values on the x axis and {y} on the y axis")]
    Lengths {
        /// Name of the series.
        series: String,
        /// Number of x values.
        x: usize,
        /// Number of y values.
        y: usize,
    },
    /// A number cannot be drawn.
    #[error("{name} is {value}: it must be {requirement}")]
    Value {
        /// What the number is for.
        name: &'static str,
        /// The number.
        value: f64,
        /// What is allowed.
        requirement: &'static str,
    },
    /// A figure without panels shows nothing.
    #[error("figure \"{figure}\" has no panel")]
    Empty {
        /// Title of the figure.
        figure: String,
    },
    /// Panels of one figure share the x axis, which these do not allow.
    #[error("the stacked panels of figure \"{figure}\" must {requirement}")]
    Stack {
        /// Title of the figure.
        figure: String,
        /// What is allowed.
        requirement: &'static str,
    },
}
