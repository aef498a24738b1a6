//! Visioli PID, ISE of a load step.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = 1.37/(K*d)`, `Ti = 1.49*d`, `Td = 0.59*d`.
//!
//! # Parameters
//! None.
//!
//! # When
//! To show what an integral criterion alone asks for: the least ISE after a load step, at the edge of stability.
//!
//! # Limits
//! K Kc Td is 0.81 with the unfiltered derivative: sensitivity peak 7.3, gain margin 1.16. A usual derivative
//! filter of Td/10 makes it worse, not better: sensitivity peak 16.3. The derivative is unfiltered in the source.
//!
//! # Published values
//! `Kc*K*d` = 1.37; `Ti/d` = 1.49; `Td/d` = 0.59; `K*Kc*Td` = 0.81; `sensitivity_peak` = 7.3.
//!
//! # Reference
//! Visioli (2001), Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory
//! Appl. 148, 180-184.

use crate::model::Process;
use crate::tuning::{Applies, Entry, Form, Provenance, RuleError, Status, Tuning, Values, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-visioli-ise",
    name: "Visioli PID, ISE of a load step",
    authors: "Visioli",
    year: 2001,
    citation: "Optimal tuning of PID controllers for integral and unstable processes, IEE Proc. Control Theory \
               Appl. 148, 180-184",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[],
    formula: &[("Kc", "1.37/(K*d)"), ("Ti", "1.49*d"), ("Td", "0.59*d")],
    when: "To show what an integral criterion alone asks for: the least ISE after a load step, at the edge of \
           stability.",
    limits: "K Kc Td is 0.81 with the unfiltered derivative: sensitivity peak 7.3, gain margin 1.16. A usual \
             derivative filter of Td/10 makes it worse, not better: sensitivity peak 16.3. The derivative is \
             unfiltered in the source.",
    validity: &[],
    provenance: Provenance::Retrieved,
    source: "public code on GitHub: ipdtctrl.m, PD and PID settings for IPDT models (Xue, Chen, Atherton, book \
             code); the ISE row also in FOMCON ipdttune.m",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-visioli-ise.toml"),
    law: tune,
};

fn tune(entry: &'static Entry, process: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut tuning = by_formula(entry, process, values)?;
    tuning.warnings.push(
        "hardly robust: K Kc Td is 0.81, the sensitivity peak 7.3 and the gain margin 1.16; a derivative \
         filter of Td/10 makes it worse (sensitivity peak 16.3)"
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
        let tuning = rule("pid-visioli-ise").unwrap().tune(&process, &Parameters::new()).unwrap();
        assert!(tuning.warnings.iter().any(|w| w.contains("hardly robust")), "{:?}", tuning.warnings);
    }
}
