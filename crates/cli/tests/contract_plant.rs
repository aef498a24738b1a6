//! What is typed into the plant or runs there: conversions, the actuator, exports.

mod common;

use common::{MARGINS, PROCESS, folder, has, json, run};
use serde_json::Value;

const PID: &str = "Kc=2.95,Ti=15,Td=3,N=100";

#[test]
fn convert_gives_what_is_typed_what_cannot_be_and_the_margins_of_what_runs() {
    let spans = ["--pv-span", "0:5", "--op-span", "0:100"];
    let words = ["convert", "-p", PROCESS, "-c", PID, "--to", "honeywell-experion"];
    let result = json(&[&words[..], &spans].concat());
    has(&result, &["vendor", "equation", "source", "parameters", "cannot", "warnings", "run", "margins"]);
    has(&result["parameters"][0], &["name", "value", "unit", "note"]);
    // 2.95 %/unit on spans of 5 and 100: 2.95·5/100 percent per percent.
    assert!((result["parameters"][0]["value"].as_f64().unwrap() - 0.1475).abs() < 1e-15);
    // The block's filter is a sixteenth of Td, not 0.01 s: the margins are those of that controller.
    let run = json(&["analyse", "-p", PROCESS, "-c", "Kc=2.95,Ti=15,Td=3,Tf=0.1875"]);
    let margin = |value: &Value| value["sensitivity_peak"].as_f64().unwrap();
    assert!((margin(&result["margins"]["run"]) / margin(&run["margins"]) - 1.0).abs() < 1e-9);
    assert!(result["cannot"][0].as_str().unwrap().contains("0.1875 s"));
    let all = json(&[&["convert", "-c", PID, "--to", "all"][..], &spans].concat());
    let listed = json(&["convert"]);
    assert_eq!(all.as_array().unwrap().len(), listed.as_array().unwrap().len());
    assert!(all.as_array().unwrap().iter().all(|entry| entry["refused"].is_null()));
}

#[test]
fn settings_read_out_of_a_block_are_a_controller_and_convert_on() {
    let spans = ["--pv-span", "0:5", "--op-span", "0:100"];
    let from = ["convert", "--from", "rockwell-pide-dependent", "PGain=2,IGain=5"];
    let result = json(&[&from[..], &spans].concat());
    assert_eq!(result["notation"], "Kc=40,Ti=300");
    let onward = json(&[&from[..], &["--to", "yokogawa-centum"], &spans].concat());
    assert_eq!(
        (&onward["parameters"][0]["value"], &onward["parameters"][1]["value"]),
        (&50.0.into(), &300.0.into())
    );
}

#[test]
fn a_sheet_fits_the_terminal() {
    for words in [&["convert"][..], &["convert", "-p", PROCESS, "-c", PID, "--to", "all"]] {
        let output = String::from_utf8(run(words).stdout).unwrap();
        assert!(output.lines().all(|line| line.chars().count() <= 80), "{output}");
    }
    let listed = json(&["convert"]);
    for entry in listed.as_array().unwrap() {
        let vendor = entry["vendor"].as_str().unwrap();
        let output = run(&["convert", "-p", PROCESS, "-c", "Kc=2.95,Ti=15,Td=3,N=100,Ko=1", "--to", vendor]);
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    }
}

#[test]
fn analyse_with_limits_says_what_the_actuator_allows() {
    let words = [
        "analyse",
        "-p",
        PROCESS,
        "-c",
        PID,
        "--limits",
        "0:100",
        "--initial-manipulated",
        "40",
        "--load-step",
        "20",
    ];
    let result = json(&words);
    let actuator = &result["actuator"];
    has(actuator, &["limits", "output_at_rest", "loads_held", "setpoint", "load"]);
    let asked = ["step", "kick", "least", "greatest", "in_reach", "steps_in_reach", "best"];
    has(&actuator["setpoint"], &asked);
    has(&actuator["load"]["best"], &["peak", "iae", "ise", "itae", "at_rest_s"]);
    assert_eq!(actuator["loads_held"], serde_json::json!([-60.0, 40.0]));
    // The paper's PID asks for Kc·(1 + Td·N) = 887.95 a unit of the setpoint.
    assert!((actuator["setpoint"]["kick"].as_f64().unwrap() - 927.95).abs() < 1e-9);
    assert_eq!(actuator["setpoint"]["in_reach"], false);
    // As much left beyond the load as the load: the way back is as steep as the way up, K·l·d = 6.072.
    let best = |name: &str| actuator["load"]["best"][name].as_f64().unwrap();
    assert!((best("peak") - 6.072).abs() < 1e-12 && (best("iae") - 6.072 * 6.0).abs() < 1e-11);
    assert!((best("at_rest_s") - 18.0).abs() < 1e-12);
    assert!(
        result["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .any(|w| w.as_str().unwrap().contains("out of the actuator's reach"))
    );
    // A bare name means the loop, not the actuator.
    let lag = json(&[
        "analyse",
        "-p",
        "K=0.0506,d=6,T=3",
        "-c",
        "Kc=1,Ti=60",
        "--limits",
        "0:100",
        "--require",
        "stable>=1",
    ]);
    assert!(lag["actuator"]["load"]["best"]["iae"].is_null());
    assert!(
        lag["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .any(|w| w.as_str().unwrap().contains("plain integrator only"))
    );
}

#[test]
fn export_writes_one_source_to_standard_output_or_to_a_file() {
    let file = folder("export").join("level.st");
    let words =
        ["export", "-p", PROCESS, "-c", "Kc=1.5321,Td=1.0343,N=10,Ko=1.5321", "--sample-period", "500ms"];
    let more = ["--language", "st", "--limits", "0:", "--name", "level"];
    let all = [&words[..], &more].concat();
    let result = json(&all);
    has(
        &result,
        &[
            "language",
            "name",
            "float",
            "sample_period_s",
            "segments",
            "segments_needed",
            "source",
            "warnings",
        ],
    );
    has(&result["margins"], &MARGINS);
    assert_eq!((result["segments_needed"].as_u64(), result["segments"].as_u64()), (Some(15), Some(19)));
    let source = result["source"].as_str().unwrap();
    let output = run(&all);
    assert_eq!(String::from_utf8(output.stdout).unwrap(), source);
    let output = run(&[&all[..], &["--output", file.to_str().unwrap()]].concat());
    assert_eq!(output.status.code(), Some(0));
    assert!(!String::from_utf8(output.stdout).unwrap().contains("FUNCTION"));
    assert_eq!(std::fs::read_to_string(file).unwrap(), source);
}

#[test]
fn the_export_of_an_unstable_loop_says_so() {
    let result = json(&["export", "-p", PROCESS, "-c", "Kc=9", "--sample-period", "1", "--language", "c"]);
    assert!(result["warnings"].to_string().contains("must not be run"), "{}", result["warnings"]);
    assert!(result["source"].as_str().unwrap().contains("WARNING: the loop is not stable"));
}
