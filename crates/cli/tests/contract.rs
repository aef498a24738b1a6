//! The JSON of every command has the names of the contract, and the numbers of the paper's loop.

mod common;

use common::{MARGINS, PROCESS, folder, has, holdup, json, run};
use serde_json::Value;

const PID: &str = "Kc=2.95,Ti=15,Td=3,N=100";

const CONTROLLER: [&str; 12] = [
    "structure",
    "proportional_gain",
    "integral_time_s",
    "derivative_time_s",
    "derivative_filter_bandwidth",
    "filter_time_s",
    "observer_gain",
    "setpoint_weight",
    "derivative_setpoint_weight",
    "output_filter",
    "parameters",
    "published",
];

const METRICS: [&str; 10] = [
    "iae",
    "ise",
    "itae",
    "control_energy",
    "total_variation",
    "overshoot",
    "rise_time_s",
    "settling_time_s",
    "settling_time_5_s",
    "peak",
];

const BOUNDS: [&str; 4] = ["iae", "ise", "itae", "peak"];

#[test]
fn analyse_has_the_names_of_the_contract() {
    let result = json(&["analyse", "-p", PROCESS, "-c", PID]);
    has(&result, &["stable", "margins", "dominant_poles", "noise_gain", "warnings"]);
    has(&result["margins"], &MARGINS);
    has(&result["dominant_poles"][0], &["re", "im"]);
}

#[test]
fn analyse_of_a_loop_with_observer_gives_whole_and_parts() {
    let result = json(&["analyse", "-p", PROCESS, "-c", "Kc=1.5321,Td=1.0343,Ko=1.5321"]);
    // Independent program, 110-digit arithmetic (findings.md of the paper): 2.12446, 33.411, 2.17946, 4.494.
    let margin = |name: &str| result["margins"][name].as_f64().unwrap();
    assert!((margin("gain_margin") - 2.12446).abs() < 5e-6);
    assert!((margin("phase_margin_deg") - 33.411).abs() < 5e-4);
    assert!((margin("sensitivity_peak") - 2.17946).abs() < 5e-6);
    assert!((margin("delay_margin_s") - 4.494).abs() < 5e-4);
    assert!((result["loops"]["without_observer"]["gain_margin"].as_f64().unwrap() - 3.854).abs() < 5e-4);
    assert!(result["noise_gain"].is_null());
}

#[test]
fn simulate_has_the_names_of_the_contract() {
    let result = json(&["simulate", "-p", PROCESS, "-c", PID, "--horizon", "200"]);
    has(&result, &["metrics", "bounds", "final", "warnings"]);
    has(&result["metrics"], &METRICS);
    has(&result["bounds"], &BOUNDS);
    has(&result["final"], &["controlled_variable", "manipulated_variable"]);
    // Independent fixed-step integration, refined until converged (findings.md): 4497.58.
    assert!((result["metrics"]["control_energy"].as_f64().unwrap() - 4497.58).abs() < 0.005);
}

#[test]
fn a_sampled_simulation_has_the_same_names_and_its_own() {
    let equipment = [
        "--sample-period",
        "0.5",
        "--limits",
        "0:100",
        "--initial-manipulated",
        "40",
        "--rate-limit",
        "5",
        "--stiction",
        "0.2:0.1",
        "--output-quantum",
        "0.05",
        "--measurement-quantum",
        "0.01",
        "--noise",
        "0.01",
        "--seed",
        "7",
        "--jitter",
        "0.1",
        "--drop",
        "0.02",
        "--computation-delay",
        "0.1",
    ];
    let csv = folder("sampled").join("run.csv");
    let words = ["simulate", "-p", PROCESS, "-c", "Kc=1.5321,Td=1.0343,N=2,Ko=0.7", "--load", "20:1"];
    let words =
        [&words[..], &["--load-ramp", "50:80:-1", "--actual-process", "K=0.055,d=6.5"], &equipment].concat();
    let result = json(&[&words[..], &["--csv", csv.to_str().unwrap()]].concat());
    has(&result, &["metrics", "bounds", "final", "sampled", "continuous", "warnings"]);
    has(&result["metrics"], &METRICS);
    has(&result["metrics"], &["valve_travel"]);
    has(&result["bounds"], &BOUNDS);
    has(&result["final"], &["controlled_variable", "manipulated_variable", "valve_position"]);
    has(&result["sampled"], &["sample_period_s", "samples", "lost_samples", "limited_samples", "seed"]);
    assert!(result["metrics"]["valve_travel"].as_f64() < result["metrics"]["total_variation"].as_f64());
    // The load is taken away again: the valve comes back to its rest, to a stickband.
    assert!((result["final"]["valve_position"].as_f64().unwrap() - 40.0).abs() < 0.5);
    let text = std::fs::read_to_string(csv).unwrap();
    assert!(text.starts_with(
        "t,setpoint,controlled_variable,manipulated_variable,load,load_estimate,valve_position\n"
    ));
    assert_eq!(result, json(&words), "the seed decides");
}

#[test]
fn a_load_ramp_alone_moves_no_setpoint_and_is_within_the_horizon() {
    let words = ["simulate", "-p", PROCESS, "-c", "Kc=1.647,Ti=48", "--sample-period", "1"];
    let result = json(&[&words[..], &["--load-ramp", "50:150:2", "--initial", "3"]].concat());
    assert_eq!(result["horizon_s"], 150.0 + 50.0 * 6.0);
    assert!((result["final"]["controlled_variable"].as_f64().unwrap() - 3.0).abs() < 1e-3);
    assert!((result["final"]["manipulated_variable"].as_f64().unwrap() + 2.0).abs() < 1e-3);
    assert!(result["continuous"].is_null() && result["bounds"]["iae"].is_null());
}

#[test]
fn fast_samples_are_compared_with_the_continuous_loop() {
    let result = json(&["simulate", "-p", PROCESS, "-c", PID, "--sample-period", "0.01", "--load", "0:1"]);
    let (sampled, continuous) = (&result["metrics"], &result["continuous"]["metrics"]);
    for name in ["iae", "ise", "peak"] {
        let ratio = sampled[name].as_f64().unwrap() / continuous[name].as_f64().unwrap();
        // h/2 of dead time more, of 6 s, and a filter of h + 0.01 s.
        assert!((ratio - 1.0).abs() < 0.01, "{name} {ratio}");
    }
    assert!(result["percent_of_best"]["iae"].as_f64().unwrap() < 100.0);
}

#[test]
fn analyse_has_the_margins_of_the_sampled_loop_beside_those_of_the_continuous_one() {
    let words = ["analyse", "-p", PROCESS, "-c", "Kc=1.647,Ti=48", "--sample-period", "2"];
    let result = json(&[&words[..], &["--largest-sample-period", "gain_margin>=2.5"]].concat());
    has(&result["sampled"], &MARGINS);
    has(&result["sampled"], &["sample_period_s", "noise_gain"]);
    assert!(result["sampled"]["gain_margin"].as_f64() < result["margins"]["gain_margin"].as_f64());
    let largest = result["largest_sample_period"]["sample_period_s"].as_f64().unwrap();
    assert!(largest > 1.0 && largest < 2.0, "{largest}");
    let demand = |text: &str| run(&[&words[..], &["--require", text]].concat()).status.code();
    assert_eq!(demand("sampled.gain_margin>=2.5"), Some(1));
    // A bare name is that of the continuous loop, as without a sample period.
    assert_eq!(demand("gain_margin>=2.5"), Some(0));
}

#[test]
fn tune_shows_what_was_specified_beside_what_is_achieved() {
    let result =
        json(&["tune", "-p", PROCESS, "--rule", "pd-kadam", "--set", "phi_m=180deg", "--set", "Ts=40s"]);
    has(&result, &["rule", "controller", "specification", "achieved", "warnings"]);
    has(&result["controller"], &CONTROLLER);
    has(&result["achieved"], &MARGINS);
    assert_eq!(result["specification"]["gain_margin"], 2.0);
    assert!((result["achieved"]["gain_margin"].as_f64().unwrap() - 3.854).abs() < 5e-4);
}

#[test]
fn tune_without_a_rule_ranks_those_that_apply() {
    let result = json(&["tune", "-p", PROCESS]);
    let rules = result.as_array().unwrap();
    assert!(rules.len() >= 7);
    for rule in rules {
        has(rule, &["rule", "controller", "specification", "achieved", "warnings"]);
    }
}

#[test]
fn the_ranking_has_its_fields_and_its_filters() {
    let words =
        ["tune", "-p", PROCESS, "--structure", "pi", "--max-sensitivity", "1.7", "--sort", "load_iae"];
    let result = json(&words);
    let rules = result.as_array().unwrap();
    let mut before = 0.0;
    for rule in rules {
        has(rule, &["load_iae", "setpoint_iae", "percent_of_best", "noise_gain", "control_energy"]);
        has(rule, &["total_variation", "dominated", "dominated_by", "tail"]);
        assert_eq!(rule["controller"]["structure"], "PI");
        assert!(rule["achieved"]["sensitivity_peak"].as_f64().unwrap() <= 1.7);
        let iae = rule["load_iae"].as_f64().unwrap();
        assert!(iae >= before, "{rule}");
        assert!(rule["tail"]["load_iae"].as_f64().unwrap() < 1e-9);
        before = iae;
    }
    let all = json(&["tune", "-p", PROCESS, "--all"]);
    let all = all.as_array().unwrap();
    assert!(all.len() > rules.len());
    let unstable = all.iter().position(|rule| rule["achieved"]["stable"] == false).unwrap();
    assert!(
        all[unstable..].iter().all(|rule| rule["achieved"]["stable"] == false),
        "unstable rules come last"
    );
    assert!(all[unstable]["warnings"][0].as_str().unwrap().starts_with("unstable"));
    // A proportional controller leaves an error after a load.
    let p = all.iter().find(|rule| rule["rule"] == "p-haalman").unwrap();
    assert!(p["load_iae"].is_null() && p["setpoint_iae"].is_number());
}

#[test]
fn the_list_of_rules_is_filtered_and_the_page_of_one_has_its_figures() {
    let list = json(&["rules", "--structure", "pi", "--process", "integrating", "--status", "recommended"]);
    assert!(list.as_array().unwrap().len() > 10);
    for rule in list.as_array().unwrap() {
        assert_eq!((&rule["structure"], &rule["process"]), (&"PI".into(), &"integrating".into()));
        assert_eq!(rule["status"], "recommended");
    }
    assert!(!json(&["rules", "--process", "double-integrating"]).as_array().unwrap().is_empty());
    let simc = json(&["rules", "pi-simc"]);
    // Ti/Kc: the error keeps its sign.
    assert!((simc["figures"]["load_iae"].as_f64().unwrap() - 16.0).abs() < 1e-7);
    assert!(simc["published"].as_array().unwrap().iter().all(|value| value["reproduced"] == true));
}

#[test]
fn the_atlas_is_one_offline_page_with_a_section_for_each_rule() {
    let path = folder("atlas").join("atlas.html");
    let list = json(&["rules", "--structure", "pi", "--report", path.to_str().unwrap()]);
    let html = std::fs::read_to_string(&path).unwrap();
    assert!(html.contains("best possible PI") && html.contains("default-src 'none'"));
    for rule in list.as_array().unwrap() {
        assert!(html.contains(&format!("<h2>{}</h2>", rule["id"].as_str().unwrap())));
    }
}

#[test]
fn rules_has_the_names_of_the_contract() {
    for rule in json(&["rules"]).as_array().unwrap() {
        has(
            rule,
            &[
                "id",
                "name",
                "authors",
                "year",
                "citation",
                "structure",
                "process",
                "parameters",
                "reproduced",
            ],
        );
        for parameter in rule["parameters"].as_array().unwrap() {
            has(parameter, &["name", "default", "unit", "description"]);
        }
    }
    assert_eq!(json(&["rules", "pd_kadam"])["id"], "pd-kadam");
}

#[test]
fn compare_recomputes_the_paper() {
    let result = json(&["compare", "studies/kadam-2017.toml"]);
    has(&result, &["scenarios", "controllers"]);
    for scenario in result["scenarios"].as_array().unwrap() {
        for row in scenario["rows"].as_array().unwrap() {
            has(row, &["controller", "metrics", "bounds"]);
            has(&row["metrics"], &METRICS);
            has(&row["bounds"], &BOUNDS);
        }
    }
    for controller in result["controllers"].as_array().unwrap() {
        has(controller, &["name", "controller", "achieved"]);
        has(&controller["controller"], &CONTROLLER);
        has(&controller["achieved"], &MARGINS);
    }
    // findings.md: settling for Ts = 40/50/60/70 and for Am = 1/1.5/2/2.5, to the printed digit.
    for (family, printed) in [(0, [29.7, 39.0, 60.8, 81.4]), (1, [44.2, 29.2, 29.7, 44.8])] {
        for (member, printed) in result["families"][family]["members"].as_array().unwrap().iter().zip(printed)
        {
            let settling = member["run"]["metrics"]["settling_time_s"].as_f64().unwrap();
            assert!((settling - printed).abs() <= 0.051, "{settling} for {printed}");
        }
    }
}

#[test]
fn reproduce_judges_every_printed_cell() {
    let result = json(&["reproduce", "kadam-2017"]);
    let cells = result["cells"].as_array().unwrap();
    assert_eq!(cells.len(), 87);
    for cell in cells {
        has(cell, &["table", "row", "column", "printed", "computed", "convention", "verdict", "reason"]);
        assert!(cell["verdict"] == "reproduced" || cell["reason"].is_string(), "{cell}");
    }
    // findings.md, fact 3: three cells of the step table and two of the regulatory table.
    let impossible: Vec<_> =
        cells.iter().filter(|cell| cell["verdict"] == "impossible").map(|cell| &cell["printed"]).collect();
    assert_eq!(impossible, [0.2512, 1.022, 4.479, 0.03, 1.002]);
}

#[test]
fn a_loop_file_says_the_same_as_the_compact_strings() {
    let file = folder("loop").join("loop.toml");
    let text = "[process]\nprocess_gain = 0.0506\ndead_time_s = 6.0\n[controller]\nproportional_gain = 2.95\nintegral_time_s = 15.0\nderivative_time_s = 3.0\nderivative_filter_bandwidth = 100.0\n";
    std::fs::write(&file, text).unwrap();
    let path = file.to_str().unwrap();
    let compact = json(&["analyse", "-p", PROCESS, "-c", PID]);
    assert_eq!(json(&["analyse", path]), compact);
    assert_eq!(json(&["analyse", "--loop", path]), compact);
}

#[test]
fn require_decides_the_exit_status() {
    let words = |demand: &'static str| ["analyse", "-p", PROCESS, "-c", PID, "--json", "--require", demand];
    for (demand, code) in [("gain_margin>=1.8", 0), ("margins.gain_margin>=2", 1), ("gain_margin_low>0", 1)] {
        let output = run(&words(demand));
        assert_eq!(output.status.code(), Some(code), "{demand}");
        assert!(serde_json::from_slice::<Value>(&output.stdout).is_ok());
    }
}

#[test]
fn an_unstable_loop_is_an_answer() {
    let result = json(&["analyse", "-p", PROCESS, "-c", "Kc=20"]);
    assert_eq!(result["stable"], false);
    assert!(result["margins"]["gain_margin"].is_null());
    assert!(
        json(&["simulate", "-p", PROCESS, "-c", "Kc=20", "--horizon", "100000"])["overflow_at_s"].is_number()
    );
}

#[test]
fn infeasible_is_an_answer_that_names_what_is_feasible() {
    let result =
        json(&["tune", "-p", PROCESS, "--rule", "pd-exact", "--set", "Am=2", "--set", "phi_m=150deg"]);
    assert!(result["controller"].is_null() && result["achieved"].is_null());
    assert!(!result["warnings"].as_array().unwrap().is_empty());
}

#[test]
fn csv_has_the_columns_of_the_contract_and_ends_at_the_horizon() {
    let file = folder("csv").join("step.csv");
    let path = file.to_str().unwrap();
    let loop_ = ["simulate", "-p", PROCESS, "-c", "Kc=1.5321,Td=1.0343,N=100,Ko=1.5321", "--load", "0:1"];
    json(&[&loop_[..], &["--csv", path, "--horizon", "200", "--points", "401"]].concat());
    let text = std::fs::read_to_string(&file).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t,setpoint,controlled_variable,manipulated_variable,load,load_estimate"));
    assert_eq!(lines.clone().count(), 401);
    let last: Vec<f64> = lines.last().unwrap().split(',').map(|cell| cell.parse().unwrap()).collect();
    assert_eq!((last[0], last[4]), (200.0, 1.0));
    assert!((last[5] - 1.0).abs() < 1e-6, "the estimate reaches the load");
}

#[test]
fn plots_are_written_in_the_kind_their_name_asks_for() {
    let folder = folder("plot");
    for (name, begins) in [("a.svg", &b"<svg"[..]), ("a.png", b"\x89PNG"), ("a.html", b"<!")] {
        let path = folder.join(name);
        json(&["simulate", "-p", PROCESS, "-c", PID, "--plot", path.to_str().unwrap()]);
        let bytes = std::fs::read(&path).unwrap();
        assert!(bytes.starts_with(begins) || bytes.starts_with(b"<?xml"), "{name}");
    }
}

#[test]
fn every_command_has_help_with_an_example_and_completions_and_manual_exist() {
    for command in ["rules", "tune", "analyse", "simulate", "compare", "reproduce", "completions", "man"] {
        let output = run(&[command, "--help"]);
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(0));
        assert!(text.contains("Example") && text.contains(&format!("holdup {command}")), "{command}: {text}");
    }
    assert!(String::from_utf8(run(&["completions", "bash"]).stdout).unwrap().contains("complete"));
    assert!(String::from_utf8(run(&["man"]).stdout).unwrap().contains(".TH"));
}

#[test]
fn tables_stay_within_eighty_columns_and_without_colours() {
    for words in [
        &["tune", "-p", PROCESS][..],
        &["compare", "studies/kadam-2017.toml"],
        &["analyse", "-p", PROCESS, "-c", PID],
        &["rules", "pd-kadam"],
        &["rules", "--status", "wrong"],
        &["rules", "pid-zhang-hinf"],
        &["tune", "-p", "K=-3e-5,d=2min,T=30", "--all"],
    ] {
        let text = String::from_utf8(run(words).stdout).unwrap();
        assert!(!text.contains('\u{1b}'));
        for line in text.lines() {
            assert!(line.chars().count() <= 80, "{words:?}: {line}");
        }
    }
}

#[test]
fn the_stability_region_of_pi_has_its_limit_and_the_curves_asked_for() {
    let region = json(&["region", "-p", "K=1,d=1", "--plane", "kc-ti", "--sensitivity", "1.4,2"]);
    has(&region, &["plane", "x", "y", "boundary", "levels"]);
    assert_eq!(region["levels"].as_array().unwrap().len(), 2);
    let vertices = region["boundary"][0]["vertices"].as_array().unwrap();
    assert!(vertices.len() > 10);
    for vertex in vertices {
        // In closed form the limit of PI is Kc = ω sin ω, Ti = tan ω/ω; 1e-9 is rounding far from both ends.
        let (kc, omega) = (vertex["x"].as_f64().unwrap(), vertex["frequency_rad_s"].as_f64().unwrap());
        assert!((kc - omega * omega.sin()).abs() < 1e-9, "{vertex}");
    }
}

#[cfg(unix)]
#[test]
fn a_closed_pipe_ends_the_command_quietly() {
    use std::process::Stdio;
    let mut child = holdup(&["compare", "studies/kadam-2017.toml"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(!String::from_utf8_lossy(&output.stderr).contains("panic"));
}

#[test]
fn robust_proves_and_samples_with_the_names_of_the_contract() {
    let folder = folder("robust");
    let runs = folder.join("runs.csv");
    let path = runs.to_str().unwrap();
    let words = ["robust", "-p", PROCESS, "-c", "Kc=1.5,Ti=50", "--samples", "300", "--max-sensitivity", "3"];
    let value = json(&[&words[..], &["--load", "0:1", "--bands", "--output", path]].concat());
    has(&value, &["guaranteed", "monte_carlo", "largest_family", "warnings"]);
    has(&value["guaranteed"], &["stable", "sensitivity_peak", "worst"]);
    has(&value["monte_carlo"], &["samples", "stable_fraction", "percentiles", "bands"]);
    let peak = value["guaranteed"]["sensitivity_peak"].as_f64().unwrap();
    let sampled = value["monte_carlo"]["percentiles"]["sensitivity_peak"]["greatest"].as_f64().unwrap();
    assert!(sampled <= peak && peak < 2.2, "{sampled} {peak}");
    let text = std::fs::read_to_string(&runs).unwrap();
    assert_eq!(text.lines().count(), 301);
    let again = json(&[&words[..], &["--load", "0:1", "--bands"]].concat());
    assert_eq!(again["monte_carlo"], value["monte_carlo"]);
}

#[test]
fn optimise_answers_from_the_table_what_it_finds_by_search() {
    let words = ["optimise", "-p", PROCESS, "--max-sensitivity", "1.6"];
    let (searched, tabulated) = (json(&words), json(&[&words[..], &["--table"]].concat()));
    has(&tabulated, &["controller", "achieved", "objective", "constraint", "table", "warnings"]);
    has(&tabulated["table"], &["name", "normalised", "error"]);
    let value = |json: &serde_json::Value| json["objective"]["value"].as_f64().unwrap();
    let error = tabulated["table"]["error"]["value"].as_f64().unwrap();
    assert!((value(&tabulated) / value(&searched) - 1.0).abs() <= error);
    let tables = json(&["optimise", "--tables", "--structure", "pi"]);
    let first = &tables[0];
    has(first, &["structure", "objective", "unit", "range", "error", "rows"]);
    assert!(tables.as_array().unwrap().iter().all(|table| table["structure"] == "pi"));
}

#[test]
fn rules_of_ones_own_stand_on_the_frontier() {
    let folder = folder("own_rules");
    let (rules, plot) = (folder.join("rules.toml"), folder.join("frontier.svg"));
    let text = "[[rule]]\nname = \"ours\"\nKc = \"0.4/(K*d)\"\nTi = \"6*d\"\n\n[[controller]]\nname = \"too fast\"\nproportional_gain = 9\nintegral_time_s = 9\n";
    std::fs::write(&rules, text).unwrap();
    let words = ["optimise", "-p", PROCESS, "--max-sensitivity", "1.6", "--rules", rules.to_str().unwrap()];
    let value = json(&[&words[..], &["--plot", plot.to_str().unwrap()]].concat());
    let ours = &value["rules"][0];
    has(ours, &["name", "sensitivity_peak", "value", "controller"]);
    // Of two settings near the optimum at M_s = 1.6, on or above the frontier.
    assert!(ours["value"].as_f64().unwrap() > 26.0 && ours["sensitivity_peak"].as_f64().unwrap() < 1.65);
    assert!(value["rules"][1]["value"].is_null());
    assert!(std::fs::read_to_string(&plot).unwrap().contains("your rules"));
}

#[test]
fn optimise_answers_as_tune_does() {
    let value = json(&["optimise", "-p", PROCESS, "--max-sensitivity", "1.6"]);
    has(
        &value,
        &["controller", "specification", "achieved", "objective", "constraint", "trade_off", "warnings"],
    );
    has(&value["controller"], &CONTROLLER);
    has(&value["achieved"], &MARGINS);
    let peak = value["achieved"]["sensitivity_peak"].as_f64().unwrap();
    assert!(peak <= 1.6 && peak > 1.6 * (1.0 - 1e-9));
}
