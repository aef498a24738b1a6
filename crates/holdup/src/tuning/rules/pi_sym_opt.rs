//! Symmetrical optimum PI (lag lumped into d), extended form.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(sqrt(beta)*K*d)`, `Ti = beta*d`.
//!
//! # Parameters
//! `beta`, default 4: integral time over dead time; larger is better damped (advised 4..16).
//!
//! # When
//! Drives and other loops whose engineers think in the symmetrical optimum; beta trades speed for damping.
//!
//! # Limits
//! Made for a small lag, which is lumped into d here; dead time takes more phase than a lag: `M_s` 1.96 at beta 4,
//! 1.42 at 9, 1.27 at 16, and a setpoint step overshoots by 49, 24 and 17 %. From memory.
//!
//! # Published values
//! None: the formula is from memory and no number of the papers was retrieved.
//!
//! # Reference
//! Kessler; Preitl, Precup (1999), C. Kessler 1958; Preitl, Precup, extended symmetrical optimum, Automatica 35,
//! 1731-1736. From memory: no source was read.

use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-sym-opt",
    name: "Symmetrical optimum PI (lag lumped into d), extended form",
    authors: "Kessler; Preitl, Precup",
    year: 1999,
    citation: "C. Kessler 1958; Preitl, Precup, extended symmetrical optimum, Automatica 35, 1731-1736",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new(
        "beta",
        Unit::Ratio,
        Default::Number(4.0),
        "integral time over dead time; larger is better damped",
    )
    .advised("4..16")],
    formula: &[("Kc", "1/(sqrt(beta)*K*d)"), ("Ti", "beta*d")],
    when: "Drives and other loops whose engineers think in the symmetrical optimum; beta trades speed for \
           damping.",
    limits: "Made for a small lag, which is lumped into d here; dead time takes more phase than a lag: \
             M_s 1.96 at beta 4, 1.42 at 9, 1.27 at 16, and a setpoint step overshoots by 49, 24 and 17 \
             %. From memory.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "none retrieved",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-sym-opt.toml"),
    law: by_formula,
};
