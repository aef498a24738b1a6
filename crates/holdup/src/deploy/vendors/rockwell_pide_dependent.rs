//! Rockwell PIDE (Logix 5000), dependent gains.
//!
//! # Equation
//! `CV = CV' + KC·[ΔE + E·Δt/(60·TI) + 60·TD·(ΔE − ΔE')/Δt]`, E and CV in percent of span; ΔPV takes the place of
//! ΔE where `PVEProportional` or `PVEDerivative` is set.
//!
//! # Units
//! TI in minutes per repeat, TD in minutes. They are typed into the same parameters as independent gains.
//!
//! # Filter
//! As in the independent form.
//!
//! # Reference
//! Logix 5000 Advanced Process Control and Drives Instructions, 1756-RM006, enhanced PID (PIDE).

use crate::deploy::conversion::{
    Action, Derivative, Filter, Fixed, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor,
    Weight, Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "rockwell-pide-dependent",
    name: "Rockwell PIDE, dependent gains (Logix 5000)",
    equation: "ΔCV = PGain·[ΔE + E·Δt/(60·IGain) + 60·DGain·Δ(ΔE or −ΔPV)/Δt], in percent of span",
    source: Source {
        citation: "Rockwell Automation 1756-RM006, Advanced Process Control and Drives Instructions, PIDE",
        read: "units of the gains, percent of span, which changes the terms act on by default, ControlAction; \
               the constant of DSmoothing is from memory (1756-RM003, PID)",
    },
    input: Scale::Span(100.0),
    output: Scale::Span(100.0),
    interacting: false,
    gain: Gain::Gain(Number::new("PGain", "")),
    integral: Integral {
        number: Number::new("IGain", "min").note("minutes per repeat"),
        kind: Kind::Time(60.0),
        off: Off::Value(0.0),
    },
    derivative: Derivative { number: Number::new("DGain", "min"), kind: Kind::Time(60.0) },
    filter: Filter::Switch { name: "DSmoothing", on: "1", off: "0", ratio: 1.0 / 16.0 },
    weights: Weights::Each {
        b: Weight::Words { name: "PVEProportional", one: "0", zero: "1", one_is_default: true },
        c: Weight::Words { name: "PVEDerivative", one: "0", zero: "1", one_is_default: false },
    },
    action: Action::Words { name: "ControlAction", reverse: "0", direct: "1" },
    spans: Some(SpanNames { pv: Some(("PVEUMin", "PVEUMax")), op: Some(("CVEUMin", "CVEUMax")) }),
    sample_period: None,
    fixed: &[Fixed { name: "DependIndepend", word: "1", note: "dependent gains" }],
    notes: &["Without DSmoothing the derivative is a difference over one sample."],
};
