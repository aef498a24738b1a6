//! ABB PidCC, System 800xA and AC 800M.
//!
//! # Equation
//! `Out = Gain·[(Beta·SP − PV) + (SP − PV)/(Ti·s) − Td·s/(Tf·s + 1)·PV]`, in percent of span.
//!
//! # Units
//! Times are seconds.
//!
//! # Reference
//! ABB System 800xA Control, AC 800M, Binary and Analog Handling (3BSE035981), process control objects.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor, Weight,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "abb-800xa-pidcc",
    name: "ABB PidCC (800xA, AC 800M)",
    equation: "Out = Gain·[(Beta·SP − PV) + (SP − PV)/(Ti·s) − Td·s/(TfDerivative·s + 1)·PV], in percent of span",
    source: Source {
        citation: "ABB System 800xA Control, AC 800M Binary and Analog Handling, 3BSE035981",
        read: "nothing: equation, names, scaling and the number of the manual are from memory",
    },
    input: Scale::Span(100.0),
    output: Scale::Span(100.0),
    interacting: false,
    gain: Gain::Gain(Number::new("Gain", "")),
    integral: Integral { number: Number::new("Ti", "s"), kind: Kind::Time(1.0), off: Off::Value(0.0) },
    derivative: Derivative { number: Number::new("Td", "s"), kind: Kind::Time(1.0) },
    filter: Filter::Time(Number::new("TfDerivative", "s"), 1.0, 0.0),
    weights: Weights::Each {
        b: Weight::Number(Number::new("Beta", "").range(0.0, 1.0), 1.0),
        c: Weight::Fixed(0.0),
    },
    action: Action::Words { name: "Direct", reverse: "false", direct: "true" },
    spans: Some(SpanNames {
        pv: Some(("Pv.Range.Min", "Pv.Range.Max")),
        op: Some(("Out.Range.Min", "Out.Range.Max")),
    }),
    sample_period: None,
    fixed: &[],
    notes: &["Names differ between versions of the library: compare with yours before typing."],
};
