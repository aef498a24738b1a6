//! Quantities with a unit: the two newtypes of the public edge.

/// A time [s].
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Seconds(pub f64);

/// An angle [rad].
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct Radians(pub f64);

impl Radians {
    /// The angle of so many degrees.
    #[must_use]
    pub fn from_degrees(degrees: f64) -> Self {
        Self(degrees.to_radians())
    }

    /// The angle in degrees [deg].
    #[must_use]
    pub fn degrees(self) -> f64 {
        self.0.to_degrees()
    }
}
