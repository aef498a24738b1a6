//! The laws that hold for every registered rule, and the registry in step with its folder.

#![expect(clippy::unwrap_used, reason = "a test may")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use holdup::model::{Controller, DerivativeFilter, Process, Seconds};
use holdup::tuning::{Applies, Default, Entry, Parameters, Status, Unit, evaluate, rule, rules};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The stems of the files of a folder with this ending.
fn stems(folder: &Path, ending: &str) -> BTreeSet<String> {
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    files
        .filter(|path: &PathBuf| path.extension().is_some_and(|e| e == ending))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .filter(|stem| stem != "mod")
        .collect()
}

fn example(applies: Applies, gain: f64, dead_time: f64, lag: f64) -> Process {
    match applies {
        Applies::Integrating => Process::integrating(gain, Seconds(dead_time)).unwrap(),
        Applies::DoubleIntegrating => Process::double_integrating(gain, Seconds(dead_time)).unwrap(),
        Applies::IntegratingWithLag => {
            Process::integrating(gain, Seconds(dead_time)).unwrap().with_lag(Seconds(lag)).unwrap()
        }
    }
}

/// Parameters that make every rule answer: the defaults, and for rules that ask for more, a feasible question.
fn question(entry: &Entry) -> Parameters {
    match entry.id {
        "pd-exact" => Parameters::new().set("Am", 2.5).set("phi_m", 1.1),
        _ => Parameters::new(),
    }
}

/// Kc, Ti, Td, Tf, Ko, a1, a2; absent is NaN.
fn settings(controller: &Controller) -> [f64; 7] {
    let none = f64::NAN;
    [
        controller.proportional_gain(),
        controller.integral_time().unwrap_or(none),
        controller.derivative_time().unwrap_or(none),
        controller.derivative_filter().map_or(none, DerivativeFilter::time),
        controller.observer().map_or(none, |observer| observer.gain()),
        controller.output_filter().map_or(none, |filter| filter.a1),
        controller.output_filter().map_or(none, |filter| filter.a2),
    ]
}

/// The parameters of a dead-time compensator, times what they must become when time is stretched by `a` and the
/// gain of the process by `b`; the unit is in the name.
fn compensator(entry: &'static Entry, [gain, dead_time, lag]: [f64; 3], a: f64, b: f64) -> Vec<f64> {
    let process = example(entry.process, gain, dead_time, lag);
    let controller = entry.tune(&process, &question(entry)).unwrap().controller;
    let parameters = controller.compensator().map_or_else(Vec::new, |compensator| compensator.parameters());
    let factor = |name: &str| match name {
        "model_gain" => b,
        _ if name.ends_with("_rad_s") => 1.0 / a,
        _ if name.ends_with("_s2") => a * a,
        _ if name.ends_with("_s") => a,
        _ => 1.0 / (a * b),
    };
    parameters.into_iter().map(|(name, value)| value * factor(name)).collect()
}

#[test]
fn settings_of_compensators_follow_time_gain_and_sign() {
    let compensators = rules().iter().filter(|entry| {
        let scaled = compensator(entry, [0.7, 1.3, 2.1], 4.0, 3.0);
        for (l, r) in compensator(entry, [2.1, 5.2, 8.4], 1.0, 1.0).into_iter().zip(&scaled) {
            assert!((l - r).abs() <= ROUNDING * r.abs(), "{}: {l} is not {r}", entry.id);
        }
        // A factor of −1 on the gain of the process is one on every gain, and on nothing else.
        let turned = compensator(entry, [0.7, 1.3, 2.1], 1.0, -1.0);
        for (l, r) in compensator(entry, [-0.7, 1.3, 2.1], 1.0, 1.0).into_iter().zip(&turned) {
            assert!((l - r).abs() <= ROUNDING * r.abs(), "{}: {l} is not {r}", entry.id);
        }
        !scaled.is_empty()
    });
    assert_eq!(compensators.count(), 7);
}

fn tuned(entry: &'static Entry, gain: f64, dead_time: f64, lag: f64) -> [f64; 7] {
    let process = example(entry.process, gain, dead_time, lag);
    let tuning = entry.tune(&process, &question(entry));
    settings(&tuning.unwrap_or_else(|error| panic!("{}: {error}", entry.id)).controller)
}

/// Rounding of a formula, or of a root solved to the last bits, in a few thousand operations.
const ROUNDING: f64 = 1e-9;

#[track_caller]
fn assert_same(entry: &Entry, left: [f64; 7], right: [f64; 7]) {
    for (l, r) in left.into_iter().zip(right) {
        assert!(
            (l.is_nan() && r.is_nan()) || (l - r).abs() <= ROUNDING * r.abs(),
            "{}: {left:?} is not {right:?}",
            entry.id
        );
    }
}

#[test]
fn registry_is_in_step_with_its_folder() {
    let folder = root().join("src/tuning/rules");
    let stems = stems(&folder, "rs");
    let modules: String = stems.iter().fold(String::new(), |all, stem| all + "mod " + stem + ";\n");
    let list: String = stems.iter().fold(String::new(), |all, stem| all + "    &" + stem + "::ENTRY,\n");
    let right = format!(
        "//! The registered rules, one file each.\n//!\n//! A test (`tests/rules.rs`) keeps the lines below in step with \
         the folder: never edit them by hand.\n\nuse super::Entry;\n\n{modules}\n/// Every rule.\n#[rustfmt::skip]\n\
         pub(super) static REGISTRY: &[&Entry] = &[\n{list}];\n"
    );
    let file = folder.join("mod.rs");
    if fs::read_to_string(&file).unwrap() != right {
        fs::write(&file, right).unwrap();
        panic!(
            "{} was not in step with the folder and has been rewritten: run the tests again",
            file.display()
        );
    }
}

#[test]
fn every_rule_has_its_file_and_its_published_values_and_no_file_is_left_over() {
    let ids: BTreeSet<String> = rules().iter().map(|entry| entry.id.to_owned()).collect();
    assert_eq!(ids.len(), rules().len(), "two rules share an identifier");
    let files = stems(&root().join("src/tuning/rules"), "rs");
    assert_eq!(ids, files.iter().map(|stem| stem.replace('_', "-")).collect(), "file name and id differ");
    assert_eq!(ids, stems(&root().join("tests/rules"), "toml"), "tests/rules/<id>.toml and the rules differ");
}

#[test]
fn published_values_are_reproduced_or_differ_for_a_stated_reason() {
    let mut wrong = Vec::new();
    for entry in rules() {
        match entry.judge() {
            Err(error) => wrong.push(format!("{}: {error}", entry.id)),
            Ok(values) => wrong.extend(values.into_iter().filter(|value| !value.expected).map(|value| {
                format!("{}: {} computed {}, printed {}", entry.id, value.what, value.computed, value.printed)
            })),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn times_follow_time_and_gains_follow_gain() {
    for entry in rules() {
        let n = if entry.process == Applies::DoubleIntegrating { 2 } else { 1 };
        let [kc, ti, td, tf, ko, a1, a2] = tuned(entry, 0.7, 1.3, 2.1);
        // Time stretched by 4, gain by 3: powers of two and a small integer keep the rounding small.
        let (a, b) = (4.0_f64, 3.0);
        let scale = 1.0 / (b * a.powi(n));
        let right = [kc * scale, ti * a, td * a, tf * a, ko * scale, a1 * a, a2 * a * a];
        assert_same(entry, tuned(entry, 0.7 * b, 1.3 * a, 2.1 * a), right);
    }
}

#[test]
fn a_negative_process_gain_turns_the_controller_gains() {
    for entry in rules() {
        let [kc, ti, td, tf, ko, a1, a2] = tuned(entry, 0.7, 1.3, 2.1);
        assert_same(entry, tuned(entry, -0.7, 1.3, 2.1), [-kc, ti, td, tf, -ko, a1, a2]);
        assert!(kc > 0.0, "{}", entry.id);
    }
}

#[test]
fn every_parameter_says_its_unit_its_default_and_its_range() {
    for entry in rules() {
        for parameter in entry.parameters {
            let name = format!("{} {}", entry.id, parameter.name);
            assert!(!parameter.description.is_empty(), "{name}");
            let process = example(entry.process, 0.7, 1.3, 2.1);
            let value = match parameter.default {
                Default::Number(number) => Some(number),
                Default::Formula(_) | Default::Absent => None,
            };
            if let Some(value) = value.filter(|_| parameter.unit != Unit::Gain) {
                let tuning = entry.tune(&process, &question(entry).set(parameter.name, value));
                assert!(tuning.is_ok() || entry.id.ends_with("-exact"), "{name}: {tuning:?}");
            }
            for outside in [f64::NAN, f64::INFINITY] {
                let error =
                    entry.tune(&process, &Parameters::new().set(parameter.name, outside)).unwrap_err();
                assert!(error.to_string().contains("must be"), "{name}: {error}");
            }
        }
    }
}

#[test]
fn the_controller_has_the_structure_that_the_list_says() {
    for entry in rules() {
        let process = example(entry.process, 0.7, 1.3, 2.1);
        let tuning = entry.tune(&process, &question(entry)).unwrap();
        assert_eq!(tuning.controller.structure(), entry.structure, "{}", entry.id);
        assert!(!tuning.published.settings.is_empty(), "{}", entry.id);
    }
}

#[test]
fn extreme_processes_and_parameters_give_an_answer_or_an_error_but_no_panic() {
    let extremes = [1e-300, 1e-9, 1.0, 1e9, 1e300];
    for entry in rules() {
        for gain in extremes {
            for dead_time in extremes {
                let process = example(entry.process, -gain, dead_time, 1.0);
                let _ = entry.tune(&process, &question(entry));
            }
        }
        let process = example(entry.process, 0.7, 1.3, 2.1);
        // Left out because they are slow, not because they fail: simulations with an extreme settling time, and margins
        // of a neutral loop with an observer and a Td of many dead times (seconds each).
        let slow = |name: &str| name == "Ts" || (entry.id, name) == ("dob-exact", "Td");
        for parameter in entry.parameters.iter().filter(|parameter| !slow(parameter.name)) {
            for value in [-1.0, 0.0, 1e-12, 0.999_999, 1.000_001, 89.0, 1e12, f64::MAX] {
                let _ = entry.tune(&process, &question(entry).set(parameter.name, value));
            }
        }
    }
}

#[test]
fn an_unknown_parameter_or_rule_names_the_nearest() {
    let process = example(Applies::Integrating, 1.0, 1.0, 1.0);
    let error =
        rule("pid-wang-cluett-z1").unwrap().tune(&process, &Parameters::new().set("betta", 3.0)).unwrap_err();
    assert_eq!(error.to_string(), "pid-wang-cluett-z1 has no parameter `betta`: did you mean `beta`?");
    assert_eq!(
        rule("pid-alimajhi").unwrap_err().to_string(),
        "no rule is called `pid-alimajhi`: did you mean `pid-ali-majhi`?"
    );
    let twice = Parameters::new().set("beta", 3.0).set("beta", 4.0);
    let error = rule("pid-wang-cluett-z1").unwrap().tune(&process, &twice).unwrap_err();
    assert_eq!(error.to_string(), "pid-wang-cluett-z1: `beta` is given twice");
}

#[test]
fn a_rule_refuses_a_process_of_another_kind() {
    let plain = example(Applies::Integrating, 1.0, 1.0, 1.0);
    let error = rule("pi-simc")
        .unwrap()
        .tune(&plain.with_lag(Seconds(1.0)).unwrap(), &Parameters::new())
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "pi-simc does not apply: it is for a process with one integrator and no lag"
    );
}

#[test]
fn a_rule_that_is_not_recommended_says_why_first() {
    for entry in rules() {
        let process = example(entry.process, 0.7, 1.3, 2.1);
        let warnings = entry.tune(&process, &question(entry)).unwrap().warnings;
        match entry.status {
            Status::Recommended => {}
            Status::History(why) | Status::Wrong(why) => {
                assert!(!why.is_empty() && warnings[0].contains(why), "{}: {warnings:?}", entry.id);
            }
        }
    }
}

#[test]
fn the_page_of_a_rule_has_its_headings_and_says_what_the_entry_says() {
    for entry in rules() {
        let file = root().join(format!("src/tuning/rules/{}.rs", entry.id.replace('-', "_")));
        let text = fs::read_to_string(&file).unwrap();
        let page: String = text
            .lines()
            .map_while(|line| line.strip_prefix("//!"))
            .fold(String::new(), |page, line| page + line.trim_start() + " ");
        let plain = |text: &str| text.replace('`', "").split_whitespace().collect::<Vec<_>>().join(" ");
        let page = plain(&page);
        let mut rest = page.as_str();
        for heading in
            ["Applies to", "Formula", "Parameters", "When", "Limits", "Published values", "Reference"]
        {
            let found = rest.split_once(&format!("# {heading} "));
            rest = found
                .unwrap_or_else(|| panic!("{}: no heading {heading}, or in the wrong place", entry.id))
                .1;
        }
        for sentence in [entry.when, entry.limits] {
            assert!(page.contains(&plain(sentence)), "{}: page and entry differ: {sentence}", entry.id);
        }
        for (name, formula) in entry.formula {
            assert!(
                page.contains(&format!("{name} = {formula}"))
                    || entry.id == "dob-kadam"
                    || entry.id.ends_with("-exact"),
                "{}: page has not {name} = {formula}",
                entry.id
            );
        }
    }
}

#[test]
fn every_formula_is_one() {
    for entry in rules() {
        for parameter in entry.parameters {
            if let Default::Formula(text) = parameter.default {
                let value = evaluate(text, &|_| Some(0.5));
                assert!(value.is_ok(), "{}: {value:?}", entry.id);
            }
        }
    }
}
