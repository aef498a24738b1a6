//! Visioli PID, ITSE of a load step.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.36/(K*d)`, `Ti = 1.66*d`, `Td = 0.53*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! The least ITSE after a load step, where the dead time is known exactly and noise is absent.
//!
//! # Limits
//! K Kc Td is 0.72 with the unfiltered derivative: sensitivity peak 5.4, gain margin 1.23. A usual derivative
//! filter of Td/10 makes it worse, not better: sensitivity peak 8.6. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.36; `Ti/d` = 1.66; `Td/d` = 0.53; `K*Kc*Td` = 0.72; `sensitivity_peak` = 5.4.
//!
//! # Reference
//! Visioli (2001), Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory
//! Appl. 148, 180-184.

use crate::model::Process;
use crate::tuning::{Applies, Entry, Form, Provenance, RuleError, Status, Tuning, Values, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-visioli-itse",
    name: "Visioli PID, ITSE of a load step",
    authors: "Visioli",
    year: 2001,
    citation: "Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory \
               Appl. 148, 180-184",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.36/(K*d)"), ("Ti", "1.66*d"), ("Td", "0.53*d")],
    when: "The least ITSE after a load step, where the dead time is known exactly and noise is absent.",
    limits: "K Kc Td is 0.72 with the unfiltered derivative: sensitivity peak 5.4, gain margin 1.23. A usual \
             derivative filter of Td/10 makes it worse, not better: sensitivity peak 8.6. The derivative is \
             unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: ipdtctrl.m, PD and PID settings for IPDT models (Xue, Chen, Atherton, book \
             code); the ISE row also in FOMCON ipdttune.m",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-visioli-itse.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut tuning = by_formula(entry, process, values)?;
    tuning.warnings.push(
        "hardly robust: K Kc Td is 0.72, the sensitivity peak 5.4 and the gain margin 1.23; a derivative \
         filter of Td/10 makes it worse (sensitivity peak 8.6)"
            .to_owned(),
    );
    Ok(tuning)
}

#[cfg(test)]
mod tests {
    use crate::model::{Process, Seconds};
    use crate::tuning::{Parameters, rule};

    #[test]
    fn its_small_robustness_is_said() {
        let process = Process::integrating(0.5, Seconds(2.0)).unwrap();
        let tuning = rule("pid-visioli-itse").unwrap().tune(&process, &Parameters::new()).unwrap();
        assert!(tuning.warnings.iter().any(|w| w.contains("hardly robust")), "{:?}", tuning.warnings);
    }
}
