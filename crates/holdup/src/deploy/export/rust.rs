//! Rust: a module on `holdup-control`, without the standard library.

use super::template::{Value, decimal, fill};
use super::{Export, Float, Language};

pub(super) const LANGUAGE: Language =
    Language { id: "rust", title: "Rust, a no_std module on holdup-control", extension: "rs", write };

fn write(export: &Export) -> String {
    let float = export.installation.float;
    let real = match float {
        Float::Single => "f32",
        Float::Double => "f64",
    };
    let mut marks = export.marks();
    marks.push(("real", Value::Text(real.to_owned())));
    fill(include_str!("templates/controller.rs"), &marks, |value| match value {
        Value::Number(number) => decimal(*number, float),
        Value::Optional(Some(number)) => format!("Some({})", decimal(*number, float)),
        Value::Optional(None) => "None".to_owned(),
        Value::Flag(flag) => flag.to_string(),
        Value::Text(text) => text.clone(),
    })
}
