//! What is asked for: objective, limits, filter.

use holdup::analysis::frequency::family::Family;
use holdup::analysis::noise::{Noise, WIDEST};
use holdup::model::Process;
use holdup::model::quantity::{read_angle, read_number, read_rate, read_time};
use holdup::tuning::optimise::{Filter, Limits, Objective, Quantity, Structure};

use super::OptimiseArgs;
use crate::fault::Fault;

/// The objectives by name.
const OBJECTIVES: &str = "load_iae, setpoint_iae, weighted_iae, load_ise, setpoint_ise, control_energy, total_variation, robust_box, averaging";

/// Refuses an option that has no part in `what`, which looks at those `used`: nothing that is asked for is left out in silence.
pub(super) fn only(args: &OptimiseArgs, what: &str, used: &[&str]) -> Result<(), Fault> {
    let given = [
        ("--process", args.process.is_some()),
        ("--structure", args.structure.is_some()),
        ("--filter", args.filter.is_some()),
        ("--max-sensitivity", args.max_sensitivity.is_some()),
        ("--max-complementary", args.max_complementary.is_some()),
        ("--min-gain-margin", args.min_gain_margin.is_some()),
        ("--min-phase-margin", args.min_phase_margin.is_some()),
        ("--min-delay-margin", args.min_delay_margin.is_some()),
        ("--max-noise-gain", args.max_noise_gain.is_some()),
        ("--max-variance-gain", args.max_variance_gain.is_some()),
        ("--noise-sample-time", args.noise_sample_time.is_some()),
        ("--noise-bandwidth", args.noise_bandwidth.is_some()),
        ("--max-load-iae", args.max_load_iae.is_some()),
        ("--max-setpoint-iae", args.max_setpoint_iae.is_some()),
        ("--max-settling-time", args.max_settling_time.is_some()),
        ("--load-step", args.load_step.is_some()),
        ("--excursion", args.excursion.is_some()),
        ("--trade-off", args.trade_off),
        ("--rules", args.rules.is_some()),
        ("--table", args.table),
        ("--plot", args.plot.is_some()),
    ];
    match given.iter().find(|(option, given)| *given && !used.contains(option)) {
        Some((option, _)) => Err(Fault::option(option, format!("has no part in {what}"))),
        None => Ok(()),
    }
}

/// The structure by name.
pub(super) fn structure(name: &str) -> Result<Structure, Fault> {
    Structure::named(name).ok_or_else(|| {
        let known: Vec<&str> = Structure::names().collect();
        Fault::option("--structure", format!("'{name}' must be one of {}", known.join(", ")))
    })
}

/// The filter of the derivative; `None` where nothing is said of it.
pub(super) fn filter(args: &OptimiseArgs, structure: Structure) -> Result<Option<Filter>, Fault> {
    let Some(text) = &args.filter else { return Ok(None) };
    if !structure.differentiates() {
        let message = format!("'{text}' must stand with a derivative, which {} has not", structure.name());
        return Err(Fault::option("--filter", message));
    }
    match text.as_str() {
        "free" => Ok(Some(Filter::Free)),
        "none" => Ok(Some(Filter::None)),
        ratio => match read_number("--filter", ratio) {
            Ok(ratio) if (1e-4..=10.0).contains(&ratio) => Ok(Some(Filter::Held(ratio))),
            _ => {
                let message =
                    format!("'{text}' must be free, none, or the ratio Tf/Td that is held, 0.0001 to 10");
                Err(Fault::option("--filter", message))
            }
        },
    }
}

/// The noise whose variance gain is limited.
fn noise(args: &OptimiseArgs, process: &Process) -> Result<Option<Noise>, Fault> {
    let options =
        [("--noise-sample-time", &args.noise_sample_time), ("--noise-bandwidth", &args.noise_bandwidth)];
    if args.max_variance_gain.is_none() {
        return match options.iter().find(|(_, given)| given.is_some()) {
            Some((option, _)) => Err(Fault::option(option, "must stand with --max-variance-gain")),
            None => Ok(None),
        };
    }
    let positive = |option: &str, text: &str, value: f64| {
        if value > 0.0 {
            Ok(value)
        } else {
            Err(Fault::option(option, format!("{text} must be greater than 0")))
        }
    };
    match (&args.noise_sample_time, &args.noise_bandwidth) {
        (Some(text), None) => {
            let value = read_time("--noise-sample-time", text).map_err(Fault::input)?;
            Ok(Some(Noise::Held { sample_time: positive("--noise-sample-time", text, value)? }))
        }
        (None, Some(text)) => {
            let value = read_rate("--noise-bandwidth", text).map_err(Fault::input)?;
            let bandwidth = positive("--noise-bandwidth", text, value)?;
            let most = WIDEST / process.dead_time();
            if bandwidth > most {
                let message = format!("{text} must be at most {most} rad/s, {WIDEST} over the dead time");
                return Err(Fault::option("--noise-bandwidth", message));
            }
            Ok(Some(Noise::Band { bandwidth }))
        }
        _ => Err(Fault::option(
            "--max-variance-gain",
            "must stand with one of --noise-sample-time and --noise-bandwidth, which say what the noise is",
        )),
    }
}

/// The limits.
pub(super) fn limits(args: &OptimiseArgs, process: &Process) -> Result<Limits, Fault> {
    let degrees = |option: &str, text: &str| match text.parse::<f64>() {
        Ok(_) => read_number(option, text).map(f64::to_radians),
        Err(_) => read_angle(option, text),
    };
    let mut limits = Limits::default();
    let options: [(&str, &Option<String>, Quantity, f64); 9] = [
        ("--max-sensitivity", &args.max_sensitivity, Quantity::SensitivityPeak, 1.0),
        ("--max-complementary", &args.max_complementary, Quantity::ComplementarySensitivityPeak, 1.0),
        ("--min-gain-margin", &args.min_gain_margin, Quantity::GainMargin, 1.0),
        ("--min-phase-margin", &args.min_phase_margin, Quantity::PhaseMargin, 0.0),
        ("--min-delay-margin", &args.min_delay_margin, Quantity::DelayMargin, 0.0),
        ("--max-noise-gain", &args.max_noise_gain, Quantity::NoiseGain, 0.0),
        ("--max-load-iae", &args.max_load_iae, Quantity::LoadIae, 0.0),
        ("--max-setpoint-iae", &args.max_setpoint_iae, Quantity::SetpointIae, 0.0),
        ("--max-settling-time", &args.max_settling_time, Quantity::SetpointSettlingTime, 0.0),
    ];
    let mut options = options.to_vec();
    if let Some(noise) = noise(args, process)? {
        options.push(("--max-variance-gain", &args.max_variance_gain, Quantity::VarianceGain(noise), 0.0));
    }
    for (option, given, quantity, above) in options {
        let Some(text) = given else { continue };
        let value = match quantity {
            Quantity::PhaseMargin => degrees(option, text),
            Quantity::DelayMargin | Quantity::SetpointSettlingTime => read_time(option, text),
            _ => read_number(option, text),
        };
        let value = value.map_err(Fault::input)?;
        if value <= above {
            return Err(Fault::option(option, format!("{text} must be greater than {above}")));
        }
        limits = limits.with(quantity, value);
    }
    Ok(limits)
}

/// What is to be least.
pub(super) fn objective(args: &OptimiseArgs, limits: &Limits) -> Result<Objective, Fault> {
    Ok(match args.objective.replace('-', "_").as_str() {
        "load_iae" => Objective::LoadIae,
        "setpoint_iae" => Objective::SetpointIae,
        "load_ise" => Objective::LoadIse,
        "setpoint_ise" => Objective::SetpointIse,
        "control_energy" => Objective::ControlEnergy,
        "total_variation" => Objective::TotalVariation,
        "weighted_iae" => {
            let load = read_number("--load-weight", &args.load_weight).map_err(Fault::input)?;
            if !(0.0..=1.0).contains(&load) {
                let message = format!("{} must be from 0 to 1", args.load_weight);
                return Err(Fault::option("--load-weight", message));
            }
            Objective::Weighted { load }
        }
        "robust_box" => {
            let wrong = || {
                let message =
                    format!("'{}' must be two half widths such as 0.2:0.2, each 0 to 1", args.robust_box);
                Fault::option("--robust-box", message)
            };
            let (gain, dead_time) = args.robust_box.split_once(':').ok_or_else(wrong)?;
            let half = |text: &str| read_number("--robust-box", text).map_err(Fault::input);
            let (gain, dead_time) = (half(gain)?, half(dead_time)?);
            let family = Family::ranges([1.0 - gain, 1.0 + gain], [1.0 - dead_time, 1.0 + dead_time]);
            let family = family.map_err(|_| wrong())?;
            let sensitivity_peak = limits.of(Quantity::SensitivityPeak).ok_or_else(|| {
                Fault::option("--objective", "robust_box needs --max-sensitivity, which the box is to keep")
            })?;
            Objective::RobustBox { family, sensitivity_peak }
        }
        _ => {
            let message = format!("'{}' must be one of {OBJECTIVES}", args.objective);
            return Err(Fault::option("--objective", message));
        }
    })
}
