//! The Structured Text export, parsed by blark and run from its syntax tree (`structured_text.py`).

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use holdup::deploy::export::language;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::c::refused_settings;
use crate::sources::{LOOPS, answer, export, folder, given, must_agree};
use crate::trace::{Real, Scale, Trace, fields, random_settings};

/// Random controllers for each export.
const RANDOM: usize = 15;

/// A Python that has blark: the one that `check` installs, or the one named in the environment.
fn python() -> Option<PathBuf> {
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

/// Tells one of the exports a trace of its own and of random settings.
fn tell<T: Real>(folder: &Path, all: &mut Trace, (place, index): (usize, usize)) -> String {
    let (export, scale) = export("loop", LOOPS[index], T::FLOAT);
    let source = format!("loop{place}.st");
    std::fs::write(folder.join(&source), language("st").unwrap().write(&export)).unwrap();
    let designed = given::<T>(&export);
    let names: Vec<_> = fields(&designed).into_iter().map(|(name, _)| name).collect();
    std::fs::write(folder.join("fields"), names.join("\n")).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(200 + index as u64);
    let segments = export.segments().max(1);
    all.told += &format!("d {place}\n");
    all.run::<T>(&mut rng, scale, designed, &[], segments, 1000);
    for _ in 0..RANDOM {
        let scale = Scale::random(&mut rng);
        let first = random_settings::<T>(&mut rng, scale);
        let others: Vec<_> = (0..4).map(|_| random_settings(&mut rng, scale)).collect();
        all.tell_settings(&first);
        all.run(&mut rng, scale, first, &others, segments, 400);
    }
    source
}

#[test]
fn structured_text_agrees_bit_for_bit() {
    let Some(python) = python() else { return };
    let folder = folder("st");
    let mut all = Trace { switched_on_only: true, ..Trace::default() };
    // With a delay line and without in double precision, predicting and with an observer in single.
    let sources = [
        tell::<f64>(&folder, &mut all, (0, 0)),
        tell::<f64>(&folder, &mut all, (1, 2)),
        tell::<f32>(&folder, &mut all, (2, 7)),
        tell::<f32>(&folder, &mut all, (3, 0)),
    ];
    assert!(all.statuses.iter().all(|&count| count > 0), "{:?}: every status must have come", all.statuses);
    // Settings that `holdup_control` cannot even be given: as the C export does with them.
    let (told, expected) = refused_settings(&folder, LOOPS[0]);
    all.told += &format!("d 0\n{told}");
    all.expected += &expected;
    let mut command = Command::new(python);
    command.arg(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/export/structured_text.py"));
    let answered = answer(command.arg("fields").args(&sources).current_dir(&folder), &all.told);
    must_agree("Structured Text", &all.told, &all.expected, &answered);
    println!(
        "Structured Text, LREAL and REAL: {} exported controllers and {} random ones, {} updates: 0 bits differ",
        sources.len(),
        all.loops - sources.len(),
        all.updates
    );
}
