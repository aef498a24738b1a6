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
fn each_fault_of_an_export_names_its_option_and_what_is_allowed() {
    let folder = folder("export");
    let absent = folder.join("absent/level.c");
    let absent = absent.to_str().unwrap();
    let observed = "Kc=1.5321,Td=1.0343,Ko=1.5321";
    for (controller, words, parts) in [
        (
            "Kc=1",
            &["--sample-period", "0"][..],
            "--sample-period is 0: must be above 0 and at most the dead time of 6 s",
        ),
        ("Kc=1", &["--sample-period", "-1"], "--sample-period is -1"),
        ("Kc=1", &["--sample-period", "nan"], "--sample-period is nan"),
        (
            "Kc=1",
            &["--sample-period", "6.1"],
            "--sample-period is 6.1: must be above 0 and at most the dead time",
        ),
        ("Kc=1,Ko=1,dm=0.2", &[], "--sample-period is 0.5: must be at most the model's dead time of 0.2 s"),
        (observed, &["--sample-period", "1us"], "--sample-period is 1us"),
        (observed, &["--sample-period", "0.00001"], "the delay line would need 600003 segments"),
        (
            observed,
            &["--segments", "14"],
            "--segments is 14: must be 15 to 131072: a dead time of 6 s at 0.5 s needs 15",
        ),
        (observed, &["--segments", "1e9"], "--segments: '1e9'"),
        (
            "Kc=1",
            &["--segments", "20"],
            "--segments is 20: must be absent: only an observer has a delay line",
        ),
        ("Kc=1", &["--limits", "100:0"], "--limits: output_low is 100: must be below output_high"),
        ("Kc=1", &["--limits", "0"], "--limits: '0': must be low:high"),
        ("Kc=1", &["--limits", ":"], "--limits: ':'"),
        ("Kc=1", &["--rate-limit", "0"], "--rate-limit: rate_limit is 0: must be finite and above 0"),
        ("Kc=1,Ti=3", &["--tracking-time", "-1"], "--tracking-time: tracking_time is -1"),
        ("Kc=1", &["--bleed-time", "0"], "--bleed-time: bleed_time is 0"),
        ("Kc=1", &["--measurement-range", "3:"], "--measurement-range: '3:'"),
        ("Kc=1", &["--measurement-range", "3:2"], "--measurement-range: measurement_low is 3"),
        ("Kc=1", &["--stale-time", "0"], "--stale-time: stale_time is 0"),
        ("Kc=1", &["--safe-output", "3"], "--safe-output: needs --failure-time"),
        ("Kc=1", &["--failure-time", "3"], "--failure-time: needs --safe-output"),
        (
            "Kc=1",
            &["--limits", "0:1", "--failure-time", "3", "--safe-output", "3"],
            "--safe-output: safe_output is 3: must be within the output limits",
        ),
        ("Kc=1,a1=3", &[], "output_filter: has no sampled law"),
        ("Kc=1,Ko=-1", &[], "observer_gain is -1: must have the sign of model_gain"),
        ("Kc=1e-60", &["--float", "f32"], "proportional_gain is 0: must be finite and not 0"),
        ("Kc=1", &["--float", "f16"], "--float: 'f16': must be f32 or f64"),
        ("Kc=1", &["--language", "cpp"], "--language: 'cpp'"),
        ("Kc=1", &["--name", "program"], "--name is 'program'"),
        ("Kc=1", &["--name", "a*/b"], "--name is 'a*/b'"),
        ("Kc=1", &["--output", absent], absent),
    ] {
        let mut all = vec!["export", "-p", PROCESS, "-c", controller];
        for (option, value) in [("--language", "c"), ("--sample-period", "0.5")] {
            if !words.contains(&option) {
                all.extend([option, value]);
            }
        }
        all.extend(words);
        let error = refused(&all);
        assert!(error.contains(parts), "{all:?}: {error}");
    }
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 0);
    assert!(refused(&["export", "-p", PROCESS, "-c", "Kc=1", "--language", "c"]).contains("--sample-period"));
    let lagging =
        ["export", "-p", "K=1,d=6,T=1", "-c", "Kc=1,Ko=1", "--language", "st", "--sample-period", "1"];
    assert!(refused(&lagging).contains("observer_gain: has no sampled law on this process"));
}

#[test]
fn a_compensator_without_a_sampled_law_is_named() {
    let file = folder("export-compensator").join("loop.toml");
    let huba = "[process]\nprocess_gain = 1.0\ndead_time_s = 2.0\n[controller]\nstructure = \"P+inverse-DOB\"\n\
                parameters = { main_gain = 0.2, filter_time_s = 2.0, model_gain = 1.0, model_dead_time_s = 2.0 }\n";
    std::fs::write(&file, huba).unwrap();
    let words = ["export", file.to_str().unwrap(), "--language", "rust", "--sample-period", "0.1"];
    assert!(
        refused(&words)
            .contains("P+inverse-DOB: has no sampled law: of the compensators only SP+DOB has one")
    );
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

#[test]
fn each_fault_of_a_conversion_names_option_and_value() {
    for (words, parts) in [
        (&["-c", "Kc=1", "--to", "yokogaw"][..], &["--to", "yokogaw", "did you mean 'yokogawa-centum'"][..]),
        (&["-c", "Kc=1", "--to", "all", "--pv-span", "5:0"], &["--pv-span", "5:0", "low:high"]),
        (&["-c", "Kc=1", "--to", "all", "--op-span", "3:3"], &["--op-span", "3:3"]),
        (&["-c", "Kc=1", "--to", "all", "--sample-period", "0"], &["--sample-period", "greater than 0"]),
        (&["-c", "Kc=0", "--to", "all"], &["--controller", "Kc is 0"]),
        (&["-c", "Kc=1"], &["--to is missing"]),
        (&["--to", "all"], &["--controller is missing"]),
        (&["PGain=2"], &["PGain=2", "--from"]),
        (&["-c", "Kc=1", "--from", "klipper-heater", "pid_Kp=1"], &["--controller", "--from"]),
        (&["--from", "klipper-heater"], &["pid_Kp is missing"]),
        (&["--from", "klipper-heater", "pid_Kp=0"], &["pid_Kp is 0"]),
        (&["--from", "klipper-heater", "pid_Kp=-3"], &["pid_Kp is -3"]),
        (&["--from", "klipper-heater", "pid_Kp=1,pid_Kj=2"], &["pid_Kj", "did you mean"]),
        (&["--from", "klipper-heater", "pid_Kp=1", "pid_Ki=nan"], &["pid_Ki is nan"]),
        (&["--from", "klipper-heater", "pid_Kp=1", "pid_Ki=-2"], &["pid_Ki"]),
        (&["--from", "yokogawa-centum", "P=1e-320,I=30"], &["P is"]),
    ] {
        let error = refused(&[&["convert"][..], words].concat());
        for part in parts {
            assert!(error.contains(part), "{words:?}: {error}");
        }
    }
}

#[test]
fn each_fault_of_the_actuator_names_option_and_value() {
    for (words, parts) in [
        (&["--limits", "100:0"][..], &["--limits", "100:0"][..]),
        (&["--limits", "5"], &["--limits", "5", "low:high"]),
        (
            &["--limits", "0:100", "--initial-manipulated", "140"],
            &["--initial-manipulated", "140", "0 to 100"],
        ),
        (&["--limits", "0:100", "--load-step", "inf"], &["--load-step", "inf"]),
        (&["--setpoint-step", "2"], &["--setpoint-step", "--limits"]),
    ] {
        let error = refused(&[&["analyse", "-p", PROCESS, "-c", "Kc=1,Ti=50"][..], words].concat());
        for part in parts {
            assert!(error.contains(part), "{words:?}: {error}");
        }
    }
}

#[test]
fn each_fault_of_a_family_or_of_an_optimum_names_option_and_value() {
    for (words, parts) in [
        (&["robust", "--gain", "0:2"][..], &["--gain", "0:2"][..]),
        (&["robust", "--gain", "-1:2"], &["--gain", "-1:2"]),
        (&["robust", "--dead-time", "2:1"], &["--dead-time", "2:1"]),
        (&["robust", "--dead-time", "1"], &["--dead-time", "LOW:HIGH", "0.8:1.2"][..1]),
        (&["robust", "--samples", "1.5"], &["--samples", "1.5"]),
        (&["robust", "--samples", "0"], &["--samples", "0", "from 1"]),
        (&["robust", "--distribution", "gaussian"], &["--distribution", "gaussian", "normal"]),
        (&["robust", "--output", "runs.xlsx", "--samples", "10"], &["runs.xlsx", ".csv"]),
        (&["robust", "--output", "/nonexistent-holdup/runs.csv"], &["/nonexistent-holdup/runs.csv"]),
        (&["robust", "--max-sensitivity", "1"], &["--max-sensitivity", "1"]),
        (&["robust", "--ellipse", "1"], &["--ellipse", "1"]),
        (&["robust", "--ellipse", "0", "--gain", "0.9:1.2"], &["--gain", "0.9:1.2", "--ellipse"]),
    ] {
        let error = refused(&[words, &["-p", PROCESS, "-c", "Kc=1,Ti=50"]].concat());
        for part in parts {
            assert!(error.contains(part), "{words:?}: {error}");
        }
    }
    for (words, parts) in [
        (&["--structure", "pidd"][..], &["--structure", "pidd", "pid"][..]),
        (&["--objective", "speed"], &["--objective", "speed", "load_iae"]),
        (&["--max-sensitivity", "0.5"], &["--max-sensitivity", "0.5"]),
        (&["--structure", "p"], &["load_iae", "integral action"]),
        (&["--objective", "total_variation"], &["total_variation", "load_iae"]),
        (&["--objective", "robust_box"], &["--max-sensitivity"]),
        (
            &["--objective", "control_energy", "--structure", "pid", "--max-settling-time", "60"],
            &["control_energy", "--filter", "free"],
        ),
        (
            &["--structure", "pid", "--max-noise-gain", "15", "--filter", "none"],
            &["noise_gain", "infinite", "--filter"],
        ),
        (&["--structure", "pid", "--filter", "-1"], &["--filter", "-1", "free", "none"]),
        (&["--filter", "0.1"], &["--filter", "0.1", "pi"]),
        (&["--max-variance-gain", "3"], &["--max-variance-gain", "--noise-sample-time", "--noise-bandwidth"]),
        (&["--noise-bandwidth", "3"], &["--noise-bandwidth", "--max-variance-gain"]),
        (
            &["--max-variance-gain", "3", "--noise-sample-time", "0"],
            &["--noise-sample-time", "0", "greater than 0"],
        ),
        (&["--max-variance-gain", "3", "--noise-bandwidth", "1e6"], &["--noise-bandwidth", "1e6", "at most"]),
        (&["--max-settling-time", "0"], &["--max-settling-time", "0"]),
        (&["--table"], &["--table", "--max-sensitivity"]),
        (&["--table", "--max-sensitivity", "3"], &["--table", "3", "1.2 to 2.5"]),
        (
            &["--table", "--max-sensitivity", "1.6", "--min-gain-margin", "2"],
            &["--min-gain-margin", "no other limit"],
        ),
        (&["--table", "--max-sensitivity", "1.6", "--plot", "never.svg"], &["--plot", "--table"]),
        (&["--table", "--max-sensitivity", "1.6", "--rules", "never.toml"], &["--rules", "--table"]),
        (&["--tables", "--max-sensitivity", "1.6"], &["--max-sensitivity", "--tables"]),
        (&["--objective", "averaging", "--min-gain-margin", "2"], &["--min-gain-margin", "averaging"]),
        (
            &["--table", "--max-sensitivity", "1.6", "--structure", "pid", "--filter", "0.2"],
            &["--table", "pid", "Tf/Td = 0.1"],
        ),
        (&["--tables", "--structure", "pd+dob"], &["--tables", "pd+dob", "pi load_iae"]),
        (&["--rules", "rules.toml"], &["--rules", "--trade-off"]),
        (&["--rules", "/nonexistent-holdup.toml", "--trade-off"], &["/nonexistent-holdup.toml"]),
        (&["--objective", "averaging"], &["--load-step"]),
        (&["--objective", "averaging", "--load-step", "10", "--excursion", "1"], &["excursion", "3.036"]),
    ] {
        let error = refused(&[&["optimise", "-p", PROCESS], words].concat());
        for part in parts {
            assert!(error.contains(part), "{words:?}: {error}");
        }
    }
}
