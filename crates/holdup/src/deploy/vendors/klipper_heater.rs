//! Klipper heater, control: pid.
//!
//! # Equation
//! `pwm = (Kp·e + Ki·∫e − Kd·s/(smooth_time·s + 1)·temp)/255`, limited to 0 … max_power.
//!
//! # Units
//! Gains on a base of 255 per full power and °C; Ki per second, Kd in seconds; smooth_time in seconds, its default
//! 1.
//!
//! # Sign
//! Heating only.
//!
//! # Reference
//! Klipper3d/klipper, klippy/extras/heaters.py, class ControlPID, read in full: the derivative's moving average
//! with 1 + smooth_time/dt is the first-order filter of time smooth_time, discretised backward.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Fixed, Gain, Integral, Kind, Number, Off, Scale, Source, Vendor, Weight,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "klipper-heater",
    name: "Klipper heater (control: pid)",
    equation: "pwm = (pid_Kp·e + pid_Ki·∫e dt − pid_Kd·s/(smooth_time·s + 1)·temp)/255",
    source: Source {
        citation: "Klipper3d/klipper, klippy/extras/heaters.py, ControlPID",
        read: "everything",
    },
    input: Scale::Engineering,
    output: Scale::Span(255.0),
    interacting: false,
    gain: Gain::Gain(Number::new("pid_Kp", "1/PV unit")),
    integral: Integral {
        number: Number::new("pid_Ki", "1/(PV unit·s)"),
        kind: Kind::Gain(1.0),
        off: Off::Value(0.0),
    },
    derivative: Derivative { number: Number::new("pid_Kd", "s/PV unit"), kind: Kind::Gain(1.0) },
    filter: Filter::Time(Number::new("smooth_time", "s"), 1.0, 1.0),
    weights: Weights::Each { b: Weight::Fixed(1.0), c: Weight::Fixed(0.0) },
    action: Action::ReverseOnly,
    spans: None,
    sample_period: None,
    fixed: &[Fixed { name: "control", word: "pid", note: "" }],
    notes: &[
        "The heater's own sample period is that of its sensor; max_power below 1 lowers the limit, not the gain.",
    ],
};
