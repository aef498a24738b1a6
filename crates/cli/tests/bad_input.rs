//! Bad input is one line on standard error that names what is wrong, and exit status 2.

mod common;

use common::{PROCESS, folder, refused};

const LOOP: [&str; 5] = ["simulate", "-p", PROCESS, "-c", "Kc=1,Ti=50"];

#[test]
fn each_fault_of_the_options_names_option_and_value() {
    for (words, parts) in [
        (&["--horizon", "-1"][..], &["--horizon", "-1"][..]),
        (&["--horizon", "nan"], &["--horizon", "nan"]),
        (&["--horizon", "0"], &["--horizon", "0"]),
        (&["--horizon", "1e999"], &["--horizon", "1e999"]),
        (&["--setpoint", "0:1,500:2", "--horizon", "300"], &["--setpoint", "500", "300"]),
        (&["--setpoint", "5:1,5:2"], &["--setpoint", "5"]),
        (&["--setpoint", "0;1"], &["--setpoint", "0;1"]),
        (&["--load", "inf:1"], &["--load", "inf:1"]),
        (&["--initial", "nan"], &["--initial", "nan"]),
        (&["--points", "1"], &["--points", "1"]),
        (&["--points", "1e300"], &["--points", "1e300"]),
        (&["--step", "0"], &["--step", "0"]),
        (&["--plot", "a.gif"], &["--plot", "a.gif", ".svg"]),
        (&["--horizn", "3"], &["--horizn", "--horizon"]),
        (&["--require", "gain"], &["--require", "gain"]),
        (&["--require", "ia>=2"], &["--require", "ia", "iae"]),
        (&["--horizon"], &["--horizon"]),
        (&["--horizon", "3", "--horizon", "4"], &["--horizon", "twice"]),
        (&["extra.toml", "b.toml"], &["b.toml"]),
        (&["extra.toml"], &["--process", "extra.toml"]),
    ] {
        let error = refused(&[&LOOP[..], words].concat());
        for part in parts {
            assert!(error.contains(part), "{words:?}: {error}");
        }
    }
}

#[test]
fn each_fault_of_the_equipment_names_option_value_and_what_is_allowed() {
    for (words, parts) in [
        (&["--sample-period", "0"][..], &["--sample-period is 0"][..]),
        (&["--sample-period", "7"], &["--sample-period is 7: must be at most the dead time of 6 s"]),
        (&["--sample-period", "1e-9"], &["--sample-period", "at least"]),
        (&["--sample-period", "fast"], &["--sample-period", "fast"]),
        (&["--limits", "0:100"], &["--limits: needs --sample-period"]),
        (&["--seed", "3"], &["--seed: needs --sample-period"]),
        (&["--sample-period", "1", "--limits", "100:0"], &["--limits is 100", "below the high one of 0"]),
        (&["--sample-period", "1", "--limits", "0-100"], &["--limits is 0-100", "LOW:HIGH"]),
        (&["--sample-period", "1", "--limits", "1:2"], &["--initial-manipulated is 0", "1 to 2"]),
        (&["--sample-period", "1", "--rate-limit", "0"], &["--rate-limit is 0"]),
        (&["--sample-period", "1", "--noise", "-0.1"], &["--noise is -0.1", "0 or greater"]),
        (&["--sample-period", "1", "--drop", "1"], &["--drop is 1", "below 1"]),
        (&["--sample-period", "1", "--drop", "-0.1"], &["--drop is -0.1"]),
        (&["--sample-period", "1", "--jitter", "1"], &["--jitter is 1", "below the sample period of 1 s"]),
        (&["--sample-period", "1", "--computation-delay", "2"], &["--computation-delay is 2", "at most 1 s"]),
        (&["--sample-period", "1", "--stiction", "3"], &["--stiction is 3", "S:J"]),
        (&["--sample-period", "1", "--stiction", "3:-1"], &["--stiction is -1"]),
        (&["--sample-period", "1", "--deadband", "-1"], &["--deadband is -1"]),
        (&["--sample-period", "1", "--deadband", "1", "--stiction", "1:0"], &["--deadband", "--stiction"]),
        (&["--sample-period", "1", "--seed", "-1"], &["--seed is -1", "whole number"]),
        (&["--sample-period", "1", "--output-quantum", "0"], &["--output-quantum is 0"]),
        (&["--sample-period", "1", "--load-ramp", "5:1"], &["--load-ramp is 5:1", "start:end:change"]),
        (&["--sample-period", "1", "--load-ramp", "5:1:1"], &["--load-ramp is 1", "after the start"]),
        (
            &["--sample-period", "1", "--load-ramp", "5:90:1", "--horizon", "80"],
            &["--load-ramp ends at 90 s", "horizon of 80 s"],
        ),
        (&["--sample-period", "1", "--actual-process", "K=0,d=6"], &["--actual-process: K is 0"]),
        (&["--sample-period", "1", "--horizon", "1e9"], &["--sample-period is 1", "at least 50"]),
    ] {
        let error = refused(&[&LOOP[..], words].concat());
        for part in parts {
            assert!(error.contains(part), "{words:?}: {error}");
        }
    }
}

#[test]
fn sampling_that_is_too_slow_for_the_loop_says_how_slow_it_may_be() {
    let words = ["simulate", "-p", PROCESS, "-c", "Kc=4,Ti=40", "--sample-period"];
    let error = refused(&[&words[..], &["5"]].concat());
    assert!(error.contains("--sample-period is 5: must be at most about 1.948"), "{error}");
    let code = |h: &str| common::run(&[&words[..], &[h]].concat()).status.code();
    assert_eq!(code("1.948"), Some(0));
    // A loop that is unstable without sampling, too, is an answer.
    let unstable = ["simulate", "-p", PROCESS, "-c", "Kc=9", "--sample-period", "5"];
    assert_eq!(common::run(&unstable).status.code(), Some(0));
}

#[test]
fn each_fault_of_the_sampled_analysis_is_named() {
    for (words, parts) in [
        (&["--sample-period", "0"][..], "--sample-period is 0"),
        (&["--sample-period", "1e-7"], "--sample-period: the dead time has 60000000 samples"),
        (&["--computation-delay", "1"], "--computation-delay: needs --sample-period"),
        (&["--sample-period", "1", "--computation-delay", "2"], "--computation-delay is 2"),
        (&["--largest-sample-period", "gain_margn>=2"], "did you mean 'gain_margin'?"),
        (&["--largest-sample-period", "gain_margin"], "has no comparison"),
        (&["--largest-sample-period", "gain_margin>=x"], "compares with no finite number"),
    ] {
        let error = refused(&[&["analyse", "-p", PROCESS, "-c", "Kc=1,Ti=50"][..], words].concat());
        assert!(error.contains(parts), "{words:?}: {error}");
    }
    let error = refused(&["analyse", "-p", PROCESS, "-c", "Kc=1,a1=1", "--sample-period", "1"]);
    assert!(error.contains("output_filter: has no sampled law"), "{error}");
}

#[test]
fn each_fault_of_the_loop_names_its_key() {
    for (process, controller, parts) in [
        ("K=0,d=6", "Kc=1", "--process: K is 0"),
        ("K=1e308,d=1e308", "Kc=1e308", ""),
        ("K=inf,d=6", "Kc=1", "--process: K is inf"),
        ("", "Kc=1", "--process: "),
        ("K=1,d=6,d=6", "Kc=1", "--process: d is given twice"),
        (PROCESS, "", "--controller: "),
        (PROCESS, "Kc=1,Tdd=3", "--controller: unknown key 'Tdd': did you mean 'Td'?"),
        (PROCESS, "Kc=1,Td=1,N=3,Tf=3", "--controller: Tf"),
        (PROCESS, "Kc=\u{1}\n", "--controller: Kc is \\u{1}\\n"),
    ] {
        let error = refused(&["analyse", "-p", process, "-c", controller]);
        assert!(error.contains(parts), "{process} {controller}: {error}");
    }
    assert!(refused(&["analyse", "-p", PROCESS]).contains("--controller is missing"));
    assert!(refused(&["analyse"]).contains("--process is missing"));
}

#[test]
fn each_fault_of_the_filters_names_what_is_allowed() {
    for (words, parts) in [
        (&["tune", "-p", PROCESS, "--sort", "load_ia"][..], &["--sort", "load_iae"][..]),
        (&["tune", "-p", PROCESS, "--structure", "pio"], &["--structure", "pio", "PID"]),
        (
            &["tune", "-p", PROCESS, "--max-sensitivity", "0.9"],
            &["--max-sensitivity", "0.9", "greater than 1"],
        ),
        (&["tune", "-p", PROCESS, "--max-sensitivity", "x"], &["--max-sensitivity", "x"]),
        (&["rules", "--process", "integrating-with-lags"], &["--process", "integrating with lag"]),
        (&["rules", "--status", "good"], &["--status", "good", "recommended"]),
        (&["rules", "pi-simk"], &["pi-simk", "pi-simc"]),
    ] {
        let error = refused(words);
        for part in parts {
            assert!(error.contains(part), "{words:?}: {error}");
        }
    }
}

#[test]
fn each_fault_of_tune_names_rule_or_parameter() {
    for (words, parts) in [
        (&["--rule", "pd-kadm"][..], "pd-kadam"),
        (&["--rule", "pd-kadam", "--set", "Tss=3"], "Ts"),
        (&["--rule", "pd-kadam", "--set", "Ts=-3"], "Ts"),
        (&["--rule", "pd-kadam", "--set", "Ts=nan"], "Ts is nan"),
        (&["--rule", "pd-kadam", "--set", "Ts"], "'Ts' must be NAME=VALUE"),
        (&["--rule", "pd-kadam", "--set", "Ts=3", "--set", "Ts=4"], "twice"),
        (&["--set", "Ts=3"], "--rule"),
    ] {
        let error = refused(&[&["tune", "-p", PROCESS][..], words].concat());
        assert!(error.contains(parts), "{words:?}: {error}");
    }
}

#[test]
fn each_fault_of_the_words_themselves_is_one_line() {
    assert!(refused(&[]).contains("no command"));
    assert!(refused(&["analize"]).contains("did you mean 'analyse'?"));
    assert!(refused(&["rules", "pd-kadm"]).contains("pd-kadam"));
    assert!(refused(&["compare"]).contains("STUDY.toml"));
    assert!(refused(&["completions", "bsh"]).contains("bash"));
    assert!(refused(&["reproduce", "kadam"]).contains("kadam-2017"));
}

const STUDY: &str = "title = \"t\"\n[process]\nprocess_gain = 0.0506\ndead_time_s = 6.0\n\n[[controller]]\nname = \"a\"\nrule = \"pi-simc\"\n\n[[scenario]]\nname = \"s\"\nsetpoint = [[0.0, 1.0]]\nhorizon_s = 300.0\n";

#[test]
fn each_fault_of_a_study_names_file_line_key_and_value() {
    let folder = folder("study");
    let path = folder.join("study.toml");
    for (from, to, parts) in [
        ("dead_time_s", "dead_tme_s", ":4: unknown key 'process.dead_tme_s': did you mean 'dead_time_s'?"),
        ("pi-simc", "pi-sim", ":8: controller.rule: no rule is called `pi-sim`"),
        (
            "rule = \"pi-simc\"",
            "rule = \"pi-simc\"\nparameters = { tau = 3.0 }",
            ":9: controller.parameters: pi-simc has no parameter `tau`",
        ),
        (
            "rule = \"pi-simc\"",
            "rule = \"pi-simc\"\nproportional_gain = 3.0",
            ":9: controller.proportional_gain: cannot stand beside rule",
        ),
        (
            "rule = \"pi-simc\"",
            "rule = \"pi-simc\"\nderivative_filter_bandwidth = 3.0",
            ":6: 'a': derivative_filter_bandwidth: needs a derivative",
        ),
        ("rule = \"pi-simc\"", "", ":6: controller.proportional_gain is missing"),
        (
            "rule = \"pi-simc\"",
            "rule = \"pi-simc\"\nscenarios = [\"x\"]",
            ":9: controller.scenarios is x: must be the name of a scenario: 's'",
        ),
        ("300.0", "-3.0", ":13: scenario.horizon_s is -3"),
        ("300.0", "nan", ":13: scenario.horizon_s is nan"),
        ("[[0.0, 1.0]]", "[[300.0, 1.0]]", ":12: scenario.setpoint is at 300 s: must be before the horizon"),
        ("[[0.0, 1.0]]", "[[0.0]]", ":12: scenario.setpoint is [[0.0]]: must be a list of [time, value]"),
        (
            "[[scenario]]",
            "[[controller]]\nname = \"a\"\nrule = \"pi-simc\"\n[[scenario]]",
            "controller.name is a: must be a name that no other",
        ),
        ("[[scenario]]", "[[scenaro]]", ":10: unknown key 'scenaro': did you mean 'scenario'?"),
        (
            "[[scenario]]",
            "[sampled]\nsample_period_s = 1.0\nlimit = [0.0, 1.0]\n[[scenario]]",
            ":12: unknown key 'sampled.limit': did you mean 'limits'?",
        ),
        (
            "[[scenario]]",
            "[sampled]\nsample_period_s = 1.0\nlimits = [1.0, 0.0]\n[[scenario]]",
            ":12: sampled.limits is 1: must be a low limit below the high one of 0",
        ),
        ("horizon_s", "load_ramp = [[1.0, 2.0, 3.0]]\nhorizon_s", ":13: scenario.load_ramp: needs the table"),
        (STUDY, "", "process is missing"),
        ("title = \"t\"", "title = ", ":1: not valid TOML"),
    ] {
        assert!(STUDY.contains(from), "{from}");
        std::fs::write(&path, STUDY.replace(from, to)).unwrap();
        let error = refused(&["compare", path.to_str().unwrap()]);
        assert!(error.contains(path.to_str().unwrap()) && error.contains(parts), "{to}: {error}");
    }
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let folder = folder("unreadable");
    assert!(refused(&["compare", "no/such/file.toml"]).contains("no/such/file.toml: cannot read"));
    assert!(refused(&["compare", folder.to_str().unwrap()]).contains("is a folder"));
    let binary = folder.join("binary.toml");
    std::fs::write(&binary, [0xff, 0xfe, 0x00]).unwrap();
    assert!(refused(&["analyse", binary.to_str().unwrap()]).contains("is not UTF-8"));
}

#[test]
fn a_file_that_cannot_be_written_is_named_and_nothing_is_left() {
    let folder = folder("unwritable");
    let words = |option: &'static str, path: &str| {
        [&LOOP[..], &[option]]
            .concat()
            .into_iter()
            .map(str::to_owned)
            .chain([path.to_owned()])
            .collect::<Vec<_>>()
    };
    for (option, path) in [
        ("--csv", folder.join("absent/step.csv")),
        ("--plot", folder.join("absent/step.svg")),
        ("--csv", folder.clone()),
    ] {
        let words = words(option, path.to_str().unwrap());
        let error = refused(&words.iter().map(String::as_str).collect::<Vec<_>>());
        assert!(error.contains(path.to_str().unwrap()), "{error}");
    }
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
}

#[test]
fn a_demand_for_an_unknown_field_writes_no_file() {
    let file = folder("demand").join("step.csv");
    refused(&[&LOOP[..], &["--csv", file.to_str().unwrap(), "--require", "gain_margin>=2"]].concat());
    assert!(!file.exists());
}

#[test]
fn an_absurd_horizon_is_an_answer_or_one_line() {
    let output = common::run(&[&LOOP[..], &["--horizon", "1e9", "--json"]].concat());
    assert!(matches!(output.status.code(), Some(0 | 2)));
    assert!(String::from_utf8_lossy(&output.stderr).lines().count() <= 3);
}
