//! Wolfe 1951, PI, decay ratio 0.4.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 0.6/(K*d)`, `Ti = 2.78*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! Only to compare with: the loop is not what its name says.
//!
//! # Limits
//! The dominant poles decay to 0.08 in a period, not 0.4. Gain margin 2.09, phase margin 23 deg, `M_s` 2.77.
//!
//! # Published values
//! `Kc*K*d` = 0.6; `Ti/d` = 2.78; `decay_ratio` = 0.4 (DIFFERENCE, see the values file).
//!
//! # Reference
//! Wolfe (1951), Controller settings for optimum control, Trans. ASME 73, 413-418.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-wolfe-1",
    name: "Wolfe 1951, PI, decay ratio 0.4",
    authors: "Wolfe",
    year: 1951,
    citation: "Controller settings for optimum control, Trans. ASME 73, 413-418",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.6/(K*d)"), ("Ti", "2.78*d")],
    when: "Only to compare with: the loop is not what its name says.",
    limits: "The dominant poles decay to 0.08 in a period, not 0.4. Gain margin 2.09, phase margin 23 \
             deg, M_s 2.77.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: S7_PID-Tuner, a transcription of O'Dwyer's handbook",
    status: Status::History("its stated decay ratio of 0.4 is not the one of its loop, which is 0.08"),
    values: include_str!("../../../tests/rules/pi-wolfe-1.toml"),
    law: by_formula,
};
