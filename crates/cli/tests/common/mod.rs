//! Running the command.
#![allow(
    dead_code,
    clippy::unwrap_used,
    reason = "each test file uses its part, and helpers of tests may unwrap"
)]

use std::path::PathBuf;
use std::process::{Command, Output};

use serde_json::Value;

/// The paper's process.
pub(crate) const PROCESS: &str = "K=0.0506,d=6";

/// The command with these words.
pub(crate) fn holdup(words: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_holdup"));
    command.args(words).current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    command
}

/// What the command says.
pub(crate) fn run(words: &[&str]) -> Output {
    holdup(words).output().unwrap()
}

/// The JSON of a command that succeeds.
pub(crate) fn json(words: &[&str]) -> Value {
    let output = run(&[words, &["--json"]].concat());
    assert_eq!(output.status.code(), Some(0), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The one line of bad input: exit status 2, nothing on standard output.
pub(crate) fn refused(words: &[&str]) -> String {
    let output = run(words);
    let error = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{words:?}: {error}");
    assert!(output.stdout.is_empty(), "{words:?} wrote to standard output");
    assert_eq!(error.lines().count(), 1, "{words:?}: {error}");
    assert!(error.starts_with("error: "), "{words:?}: {error}");
    error
}

/// A fresh folder of this name.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("holdup-cli-{name}-{}", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Whether an object has these names.
pub(crate) fn has(value: &Value, names: &[&str]) {
    for name in names {
        assert!(value.get(name).is_some(), "{name} is absent in {value}");
    }
}

/// The names of margins.
pub(crate) const MARGINS: [&str; 12] = [
    "stable",
    "gain_margin",
    "gain_margin_low",
    "phase_margin_deg",
    "delay_margin_s",
    "delay_margin_low_s",
    "gain_crossovers_rad_s",
    "phase_crossovers_rad_s",
    "sensitivity_peak",
    "sensitivity_peak_rad_s",
    "complementary_sensitivity_peak",
    "high_frequency_gain",
];
