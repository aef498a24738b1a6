//! Chidambaram-Sree PID of 2003.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.2346/(K*d)`, `Ti = 4.5*d`, `Td = 0.45*d`. The factors are 1/0.9², 5·0.9 and 0.5·0.9, the first as
//! printed.
//!
//! # Parameters
//! None.
//!
//! # When
//! Fast load rejection where the dead time is known well; pid-sree-chidambaram by the same authors has the same IAE
//! after a load at sensitivity peak 2.2.
//!
//! # Limits
//! Sensitivity peak 3.8, gain margin 1.37: a gain 37 % higher makes the loop unstable. From memory: no source was
//! read. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc` = 4.066 (K = 0.0506, d = 6) — DIFFERENCE, see the values file; `Ti` = 27; `Td` = 2.7; `sensitivity_peak` =
//! 3.8.
//!
//! # Reference
//! Chidambaram, Padma Sree (2003), A simple method of tuning PID controllers for integrator/dead-time processes,
//! Comput. Chem. Eng. 27, 211-215.

use crate::model::Process;
use crate::tuning::{Applies, Entry, Form, Provenance, RuleError, Status, Tuning, Values, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-chidambaram-sree2003",
    name: "Chidambaram-Sree PID of 2003",
    authors: "Chidambaram, Padma Sree",
    year: 2003,
    citation: "A simple method of tuning PID controllers for integrator/dead-time processes, Comput. Chem. \
               Eng. 27, 211-215",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.2346/(K*d)"), ("Ti", "4.5*d"), ("Td", "0.45*d")],
    when: "Fast load rejection where the dead time is known well; pid-sree-chidambaram by the same authors has \
           the same IAE after a load at sensitivity peak 2.2.",
    limits: "Sensitivity peak 3.8, gain margin 1.37: a gain 37 % higher makes the loop unstable. From memory: \
             no source was read. The derivative is unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-chidambaram-sree2003.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut tuning = by_formula(entry, process, values)?;
    tuning
        .warnings
        .push("little robustness: the sensitivity peak is 3.8 and the gain margin 1.37".to_owned());
    Ok(tuning)
}

#[cfg(test)]
mod tests {
    use crate::model::{Process, Seconds};
    use crate::tuning::{Parameters, rule};

    #[test]
    fn its_small_robustness_is_said() {
        let process = Process::integrating(0.5, Seconds(2.0)).unwrap();
        let tuning = rule("pid-chidambaram-sree2003").unwrap().tune(&process, &Parameters::new()).unwrap();
        assert!(
            tuning.warnings.iter().any(|w| w.contains("sensitivity peak is 3.8")),
            "{:?}",
            tuning.warnings
        );
    }
}
