//! `holdup export`: the controller as source code that runs in the plant.

use holdup::deploy::export::{Export, ExportError, Float, Installation, LANGUAGES, Language};
use holdup::model::quantity::{read_number, read_rate, read_time};
use holdup::model::text::nearest;
use holdup::model::{NoSampledLaw, Seconds};
use holdup_control::SettingError;
use serde_json::json;

use super::view::controller_line;
use crate::args::ExportArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::closed_loop;

/// Exports the controller.
pub(crate) fn run(args: &ExportArgs, console: Console) -> Result<Answer, Fault> {
    let language = language(&args.language)?;
    let (process, controller) = closed_loop(&args.of)?;
    let installation = installation(args)?;
    let export =
        Export::new(&args.name, &process, &controller, &installation).map_err(|error| refused(&error))?;
    let source = language.write(&export);
    let json = json!({
        "language": language.id,
        "name": args.name,
        "float": args.float,
        "sample_period_s": installation.sample_period.0,
        "segments": export.segments(),
        "segments_needed": export.segments_needed(),
        "margins": export.margins(),
        "source": source,
        "warnings": export.warnings(),
    });
    let warnings = export.warnings();
    let Some(path) = &args.output else {
        let text = if console.json { String::new() } else { source };
        return Ok(Answer { json, text, warnings, ..Answer::default() });
    };
    let text = format!("{}: {} as {}\n", path.display(), controller_line(&controller), language.title);
    Ok(Answer { json, text, warnings, files: vec![(path.clone(), source.into_bytes())] })
}

fn language(id: &str) -> Result<&'static Language, Fault> {
    holdup::deploy::export::language(id).ok_or_else(|| {
        let known = LANGUAGES.map(|language| language.id);
        let near = nearest(id, known).map(|near| format!(": did you mean '{near}'?"));
        let allowed = known.join(", ");
        Fault::option("--language", format!("'{id}'{} must be one of {allowed}", near.unwrap_or_default()))
    })
}

/// The options that say what surrounds the controller.
fn installation(args: &ExportArgs) -> Result<Installation, Fault> {
    let time = |option: &str, text: &Option<String>| match text {
        Some(text) => read_time(option, text).map(|time| Some(Seconds(time))).map_err(Fault::input),
        None => Ok(None),
    };
    let sample_period = read_time("--sample-period", &args.sample_period).map_err(Fault::input)?;
    let float = match args.float.as_str() {
        "f32" => Float::Single,
        "f64" => Float::Double,
        other => return Err(Fault::option("--float", format!("'{other}': must be f32 or f64"))),
    };
    let number = |option: &str, text: &Option<String>| {
        text.as_ref().map(|text| read_number(option, text)).transpose().map_err(Fault::input)
    };
    let (output_low, output_high) = range("--limits", args.limits.as_ref())?;
    let (range_low, range_high) = range("--measurement-range", args.measurement_range.as_ref())?;
    if range_low.is_some() != range_high.is_some() {
        let text = args.measurement_range.as_deref().unwrap_or_default();
        return Err(Fault::option("--measurement-range", format!("'{text}': must have both ends, low:high")));
    }
    let failure_time = time("--failure-time", &args.failure_time)?;
    let safe_output = number("--safe-output", &args.safe_output)?;
    let failure = match (failure_time, safe_output) {
        (Some(time), Some(output)) => Some((time, output)),
        (None, None) => None,
        (Some(_), None) => return Err(Fault::option("--failure-time", "needs --safe-output beside it")),
        (None, Some(_)) => return Err(Fault::option("--safe-output", "needs --failure-time beside it")),
    };
    let rate_limit = args.rate_limit.as_ref().map(|text| read_rate("--rate-limit", text));
    let segments = args.segments.as_ref().map(|text| {
        let allowed = "must be a whole number of segments";
        text.parse().map_err(|_| Fault::option("--segments", format!("'{text}': {allowed}")))
    });
    Ok(Installation {
        float,
        output_low,
        output_high,
        rate_limit: rate_limit.transpose().map_err(Fault::input)?,
        tracking_time: time("--tracking-time", &args.tracking_time)?,
        bias: number("--bias", &args.bias)?.unwrap_or(0.0),
        bleed_time: time("--bleed-time", &args.bleed_time)?,
        measurement_range: range_low.zip(range_high),
        stale_time: time("--stale-time", &args.stale_time)?,
        failure,
        segments: segments.transpose()?,
        ..Installation::sampled(Seconds(sample_period))
    })
}

/// `low:high`, either of which may be left out.
fn range(option: &str, text: Option<&String>) -> Result<(Option<f64>, Option<f64>), Fault> {
    let Some(text) = text else { return Ok((None, None)) };
    let refused = || Fault::option(option, format!("'{text}': must be low:high such as 0:100"));
    let (low, high) = text.split_once(':').ok_or_else(refused)?;
    let end = |text: &str| match text {
        "" => Ok(None),
        text => read_number(option, text).map(Some).map_err(|_| refused()),
    };
    if low.is_empty() && high.is_empty() {
        return Err(refused());
    }
    Ok((end(low)?, end(high)?))
}

/// Why there is no export, with the option that says so.
fn refused(error: &ExportError) -> Fault {
    match error {
        ExportError::OutOfRange { name, value, allowed } => {
            Fault::Input(format!("--{} is {value}: must be {allowed}", name.replace('_', "-")))
        }
        ExportError::NoLaw(NoSampledLaw::Setting(SettingError::OutOfRange {
            parameter,
            value,
            requirement,
        })) => Fault::Input(format!("{}{parameter} is {value}: {requirement}", option_of(parameter))),
        other => Fault::input(other),
    }
}

/// The option that a setting of `holdup_control` comes from.
fn option_of(parameter: &str) -> &'static str {
    match parameter {
        "output_low" | "output_high" => "--limits: ",
        "rate_limit" => "--rate-limit: ",
        "tracking_time" => "--tracking-time: ",
        "bias" => "--bias: ",
        "bleed_time" => "--bleed-time: ",
        "measurement_low" | "measurement_high" => "--measurement-range: ",
        "stale_time" => "--stale-time: ",
        "failure_time" => "--failure-time: ",
        "safe_output" => "--safe-output: ",
        "sample_period" => "--sample-period: ",
        _ => "",
    }
}
