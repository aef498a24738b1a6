//! Omron PIDAT (CS, CJ and CP series), times in 0.1 s.
//!
//! # Equation
//! Two-degree-of-freedom PID, `MV = (100/P)·[(1 − α)·SV − PV + (SV − PV)/(Ti·s) − Td·s·PV]`, in percent of the
//! input and output range.
//!
//! # Units
//! Proportional band in steps of 0.1 %, times in steps of 0.1 s with the unit of C+6 set to 9; the numbers here are
//! those before they are coded. Tik = 9999 is no integral action.
//!
//! # Reference
//! CS/CJ/NSJ Series Instructions Reference Manual, W474, PIDAT; CP Series Programming Manual, data control
//! instructions, 3-17.

use crate::deploy::conversion::{
    Action, Derivative, Filter, Fixed, Gain, Integral, Kind, Number, Off, Scale, Source, Vendor, Weight,
    Weights,
};

/// The block.
pub(in crate::deploy) static ENTRY: Vendor = Vendor {
    id: "omron-pidat",
    name: "Omron PIDAT (CS, CJ, CP series)",
    equation: "MV = (100/P)·[(1 − α)·SV − PV + (SV − PV)/(Ti·s) − Td·s·PV], in percent of range",
    source: Source {
        citation: "Omron CS/CJ/NSJ Series Instructions Reference Manual, W474, PIDAT",
        read: "words and units of the parameters, their steps and ranges, the codes for none, α and its normal \
               value; that α is 1 − b and that the derivative is of the measurement are from memory",
    },
    input: Scale::Span(100.0),
    output: Scale::Span(100.0),
    interacting: false,
    gain: Gain::Band(Number::new("P", "0.1 %").counted(10.0).range(1.0, 9999.0).note("word C+1")),
    integral: Integral {
        number: Number::new("Tik", "0.1 s").counted(10.0).range(1.0, 8191.0).note("word C+2, 9999 is none"),
        kind: Kind::Time(1.0),
        off: Off::Value(999.9),
    },
    derivative: Derivative {
        number: Number::new("Tdk", "0.1 s").counted(10.0).range(1.0, 8191.0).note("word C+3"),
        kind: Kind::Time(1.0),
    },
    filter: Filter::Absent,
    weights: Weights::Each {
        b: Weight::Complement(
            Number::new("alpha", "")
                .steps(100.0)
                .range(0.0, 0.99)
                .note("C+5 bits 04 to 15, there as hex 1nn"),
            0.65,
        ),
        c: Weight::Fixed(0.0),
    },
    action: Action::Words { name: "forward", reverse: "0", direct: "1" },
    spans: None,
    sample_period: Some((Number::new("sampling period", "10 ms").counted(100.0).note("word C+4"), 1.0)),
    fixed: &[Fixed { name: "integral and derivative unit", word: "9", note: "C+6 bits 04 to 07" }],
    notes: &["The manual does not say how the derivative is filtered: none is assumed."],
};
