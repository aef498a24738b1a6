//! Structured Text of IEC 61131-3: a function block with its types and functions.

use super::template::{Value, decimal, fill};
use super::{Export, Float, Language};

pub(super) const LANGUAGE: Language =
    Language { id: "st", title: "Structured Text (IEC 61131-3), a function block", extension: "st", write };

/// The parts of the file, in their order: what is used stands before what uses it.
const TEMPLATE: [&str; 4] = [
    include_str!("templates/types.st"),
    include_str!("templates/functions.st"),
    include_str!("templates/settings.st"),
    include_str!("templates/block.st"),
];

pub(super) fn write(export: &Export) -> String {
    let float = export.installation.float;
    let (real, real_max) = match float {
        Float::Single => ("REAL", f64::from(f32::MAX)),
        Float::Double => ("LREAL", f64::MAX),
    };
    let mut marks = export.marks();
    marks.extend([("real", Value::Text(real.to_owned())), ("real_max", Value::Number(real_max))]);
    fill(&TEMPLATE.concat(), &marks, |value| match value {
        Value::Number(number) => decimal(*number, float),
        // The value of an absent term is not looked at.
        Value::Optional(number) => decimal(number.unwrap_or(0.0), float),
        Value::Flag(flag) => flag.to_string().to_ascii_uppercase(),
        Value::Text(text) => text.clone(),
    })
}
