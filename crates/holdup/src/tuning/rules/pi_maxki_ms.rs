//! Exact M-constrained integral gain optimisation (MIGO criterion) PI for IPDT, numeric.
//!
//! # Applies to
//! The plain integrator with dead time.
//!
//! # Formula
//! `Kc = row(Ms, 1.4, 0.282, 1.6, 0.369, 1.7, 0.404, 2, 0.489)/(K*d)`,
//! `Ti = row(Ms, 1.4, 6.741, 1.6, 5.079, 1.7, 4.597, 2, 3.743)*d`.
//!
//! # Parameters
//! `Ms`, default 1.7: sensitivity peak (one of 1.4, 1.6, 1.7, 2).
//!
//! # When
//! The best PI under a robustness limit: the largest integral gain Kc/Ti whose sensitivity peak is Ms.
//!
//! # Limits
//! Table rows, nothing between them. The loop oscillates slightly and a setpoint step overshoots (41 % at 1.7): weight
//! the setpoint. With `M_s` and `M_t` both at most 1.4 the optimum is 0.298/(K d), 7.276 d.
//!
//! # Published values
//! `sensitivity_peak`, `Kc*K*d` and `Ti/d` of the four rows.
//!
//! # Reference
//! criterion: Astrom, Panagopoulos, Hagglund (1998), Design of PI controllers based on non-convex optimization,
//! Automatica 34, 585-601 (criterion); the numbers were computed for this collection. Derived here.

use crate::tuning::{
    Applies, Default, Entry, Form, Parameter, Property, Provenance, Status, Unit, by_formula,
};

/// The rule.
pub(in crate::tuning) static ENTRY: Entry = Entry {
    id: "pi-maxki-ms",
    name: "Exact M-constrained integral gain optimisation (MIGO criterion) PI for IPDT, numeric",
    authors: "criterion: Astrom, Panagopoulos, Hagglund",
    year: 1998,
    citation: "Design of PI controllers based on non-convex optimization, Automatica 34, 585-601 \
               (criterion); the numbers were computed for this collection",
    structure: "PI",
    process: Applies::Integrating,
    form: Form::Ideal,
    parameters: &[Parameter::new("Ms", Unit::Ratio, Default::Number(1.7), "sensitivity peak")
        .range("1.4 | 1.6 | 1.7 | 2")
        .asks(Property::SensitivityPeak)],
    formula: &[
        ("Kc", "row(Ms, 1.4, 0.282, 1.6, 0.369, 1.7, 0.404, 2, 0.489)/(K*d)"),
        ("Ti", "row(Ms, 1.4, 6.741, 1.6, 5.079, 1.7, 4.597, 2, 3.743)*d"),
    ],
    when: "The best PI under a robustness limit: the largest integral gain Kc/Ti whose sensitivity peak \
           is Ms.",
    limits: "Table rows, nothing between them. The loop oscillates slightly and a setpoint step \
             overshoots (41 % at 1.7): weight the setpoint. With M_s and M_t both at most 1.4 the optimum \
             is 0.298/(K d), 7.276 d.",
    validity: &[],
    provenance: Provenance::Derived,
    source: "the table of rules.json, held against the analysis here",
    status: Status::Recommended,
    values: include_str!("../../../tests/rules/pi-maxki-ms.toml"),
    law: by_formula,
};

#[cfg(test)]
mod tests {
    use crate::analysis::frequency::margins;
    use crate::model::{ClosedLoop, Controller, Process, Seconds};

    /// The integral gain at which this integral time has this sensitivity peak, K = d = 1.
    fn integral_gain(ti: f64, peak: f64) -> f64 {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        // From the gain of least M_s upwards M_s rises with the gain; the bracket lies there.
        let (mut low, mut high) = (0.25, 0.75);
        for _ in 0..60 {
            let kc = 0.5 * (low + high);
            let pi = Controller::proportional(kc).unwrap().with_integral_time(Seconds(ti)).unwrap();
            let achieved = margins(&ClosedLoop::new(&process, &pi)).unwrap().sensitivity_peak;
            if achieved.is_some_and(|m| m < peak) { low = kc } else { high = kc }
        }
        low / ti
    }

    #[test]
    fn the_rows_are_the_largest_integral_gain_of_their_sensitivity_peak() {
        for (peak, ti) in [(1.4, 6.741), (1.6, 5.079), (1.7, 4.597), (2.0, 3.743)] {
            let best = integral_gain(ti, peak);
            assert!(best > integral_gain(ti * 1.01, peak) && best > integral_gain(ti * 0.99, peak), "{peak}");
        }
    }
}
