//! Shinskey min-IAE load, PI.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! - `Kc = 0.9524/(K*d)`
//! - `Ti = 4*d`
//!
//! # Parameters
//! None.
//!
//! # When
//! Least integrated error after a load, robustness aside.
//!
//! # Limits
//! Proportional band 105 K d.
//!
//! # Published values
//! `Kc*K*d` = 0.9524; `Ti/d` = 4.0.
//!
//! # Reference
//! Shinskey (1994), Feedback Controllers for the Process Industries, `McGraw`-Hill.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-shinskey-1994",
    name: "Shinskey min-IAE load, PI",
    authors: "Shinskey",
    year: 1994,
    citation: "Feedback Controllers for the Process Industries, McGraw-Hill",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "0.9524/(K*d)"), ("Ti", "4*d")],
    when: "Least integrated error after a load, robustness aside.",
    limits: "Proportional band 105 K d.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "github WKolaj/S7_PID-Tuner (C# transcription of O'Dwyer handbook tables), Methods/TunningMethods/IPDModelTunningMethods/*.cs, commit 59b8950a; public code on GitHub 'Cheatsheet - Shinskey, Process Control Systems (4th ed.)', Table 4.4 and set-point section",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-shinskey-1994.toml"),
    law: by_formula,
};
