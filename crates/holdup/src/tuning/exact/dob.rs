//! `dob-exact`: PD or P control with an observer whose gain gives the whole loop a stated robustness.

use std::f64::consts::FRAC_PI_2;

use super::goal::Goal;
use super::{Normal, observer};
use crate::model::Process;
use crate::tuning::{Entry, Infeasible, RuleError, Specification, TradeOff, Tuning, Values, from_settings};

/// The tuning of the rule.
pub(in crate::tuning) fn tune(
    entry: &'static Entry,
    process: &Process,
    values: &Values<'_>,
) -> Result<Tuning, RuleError> {
    let (rule, d) = (entry.id, process.dead_time());
    let mut values = values.clone();
    let asked = question(rule, &values)?;
    let pd = pd_settings(entry, &mut values, d)?;
    let infeasible = |reason: String, nearest: Vec<Specification>| {
        RuleError::Infeasible(Box::new(Infeasible { rule, asked: asked.specification(), reason, nearest }))
    };
    let whole = match asked {
        Question::Both(am, phi) => observer::both_margins(pd, am, phi, rule)?.map_err(|nearest| {
            let reason = "no Kc and Ko with this derivative time give the whole loop both margins".to_owned();
            let pair = |phi| Specification { phase_margin: Some(phi), ..Goal::GainMargin(am).achieved(0.0) };
            infeasible(reason, nearest.map(pair).into_iter().collect())
        })?,
        Question::BestLoad(peak) => observer::best_load(pd, peak, rule)?.ok_or_else(|| {
            infeasible(
                "no Kc and Ko with this derivative time give the whole loop this peak".into(),
                Vec::new(),
            )
        })?,
        Question::One(goal) => {
            if !(pd.margins(rule)?.stable) {
                return Err(infeasible(
                    "the PD loop alone is unstable: no observer gain can help".into(),
                    Vec::new(),
                ));
            }
            let found = observer::largest(pd, goal, rule)?;
            let observer = found.map_err(|least| {
                let reason =
                    "the PD loop alone is already less robust: no observer gain meets this".to_owned();
                infeasible(reason, vec![goal.achieved(least + observer::MARGIN_TO_THE_EDGE)])
            })?;
            Normal { observer, ..pd }
        }
    };
    let k = values.get("K")?;
    values.keep("Kc", whole.gain / (k * d));
    values.keep("Ko", whole.observer / (k * d));
    let mut tuning = finish(entry, &values, whole, d)?;
    tuning.specification = asked.specification();
    tuning.trade_off = trade_off(rule, whole, k, d, values.sign())?;
    Ok(tuning)
}

/// What is asked of the whole loop.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Question {
    /// One robustness; Kc as it is.
    One(Goal),
    /// Gain margin and phase margin; Kc is solved too.
    Both(f64, f64),
    /// A sensitivity peak with the best load rejection; Kc is chosen too.
    BestLoad(f64),
}

impl Question {
    fn specification(self) -> Specification {
        match self {
            Self::One(goal) => goal.achieved(0.0),
            Self::Both(am, phi) => {
                Specification { gain_margin: Some(am), phase_margin: Some(phi), ..Specification::default() }
            }
            Self::BestLoad(peak) => Goal::SensitivityPeak(peak).achieved(0.0),
        }
    }
}

fn question(rule: &'static str, values: &Values<'_>) -> Result<Question, RuleError> {
    let (peak, am, phi) = (values.given("Ms"), values.given("Am"), values.given("phi_m"));
    let free = values.get("optimise_Kc")? == 1.0;
    let wrong = |reason| Err(RuleError::Combination { rule, reason });
    if peak.is_some() && (am.is_some() || phi.is_some()) {
        return wrong("Ms does not go together with Am or phi_m");
    }
    if free && (am.is_some() || phi.is_some()) {
        return wrong("optimise_Kc goes with Ms only");
    }
    if values.given("Kc").is_some() && (free || (am.is_some() && phi.is_some())) {
        return wrong("Kc is solved here and cannot be set");
    }
    Ok(match (am, phi) {
        (Some(am), Some(phi)) => Question::Both(am, phi),
        (Some(am), None) => Question::One(Goal::GainMargin(am)),
        (None, Some(phi)) => Question::One(Goal::PhaseMargin(phi)),
        (None, None) if free => Question::BestLoad(values.get("Ms")?),
        (None, None) => Question::One(Goal::SensitivityPeak(values.get("Ms")?)),
    })
}

/// The PD loop: what is set, and where nothing is set the formulas of `pd-kadam`.
fn pd_settings(entry: &'static Entry, values: &mut Values<'_>, d: f64) -> Result<Normal, RuleError> {
    let (kc, td) = (values.given("Kc"), values.given("Td"));
    for (name, formula) in entry.formula {
        match (*name, kc, td) {
            ("Td", _, Some(td)) => values.keep("Td", td),
            // Kc alone is a P controller, as on the command line.
            ("Td", Some(_), None) => values.keep("Td", 0.0),
            ("Kc", Some(kc), _) => values.keep("Kc", kc),
            _ => {
                values.compute(name, formula)?;
            }
        }
    }
    Ok(Normal {
        gain: values.get("Kc")? * values.get("K")? * d,
        derivative: values.get("Td")? / d,
        filter: values.given("N").map_or(0.0, |n| 1.0 / (n * d)),
        observer: 0.0,
    })
}

/// The tuning in the units of the process.
fn finish(entry: &'static Entry, values: &Values<'_>, whole: Normal, d: f64) -> Result<Tuning, RuleError> {
    let mut settings = values.clone();
    settings.clear();
    settings.keep("Kc", values.get("Kc")?);
    if whole.derivative > 0.0 {
        settings.keep("Td", whole.derivative * d);
        if let Some(n) = values.given("N") {
            settings.keep("N", n);
        }
    }
    settings.keep("Ko", values.get("Ko")?);
    from_settings(entry, &settings)
}

/// What more or less observer gain would buy and cost, the paper's Ko = Kc among it.
fn trade_off(
    rule: &'static str,
    whole: Normal,
    k: f64,
    d: f64,
    sign: f64,
) -> Result<Vec<TradeOff>, RuleError> {
    let factors = [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0];
    let mut gains: Vec<f64> = factors.iter().map(|factor| factor * whole.observer).collect();
    gains.push(whole.gain);
    gains.retain(|gain| *gain < FRAC_PI_2);
    gains.sort_by(f64::total_cmp);
    gains.dedup();
    let point = |observer: f64| -> Result<TradeOff, RuleError> {
        Ok(TradeOff {
            observer_gain: sign * observer / (k * d),
            sensitivity_peak: Normal { observer, ..whole }.margins(rule)?.sensitivity_peak,
            load_integral_error: k * d * d / (whole.gain * observer),
        })
    };
    gains.into_iter().map(point).collect()
}
