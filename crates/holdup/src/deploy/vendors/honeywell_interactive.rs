//! Honeywell PID, the interactive form (TDC 3000 and its successors).
//!
//! # Equation
//! Equation A: `CV = K·(1 + T1·s)/(T1·s)·(1 + T2·s)/(1 + a·T2·s)·(SP − PV)` with a = 0.1, in percent of span. In
//! equation B the setpoint passes without the lead; in C it enters the integral only.
//!
//! # Units
//! T1 and T2 in minutes; T1 = 0 is no integral action.
//!
//! # Limits
//! Real zeros only: an integral time of at least 4 derivative times, with the filter a little more.
//!
//! # Reference
//! The equation as quoted from Honeywell's reference books in a public discussion on control.com, "Honeywell PID
//! Equation Query".

use crate::deploy::conversion::{
    Action, Choice, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "honeywell-interactive",
    name: "Honeywell PID, interactive form (TDC 3000)",
    equation: "CV = K·(1 + T1·s)/(T1·s)·(1 + T2·s)/(1 + 0.1·T2·s)·(SP − PV), equation A, in percent of span",
    source: Source {
        citation: "control.com, Honeywell PID Equation Query: equation B as quoted from Honeywell's reference books",
        read: "equation B, its constant 0.1 and the units; equations A and C, names of the choices from memory",
    },
    input: Scale::Span(100.0),
    output: Scale::Span(100.0),
    interacting: true,
    gain: Gain::Gain(Number::new("K", "")),
    integral: Integral { number: Number::new("T1", "min"), kind: Kind::Time(60.0), off: Off::Value(0.0) },
    derivative: Derivative { number: Number::new("T2", "min"), kind: Kind::Time(60.0) },
    filter: Filter::Fixed(0.1),
    weights: Weights::Choice {
        name: "CTLEQN",
        choices: &[
            Choice { word: "EQA", b: 1.0, c: 1.0, integral: None },
            Choice { word: "EQB", b: 1.0, c: 0.0, integral: None },
            Choice { word: "EQC", b: 0.0, c: 0.0, integral: None },
        ],
        free: None,
    },
    action: Action::Words { name: "CTLACTN", reverse: "REVERSE", direct: "DIRECT" },
    spans: Some(SpanNames { pv: Some(("PVEULO", "PVEUHI")), op: Some(("CVEULO", "CVEUHI")) }),
    sample_period: None,
    fixed: &[],
    notes: &[],
};
