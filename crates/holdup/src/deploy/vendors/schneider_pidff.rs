//! Schneider Electric PIDFF (Modicon, EcoStruxure Control Expert), mixed structure.
//!
//! # Equation
//! `OUT = α·kp·[(1 + 1/(ti·s))·(SP − PV) + td·s/((td/kd)·s + 1)·(SP − PV or −PV)]`, `α = (out_sup −
//! out_inf)/(pv_sup − pv_inf)`.
//!
//! # Units
//! ti and td are times (typed as TIME in milliseconds), here in seconds; ti = 0 is no integral action.
//!
//! # Reference
//! EcoStruxure Control Expert, Control, Block Library, PIDFF: detailed formulas, structures mixed and parallel.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Fixed, Gain, Integral, Kind, Number, Off, Scale, Source, SpanNames, Vendor,
    Weight, Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "schneider-pidff",
    name: "Schneider PIDFF, mixed structure (Modicon)",
    equation: "OUT = α·kp·[(1 + 1/(ti·s))·(SP − PV) + td·s/((td/kd)·s + 1)·(SP − PV or −PV)], α = out span/pv span",
    source: Source {
        citation: "EcoStruxure Control Expert, Control, Block Library, PIDFF",
        read: "the structures mixed and parallel and the scaling factor α; the equation itself and the names of \
               Para_PIDFF are from memory",
    },
    input: Scale::Span(100.0),
    output: Scale::Span(100.0),
    interacting: false,
    gain: Gain::Gain(Number::new("kp", "")),
    integral: Integral {
        number: Number::new("ti", "s").steps(1000.0),
        kind: Kind::Time(1.0),
        off: Off::Value(0.0),
    },
    derivative: Derivative { number: Number::new("td", "s").steps(1000.0), kind: Kind::Time(1.0) },
    filter: Filter::Divisor(Number::new("kd", "").note("td/Tf"), 10.0),
    weights: Weights::Each {
        b: Weight::Complement(Number::new("ovs_att", "").range(0.0, 1.0).note("1 − b"), 0.0),
        c: Weight::Words { name: "pv_dev", one: "1", zero: "0", one_is_default: false },
    },
    action: Action::Words { name: "rev_dir", reverse: "0", direct: "1" },
    spans: Some(SpanNames { pv: Some(("pv_inf", "pv_sup")), op: Some(("out_inf", "out_sup")) }),
    sample_period: None,
    fixed: &[Fixed { name: "mix_par", word: "0", note: "mixed structure" }],
    notes: &["ti and td are of type TIME, in whole milliseconds."],
};
