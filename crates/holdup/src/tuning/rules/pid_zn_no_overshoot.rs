//! Modified Ziegler-Nichols PID, no overshoot.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ku = pi/(2*K*d)`, `Pu = 4*d`, `Kc = 0.2*Ku`, `Ti = Pu/2`, `Td = Pu/3`. Ku and Pu are the exact ultimate gain
//! and period of the plain integrator.
//!
//! # Parameters
//! None.
//!
//! # When
//! Not to be used on an integrator: kept to show what is wrong with it. pid-isimc is the robust everyday PID.
//!
//! # Limits
//! Made for self-regulating processes: on an integrator every controller with integral action and setpoint weight 1
//! overshoots, because the error of a setpoint step integrates to 0; this one by 45 %; dominant damping 0.23. From
//! memory: no source was read.
//!
//! # Published values
//! `100*overshoot` = 0 — DIFFERENCE, see the values file.
//!
//! # Reference
//! Seborg, Edgar, Mellichamp (table) (1989), Process Dynamics and Control; a general rule from the ultimate cycle.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-zn-no-overshoot",
    name: "Modified Ziegler-Nichols PID, no overshoot",
    authors: "Seborg, Edgar, Mellichamp (table)",
    year: 1989,
    citation: "Process Dynamics and Control; a general rule from the ultimate cycle",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Ku", "pi/(2*K*d)"), ("Pu", "4*d"), ("Kc", "0.2*Ku"), ("Ti", "Pu/2"), ("Td", "Pu/3")],
    when: "Not to be used on an integrator: kept to show what is wrong with it. pid-isimc is the robust \
           everyday PID.",
    limits: "Made for self-regulating processes: on an integrator every controller with integral action and \
             setpoint weight 1 overshoots, because the error of a setpoint step integrates to 0; this one by \
             45 %; dominant damping 0.23. From memory: no source was read.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read",
    status: Status::Wrong(
        "on an integrator it overshoots by 45 % and has a dominant damping of 0.23, which contradicts its name",
    ),
    values: include_str!("../../../tests/rules/pid-zn-no-overshoot.toml"),
    law: by_formula,
};
