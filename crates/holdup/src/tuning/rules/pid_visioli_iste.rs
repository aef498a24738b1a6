//! Visioli PID, ISTE of a load step.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.34/(K*d)`, `Ti = 1.83*d`, `Td = 0.49*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! The least ISTE after a load step; the least extreme of the three Visioli load rules.
//!
//! # Limits
//! K Kc Td is 0.66 with the unfiltered derivative: sensitivity peak 4.6, gain margin 1.28. A usual derivative
//! filter of Td/10 makes it worse, not better: sensitivity peak 6.4. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.34; `Ti/d` = 1.83; `Td/d` = 0.49; `K*Kc*Td` = 0.66; `sensitivity_peak` = 4.6.
//!
//! # Reference
//! Visioli (2001), Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory
//! Appl. 148, 180-184.

use crate::model::Process;
use crate::tuning::{Applies, Entry, Form, Provenance, RuleError, Status, Tuning, Values, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-visioli-iste",
    name: "Visioli PID, ISTE of a load step",
    authors: "Visioli",
    year: 2001,
    citation: "Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory \
               Appl. 148, 180-184",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.34/(K*d)"), ("Ti", "1.83*d"), ("Td", "0.49*d")],
    when: "The least ISTE after a load step; the least extreme of the three Visioli load rules.",
    limits: "K Kc Td is 0.66 with the unfiltered derivative: sensitivity peak 4.6, gain margin 1.28. A usual \
             derivative filter of Td/10 makes it worse, not better: sensitivity peak 6.4. The derivative is \
             unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: ipdtctrl.m, PD and PID settings for IPDT models (Xue, Chen, Atherton, book \
             code); the ISE row also in FOMCON ipdttune.m",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-visioli-iste.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut tuning = by_formula(entry, process, values)?;
    tuning.warnings.push(
        "hardly robust: K Kc Td is 0.66, the sensitivity peak 4.6 and the gain margin 1.28; a derivative \
         filter of Td/10 makes it worse (sensitivity peak 6.4)"
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
        let tuning = rule("pid-visioli-iste").unwrap().tune(&process, &Parameters::new()).unwrap();
        assert!(tuning.warnings.iter().any(|w| w.contains("hardly robust")), "{:?}", tuning.warnings);
    }
}
