//! Exact M-constrained integral gain optimisation (MIGO criterion) PI for IPDT, numeric.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = row(Ms, 1.4, 0.282, 1.6, 0.369, 1.7, 0.404, 2, 0.489)/(K*d)`
//! - `Ti = row(Ms, 1.4, 6.741, 1.6, 5.079, 1.7, 4.597, 2, 3.743)*d`
//!
//! # Parameters
//! `Ms`, default 1.7: sensitivity peak (range 1.4 | 1.6 | 1.7 | 2).
//!
//! # When
//! The largest integral gain at a stated sensitivity peak.
//!
//! # Limits
//! The printed rows only; an optimum between them is the business of optimise.
//!
//! # Published values
//! `Ms` = 1.4; `Ms` = 1.6; `Ms` = 1.7; `Ms` = 2.0.
//!
//! # Reference
//! criterion: Astrom, Panagopoulos, Hagglund (1998), Design of PI controllers based on non-convex
//! optimization, Automatica 34, 585-601 (criterion); numbers computed here.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-maxki-ms",
    name: "Exact M-constrained integral gain optimisation (MIGO criterion) PI for IPDT, numeric",
    authors: "criterion: Astrom, Panagopoulos, Hagglund",
    year: 1998,
    citation: "Design of PI controllers based on non-convex optimization, Automatica 34, 585-601 (criterion); numbers computed here",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new("Ms", Unit::Ratio, Default::Number(1.7), "sensitivity peak")
        .range("1.4 | 1.6 | 1.7 | 2")
        .asks(Property::SensitivityPeak)],
    formula: &[
        ("Kc", "row(Ms, 1.4, 0.282, 1.6, 0.369, 1.7, 0.404, 2, 0.489)/(K*d)"),
        ("Ti", "row(Ms, 1.4, 6.741, 1.6, 5.079, 1.7, 4.597, 2, 3.743)*d"),
    ],
    when: "The largest integral gain at a stated sensitivity peak.",
    limits: "The printed rows only; an optimum between them is the business of optimise.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-maxki-ms.toml"),
    law: by_formula,
};
