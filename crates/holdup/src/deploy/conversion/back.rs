//! From the settings of a block to the controller that it runs.

use super::interacting::{self, Terms};
use super::numbers::{gain_scale, read_derivative, read_gain, read_integral};
use super::scaling::Scaling;
use super::settings::Given;
use super::vendor::{Action, Filter, Gain, Off, Vendor};
use super::weights;
use crate::model::text::{Problem, TextError};
use crate::model::{Controller, ModelError, Seconds};

/// The controller, in ideal form and the units of the plant, that a block runs with these settings.
///
/// What is not given has the block's default: no integral, no derivative action, the default filter and equation.
///
/// ```
/// use holdup::deploy::conversion::{Given, Scaling, Span, read, vendor};
/// let pide = vendor("rockwell-pide-dependent")?;
/// let scaling = Scaling::new(Span::new(0.0, 5.0)?, Span::new(0.0, 100.0)?);
/// let pi = read(pide, &Given::read(pide, &["PGain=2,IGain=5"])?, &scaling)?;
/// assert_eq!((pi.proportional_gain(), pi.integral_time()), (40.0, Some(300.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`TextError`] for a setting that is absent but needed, or out of its range.
pub fn read(vendor: &Vendor, given: &Given, scaling: &Scaling) -> Result<Controller, TextError> {
    let (Gain::Gain(key) | Gain::Band(key)) = vendor.gain;
    let typed = given.number(&key).ok_or_else(|| {
        TextError::at(key.name, Problem::Missing { allowed: "a number: without it there is no controller" })
    })?;
    let signed = vendor.action == Action::Sign;
    let allowed = if signed {
        "a finite number other than 0"
    } else {
        "a finite number greater than 0: its sign is set elsewhere"
    };
    if typed == 0.0 || (typed < 0.0 && !signed) {
        return Err(TextError::value(key.name, typed.to_string(), allowed));
    }
    let scaled = read_gain(&vendor.gain, typed);
    let direct = matches!(vendor.action, Action::Words { name, direct, .. } if given.is(name, direct));
    let unsigned = scaled / gain_scale(vendor, scaling);

    let integral = vendor.integral.number;
    let ti = match (given.number(&integral), vendor.integral.off) {
        (Some(typed), off) => read_integral(vendor.integral.kind, off, typed, scaled),
        (None, Off::Value(_)) => None,
        (None, Off::Never) => {
            let allowed = "a number: the block has no way without integral action";
            return Err(TextError::at(integral.name, Problem::Missing { allowed }));
        }
    };
    let derivative = vendor.derivative.number;
    let td = given.number(&derivative).filter(|typed| *typed != 0.0);
    let td = td.map(|typed| read_derivative(vendor.derivative.kind, typed, scaled));
    let tf = td.and_then(|td| filter_time(vendor, given, td)).filter(|tf| *tf != 0.0);

    let block = Terms { gain: if direct { -unsigned } else { unsigned }, ti, td, tf };
    let mut factor = 1.0;
    let mut terms = block;
    if vendor.interacting {
        checked(vendor, &block)?;
        factor = interacting::factor(&block);
        terms = interacting::ideal(&block).ok_or_else(|| {
            let reason = "the filter outweighs the lead: the derivative time would be negative";
            TextError::at(derivative.name, Problem::Conflict { reason: reason.into() })
        })?;
    }
    let (b, c) = weights::ideal(weights::read(&vendor.weights, given), factor);
    let c = if terms.td.is_some() { c } else { 1.0 };
    let controller = checked(vendor, &terms)?;
    controller.with_setpoint_weights(b, c).map_err(|error| named(vendor, &error))
}

/// The filter time [s] of a block whose derivative time is `td` [s].
fn filter_time(vendor: &Vendor, given: &Given, td: f64) -> Option<f64> {
    match vendor.filter {
        Filter::Absent => None,
        Filter::Fixed(ratio) => Some(ratio * td),
        Filter::Switch { name, on, ratio, .. } => given.is(name, on).then_some(ratio * td),
        Filter::Ratio(key, default) => Some(given.number(&key).unwrap_or(default) * td),
        Filter::Divisor(key, default) => Some(td / given.number(&key).unwrap_or(default)),
        Filter::Time(key, unit, default) => Some(given.number(&key).unwrap_or(default) * unit),
    }
}

/// The controller of these terms, its faults named as the block names its parameters.
fn checked(vendor: &Vendor, terms: &Terms) -> Result<Controller, TextError> {
    let build = || -> Result<Controller, ModelError> {
        let mut controller = Controller::proportional(terms.gain)?;
        if let Some(ti) = terms.ti {
            controller = controller.with_integral_time(Seconds(ti))?;
        }
        if let Some(td) = terms.td {
            controller = controller.with_derivative_time(Seconds(td))?;
        }
        terms.tf.map_or(Ok(controller), |tf| controller.with_filter_time(Seconds(tf)))
    };
    build().map_err(|error| named(vendor, &error))
}

fn named(vendor: &Vendor, error: &ModelError) -> TextError {
    let (Gain::Gain(gain) | Gain::Band(gain)) = vendor.gain;
    let filter = match vendor.filter {
        Filter::Ratio(key, _) | Filter::Divisor(key, _) | Filter::Time(key, _, _) => key.name,
        Filter::Absent | Filter::Fixed(_) | Filter::Switch { .. } => vendor.derivative.number.name,
    };
    TextError::from_model(error, |name| match name {
        "proportional_gain" => gain.name,
        "integral_time" => vendor.integral.number.name,
        "derivative_time" => vendor.derivative.number.name,
        "filter_time" => filter,
        other => other,
    })
}
