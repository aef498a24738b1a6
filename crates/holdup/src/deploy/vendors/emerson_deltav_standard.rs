//! Emerson DeltaV PID, standard form.
//!
//! # Equation
//! `OUT = GAIN·[P + E/(Tr·s) + Td·s/(ALPHA·Td·s + 1)·D]`, in percent of span; P and D are the error or the
//! measurement, as `STRUCTURE`, `BETA` and `GAMMA` say.
//!
//! # Units
//! RESET and RATE in seconds; RESET 0 is no integral action.
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
    id: "emerson-deltav-standard",
    name: "Emerson DeltaV PID, standard form",
    equation: "OUT = GAIN·[P(s) + E(s)/(Tr·s) + Td·s/(ALPHA·Td·s + 1)·D(s)], in percent of span",
    source: Source {
        citation: "DeltaV Books Online, PID function block; Rosemount 00809-0500-4880, figure 8-13",
        read: "forms, ALPHA with default and range, BETA and GAMMA, sign; the names of scales and options, the \
               words of STRUCTURE and that a RESET of 0 is no integral action are from memory",
    },
    input: Scale::Span(100.0),
    output: Scale::Span(100.0),
    interacting: false,
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
        free: Some((
            "Two Degrees of Freedom Controller",
            Number::new("BETA", "").range(0.0, 1.0),
            Number::new("GAMMA", "").range(0.0, 1.0),
        )),
    },
    action: Action::Words { name: "CONTROL_OPTS.Direct_Acting", reverse: "FALSE", direct: "TRUE" },
    spans: Some(SpanNames {
        pv: Some(("PV_SCALE.EU0", "PV_SCALE.EU100")),
        op: Some(("OUT_SCALE.EU0", "OUT_SCALE.EU100")),
    }),
    sample_period: None,
    fixed: &[Fixed { name: "FORM", word: "Standard", note: "" }],
    notes: &["The block advises against changing ALPHA: less of it is less protection against noise."],
};
