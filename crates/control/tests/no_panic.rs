//! No panic and no allocation, shown on the machine code: what an optimised build of the update calls.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use std::path::Path;
use std::process::Command;

/// What a target would call; `pub` and not generic, so that the compiler must make code for it.
const CALLER: &str = r"
#![no_std]
use holdup_control::{DelayLine, Input, Output, Segment, SettingError, Settings, State};

type Line<T> = [Segment<T>; 64];

#[inline(never)]
pub fn update_f64(state: &mut State<f64, Line<f64>>, settings: &Settings<f64>, input: &Input<f64>) -> Output<f64> {
    state.update(settings, input)
}

#[inline(never)]
pub fn update_f32(state: &mut State<f32, Line<f32>>, settings: &Settings<f32>, input: &Input<f32>) -> Output<f32> {
    state.update(settings, input)
}

#[inline(never)]
pub fn update_without_line(state: &mut State<f32, [Segment<f32>; 0]>, settings: &Settings<f32>, input: &Input<f32>)
    -> Output<f32> {
    state.update(settings, input)
}

#[inline(never)]
pub fn at_rest(settings: &Settings<f64>, line: Line<f64>) -> Result<State<f64, Line<f64>>, SettingError> {
    State::at_rest(settings, line, 1.0, 1.0, 0.0)
}

#[inline(never)]
pub fn set_dead_time(line: &mut DelayLine<f64, Line<f64>>, dead_time: f64) {
    line.set_dead_time(dead_time);
}
";

fn compile(arguments: &[&str], folder: &Path) {
    let compiler = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let output = Command::new(compiler)
        .args([
            "--edition=2024",
            "--crate-type=lib",
            "-Copt-level=3",
            "-Ccodegen-units=1",
            "-Cpanic=abort",
            "-Coverflow-checks=on",
        ])
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn the_machine_code_of_an_update_calls_neither_panic_nor_allocation() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no_panic");
    std::fs::create_dir_all(&folder).unwrap();
    let library = concat!(env!("CARGO_MANIFEST_DIR"), "/src/lib.rs");
    compile(&["--crate-name=holdup_control", "--cap-lints=allow", library], &folder);
    std::fs::write(folder.join("caller.rs"), CALLER).unwrap();
    compile(&["--extern=holdup_control=libholdup_control.rlib", "--emit=asm=caller.s", "caller.rs"], &folder);

    let code = std::fs::read_to_string(folder.join("caller.s")).unwrap();
    for function in ["update_f64", "update_f32", "update_without_line", "at_rest", "set_dead_time"] {
        assert!(code.contains(function), "no code for {function}");
    }
    for called in ["panicking", "rust_alloc", "unwrap_failed", "expect_failed"] {
        let lines: Vec<_> = code.lines().filter(|line| line.contains(called)).collect();
        assert!(lines.is_empty(), "{lines:#?}");
    }
}
