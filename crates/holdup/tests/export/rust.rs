//! The Rust export, compiled by rustc on `holdup-control` without the standard library.

use std::path::Path;
use std::process::Command;

use holdup::deploy::export::language;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::sources::{LOOPS, answer, compile, export, folder, given, must_agree};
use crate::trace::{Real, Trace};

/// rustc, quiet about nothing.
fn rustc(folder: &Path) -> Command {
    let mut command = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    command.args(["--edition", "2024", "-O", "-D", "warnings"]).current_dir(folder);
    command
}

fn rust_agrees_bit_for_bit<T: Real>(real: &str) {
    let folder = folder(&format!("rust-{real}"));
    let control = Path::new(env!("CARGO_MANIFEST_DIR")).join("../control/src/lib.rs");
    compile(rustc(&folder).args(["--crate-type", "rlib", "--crate-name", "holdup_control"]).arg(control));

    let (mut modules, mut arms, mut all) = (String::new(), String::new(), Trace::default());
    for (index, described) in LOOPS.into_iter().enumerate() {
        let (export, scale) = export(&format!("loop{index}"), described, T::FLOAT);
        std::fs::write(folder.join(format!("loop{index}.rs")), language("rust").unwrap().write(&export))
            .unwrap();
        modules += &format!("pub mod loop{index};\n");
        arms += &format!("        {index} => run!(loop{index}, lines),\n");
        let mut rng = ChaCha8Rng::seed_from_u64(100 + index as u64);
        all.told += &format!("d {index}\n");
        all.run::<T>(&mut rng, scale, given(&export), &[], export.segments().max(1), 2000);
    }
    // The exports are a crate of their own that has no standard library.
    std::fs::write(folder.join("exports.rs"), format!("#![no_std]\n{modules}")).unwrap();
    compile(rustc(&folder).args([
        "--crate-type",
        "rlib",
        "-L",
        ".",
        "--extern",
        "holdup_control=libholdup_control.rlib",
        "exports.rs",
    ]));
    let main = include_str!("harness.rs").replace("f64", real).replace("        // the loops\n", &arms);
    let main = main.replace("u64", if real == "f32" { "u32" } else { "u64" });
    std::fs::write(folder.join("main.rs"), main.replace("WIDTH", if real == "f32" { "08" } else { "016" }))
        .unwrap();
    compile(rustc(&folder).args([
        "--extern",
        "exports=libexports.rlib",
        "-L",
        ".",
        "--extern",
        "holdup_control=libholdup_control.rlib",
        "main.rs",
    ]));

    let answered = answer(&mut Command::new(folder.join("main")), &all.told);
    must_agree(&format!("Rust {real}"), &all.told, &all.expected, &answered);
    println!("Rust {real}: {} exported controllers, {} updates: 0 bits differ", LOOPS.len(), all.updates);
}

#[test]
fn rust_in_double_precision_agrees_bit_for_bit() {
    rust_agrees_bit_for_bit::<f64>("f64");
}

#[test]
fn rust_in_single_precision_agrees_bit_for_bit() {
    rust_agrees_bit_for_bit::<f32>("f32");
}
