//! The Rust and the C export on an emulated Cortex-M4 (`./check --full`): without the standard library, `f64` by
//! software, `f32` by the floating-point unit.
//!
//! Needs Debian's rustc-web, rust-web-src, gcc-arm-none-eabi and qemu-system-arm (254 MB): skipped where one is absent.

use std::path::Path;
use std::process::{Command, Stdio};

use holdup::deploy::export::language;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::sources::{LOOPS, compile, export, folder, given, must_agree};
use crate::trace::{Real, Trace};

/// A rustc whose own core library is there as source.
const RUSTC: &str = "/usr/bin/rustc";
const TARGET: &str = "thumbv7em-none-eabihf";
const ARM: [&str; 6] =
    ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", "-ffreestanding", "-O2"];

const FILES: [(&str, &str); 4] = [
    ("firmware.h", include_str!("cortex_m4/firmware.h")),
    ("startup.c", include_str!("cortex_m4/startup.c")),
    ("link.ld", include_str!("cortex_m4/link.ld")),
    ("loop_in_c.c", include_str!("cortex_m4/loop_in_c.c")),
];

/// What of the tools is absent.
fn absent() -> Option<&'static str> {
    let runs = |program: &str| {
        let asked =
            Command::new(program).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        asked.is_ok_and(|status| status.success())
    };
    if !runs(RUSTC) || !Path::new("/usr/lib/rustlib/src/rust/library/core").exists() {
        return Some("rustc-web and rust-web-src");
    }
    [("arm-none-eabi-gcc", "gcc-arm-none-eabi"), ("qemu-system-arm", "qemu-system-arm")]
        .into_iter()
        .find_map(|(program, package)| (!runs(program)).then_some(package))
}

fn arm_gcc(folder: &Path, digits: &str) -> Command {
    let mut command = Command::new("arm-none-eabi-gcc");
    command.args(ARM).args([
        "-ffp-contract=off",
        "-fno-tree-loop-distribute-patterns",
        "-nostdlib",
        "-Wl,-z,noexecstack",
    ]);
    command.arg(format!("-DDIGITS={digits}")).args(["-T", "link.ld", "startup.c"]).current_dir(folder);
    command
}

/// What the image answers.
fn emulated(folder: &Path, image: &str) -> String {
    let output = Command::new("timeout")
        .args([
            "120",
            "qemu-system-arm",
            "-M",
            "mps2-an386",
            "-cpu",
            "cortex-m4",
            "-nographic",
            "-monitor",
            "none",
        ])
        .args([
            "-serial",
            "null",
            "-chardev",
            "stdio,id=told",
            "-semihosting-config",
            "enable=on,chardev=told",
        ])
        .args(["-kernel", image])
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    assert!(output.status.success(), "{image}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The static library of a Rust export, its core library built for the target.
fn rust_library(folder: &Path, real: &str, bits: &str) {
    let control = Path::new(env!("CARGO_MANIFEST_DIR")).join("../control");
    let manifest = format!(
        "[package]\nname = \"firmware\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[lib]\ncrate-type = [\"staticlib\"]\n\
         [dependencies]\nholdup-control = {{ path = \"{}\" }}\n[profile.release]\npanic = \"abort\"\n[workspace]\n",
        control.display()
    );
    std::fs::create_dir_all(folder.join("src")).unwrap();
    std::fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    std::fs::rename(folder.join("exported.rs"), folder.join("src/exported.rs")).unwrap();
    let main = include_str!("cortex_m4/loop_in_rust.rs");
    let main = main.replace("type Real = f64", &format!("type Real = {real}"));
    std::fs::write(
        folder.join("src/lib.rs"),
        main.replace("type Bits = u64", &format!("type Bits = {bits}")),
    )
    .unwrap();
    compile(
        Command::new(env!("CARGO"))
            .args(["build", "--quiet", "--release", "--target", TARGET, "-Zbuild-std=core,panic_abort"])
            .env("RUSTC", RUSTC)
            .env("RUSTC_BOOTSTRAP", "1")
            .env_remove("RUSTUP_TOOLCHAIN")
            // One for all, so that the core library is built once.
            .env("CARGO_TARGET_DIR", folder.join("../cortex-m4-target"))
            .current_dir(folder),
    );
}

fn the_cortex_m4_agrees_bit_for_bit<T: Real>(real: &str, bits: &str) {
    if let Some(package) = absent() {
        println!("SKIPPED: Cortex-M4: {package} is not installed");
        return;
    }
    let digits = if size_of::<T>() == 4 { "8" } else { "16" };
    let c_real = if size_of::<T>() == 4 {
        ["-DREAL=float", "-DBITS=uint32_t"]
    } else {
        ["-DREAL=double", "-DBITS=uint64_t"]
    };
    let (chosen, mut updates) = ([0, 1, 2, 7], 0);
    for index in chosen {
        let (export, scale) = export("loop", LOOPS[index], T::FLOAT);
        let folder = folder(&format!("cortex-m4-{real}-{index}"));
        let mut trace = Trace::default();
        let mut rng = ChaCha8Rng::seed_from_u64(300 + index as u64);
        for _ in 0..2 {
            trace.run::<T>(&mut rng, scale, given(&export), &[], export.segments().max(1), 1000);
        }
        for (name, text) in FILES {
            std::fs::write(folder.join(name), text).unwrap();
        }
        std::fs::write(folder.join("trace"), &trace.told).unwrap();
        std::fs::write(folder.join("loop.c"), language("c").unwrap().write(&export)).unwrap();
        std::fs::write(folder.join("exported.rs"), language("rust").unwrap().write(&export)).unwrap();

        compile(arm_gcc(&folder, digits).args(c_real).args([
            "loop_in_c.c",
            "loop.c",
            "-lgcc",
            "-o",
            "c.elf",
        ]));
        let answered = emulated(&folder, "c.elf");
        must_agree(&format!("C {real} on the Cortex-M4"), &trace.told, &trace.expected, &answered);

        rust_library(&folder, real, bits);
        let library = folder.join(format!("../cortex-m4-target/{TARGET}/release/libfirmware.a"));
        compile(arm_gcc(&folder, digits).arg(library).args(["-lgcc", "-o", "rust.elf"]));
        let answered = emulated(&folder, "rust.elf");
        must_agree(&format!("Rust {real} on the Cortex-M4"), &trace.told, &trace.expected, &answered);
        updates += trace.updates;
    }
    println!(
        "Cortex-M4 {real}: {} exported controllers, {updates} updates, Rust and C: 0 bits differ",
        chosen.len()
    );
}

#[test]
#[ignore = "builds a core library and needs an emulator: ./check --full"]
fn the_cortex_m4_agrees_bit_for_bit_in_both_precisions() {
    the_cortex_m4_agrees_bit_for_bit::<f32>("f32", "u32");
    the_cortex_m4_agrees_bit_for_bit::<f64>("f64", "u64");
}
