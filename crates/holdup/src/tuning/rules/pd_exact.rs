//! PD control that meets two of gain margin, phase margin and settling time exactly.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! None: solved on the curve of constant gain margin, `K*Kc = p*sin(p)/(Am*d)` and `Td = -d*cos(p)/(p*sin(p))` for the
//! phase crossover p/d between pi/2 and pi, or on the curve of constant phase margin.
//!
//! # Parameters
//! Exactly two of `Am` (gain margin), `phi_m` [rad] (phase margin) and `Ts` [s] (settling time of a unit setpoint
//! step, 2 % band, dead time included, derivative action on the control error). `N` [rad/s]: bandwidth of the
//! derivative filter; without it the derivative is unfiltered where only margins are asked, and N = 100/d where `Ts` is.
//!
//! # When
//! Where a specification is to be met, not only named.
//!
//! # Limits
//! Both margins are feasible exactly for 90° (1 - 1/Am) <= `phi_m` < 90° + asin(1/Am), and then unique. Settling time
//! jumps and has a minimum as a function of Td: what lies in a jump or below is infeasible. A load leaves a lasting error.
//!
//! # Published values
//! None: derived here. At Td = 0 it is P control with K Kc d = pi/(2 Am).
//!
//! # Reference
//! Derived here; the specification is that of S. D. Kadam, arXiv 1711.11250 (2017).

use crate::tuning::exact;
use crate::tuning::{Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pd-exact",
    name: "PD that meets two of gain margin, phase margin and settling time",
    authors: "holdup",
    year: 2026,
    citation: "derived here",
    structure: "PD",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[
        Parameter::new("Am", Unit::Ratio, Default::Absent, "gain margin")
            .range("> 1")
            .asks(Property::GainMargin),
        Parameter::new("phi_m", Unit::Radian, Default::Absent, "phase margin")
            .range("> 0 and < pi")
            .asks(Property::PhaseMargin),
        Parameter::new("Ts", Unit::Second, Default::Absent, "settling time, 2 % band")
            .range("> d and <= 1000*d")
            .asks(Property::SettlingTime),
        Parameter::new(
            "N",
            Unit::RadianPerSecond,
            Default::Absent,
            "derivative filter bandwidth; 100/d where Ts is asked, else none",
        ),
    ],
    formula: &[],
    when: "Where a specification is to be met, not only named.",
    limits: "Both margins are feasible exactly for 90° (1 - 1/Am) <= phi_m < 90° + asin(1/Am), and then unique. \
             Settling time jumps and has a minimum as a function of Td: what lies in a jump or below is infeasible. \
             A load leaves a lasting error.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "derived here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pd-exact.toml"),
    law: exact::pd,
};
