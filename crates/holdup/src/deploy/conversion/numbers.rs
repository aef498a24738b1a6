//! How gains and times become typed numbers, and numbers gains and times.

use super::scaling::{Scaling, Span};
use super::vendor::{Gain, Kind, Number, Off, Scale, Vendor};

/// Typed gain per gain in the units of the plant: span of the controlled variable over that of the output where both
/// are percent.
pub(super) fn gain_scale(vendor: &Vendor, scaling: &Scaling) -> f64 {
    let per_unit = |scale: Scale, span: Span| match scale {
        Scale::Engineering => 1.0,
        Scale::Span(full) => full / span.width(),
    };
    per_unit(vendor.output, scaling.op) / per_unit(vendor.input, scaling.pv)
}

/// What is typed for a value: in whole steps, or their number, where the parameter takes no more.
pub(super) fn encoded(number: &Number, value: f64) -> f64 {
    match number.steps {
        Some(steps) if number.counted => (value * steps).round(),
        Some(steps) => (value * steps).round() / steps,
        None => value,
    }
}

/// The value of what is typed.
pub(super) fn decoded(number: &Number, typed: f64) -> f64 {
    number.steps.filter(|_| number.counted).map_or(typed, |steps| typed / steps)
}

/// The number that is typed for a scaled gain > 0 (or of any sign, where the sign is typed with it).
pub(super) fn typed_gain(gain: &Gain, scaled: f64) -> (Number, f64) {
    match *gain {
        Gain::Gain(number) => (number, scaled),
        Gain::Band(number) => (number, 100.0 / scaled),
    }
}

/// The scaled gain of a typed number.
pub(super) fn read_gain(gain: &Gain, typed: f64) -> f64 {
    match gain {
        Gain::Gain(_) => typed,
        Gain::Band(_) => 100.0 / typed,
    }
}

/// The number that is typed for an integral time [s]; `gain` is the scaled gain.
pub(super) fn typed_integral(kind: Kind, ti: f64, gain: f64) -> f64 {
    match kind {
        Kind::Time(unit) => ti / unit,
        Kind::Rate(unit) => unit / ti,
        Kind::Gain(unit) => gain * unit / ti,
    }
}

/// The integral time [s] of a typed number, where it is not that for none.
pub(super) fn read_integral(kind: Kind, off: Off, typed: f64, gain: f64) -> Option<f64> {
    if off == Off::Value(typed) {
        return None;
    }
    Some(match kind {
        Kind::Time(unit) => typed * unit,
        Kind::Rate(unit) => unit / typed,
        Kind::Gain(unit) => gain * unit / typed,
    })
}

/// The number that is typed for a derivative time [s].
pub(super) fn typed_derivative(kind: Kind, td: f64, gain: f64) -> f64 {
    match kind {
        Kind::Time(unit) => td / unit,
        Kind::Rate(unit) => unit / td,
        Kind::Gain(unit) => gain * td / unit,
    }
}

/// The derivative time [s] of a typed number; 0 is none.
pub(super) fn read_derivative(kind: Kind, typed: f64, gain: f64) -> f64 {
    match kind {
        Kind::Time(unit) => typed * unit,
        Kind::Rate(unit) => unit / typed,
        Kind::Gain(unit) => typed * unit / gain,
    }
}
