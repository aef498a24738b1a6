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

const STRICT: [&str; 8] =
    ["-std=c99", "-Wall", "-Wextra", "-pedantic", "-Werror", "-Wconversion", "-Wdouble-promotion", "-Wshadow"];

/// A program that reads a trace and writes what the exported controller answers.
fn harness<T: Real>(given: &Given<T>) -> String {
    let real = if size_of::<T>() == 4 { ("float", "uint32_t", "08llx") } else { ("double", "uint64_t", "016llx") };
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
    let (mut updates, mut statuses) = (0, [0; 7]);
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
            must_agree(&format!("C {name} {optimised} of {described:?}"), &trace.told, &trace.expected, &answered);
        }
        updates += trace.updates;
        for (total, count) in statuses.iter_mut().zip(trace.statuses) {
            *total += count;
        }
    }
    assert!(statuses.iter().all(|&count| count > 0), "{statuses:?}: every status must have come");
    println!(
        "C {name}: {} exported controllers and {} random ones, {updates} updates, -O2 and -O0: 0 bits differ ({:.1} s)",
        LOOPS.len(),
        LOOPS.len() * 25,
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
