//! Shinskey PD for ramps and batches.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1/(1.20*K*d)`, `Td = 0.45*d`. The source gives the gain as a proportional band of 120 % of K·d. Chapter 12
//! gives Td as the second lag plus 0.5·d instead: a remark, the rule is 0.45·d.
//!
//! # Parameters
//! None.
//!
//! # When
//! A setpoint that ramps, as in batch control: tighter than the rule for steps.
//!
//! # Limits
//! A load D at the process input leaves a lasting error of D/Kc. A ramp is followed with a constant lag.
//! Sensitivity peak 2.08, gain margin 1.95. The derivative is unfiltered in the source.
//!
//! # Published values
//! `100/(Kc*K*d)` = 120; `Td/d` = 0.45.
//!
//! # Reference
//! Shinskey (1996), Process Control Systems, 4th edition, chapters 4 and 12.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-shinskey-ramp",
    name: "Shinskey PD for ramps and batches",
    authors: "Shinskey",
    year: 1996,
    citation: "Process Control Systems, 4th edition, chapters 4 and 12",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1/(1.20*K*d)"), ("Td", "0.45*d")],
    when: "A setpoint that ramps, as in batch control: tighter than the rule for steps.",
    limits: "A load D at the process input leaves a lasting error of D/Kc. A ramp is followed with a constant \
             lag. Sensitivity peak 2.08, gain margin 1.95. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public notes on GitHub on Shinskey, Process Control Systems, 4th edition (Table 4.4 and the \
             set-point section)",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-shinskey-ramp.toml"),
    law: by_formula,
};
