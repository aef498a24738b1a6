//! What stands at the head of every exported source: what it controls, how it is set, what the loop achieves.

use super::{Export, Float};
use crate::model::notation::{write_controller, write_process};
use crate::model::{Radians, Seconds};

/// The header, one statement a line, without the marks of a comment.
pub(super) fn text(export: &Export) -> String {
    let Seconds(h) = export.installation.sample_period;
    let precision = match export.installation.float {
        Float::Single => "single precision (32 bits)",
        Float::Double => "double precision (64 bits)",
    };
    let mut lines = vec![
        format!(
            "{}: {}, exported by holdup {}",
            export.name,
            what(export.controller.structure()),
            env!("CARGO_PKG_VERSION")
        ),
        String::new(),
        format!("process        {}", write_process(&export.process)),
        format!("controller     {}", write_controller(&export.controller)),
        format!("sample period  {h} s, nominal: the law runs on the time measured"),
        format!("arithmetic     {precision}"),
    ];
    lines.extend(surroundings(export));
    lines.extend(delay_line(export));
    lines.push(String::new());
    lines.extend(achieved(export));
    lines.join("\n")
}

/// The structure in words.
fn what(structure: &str) -> String {
    match structure.strip_suffix("+DOB") {
        Some("SP") => "a modified Smith predictor".to_owned(),
        Some(law) => format!("a {law} controller with disturbance observer"),
        None => format!("a {structure} controller"),
    }
}

/// Limits and watch.
fn surroundings(export: &Export) -> Vec<String> {
    let (limits, watch) = (export.settings.limits(), export.settings.watch());
    let or = |value: Option<f64>, without: &str| value.map_or(without.to_owned(), |value| value.to_string());
    let mut lines = Vec::new();
    if limits.low().is_some() || limits.high().is_some() {
        lines.push(format!(
            "limits         {} to {} of the output",
            or(limits.low(), "no low limit"),
            or(limits.high(), "no high limit")
        ));
    } else {
        lines.push("limits         none: the actuator's should be set".to_owned());
    }
    lines.push(format!(
        "rate limit     {}",
        limits.rate().map_or("none".to_owned(), |rate| format!("{rate} per s"))
    ));
    if let Some((low, high)) = watch.range() {
        lines.push(format!("measurement    {low} to {high}: one outside it holds the output"));
    }
    if let Some(stale_time) = watch.stale_time() {
        lines.push(format!("stale          a measurement older than {stale_time} s holds the output"));
    }
    lines.push(match (watch.failure_time(), watch.safe_output()) {
        (Some(time), Some(output)) => {
            format!("safe output    {output}, after {time} s without a good measurement")
        }
        _ => "safe output    none: without a good measurement the output is held for ever".to_owned(),
    });
    lines
}

/// How long the delay line is, and how much of that is spare.
fn delay_line(export: &Export) -> Option<String> {
    let observer = export.settings.law().observer?;
    // A line of n segments holds n - 2 whole samples.
    let samples = f64::from(u32::try_from(export.segments).unwrap_or(u32::MAX)) - 2.0;
    let (dead_time, h) = (observer.dead_time(), observer.sample_period());
    let digits = |value: f64| (value * 1e4).floor() / 1e4;
    let (longest, shortest) = (digits(samples * h), digits(dead_time / samples) + 1e-4);
    Some(format!(
        "delay line     {} segments, {} needed for {dead_time} s at {h} s: enough for a dead time below {longest} s,\n\
         \u{20}              or for samples every {shortest:.4} s",
        export.segments, export.needed,
    ))
}

/// The margins of the loop that was designed.
fn achieved(export: &Export) -> Vec<String> {
    let margins = &export.margins;
    if !margins.stable {
        return vec!["WARNING: the loop is not stable. This controller must not be run.".to_owned()];
    }
    let or = |value: Option<f64>, unit: &str| {
        value.map_or_else(|| "infinite".to_owned(), |value| format!("{value:.4}{unit}"))
    };
    let Seconds(h) = export.installation.sample_period;
    vec![
        "The loop as designed, with this process, continuous and without limits:".to_owned(),
        format!(
            "  gain margin {}, phase margin {}, delay margin {}, sensitivity peak Ms {}",
            or(margins.gain_margin, ""),
            or(margins.phase_margin.map(Radians::degrees), " degrees"),
            or(margins.delay_margin.map(|Seconds(delay)| delay), " s"),
            or(margins.sensitivity_peak, ""),
        ),
        format!("Sampling holds the output, which acts like about {} s more dead time.", h / 2.0),
    ]
}
