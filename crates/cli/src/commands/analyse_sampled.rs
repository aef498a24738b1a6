//! `holdup analyse --sample-period` and `--largest-sample-period`: the loop as it is sampled.

use std::fmt::Write as _;

use holdup::analysis::frequency::Margins;
use holdup::analysis::frequency::sampled::{
    LargestPeriod, SampledMargins, largest_sample_period, sampled_margins,
};
use holdup::model::quantity::{read_number, read_time};
use holdup::model::text::{nearest, one_line};
use holdup::model::{Controller, Process, Radians, Seconds, sampled_law};
use serde_json::{Value, json};

use crate::args::AnalyseArgs;
use crate::fault::Fault;
use crate::table::number;

/// What was asked about the sampled loop.
pub(super) struct Sampled {
    margins: Option<SampledMargins>,
    largest: Option<(String, LargestPeriod)>,
}

impl Sampled {
    pub(super) fn of(args: &AnalyseArgs, process: &Process, controller: &Controller) -> Result<Self, Fault> {
        let time = |option: &str, given: &Option<String>| {
            let Some(text) = given else { return Ok(None) };
            let value = read_time(option, text).map_err(Fault::input)?;
            let allowed = |ok: bool, what: &str| {
                if ok {
                    Ok(Some(value))
                } else {
                    Err(Fault::input(format!("{option} is {text}: must be {what}")))
                }
            };
            match option {
                "--sample-period" => allowed(value > 0.0, "a time greater than 0"),
                _ => allowed(value >= 0.0, "a time, 0 or greater"),
            }
        };
        let period = time("--sample-period", &args.sample_period)?;
        let delay = time("--computation-delay", &args.computation_delay)?;
        if let Some(delay) = delay {
            match period {
                None if args.largest_sample_period.is_none() => {
                    return Err(Fault::option("--computation-delay", "needs --sample-period"));
                }
                Some(period) if delay > period => {
                    return Err(Fault::input(format!(
                        "--computation-delay is {delay}: must be at most the sample period of {period} s"
                    )));
                }
                _ => {}
            }
        }
        let delay = Seconds(delay.unwrap_or(0.0));
        let margins = period.map(|h| {
            let fault = |error: &dyn std::fmt::Display| Fault::option("--sample-period", error);
            let law = sampled_law(process, controller, Seconds(h)).map_err(|error| fault(&error))?;
            sampled_margins(&law, process, Seconds(h), delay).map_err(|error| fault(&error))
        });
        let largest = args.largest_sample_period.as_ref().map(|text| {
            let demand = Demand::read(text)?;
            let found = largest_sample_period(process, controller, delay, |margins| demand.slack(margins));
            let found = found.map_err(|error| Fault::option("--largest-sample-period", error))?;
            Ok((text.trim().to_owned(), found))
        });
        Ok(Self { margins: margins.transpose()?, largest: largest.transpose()? })
    }

    pub(super) fn warnings(&self) -> Vec<String> {
        self.margins.iter().flat_map(|sampled| sampled.margins.warnings.iter().cloned()).collect()
    }

    pub(super) fn column(&self) -> Option<(&'static str, &Margins)> {
        self.margins.as_ref().map(|sampled| ("sampled", &sampled.margins))
    }

    /// Puts what was asked for into the JSON of the command.
    pub(super) fn add_to(&self, json: &mut Value) {
        if let Some(sampled) = &self.margins {
            let mut object = serde_json::to_value(&sampled.margins).unwrap_or_default();
            object["sample_period_s"] = json!(sampled.sample_period.0);
            object["noise_gain"] = json!(sampled.noise_gain);
            json["sampled"] = object;
        }
        if let Some((condition, largest)) = &self.largest {
            let (period, limit) = match largest {
                LargestPeriod::None => (None, "the continuous loop does not meet it"),
                LargestPeriod::UpTo(h) => (Some(h.0), "the condition"),
                LargestPeriod::DeadTime(h) => (Some(h.0), "the dead time"),
            };
            json["largest_sample_period"] =
                json!({ "condition": condition, "sample_period_s": period, "limited_by": limit });
        }
    }

    /// The lines under the table.
    pub(super) fn lines(&self) -> String {
        let mut text = String::new();
        if let Some(sampled) = &self.margins {
            let h = sampled.sample_period.0;
            let _ = writeln!(
                text,
                " sampled every {} s: noise gain {} at π/h = {} rad/s",
                number(h),
                number(sampled.noise_gain),
                number(std::f64::consts::PI / h)
            );
        }
        if let Some((condition, largest)) = &self.largest {
            let _ = match largest {
                LargestPeriod::None => {
                    writeln!(text, " {condition} does not hold for the continuous loop: for no sample period")
                }
                LargestPeriod::UpTo(h) => {
                    writeln!(text, " {condition} holds for every sample period up to {} s", number(h.0))
                }
                LargestPeriod::DeadTime(h) => writeln!(
                    text,
                    " {condition} holds for every sample period up to the dead time of {} s",
                    number(h.0)
                ),
            };
        }
        text
    }
}

/// A margin by name; one that is absent is infinite, or 0 where smaller is better.
type Margin = (&'static str, fn(&Margins) -> f64);

const MARGINS: [Margin; 6] = [
    ("gain_margin", |m| m.gain_margin.unwrap_or(f64::INFINITY)),
    ("gain_margin_low", |m| m.gain_margin_low.unwrap_or(0.0)),
    ("phase_margin_deg", |m| m.phase_margin.map_or(f64::INFINITY, Radians::degrees)),
    ("delay_margin_s", |m| m.delay_margin.map_or(f64::INFINITY, |time| time.0)),
    ("sensitivity_peak", |m| m.sensitivity_peak.unwrap_or(f64::INFINITY)),
    ("complementary_sensitivity_peak", |m| m.complementary_sensitivity_peak.unwrap_or(f64::INFINITY)),
];

/// What the margins of a stable loop must meet.
enum Demand {
    Stable,
    AtLeast(fn(&Margins) -> f64, f64),
    AtMost(fn(&Margins) -> f64, f64),
}

impl Demand {
    fn read(text: &str) -> Result<Self, Fault> {
        if text.trim() == "stable" {
            return Ok(Self::Stable);
        }
        let refused = |what: &str| {
            let given = one_line(text);
            let message = format!("'{given}' {what}: must be 'stable' or such as 'gain_margin>=2'");
            Fault::option("--largest-sample-period", message)
        };
        let (name, value, least) = match (text.split_once(">="), text.split_once("<=")) {
            (Some((name, value)), None) => (name.trim(), value.trim(), true),
            (None, Some((name, value))) => (name.trim(), value.trim(), false),
            _ => return Err(refused("has no comparison with >= or <=")),
        };
        let value = read_number("value", value).map_err(|_| refused("compares with no finite number"))?;
        let Some((_, of)) = MARGINS.iter().find(|(known, _)| *known == name) else {
            let names = MARGINS.map(|(known, _)| known);
            let near = nearest(name, names.iter().copied());
            let hint = near.map_or_else(|| names.join(", "), |near| format!("did you mean '{near}'?"));
            return Err(refused(&format!("names no margin ({hint})")));
        };
        Ok(if least { Self::AtLeast(*of, value) } else { Self::AtMost(*of, value) })
    }

    /// By how much it is met.
    fn slack(&self, margins: &Margins) -> f64 {
        match self {
            Self::Stable => 1.0,
            Self::AtLeast(of, least) => of(margins) - least,
            Self::AtMost(of, most) => most - of(margins),
        }
    }
}
