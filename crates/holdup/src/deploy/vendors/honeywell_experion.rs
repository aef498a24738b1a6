//! Honeywell Experion PKS PID, the noninteracting form.
//!
//! # Equation
//! Equation A: `CV = K·[1 + 1/(T1·s) + T2·s/(1 + a·T2·s)]·(SP − PV)` with a = 1/16, in percent of span. Equation B
//! takes the derivative, C the proportional action too, of the measurement only. Equation D is integral action
//! alone, which no design here is.
//!
//! # Units
//! T1 and T2 in minutes; T1 = 0 is no integral action.
//!
//! # Reference
//! Experion Control Builder Components Theory, R300.1, PID block.

use crate::deploy::conversion::{
    Action, Choice, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "honeywell-experion",
    name: "Honeywell Experion PKS PID, equations A to C",
    equation: "CV = K·[1 + 1/(T1·s) + T2·s/(1 + T2·s/16)]·(SP − PV), equation A, in percent of span",
    source: Source {
        citation: "Honeywell Experion Control Builder Components Theory, R300.1, PID block",
        read: "only that the manual has this block; equations, names and the rate amplitude of 1/16 are from \
               memory",
    },
    input: Scale::Span(100.0),
    output: Scale::Span(100.0),
    interacting: false,
    gain: Gain::Gain(Number::new("K", "")),
    integral: Integral { number: Number::new("T1", "min"), kind: Kind::Time(60.0), off: Off::Value(0.0) },
    derivative: Derivative { number: Number::new("T2", "min"), kind: Kind::Time(60.0) },
    filter: Filter::Fixed(1.0 / 16.0),
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
    notes: &["Equation D (EQD) is integral action alone: no design here is."],
};
