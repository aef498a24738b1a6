//! Beckhoff TwinCAT Controller Toolbox, FB_CTRL_PID.
//!
//! # Equation
//! `Y = fKp·[E + E/(tTn·s) + tTv·s/(tTd·s + 1)·E]`, additive form; `bPInTheFeedbackPath` and `bDInTheFeedbackPath`
//! take the measurement instead of the error.
//!
//! # Units
//! tTn, tTv and tTd are times (typed as TIME in milliseconds), here in seconds; tTn = 0 is no integral action.
//!
//! # Reference
//! TwinCAT 3 Controller Toolbox, TF4100, FB_CTRL_PID.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor, Weight,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "beckhoff-ctrl-pid",
    name: "Beckhoff FB_CTRL_PID (TwinCAT TF4100)",
    equation: "Y = fKp·[E + E/(tTn·s) + tTv·s/(tTd·s + 1)·E]",
    source: Source {
        citation: "Beckhoff TwinCAT 3 Controller Toolbox, TF4100, FB_CTRL_PID",
        read: "additive form, the two switches and their defaults; the names of the times and their zeros are \
               from memory",
    },
    input: Scale::Engineering,
    output: Scale::Engineering,
    interacting: false,
    gain: Gain::Gain(Number::new("fKp", "output/PV unit")),
    integral: Integral {
        number: Number::new("tTn", "s").steps(1000.0),
        kind: Kind::Time(1.0),
        off: Off::Value(0.0),
    },
    derivative: Derivative { number: Number::new("tTv", "s").steps(1000.0), kind: Kind::Time(1.0) },
    filter: Filter::Time(Number::new("tTd", "s").steps(1000.0), 1.0, 0.0),
    weights: Weights::Each {
        b: Weight::Words { name: "bPInTheFeedbackPath", one: "FALSE", zero: "TRUE", one_is_default: true },
        c: Weight::Words { name: "bDInTheFeedbackPath", one: "FALSE", zero: "TRUE", one_is_default: true },
    },
    action: Action::Sign,
    spans: Some(SpanNames { pv: None, op: Some(("fOutMinLimit", "fOutMaxLimit")) }),
    sample_period: Some((Number::new("tCtrlCycleTime", "s").steps(1000.0), 1.0)),
    fixed: &[],
    notes: &["The times are of type TIME, in whole milliseconds."],
};
