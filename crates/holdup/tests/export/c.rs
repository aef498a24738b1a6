//! The C export, compiled by the machine's C compiler.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use holdup::deploy::export::{Export, language};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::sources::{LOOPS, answer, compile, export, folder, given, must_agree};
use crate::trace::{Field, Given, Real, Scale, Trace, fields, random_settings};

const STRICT: [&str; 8] = [
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-pedantic",
    "-Werror",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Wshadow",
];

/// A program that reads a trace and writes what the exported controller answers.
fn harness<T: Real>(given: &Given<T>) -> String {
    let real =
        if size_of::<T>() == 4 { ("float", "uint32_t", "08llx") } else { ("double", "uint64_t", "016llx") };
    let mut read = String::new();
    for (name, field) in fields(given) {
        let reader = if matches!(field, Field::Flag(_)) { "integer() != 0" } else { "number()" };
        let _ = writeln!(read, "            given.{name} = {reader};");
    }
    include_str!("harness.c")
        .replace("REAL", real.0)
        .replace("BITS", real.1)
        .replace("DIGITS", real.2)
        .replace("        /* the settings */\n", &read)
}

fn built<T: Real>(folder: &Path, export: &Export, given: &Given<T>, optimised: &str) -> Command {
    std::fs::write(folder.join("loop.c"), language("c").unwrap().write(export)).unwrap();
    std::fs::write(folder.join("main.c"), harness(given)).unwrap();
    let program = folder.join(format!("loop{optimised}"));
    compile(
        Command::new("cc")
            .args(STRICT)
            .args([optimised, "-ffp-contract=off", "-o"])
            .arg(&program)
            .args(["main.c", "loop.c"])
            .current_dir(folder),
    );
    Command::new(program)
}

fn c_agrees_bit_for_bit<T: Real>(name: &str) {
    let began = Instant::now();
    let (mut updates, mut loops, mut statuses) = (0, 0, [0; 7]);
    for (index, described) in LOOPS.into_iter().enumerate() {
        let (export, scale) = export("loop", described, T::FLOAT);
        let folder = folder(&format!("{name}-{index}"));
        let mut rng = ChaCha8Rng::seed_from_u64(index as u64);
        let segments = export.segments().max(1);
        let mut trace = Trace::default();
        // As designed, then random ones in the same program.
        trace.told += "d\n";
        trace.run::<T>(&mut rng, scale, given(&export), &[], segments, 2000);
        for _ in 0..25 {
            let scale = Scale::random(&mut rng);
            let first = random_settings::<T>(&mut rng, scale);
            let others: Vec<_> = (0..4).map(|_| random_settings(&mut rng, scale)).collect();
            trace.tell_settings(&first);
            trace.run(&mut rng, scale, first, &others, segments, 1000);
        }
        // Not optimised, the parts that a compiler could turn around: observer and predictor.
        let levels: &[&str] = if [0, 7].contains(&index) { &["-O2", "-O0"] } else { &["-O2"] };
        for optimised in levels {
            let answered = answer(&mut built::<T>(&folder, &export, &given(&export), optimised), &trace.told);
            must_agree(
                &format!("C {name} {optimised} of {described:?}"),
                &trace.told,
                &trace.expected,
                &answered,
            );
        }
        updates += trace.updates;
        loops += trace.loops;
        for (total, count) in statuses.iter_mut().zip(trace.statuses) {
            *total += count;
        }
    }
    assert!(statuses.iter().all(|&count| count > 0), "{statuses:?}: every status must have come");
    println!(
        "C {name}: {} exported controllers and {} random ones, {updates} updates, -O2, two also -O0: 0 bits differ ({:.1} s)",
        LOOPS.len(),
        loops - LOOPS.len(),
        began.elapsed().as_secs_f64()
    );
}

#[test]
fn c_in_double_precision_agrees_bit_for_bit() {
    c_agrees_bit_for_bit::<f64>("f64");
}

#[test]
fn c_in_single_precision_agrees_bit_for_bit() {
    c_agrees_bit_for_bit::<f32>("f32");
}

/// Fields, the number that spoils each, and how C names the fault.
const FAULTS: [(&str, f64, &str); 21] = [
    ("law.pid.proportional_gain", 0.0, "proportional_gain"),
    ("law.pid.proportional_gain", -1.0, "proportional_gain"),
    ("law.pid.setpoint_weight", f64::NAN, "setpoint_weight"),
    ("law.pid.derivative_setpoint_weight", f64::INFINITY, "derivative_setpoint_weight"),
    ("law.pid.integral_time", 0.0, "integral_time"),
    ("law.pid.tracking_time", -1.0, "tracking_time"),
    ("law.pid.derivative_time", -1.0, "derivative_time"),
    ("law.pid.filter_time", 0.0, "filter_time"),
    ("law.pid.bias", f64::NAN, "bias"),
    ("law.pid.bleed_time", 0.0, "bleed_time"),
    ("law.observer.observer_gain", -1.0, "observer_gain"),
    ("law.observer.model_gain", 0.0, "model_gain"),
    ("law.observer.dead_time", f64::NAN, "dead_time"),
    ("law.observer.sample_period", 0.0, "sample_period"),
    ("limits.low", 3.0, "low"),
    ("limits.high", f64::NAN, "high"),
    ("limits.rate", 0.0, "rate"),
    ("watch.range_low", 2e4, "range_low"),
    ("watch.stale_time", 0.0, "stale_time"),
    ("watch.failure_time", 0.1, "failure_time"),
    ("watch.safe_output", 3.0, "safe_output"),
];

/// The settings of a trace with one number or flag changed.
fn spoilt(given: &Given<f64>, field: &str, number: f64) -> String {
    let words = fields(given).into_iter().map(|(name, held)| match held {
        _ if name == field => number.bits(),
        Field::Flag(flag) => u8::from(flag).to_string(),
        Field::Number(held) => held.unwrap_or(0.0).bits(),
    });
    format!("s {}\n", words.collect::<Vec<_>>().join(" "))
}

#[test]
fn settings_that_no_controller_can_run_with_are_named_and_the_old_ones_run_on() {
    let (export, scale) = export("loop", LOOPS[1], <f64 as Real>::FLOAT);
    let designed = given::<f64>(&export);
    let folder = folder("faults");
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut trace = Trace::default();
    trace.run::<f64>(&mut rng, scale, designed, &[], export.segments(), 60);
    let lines: Vec<_> = trace.told.lines().collect();
    let mut told = format!("d\nf\n{}\n", lines[..lines.len() - 1].join("\n"));
    let last = lines[lines.len() - 1];

    for (field, number, _) in FAULTS {
        told += &format!("{}f\n{last}\n", spoilt(&designed, field, number));
    }
    let answered = answer(&mut built::<f64>(&folder, &export, &designed, "-O2"), &told);
    let answers: Vec<_> = answered.lines().collect();
    let (named, before) = (answers[0], &answers[1..lines.len()]);
    assert_eq!(named, "good");
    assert_eq!(before.join("\n"), trace.expected.lines().take(before.len()).collect::<Vec<_>>().join("\n"));
    for ((field, _, fault), answer) in FAULTS.into_iter().zip(answers[lines.len()..].chunks(2)) {
        assert_eq!(answer[0], fault, "{field}");
        let words: Vec<_> = answer[1].split(' ').collect();
        let output = f64::from_bits(u64::from_str_radix(words[0], 16).unwrap());
        assert!((-1.5..=2.5).contains(&output), "{field}: {output}");
        // Refused, unless the measurement has more to say.
        assert!(words[4] == "2" || words[4].parse::<u8>().unwrap() > 3, "{field}: {}", answer[1]);
    }
}

/// A trace with settings that are refused, and what the C export answers to it: what another language must answer.
pub(crate) fn refused_settings(folder: &Path, described: (&str, &str)) -> (String, String) {
    let (export, scale) = export("loop", described, <f64 as Real>::FLOAT);
    let designed = given::<f64>(&export);
    let mut trace = Trace { switched_on_only: true, ..Trace::default() };
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    trace.run::<f64>(&mut rng, scale, designed, &[], export.segments().max(1), 60);
    let mut told = trace.told.clone();
    for ((field, number, _), update) in FAULTS.into_iter().zip(trace.told.lines().skip(1)) {
        told += &format!("{}{update}\n", spoilt(&designed, field, number));
    }
    let answered = answer(&mut built::<f64>(folder, &export, &designed, "-O2"), &format!("d\n{told}"));
    assert!(answered.lines().any(|line| line.ends_with(" 2")), "none was refused");
    (told, answered)
}
