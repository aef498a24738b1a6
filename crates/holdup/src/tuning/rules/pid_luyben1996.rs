//! Luyben PID, series with filtered lead.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Ku = pi/(2*K*d)`, `Pu = 4*d`, `Kc = 0.46*Ku`, `Ti = 2.2*Pu`, `Td = 0.16*Pu`, `Tf = 0.1*Td`. The controller is
//! `Kc*(1 + 1/(Ti*s))*(1 + Td*s)/(1 + Tf*s)`, which is exactly the ideal form of gain `Kc*(Ti + Td - Tf)/Ti`,
//! integral time `Ti + Td - Tf`, derivative time `(Ti - Tf)*(Td - Tf)/(Ti + Td - Tf)` and derivative filter Tf.
//!
//! # Parameters
//! None.
//!
//! # When
//! Smooth control from an ultimate-cycle test with a real series controller whose lead is filtered at a tenth of
//! Td.
//!
//! # Limits
//! From memory: no source was read, but its stated closed-loop log modulus of 2 dB is reproduced. Gain margin 1.82,
//! sensitivity peak 2.24.
//!
//! # Published values
//! `20*ln(complementary_sensitivity_peak)/ln(10)` = 2.0; `Kc*K*d` = 0.722566; `Ti/d` = 8.8; `Td/d` = 0.64.
//!
//! # Reference
//! Luyben (1996), Tuning proportional-integral-derivative controllers for integrator/deadtime processes, Ind. Eng.
//! Chem. Res. 35, 3480-3483.

use crate::tuning::{Applies, Entry, Form, Provenance, Status, by_formula};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pid-luyben1996",
    name: "Luyben PID, series with filtered lead",
    authors: "Luyben",
    year: 1996,
    citation: "Tuning proportional-integral-derivative controllers for integrator/deadtime processes, Ind. \
               Eng. Chem. Res. 35, 3480-3483",
    structure: "PID",
    process: Applies::Integrating,
    form: Form::SeriesFilteredLead,
    parameters: &[],
    formula: &[
        ("Ku", "pi/(2*K*d)"),
        ("Pu", "4*d"),
        ("Kc", "0.46*Ku"),
        ("Ti", "2.2*Pu"),
        ("Td", "0.16*Pu"),
        ("Tf", "0.1*Td"),
    ],
    when: "Smooth control from an ultimate-cycle test with a real series controller whose lead is filtered at \
           a tenth of Td.",
    limits: "From memory: no source was read, but its stated closed-loop log modulus of 2 dB is reproduced. \
             Gain margin 1.82, sensitivity peak 2.24.",
    validity: &[],
    provenance: Provenance::Memory,
    source: "memory: no source was read",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pid-luyben1996.toml"),
    law: by_formula,
};

#[cfg(test)]
mod tests {
    use num_complex::Complex64;

    use crate::model::{Process, Seconds};
    use crate::tuning::{Parameters, rule};

    #[test]
    fn the_ideal_form_is_the_series_form_with_its_filtered_lead() {
        let process = Process::integrating(0.5, Seconds(2.0)).unwrap();
        let tuning = rule("pid-luyben1996").unwrap().tune(&process, &Parameters::new()).unwrap();
        let of = |name| tuning.published.settings.iter().find(|setting| setting.name == name).unwrap().value;
        let (kc, ti, td, tf) = (of("Kc"), of("Ti"), of("Td"), of("Tf"));
        let ideal = tuning.controller;
        let filter = ideal.derivative_filter().unwrap().time();
        for omega in [0.01, 0.3, 1.0, 7.0, 100.0] {
            let s = Complex64::new(0.2, omega);
            let series = kc * (1.0 + 1.0 / (ti * s)) * (1.0 + td * s) / (1.0 + tf * s);
            let derivative = ideal.derivative_time().unwrap() * s / (1.0 + filter * s);
            let converted =
                ideal.proportional_gain() * (1.0 + 1.0 / (ideal.integral_time().unwrap() * s) + derivative);
            // A dozen roundings.
            assert!((series - converted).norm() < 1e-13 * series.norm(), "{series} is not {converted}");
        }
    }
}
