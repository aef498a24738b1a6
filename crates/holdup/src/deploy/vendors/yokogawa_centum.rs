//! Yokogawa CENTUM VP and CS 3000 PID.
//!
//! # Equation
//! `MV = (100/P)·[E + (1/I)·∫E + D·s/(D·s/8 + 1)·E]`, in percent of span. Algorithm PID takes all of the error,
//! PI-D the derivative, I-PD the proportional action too, of the measurement only.
//!
//! # Units
//! P is the proportional band in percent, I and D are seconds.
//!
//! # Limits
//! The derivative gain is 8.
//!
//! # Reference
//! CENTUM VP reference, function blocks, PID controller block; the basic algorithms as in Yokogawa IM
//! 21B04C01-01E, 16.5, and IM 01C50T02-01E, A4.4.

use crate::deploy::conversion::{
    Action, Choice, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "yokogawa-centum",
    name: "Yokogawa CENTUM VP / CS 3000 PID",
    equation: "MV = (100/P)·[E + (1/I)·∫E dt + D·s/(D·s/8 + 1)·E], in percent of span",
    source: Source {
        citation: "Yokogawa CENTUM VP function block reference, PID block; algorithms as in IM 21B04C01-01E, 16.5",
        read: "P as proportional band with its range, I and D in seconds with ranges, I-PD and PI-D; the \
               derivative gain of 8, the names of the scales and that I = 0 cannot be typed are from memory",
    },
    input: Scale::Span(100.0),
    output: Scale::Span(100.0),
    interacting: false,
    gain: Gain::Band(Number::new("P", "%").range(0.0, 1000.0).note("proportional band")),
    integral: Integral {
        number: Number::new("I", "s").range(0.1, 10_000.0),
        kind: Kind::Time(1.0),
        off: Off::Never,
    },
    derivative: Derivative { number: Number::new("D", "s").range(0.0, 10_000.0), kind: Kind::Time(1.0) },
    filter: Filter::Fixed(1.0 / 8.0),
    weights: Weights::Choice {
        name: "PID control algorithm",
        choices: &[
            Choice { word: "I-PD", b: 0.0, c: 0.0, integral: None },
            Choice { word: "PI-D", b: 1.0, c: 0.0, integral: None },
            Choice { word: "PID", b: 1.0, c: 1.0, integral: None },
        ],
        free: None,
    },
    action: Action::Words { name: "Control action direction", reverse: "Reverse", direct: "Direct" },
    spans: Some(SpanNames { pv: Some(("SL", "SH")), op: Some(("MSL", "MSH")) }),
    sample_period: None,
    fixed: &[],
    notes: &["Without integral action the block PD-MR is used, which is another one."],
};
