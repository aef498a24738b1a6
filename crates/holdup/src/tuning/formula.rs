//! Rules that are formulas: from the evaluated settings to the controller.

use super::entry::{Entry, Form, Unit};
use super::error::RuleError;
use super::parameters::Values;
use super::{Published, Setting, Tuning};
use crate::model::{Compensator, CompensatorLaw, Controller, ModelError, Observer, Process, Seconds};

/// The names of settings; every other name of a formula is an intermediate value.
const SETTINGS: [(&str, Unit); 11] = [
    ("Kc", Unit::Gain),
    ("Ti", Unit::Second),
    ("Td", Unit::Second),
    ("Tf", Unit::Second),
    ("N", Unit::RadianPerSecond),
    ("b", Unit::Ratio),
    ("c", Unit::Ratio),
    ("Ko", Unit::Gain),
    ("a1", Unit::Second),
    ("a2", Unit::SecondSquared),
    ("Kr", Unit::Gain),
];

/// A rule that is its formula: evaluates the lines of the entry in order and builds the controller of them.
///
/// # Errors
/// [`RuleError`] if a formula has no value or the settings are no controller.
pub fn by_formula(entry: &'static Entry, _: &Process, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let mut values = values.clone();
    for (name, formula) in entry.formula {
        values.compute(name, formula)?;
    }
    from_settings(entry, &values)
}

/// The tuning of the settings that `values` has computed.
///
/// # Errors
/// [`RuleError::Setting`] if they are no controller, for example because a number has overflowed.
pub fn from_settings(entry: &'static Entry, values: &Values<'_>) -> Result<Tuning, RuleError> {
    let setting =
        |name: &str| values.computed().iter().rev().find(|(n, _)| *n == name).map(|(_, value)| *value);
    let controller = controller(entry.form, values.sign(), &setting)
        .map_err(|error| RuleError::Setting { rule: entry.id, error })?;
    let settings = SETTINGS.iter().filter_map(|&(name, unit)| {
        let value = setting(name)?;
        Some(Setting {
            name,
            value: if unit == Unit::Gain { value * values.sign() } else { value },
            unit: unit.symbol(),
        })
    });
    Ok(Tuning {
        published: Published { form: entry.form.text(), settings: settings.collect() },
        ..Tuning::new(entry.id, controller, values.specification())
    })
}

/// How a rule makes a compensator of its settings, which it looks up by name.
pub type CompensatorOf = fn(&dyn Fn(&str) -> f64) -> CompensatorLaw;

/// The tuning of a rule for a dead-time compensator, with a model that is the process: evaluates the formulas of the
/// entry and makes the law of the settings named; gains come to it with the sign of the process gain.
///
/// # Errors
/// [`RuleError`] if a formula has no value or the settings are no compensator.
pub fn compensated(
    entry: &'static Entry,
    process: &Process,
    values: &Values<'_>,
    names: &[(&'static str, Unit)],
    law: CompensatorOf,
) -> Result<Tuning, RuleError> {
    let mut values = values.clone();
    for (name, formula) in entry.formula {
        values.compute(name, formula)?;
    }
    let mut settings = Vec::with_capacity(names.len());
    for &(name, unit) in names {
        let sign = if unit == Unit::Gain { values.sign() } else { 1.0 };
        settings.push(Setting { name, value: values.get(name)? * sign, unit: unit.symbol() });
    }
    let setting =
        |name: &str| settings.iter().find(|setting| setting.name == name).map_or(f64::NAN, |s| s.value);
    let dead_time = Seconds(process.dead_time());
    let compensator = Compensator::new(law(&setting), process.process_gain(), dead_time)
        .map_err(|error| RuleError::Setting { rule: entry.id, error })?;
    Ok(Tuning {
        published: Published { form: entry.form.text(), settings },
        ..Tuning::new(entry.id, compensator.into(), values.specification())
    })
}

/// The controller in ideal form.
fn controller(
    form: Form,
    sign: f64,
    setting: &dyn Fn(&str) -> Option<f64>,
) -> Result<Controller, ModelError> {
    let (kc, ti, td) = (setting("Kc").unwrap_or(f64::NAN) * sign, setting("Ti"), setting("Td"));
    let series = matches!(form, Form::Series | Form::SeriesOutputFilter);
    let (kc, ti, td) = match (series, ti, td) {
        // The filtered lead is an ideal form with the same filter on the derivative action: comparing the powers
        // of s in Kc·(Ti·s + 1)·(Td·s + 1)/(Ti·s·(Tf·s + 1)) gives its three settings. Td ≥ 0 where Tf ≤ Td.
        _ if form == Form::SeriesFilteredLead => {
            let (tf, ti, td) = (setting("Tf").unwrap_or(0.0), ti.unwrap_or(f64::NAN), td.unwrap_or(0.0));
            let sum = ti + td - tf;
            (kc * sum / ti, Some(sum), Some((ti - tf) * (td - tf) / sum))
        }
        (true, Some(ti), Some(td)) => (kc * (1.0 + td / ti), Some(ti + td), Some(ti * td / (ti + td))),
        _ => (kc, ti, td),
    };
    let mut controller = Controller::proportional(kc)?;
    if let Some(ti) = ti {
        controller = controller.with_integral_time(Seconds(ti))?;
    }
    if let Some(td) = td {
        controller = controller.with_derivative_time(Seconds(td))?;
    }
    if let Some(n) = setting("N") {
        controller = controller.with_filter_bandwidth(n)?;
    }
    match (form, setting("Tf"), setting("a1"), setting("a2")) {
        (Form::Ideal | Form::Series | Form::SeriesFilteredLead, Some(tf), _, _) => {
            controller = controller.with_filter_time(Seconds(tf))?;
        }
        (_, Some(tf), _, _) => controller = controller.with_output_filter(tf, 0.0)?,
        (_, None, Some(a1), a2) => controller = controller.with_output_filter(a1, a2.unwrap_or(0.0))?,
        _ => {}
    }
    if setting("b").is_some() || setting("c").is_some() {
        controller =
            controller.with_setpoint_weights(setting("b").unwrap_or(1.0), setting("c").unwrap_or(1.0))?;
    }
    if let Some(ko) = setting("Ko") {
        controller = controller.with_observer(Observer::new(ko * sign)?);
    }
    Ok(controller)
}
