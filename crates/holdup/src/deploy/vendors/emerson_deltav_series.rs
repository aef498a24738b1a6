//! Emerson DeltaV PID, series form.
//!
//! # Equation
//! `OUT = GAIN·(1 + 1/(Tr·s))·(Td·s + 1)/(ALPHA·Td·s + 1)·E`, in percent of span. With the derivative action on the
//! measurement, the setpoint passes without the lead.
//!
//! # Units
//! RESET and RATE in seconds; RESET 0 is no integral action.
//!
//! # Limits
//! Real zeros only: an integral time of at least 4 derivative times, with the filter a little more.
//!
//! # Reference
//! DeltaV Books Online, PID function block and its parameters; FOUNDATION Fieldbus Manual for Rosemount OCX8800A,
//! 00809-0500-4880, figure 8-13 (the same block).

use crate::deploy::conversion::{
    Action, Choice, Derivative, Filter, Fixed, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames,
    Vendor, Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "emerson-deltav-series",
    name: "Emerson DeltaV PID, series form",
    equation: "OUT = GAIN·(1 + 1/(Tr·s))·(Td·s + 1)/(ALPHA·Td·s + 1)·E(s), in percent of span",
    source: Source {
        citation: "DeltaV Books Online, PID function block; Rosemount 00809-0500-4880, figure 8-13",
        read: "that there is a series form, ALPHA with default and range, sign; where the lead stands, the \
               names of scales and options, the words of STRUCTURE and that a RESET of 0 is no integral action \
               are from memory",
    },
    input: Scale::Span(100.0),
    output: Scale::Span(100.0),
    interacting: true,
    gain: Gain::Gain(Number::new("GAIN", "")),
    integral: Integral { number: Number::new("RESET", "s"), kind: Kind::Time(1.0), off: Off::Value(0.0) },
    derivative: Derivative { number: Number::new("RATE", "s"), kind: Kind::Time(1.0) },
    filter: Filter::Ratio(Number::new("ALPHA", "").range(0.05, 1.0).note("Tf/RATE"), 0.125),
    weights: Weights::Choice {
        name: "STRUCTURE",
        choices: &[
            Choice { word: "PI action on Error, D action on PV", b: 1.0, c: 0.0, integral: Some(true) },
            Choice { word: "PID action on Error", b: 1.0, c: 1.0, integral: Some(true) },
            Choice { word: "I action on Error, PD action on PV", b: 0.0, c: 0.0, integral: Some(true) },
            Choice { word: "PD action on Error", b: 1.0, c: 1.0, integral: Some(false) },
            Choice { word: "P action on Error, D action on PV", b: 1.0, c: 0.0, integral: Some(false) },
        ],
        free: None,
    },
    action: Action::Words { name: "CONTROL_OPTS.Direct_Acting", reverse: "FALSE", direct: "TRUE" },
    spans: Some(SpanNames {
        pv: Some(("PV_SCALE.EU0", "PV_SCALE.EU100")),
        op: Some(("OUT_SCALE.EU0", "OUT_SCALE.EU100")),
    }),
    sample_period: None,
    fixed: &[Fixed { name: "FORM", word: "Series", note: "" }],
    notes: &["The block advises against changing ALPHA: less of it is less protection against noise."],
};
