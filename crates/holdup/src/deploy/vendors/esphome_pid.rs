//! ESPHome climate, platform pid.
//!
//! # Equation
//! `output = kp·e + ki·∫e + kd·de/dt`, e = setpoint − measurement, setpoint changes taken out of the derivative;
//! the output is a fraction, 1 is full power.
//!
//! # Units
//! ki per second, kd in seconds, gains in fractions of full output per unit of the measurement.
//!
//! # Sign
//! One output heats, the other cools with the negative output.
//!
//! # Reference
//! esphome/esphome, components/pid/pid_controller.cpp, read in full.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, Vendor, Weight, Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "esphome-pid",
    name: "ESPHome climate pid",
    equation: "output = kp·e + ki·∫e dt + kd·de/dt without setpoint changes, output 0 to 1",
    source: Source {
        citation: "esphome/esphome, esphome/components/pid/pid_controller.cpp",
        read: "everything but the names of the outputs, which are from memory",
    },
    input: Scale::Engineering,
    output: Scale::Span(1.0),
    interacting: false,
    gain: Gain::Gain(Number::new("kp", "1/PV unit")),
    integral: Integral {
        number: Number::new("ki", "1/(PV unit·s)"),
        kind: Kind::Gain(1.0),
        off: Off::Value(0.0),
    },
    derivative: Derivative { number: Number::new("kd", "s/PV unit"), kind: Kind::Gain(1.0) },
    filter: Filter::Absent,
    weights: Weights::Each { b: Weight::Fixed(1.0), c: Weight::Fixed(0.0) },
    action: Action::Words { name: "output", reverse: "heat_output", direct: "cool_output" },
    spans: None,
    sample_period: Some((Number::new("update_interval of the sensor", "s"), 1.0)),
    fixed: &[],
    notes: &[
        "derivative_averaging_samples averages the derivative over samples, which is no first-order filter.",
    ],
};
