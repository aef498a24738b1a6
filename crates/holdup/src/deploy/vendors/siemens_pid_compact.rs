//! Siemens PID_Compact, SIMATIC S7-1200 and S7-1500 (version 2).
//!
//! # Equation
//! `y = Kp·[(b·w − x) + 1/(TI·s)·(w − x) + TD·s/(a·TD·s + 1)·(c·w − x)]`
//!
//! # Units
//! The measurement is in its physical unit, the output in percent, so the gain is in percent per unit. Times are
//! seconds. TI = 0 switches integral action off.
//!
//! # Sign
//! The gain is positive; `Config.InvertControl` turns it.
//!
//! # Reference
//! SIMATIC S7-1200, S7-1500 PID control, Function Manual, A5E35300227-AC (03/2017), description of PID_Compact V2
//! and its static tags; S7-1200 System Manual, A5E02486680-06 (04/2012), section 9.2.2.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor, Weight,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "siemens-pid-compact",
    name: "Siemens PID_Compact (S7-1200, S7-1500)",
    equation: "y = Kp·[(b·w − x) + 1/(TI·s)·(w − x) + TD·s/(a·TD·s + 1)·(c·w − x)]",
    source: Source {
        citation: "SIMATIC S7-1200, S7-1500 PID control, Function Manual A5E35300227-AC (03/2017), PID_Compact V2",
        read: "equation, names, defaults, ranges, sign; that the gain is in percent per physical unit is from \
               memory",
    },
    input: Scale::Engineering,
    output: Scale::Span(100.0),
    interacting: false,
    gain: Gain::Gain(Number::new("Retain.CtrlParams.Gain", "%/PV unit")),
    integral: Integral {
        number: Number::new("Retain.CtrlParams.Ti", "s"),
        kind: Kind::Time(1.0),
        off: Off::Value(0.0),
    },
    derivative: Derivative { number: Number::new("Retain.CtrlParams.Td", "s"), kind: Kind::Time(1.0) },
    filter: Filter::Ratio(
        Number::new("Retain.CtrlParams.TdFiltRatio", "").range(0.001, 1000.0).note("Tf/Td"),
        0.2,
    ),
    weights: Weights::Each {
        b: Weight::Number(Number::new("Retain.CtrlParams.PWeighting", "").range(0.0, 1.0), 1.0),
        c: Weight::Number(Number::new("Retain.CtrlParams.DWeighting", "").range(0.0, 1.0), 1.0),
    },
    action: Action::Words { name: "Config.InvertControl", reverse: "FALSE", direct: "TRUE" },
    spans: Some(SpanNames { pv: Some(("Config.InputLowerLimit", "Config.InputUpperLimit")), op: None }),
    sample_period: Some((Number::new("Retain.CtrlParams.Cycle", "s"), 1.0)),
    fixed: &[],
    notes: &["A TdFiltRatio of 0 makes the derivative last one cycle only: it is almost without effect."],
};
