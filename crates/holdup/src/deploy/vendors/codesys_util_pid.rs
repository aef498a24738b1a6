//! CODESYS Util library, PID and PID_FIXCYCLE.
//!
//! # Equation
//! `Y = Y_OFFSET + KP·[E + (1/TN)·∫E + TV·dE/dt]`, E = SET_POINT − ACTUAL, in the units of both.
//!
//! # Units
//! TN and TV in seconds. TN must be greater than 0: there is no way without integral action (the block PD).
//!
//! # Reference
//! The ideal standard form and the names in the documentation of u-create Util (Weidmüller UC20), PID; CODESYS
//! help, library Util, PID.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor, Weight,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "codesys-util-pid",
    name: "CODESYS Util PID, PID_FIXCYCLE",
    equation: "Y = Y_OFFSET + KP·[E + (1/TN)·∫E dt + TV·dE/dt], E = SET_POINT − ACTUAL",
    source: Source {
        citation: "CODESYS library Util, PID; Weidmüller UC20-WL2000-AC documentation, PID",
        read: "names, ideal form, seconds, TN greater than 0, sign by KP; that the derivative is not filtered \
               is from memory",
    },
    input: Scale::Engineering,
    output: Scale::Engineering,
    interacting: false,
    gain: Gain::Gain(Number::new("KP", "output/PV unit")),
    integral: Integral { number: Number::new("TN", "s"), kind: Kind::Time(1.0), off: Off::Never },
    derivative: Derivative { number: Number::new("TV", "s"), kind: Kind::Time(1.0) },
    filter: Filter::Absent,
    weights: Weights::Each { b: Weight::Fixed(1.0), c: Weight::Fixed(1.0) },
    action: Action::Sign,
    spans: Some(SpanNames { pv: None, op: Some(("Y_MIN", "Y_MAX")) }),
    sample_period: Some((Number::new("CYCLE", "s").note("PID_FIXCYCLE only"), 1.0)),
    fixed: &[],
    notes: &["Without integral action the block PD is used, which is another one."],
};
