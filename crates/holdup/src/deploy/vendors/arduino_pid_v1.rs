//! Arduino PID library, PID_v1 (version 1.2).
//!
//! # Equation
//! `Output = Kp·(Setpoint − Input) + Ki·∫(Setpoint − Input) − Kd·s·Input`, in the units of Input and Output. With
//! `P_ON_M` the proportional action is of Input alone.
//!
//! # Units
//! Ki per second, Kd in seconds: the library multiplies by its sample time itself. Gains are positive; the
//! direction turns them. `DIRECT` there is what other blocks call reverse: output and measurement rise together.
//!
//! # Reference
//! PID_v1.cpp of br3ttb/Arduino-PID-Library, read in full.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor, Weight,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "arduino-pid-v1",
    name: "Arduino PID_v1",
    equation: "Output = Kp·(Setpoint − Input) + Ki·∫(Setpoint − Input) dt − Kd·dInput/dt",
    source: Source { citation: "br3ttb/Arduino-PID-Library, PID_v1.cpp, version 1.2.1", read: "everything" },
    input: Scale::Engineering,
    output: Scale::Engineering,
    interacting: false,
    gain: Gain::Gain(Number::new("Kp", "output/PV unit")),
    integral: Integral {
        number: Number::new("Ki", "output/(PV unit·s)"),
        kind: Kind::Gain(1.0),
        off: Off::Value(0.0),
    },
    derivative: Derivative { number: Number::new("Kd", "output·s/PV unit"), kind: Kind::Gain(1.0) },
    filter: Filter::Absent,
    weights: Weights::Each {
        b: Weight::Words { name: "POn", one: "P_ON_E", zero: "P_ON_M", one_is_default: true },
        c: Weight::Fixed(0.0),
    },
    action: Action::Words { name: "ControllerDirection", reverse: "DIRECT", direct: "REVERSE" },
    spans: Some(SpanNames { pv: None, op: Some(("SetOutputLimits Min", "SetOutputLimits Max")) }),
    sample_period: Some((Number::new("SetSampleTime", "ms"), 0.001)),
    fixed: &[],
    notes: &["The derivative is a difference over one sample: noise of the measurement passes unfiltered."],
};
