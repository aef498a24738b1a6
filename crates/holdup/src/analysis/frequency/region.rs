//! The stability region in a plane of two settings, and curves of constant robustness in it.
//!
//! A pole crosses the imaginary axis at jω where the characteristic equation has the root jω: two real equations
//! for the two settings, so that ω runs along the boundary (D-decomposition). A pole crosses at s = ∞ where the
//! gain of a neutral loop at infinite frequency is 1. Each piece of these curves is kept where the argument
//! principle counts no unstable pole on one side and some on the other.

use serde::Serialize;
use serde::ser::{SerializeStruct, Serializer};

use super::error::FrequencyError;
use crate::model::{Controller, Process};

mod boundary;
mod crossing;
mod level;
mod plane;
#[cfg(test)]
mod tests;

use self::plane::Settings;

/// The two settings that span the plane; the first is always the proportional gain.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Plane {
    /// Proportional gain and integral time.
    KcTi,
    /// Proportional gain and derivative time.
    KcTd,
    /// Proportional gain and observer gain.
    KcKo,
}

/// The part of the plane that is examined: from 0 to these moduli.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// Greatest modulus of the proportional gain [input unit / output unit].
    pub proportional_gain: f64,
    /// Greatest modulus of the other setting [s, or input unit / output unit].
    pub other: f64,
}

/// A quantity that is constant along a curve, with its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Constant {
    /// Sensitivity peak `M_s` [–], > 1.
    SensitivityPeak(f64),
    /// Gain margin [–], > 1.
    GainMargin(f64),
    /// Modulus of the phase margin [rad], between 0 and π.
    PhaseMargin(f64),
}

/// What happens on a piece of the boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Crossing {
    /// A pair of poles crosses the imaginary axis.
    ImaginaryAxis,
    /// Infinitely many poles cross at infinite frequency: the high-frequency gain is 1.
    InfiniteFrequency,
}

/// A point of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Vertex {
    /// Proportional gain [input unit / output unit].
    pub x: f64,
    /// The other setting [s, or input unit / output unit].
    pub y: f64,
    /// Frequency at which poles cross there [rad/s]; `None` on curves of constant robustness and where poles
    /// cross at infinite frequency.
    #[serde(rename = "frequency_rad_s", skip_serializing_if = "Option::is_none")]
    pub frequency: Option<f64>,
}

/// A piece of the boundary of the stability region.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Curve {
    /// How poles become unstable there.
    pub crossing: Crossing,
    /// Its points, each exact to rounding, close enough to draw.
    pub vertices: Vec<Vertex>,
}

/// The curves on which a quantity has one value.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// The quantity and its value.
    pub constant: Constant,
    /// The curves: at every vertex the quantity has the value to a relative 1e-9. They end within 1e-4 of the
    /// window's sides, or where the quantity jumps; a curve smaller than a fortieth of the window may be missed.
    pub curves: Vec<Vec<Vertex>>,
}

/// The stability region of a loop in a plane of two settings, the others fixed.
///
/// The axes are not listed: the region also ends where a setting becomes 0. Crossings are followed up to 50
/// radians per dead time; those of a neutral loop accumulate at infinity, where [`Crossing::InfiniteFrequency`] is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Region {
    /// The plane.
    pub plane: Plane,
    /// Name of the horizontal setting, with its unit: that of the contract for JSON.
    pub x: &'static str,
    /// Name of the vertical setting, with its unit.
    pub y: &'static str,
    /// What bounds the stable settings within the window.
    pub boundary: Vec<Curve>,
    /// The levels asked for.
    pub levels: Vec<Level>,
}

/// Why a region was not computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RegionError {
    /// The window or a level is out of its range.
    #[error("{name} is {value}: it must be {requirement}")]
    OutOfRange {
        /// Which number.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        requirement: &'static str,
    },
    /// The loop is out of the reach of double precision.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
}

impl Plane {
    /// Name of the second setting, with its unit.
    #[must_use]
    pub fn other(self) -> &'static str {
        match self {
            Self::KcTi => "integral_time_s",
            Self::KcTd => "derivative_time_s",
            Self::KcKo => "observer_gain",
        }
    }
}

/// The stability region of a process and a controller in a plane of two settings, and the curves of the levels.
///
/// The controller gives the settings that are not in the plane; its gain there is not looked at. Gains have the
/// sign of the process gain.
///
/// ```
/// use holdup::analysis::frequency::region::{Plane, Window, region};
/// use holdup::model::{Controller, Process, Seconds};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let any = Controller::proportional(1.0)?;
/// let window = Window { proportional_gain: 2.0, other: 20.0 };
/// let region = region(&process, &any, Plane::KcTi, window, &[])?;
/// // Every stable PI loop has Ti > d and K·Kc·d < π/2.
/// assert!(region.boundary[0].vertices.iter().all(|v| v.y >= 1.0 && v.x <= std::f64::consts::FRAC_PI_2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`RegionError`] if the window or a level is out of its range or the loop out of the reach of double precision.
pub fn region(
    process: &Process,
    controller: &Controller,
    plane: Plane,
    window: Window,
    levels: &[Constant],
) -> Result<Region, RegionError> {
    positive("the window's proportional gain", window.proportional_gain)?;
    positive("the window's other setting", window.other)?;
    for constant in levels {
        constant.check()?;
    }
    let settings = Settings::new(process, controller, plane, window);
    let survey = (!levels.is_empty()).then(|| level::Survey::new(&settings));
    let curves = |survey: &level::Survey, constant| Level {
        constant,
        curves: level::curves(&settings, survey, constant),
    };
    Ok(Region {
        plane,
        x: "proportional_gain",
        y: plane.other(),
        boundary: boundary::curves(&settings)?,
        levels: survey.iter().flat_map(|s| levels.iter().map(|&constant| curves(s, constant))).collect(),
    })
}

fn positive(name: &'static str, value: f64) -> Result<(), RegionError> {
    let good = value.is_finite() && value > 0.0;
    good.then_some(()).ok_or(RegionError::OutOfRange { name, value, requirement: "a finite number above 0" })
}

impl Constant {
    fn check(self) -> Result<(), RegionError> {
        let (name, value, good, requirement) = match self {
            Self::SensitivityPeak(v) => ("the sensitivity peak", v, v > 1.0, "a finite number above 1"),
            Self::GainMargin(v) => ("the gain margin", v, v > 1.0, "a finite number above 1"),
            Self::PhaseMargin(v) => {
                ("the phase margin", v, v > 0.0 && v < std::f64::consts::PI, "between 0 and π radians")
            }
        };
        let good = good && value.is_finite();
        good.then_some(()).ok_or(RegionError::OutOfRange { name, value, requirement })
    }
}

impl Serialize for Level {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (kind, value) = match self.constant {
            Constant::SensitivityPeak(value) => ("sensitivity_peak", value),
            Constant::GainMargin(value) => ("gain_margin", value),
            Constant::PhaseMargin(value) => ("phase_margin_deg", value.to_degrees()),
        };
        let mut s = serializer.serialize_struct("Level", 3)?;
        s.serialize_field("kind", kind)?;
        s.serialize_field("value", &value)?;
        s.serialize_field("curves", &self.curves)?;
        s.end()
    }
}
