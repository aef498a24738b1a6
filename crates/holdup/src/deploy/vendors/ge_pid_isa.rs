//! GE (Emerson) PACSystems and VersaMax, PID_ISA.
//!
//! # Equation
//! `PID Output = Kc·(Error + Error·dt/Ti + Td·Derivative) + CV Bias`, in counts of PV and CV; the usual scaling of both
//! spans to 0 … 32000 counts is taken.
//!
//! # Units
//! Whole numbers: Kp in hundredths, Ki = 1/Ti in thousandths of a repeat per second, Kd = Td in hundredths of a second.
//!
//! # Limits
//! The step of Ki is coarse: an integral time of 300 s is 3.33 steps. No filter of the derivative.
//!
//! # Reference
//! PACSystems CPU Programmer's Reference Manual, GFK-2950C, chapter 7: sections 7.2.2 and 7.4; VersaMax PLC User's
//! Manual, GFK-1503E, PID built-in function block, word 8.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Gain, Integral, Kind, Number, Off, Scale, Source, Vendor, Weight, Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "ge-pid-isa",
    name: "GE PACSystems, VersaMax PID_ISA",
    equation: "PID Output = Kc·(Error + Error·dt/Ti + Td·Derivative) + CV Bias, in counts",
    source: Source {
        citation: "GE PACSystems GFK-2950C, sections 7.2.2 and 7.4; VersaMax GFK-1503E, PID, word 8",
        read: "equation, step and coding of Kp, Ki as 1/Ti with its step and range; the step of Kd and the bits \
               of the Config Word are from memory",
    },
    input: Scale::Span(32_000.0),
    output: Scale::Span(32_000.0),
    interacting: false,
    gain: Gain::Gain(Number::new("Kp", "0.01").counted(100.0).range(0.0, 32_767.0).note("word 6")),
    integral: Integral {
        number: Number::new("Ki", "0.001/s").counted(1000.0).range(0.0, 32_767.0).note("word 8, 1/Ti"),
        kind: Kind::Rate(1.0),
        off: Off::Value(0.0),
    },
    derivative: Derivative {
        number: Number::new("Kd", "0.01 s").counted(100.0).range(0.0, 32_767.0).note("word 7, Td"),
        kind: Kind::Time(1.0),
    },
    filter: Filter::Absent,
    weights: Weights::Each {
        b: Weight::Fixed(1.0),
        c: Weight::Words { name: "Config Word bit 2", one: "0", zero: "1", one_is_default: true },
    },
    action: Action::Words { name: "Config Word bit 0", reverse: "0", direct: "1" },
    spans: None,
    sample_period: Some((Number::new("Sample Period", "10 ms").counted(100.0).note("word 3"), 1.0)),
    fixed: &[],
    notes: &["Both spans are taken to be scaled to 0 to 32000 counts."],
};
