//! PD or P control with an observer whose gain gives the whole loop a stated robustness.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! PD settings as `pd-kadam` unless `Kc` (alone: P control) or `Td` is set. The observer gain is the largest that
//! meets the goal; solved with the exact margins of the whole loop, broken at the process input.
//!
//! # Parameters
//! `Ms`, default 2: sensitivity peak of the whole loop; or instead `Am` (gain margin) or `phi_m` [rad] (phase margin);
//! with both, Kc is solved too. `optimise_Kc` = 1: with `Ms`, Kc is chosen too, for the least integral of the error
//! after a load step. `Kc`, `Td`, `N`: PD settings. `Ts`, `Am_pd`, `phi_m_pd`: parameters of `pd-kadam`.
//!
//! # When
//! Load rejection with a stated robustness, instead of Ko = Kc, which spends robustness untold.
//!
//! # Limits
//! An observer never makes a loop as robust as without it where the PD loop alone misses the goal.
//!
//! # Published values
//! None: derived here.
//!
//! # Reference
//! Derived here; the structure is that of S. D. Kadam, arXiv 1711.11250 (2017), equations 16 to 22.

use super::pd_kadam;
use crate::tuning::exact;
use crate::tuning::{Applies, Default, Entry, Form, Parameter, Provenance, Status, Unit};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "dob-exact",
    name: "Observer gain for a stated robustness of the whole loop",
    authors: "holdup",
    year: 2026,
    citation: "derived here",
    structure: "PD+DOB",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new("Ms", Unit::Ratio, Default::Number(2.0), "sensitivity peak of the whole loop")
            .range("> 1"),
        Parameter::new("Am", Unit::Ratio, Default::Absent, "gain margin of the whole loop").range("> 1"),
        Parameter::new("phi_m", Unit::Radian, Default::Absent, "phase margin of the whole loop")
            .range("> 0 and < pi"),
        Parameter::new(
            "optimise_Kc",
            Unit::Ratio,
            Default::Number(0.0),
            "1: Kc is chosen for best load rejection",
        )
        .range("0 | 1"),
        Parameter::new("Kc", Unit::Gain, Default::Absent, "proportional gain; alone it makes P control"),
        Parameter::new("Td", Unit::Second, Default::Absent, "derivative time").range(">= 0"),
        Parameter::new(
            "N",
            Unit::RadianPerSecond,
            Default::Absent,
            "derivative filter bandwidth; none when absent",
        ),
        pd_kadam::PARAMETERS[0].no_goal(),
        pd_kadam::PARAMETERS[1].no_goal().named("Am_pd", "gain margin asked of pd-kadam"),
        pd_kadam::PARAMETERS[2].no_goal().named("phi_m_pd", "phase margin asked of pd-kadam"),
    ],
    formula: &[
        pd_kadam::FORMULA[0],
        pd_kadam::FORMULA[1],
        ("Td", "abs(tan(phi_m_pd + w_gc*d - pi/2))/w_gc"),
        ("Kc", "w_pc/(K*Am_pd*sqrt(1 + (Td*w_pc)^2))"),
    ],
    when: "Load rejection with a stated robustness, instead of Ko = Kc, which spends robustness untold.",
    limits: "An observer never makes a loop as robust as without it where the PD loop alone misses the goal.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/dob-exact.toml"),
    law: exact::dob,
};
