//! The Structured Text export, parsed by blark and run from its syntax tree (`structured_text.py`).

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use holdup::deploy::export::language;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::sources::{LOOPS, answer, export, folder, given, must_agree};
use crate::trace::{Real, Scale, Trace, fields, random_settings};

/// A Python that has blark: the one that `check` installs, or the one named in the environment.
pub(crate) fn python() -> Option<PathBuf> {
    let installed = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/check/bin/python");
    let python = std::env::var_os("HOLDUP_BLARK_PYTHON").map_or(installed, PathBuf::from);
    let asked = Command::new(&python).args(["-c", "import blark"]).stderr(Stdio::null()).status();
    if asked.is_ok_and(|status| status.success()) {
        return Some(python);
    }
    let required = std::env::var_os("HOLDUP_BLARK_PYTHON").is_some();
    assert!(!required, "{} has no blark", python.display());
    println!("SKIPPED: Structured Text: {} has no blark; ./check installs it", python.display());
    None
}

fn structured_text_agrees_bit_for_bit<T: Real>(real: &str, chosen: &[usize]) {
    let Some(python) = python() else { return };
    let folder = folder(&format!("st-{real}"));
    let mut command = Command::new(python);
    command.arg(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/export/structured_text.py"));
    command.arg("fields").current_dir(&folder);
    let mut all = Trace { switched_on_only: true, ..Trace::default() };
    for (place, &index) in chosen.iter().enumerate() {
        let (export, scale) = export("loop", LOOPS[index], T::FLOAT);
        let source = format!("loop{index}.st");
        std::fs::write(folder.join(&source), language("st").unwrap().write(&export)).unwrap();
        command.arg(source);
        let designed = given::<T>(&export);
        let names: Vec<_> = fields(&designed).into_iter().map(|(name, _)| name).collect();
        std::fs::write(folder.join("fields"), names.join("\n")).unwrap();
        let mut rng = ChaCha8Rng::seed_from_u64(200 + index as u64);
        let segments = export.segments().max(1);
        all.told += &format!("d {place}\n");
        all.run::<T>(&mut rng, scale, designed, &[], segments, 1000);
        for _ in 0..20 {
            let scale = Scale::random(&mut rng);
            let first = random_settings::<T>(&mut rng, scale);
            let others: Vec<_> = (0..4).map(|_| random_settings(&mut rng, scale)).collect();
            all.tell_settings(&first);
            all.run(&mut rng, scale, first, &others, segments, 400);
        }
    }
    assert!(all.statuses.iter().all(|&count| count > 0), "{:?}: every status must have come", all.statuses);
    let answered = answer(&mut command, &all.told);
    must_agree(&format!("Structured Text, {real}"), &all.told, &all.expected, &answered);
    println!(
        "Structured Text {real}: {} exported controllers and {} random ones, {} updates: 0 bits differ",
        chosen.len(),
        chosen.len() * 20,
        all.updates
    );
}

// Of the two in double precision one has a delay line and one has not; the one in single precision predicts.

#[test]
fn structured_text_in_double_precision_agrees_bit_for_bit() {
    structured_text_agrees_bit_for_bit::<f64>("LREAL", &[0, 2]);
}

#[test]
fn structured_text_in_single_precision_agrees_bit_for_bit() {
    structured_text_agrees_bit_for_bit::<f32>("REAL", &[7]);
}
