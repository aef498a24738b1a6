//! From a controller to the sheet of numbers that are typed.

use serde::Serialize;

use super::back::read;
use super::error::Refusal;
use super::interacting::{self, Lag, Terms};
use super::numbers::{decoded, encoded, gain_scale, typed_derivative, typed_gain, typed_integral};
use super::scaling::Scaling;
use super::settings::{Given, Value};
use super::vendor::{Action, Filter, Number, Off, Scale, Vendor};
use super::weights;
use crate::model::{Controller, DerivativeFilter};

/// One parameter, as it is typed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Parameter {
    /// Name, as the vendor writes it.
    pub name: &'static str,
    /// What is typed.
    pub value: Value,
    /// Unit; empty for a ratio or a word.
    pub unit: String,
    /// What must be known, or empty.
    pub note: &'static str,
}

impl Parameter {
    pub(super) fn number(number: &Number, value: f64) -> Self {
        let Number { name, unit, note, .. } = *number;
        Self { name, value: Value::Number(encoded(number, value)), unit: unit.to_owned(), note }
    }

    pub(super) fn word(name: &'static str, word: &'static str, note: &'static str) -> Self {
        Self { name, value: Value::Word(word), unit: String::new(), note }
    }
}

/// What is typed, and what then runs.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// The parameters, in the order of the block.
    pub parameters: Vec<Parameter>,
    /// The controller that the block runs with them, read back from the typed values.
    pub run: Controller,
    /// What of the design the block cannot represent, one sentence each.
    pub cannot: Vec<String>,
    /// What the user must know, one sentence each.
    pub warnings: Vec<String>,
}

/// A controller for one vendor's block.
#[derive(Debug, Clone, PartialEq)]
pub struct Conversion {
    /// The block.
    pub vendor: &'static Vendor,
    /// The sheet, or why the block cannot run this controller.
    pub sheet: Result<Sheet, Refusal>,
}

/// The parameters of a vendor's block for a controller.
///
/// Gain, integral and derivative time are met exactly, to the steps in which the block takes its numbers; what else
/// differs is in [`Sheet::cannot`] and in [`Sheet::run`].
#[must_use]
pub fn convert(vendor: &'static Vendor, controller: &Controller, scaling: &Scaling) -> Conversion {
    Conversion { vendor, sheet: sheet(vendor, controller, scaling) }
}

fn sheet(vendor: &Vendor, design: &Controller, scaling: &Scaling) -> Result<Sheet, Refusal> {
    if design.compensator().is_some() {
        return Err(Refusal::because("a PID block cannot run a dead-time compensator: see 'holdup export'"));
    }
    let mut parameters = law(vendor, design, scaling)?;
    let finite =
        |parameter: &Parameter| !matches!(parameter.value, Value::Number(number) if !number.is_finite());
    if let Some(parameter) = parameters.iter().find(|parameter| !finite(parameter)) {
        let reason = format!("{} would be out of the reach of double precision", parameter.name);
        return Err(Refusal::because(reason));
    }
    let typed = Given::of(parameters.iter().map(|parameter| (parameter.name, parameter.value)));
    let run = read(vendor, &typed, scaling)
        .map_err(|error| Refusal::because(format!("the block does not take these numbers: {error}")))?;
    let mut warnings = out_of_range(vendor, &parameters);
    surroundings(vendor, scaling, &mut parameters, &mut warnings);
    if !scaling.pv_unit.is_empty() {
        for parameter in &mut parameters {
            parameter.unit = parameter.unit.replace("PV unit", &scaling.pv_unit);
        }
    }
    Ok(Sheet { parameters, cannot: differences(design, &run), run, warnings })
}

/// The parameters that make the law.
fn law(vendor: &Vendor, design: &Controller, scaling: &Scaling) -> Result<Vec<Parameter>, Refusal> {
    let terms = Terms {
        gain: design.proportional_gain(),
        ti: design.integral_time(),
        td: design.derivative_time(),
        tf: design.derivative_filter().map(DerivativeFilter::time),
    };
    if vendor.action == Action::ReverseOnly && terms.gain < 0.0 {
        return Err(Refusal::because(
            "the block raises its output only when the measurement is too low: Kc must be positive",
        ));
    }
    let (block, filter) = with_filter(vendor, &terms)?;
    let signed = block.gain * gain_scale(vendor, scaling);
    let scaled = if vendor.action == Action::Sign { signed } else { signed.abs() };
    if !(scaled.is_finite() && scaled != 0.0 && (1.0 / scaled).is_finite()) {
        return Err(Refusal::because("its scaled gain is out of the reach of double precision"));
    }
    let (gain, value) = typed_gain(&vendor.gain, scaled);
    let mut parameters = vec![Parameter::number(&gain, value)];
    let integral = match (block.ti, vendor.integral.off) {
        (Some(ti), _) => typed_integral(vendor.integral.kind, ti, scaled),
        (None, Off::Value(off)) => off,
        (None, Off::Never) => return Err(Refusal::because("the block has no way without integral action")),
    };
    parameters.push(Parameter::number(&vendor.integral.number, integral));
    let derivative = block.td.map_or(0.0, |td| typed_derivative(vendor.derivative.kind, td, scaled));
    parameters.push(Parameter::number(&vendor.derivative.number, derivative));
    parameters.extend(filter);
    let wanted = (design.setpoint_weight(), design.derivative_setpoint_weight());
    let factor = if vendor.interacting { interacting::factor(&block) } else { 1.0 };
    parameters.extend(weights::typed(
        &vendor.weights,
        wanted,
        factor,
        block.ti.is_some(),
        block.td.is_some(),
    ));
    if let Action::Words { name, reverse, direct } = vendor.action {
        parameters.push(Parameter::word(name, if terms.gain > 0.0 { reverse } else { direct }, ""));
    }
    parameters.extend(vendor.fixed.iter().map(|fixed| Parameter::word(fixed.name, fixed.word, fixed.note)));
    Ok(parameters)
}

/// The block's own terms, and what is typed for its filter.
fn with_filter(vendor: &Vendor, terms: &Terms) -> Result<(Terms, Option<Parameter>), Refusal> {
    if terms.td.is_none() {
        return Ok((*terms, None));
    }
    let exact = |time: Option<f64>, default: f64| time.map_or(Lag::Ratio(default), Lag::Time);
    let lag = match vendor.filter {
        Filter::Absent => Lag::Time(0.0),
        Filter::Fixed(ratio) => Lag::Ratio(ratio),
        Filter::Switch { ratio, .. } => terms.tf.map_or(Lag::Time(0.0), |_| Lag::Ratio(ratio)),
        Filter::Ratio(_, default) => exact(terms.tf, default),
        Filter::Divisor(_, default) => exact(terms.tf, 1.0 / default),
        Filter::Time(_, unit, default) => Lag::Time(terms.tf.unwrap_or(default * unit)),
    };
    let block = block(vendor, terms, lag)?;
    let (td, tf) = (block.td.unwrap_or(0.0), block.tf.unwrap_or(0.0));
    let (key, value) = match vendor.filter {
        Filter::Absent | Filter::Fixed(_) => return Ok((block, None)),
        Filter::Switch { name, on, off, .. } => {
            return Ok((block, Some(Parameter::word(name, if tf > 0.0 { on } else { off }, ""))));
        }
        Filter::Ratio(key, _) => (key, tf / td),
        Filter::Divisor(key, _) => (key, td / tf),
        Filter::Time(key, unit, _) => (key, tf / unit),
    };
    let (low, high) = key.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
    if value >= low && value <= high {
        return Ok((block, Some(Parameter::number(&key, value))));
    }
    // The nearest filter that the block has, and the times that keep gain, Ti and Td with it.
    let nearest = value.max(low).min(high);
    let lag = match vendor.filter {
        Filter::Time(_, unit, _) => Lag::Time(nearest * unit),
        Filter::Divisor(..) => Lag::Ratio(1.0 / nearest),
        _ => Lag::Ratio(nearest),
    };
    Ok((self::block(vendor, terms, lag)?, Some(Parameter::number(&key, nearest))))
}

/// The block's own terms with this filter.
fn block(vendor: &Vendor, terms: &Terms, lag: Lag) -> Result<Terms, Refusal> {
    if vendor.interacting {
        return interacting::block(terms, lag).ok_or_else(|| {
            Refusal::because(
                "the block is interacting, which needs an integral time of at least 4 derivative times \
                 (with its filter a little more): this design has complex zeros",
            )
        });
    }
    let tf = match lag {
        Lag::Time(tf) => tf,
        Lag::Ratio(ratio) => ratio * terms.td.unwrap_or(0.0),
    };
    Ok(Terms { tf: (tf > 0.0).then_some(tf), ..*terms })
}

/// Spans and sample period: parameters where the block has them, a warning where the design does not say.
fn surroundings(
    vendor: &Vendor,
    scaling: &Scaling,
    parameters: &mut Vec<Parameter>,
    warnings: &mut Vec<String>,
) {
    let ends = [
        (vendor.spans.and_then(|spans| spans.pv), scaling.pv, "PV unit"),
        (vendor.spans.and_then(|spans| spans.op), scaling.op, "output unit"),
    ];
    for (names, span, unit) in ends {
        if let Some((low, high)) = names {
            parameters.push(Parameter::number(&Number::new(low, unit), span.low()));
            parameters.push(Parameter::number(&Number::new(high, unit), span.high()));
        }
    }
    if vendor.output == Scale::Engineering && vendor.input == Scale::Engineering && vendor.spans.is_none() {
        warnings.push("The gain is in the units of the plant: the block must see the measurement and give the output in them.".to_owned());
    }
    if let (Some((number, unit)), Some(period)) = (vendor.sample_period, scaling.sample_period) {
        parameters.push(Parameter::number(&number, period / unit));
    }
}

/// A warning for every number outside the range of its parameter.
fn out_of_range(vendor: &Vendor, parameters: &[Parameter]) -> Vec<String> {
    let (super::vendor::Gain::Gain(gain) | super::vendor::Gain::Band(gain)) = vendor.gain;
    let numbers = [gain, vendor.integral.number, vendor.derivative.number];
    let off = |number: &Number, value: f64| {
        (number.name == vendor.integral.number.name && vendor.integral.off == Off::Value(value))
            || (number.name == vendor.derivative.number.name && value == 0.0)
    };
    let outside = |number: &Number| {
        let (low, high) = number.range?;
        let typed = parameters.iter().find(|parameter| parameter.name == number.name)?;
        let Value::Number(value) = typed.value else { return None };
        let sentence = format!("{} is {value}: the block takes {low} to {high}.", number.name);
        (!(low..=high).contains(&value) && !off(number, decoded(number, value))).then_some(sentence)
    };
    numbers.iter().filter_map(outside).collect()
}

/// What of the design the block does not run, in sentences.
fn differences(design: &Controller, run: &Controller) -> Vec<String> {
    let mut cannot = Vec::new();
    if let Some(observer) = design.observer() {
        cannot.push(format!("It has no disturbance observer: Ko = {} is left out.", observer.gain()));
    }
    if design.output_filter().is_some() {
        cannot.push("It has no filter of the whole output: a1 and a2 are left out.".to_owned());
    }
    let time = |controller: &Controller| controller.derivative_filter().map(DerivativeFilter::time);
    match (design.derivative_time().and(time(design)), time(run)) {
        (None, Some(tf)) => cannot.push(format!("It has no unfiltered derivative: Tf is {tf} s.")),
        (Some(tf), None) => cannot.push(format!(
            "It has no filter of the derivative, which is a difference over one sample: Tf = {tf} s is left out."
        )),
        (Some(wanted), Some(tf)) if differs(wanted, tf) => {
            cannot.push(format!("It cannot have the filter Tf = {wanted} s: Tf is {tf} s."));
        }
        _ => {}
    }
    let mut weight = |name: &str, of: &str, wanted: f64, is: f64| {
        if differs(1.0 + wanted, 1.0 + is) {
            cannot.push(format!(
                "It cannot have the setpoint weight {name} = {wanted} of the {of} action: {name} is {is}."
            ));
        }
    };
    weight("b", "proportional", design.setpoint_weight(), run.setpoint_weight());
    if design.derivative_time().is_some() {
        let is = run.derivative_setpoint_weight();
        weight("c", "derivative", design.derivative_setpoint_weight(), is);
    }
    let settings = |controller: &Controller| {
        let gain = Some(controller.proportional_gain());
        [gain, controller.integral_time(), controller.derivative_time()]
    };
    for ((name, unit), (wanted, is)) in [("Kc", ""), ("Ti", " s"), ("Td", " s")]
        .into_iter()
        .zip(settings(design).into_iter().zip(settings(run)))
    {
        match (wanted, is) {
            (Some(wanted), Some(is)) if differs(wanted, is) => {
                cannot.push(format!(
                    "It takes whole steps only: {name} is {is}{unit} instead of {wanted}{unit}."
                ));
            }
            (Some(wanted), None) => {
                cannot
                    .push(format!("It takes whole steps only: {name} = {wanted}{unit} is rounded to none."));
            }
            _ => {}
        }
    }
    cannot
}

/// Whether two settings differ by more than a conversion's rounding.
fn differs(left: f64, right: f64) -> bool {
    (left - right).abs() > 1e-9 * left.abs().max(right.abs())
}
