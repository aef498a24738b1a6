//! Style police: the allowed edges between the crates and between the rooms of the library.

use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Crate, and the crates of this workspace it may depend on.
const EDGES: [(&str, &[&str]); 4] = [
    ("holdup-control", &[]),
    ("holdup", &["holdup-control"]),
    ("holdup-cli", &["holdup", "holdup-control"]),
    ("holdup-python", &["holdup", "holdup-control"]),
];

/// Rooms of the library from top to bottom: a room uses the rooms above it, never one below.
const ROOMS: [&str; 6] = ["model", "analysis", "tuning", "record", "study", "deploy"];

#[test]
fn crates_depend_on_each_other_only_along_the_allowed_edges() {
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--no-deps", "--offline"])
        .current_dir(root())
        .output()
        .unwrap();
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let packages = metadata["packages"].as_array().unwrap();
    assert!(!packages.is_empty());
    for package in packages {
        let name = package["name"].as_str().unwrap();
        let (_, allowed) = EDGES
            .iter()
            .find(|(from, _)| *from == name)
            .unwrap_or_else(|| panic!("{name} is a crate that EDGES does not know"));
        for dependency in package["dependencies"].as_array().unwrap() {
            let on = dependency["name"].as_str().unwrap();
            if EDGES.iter().any(|(known, _)| *known == on) {
                assert!(allowed.contains(&on), "{name} must not depend on {on}");
            }
            if name == "holdup-control" {
                assert_eq!(dependency["kind"], "dev", "holdup-control must not depend on {on}");
            }
        }
    }
}

#[test]
fn rooms_use_only_the_rooms_above_them() {
    let source = root().join("crates/holdup/src");
    for (index, room) in ROOMS.iter().enumerate() {
        let Ok(files) = rust_files(&source.join(room)) else { continue };
        for file in files {
            let text = std::fs::read_to_string(&file).unwrap();
            for (number, line) in text.lines().enumerate() {
                for below in &ROOMS[index + 1..] {
                    let path = format!("crate::{below}");
                    assert!(
                        !line.trim_start().starts_with("use ") || !line.contains(&path),
                        "{}:{}: the room {room} uses the room {below} below it: {line}",
                        file.display(),
                        number + 1
                    );
                }
            }
        }
    }
}

#[test]
fn no_source_file_is_longer_than_600_lines() {
    for folder in ["crates", "fuzz", "examples"] {
        for file in rust_files(&root().join(folder)).unwrap_or_default() {
            let lines = std::fs::read_to_string(&file).unwrap().lines().count();
            assert!(lines <= 600, "{} has {lines} lines: split it", file.display());
        }
    }
}

fn rust_files(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() && path.file_name().is_some_and(|n| n != "target") {
            found.extend(rust_files(&path)?);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    Ok(found)
}
