//! C99: one file, no library, no allocation.

use super::template::{Value, fill, hexadecimal};
use super::{Export, Float, Language};

pub(super) const LANGUAGE: Language =
    Language { id: "c", title: "C99, one file without dependencies", extension: "c", write };

/// The parts of the file, in their order.
const TEMPLATE: [&str; 4] = [
    include_str!("templates/c/declarations.c"),
    include_str!("templates/c/terms.c"),
    include_str!("templates/c/settings.c"),
    include_str!("templates/c/update.c"),
];

fn write(export: &Export) -> String {
    let float = export.installation.float;
    let (real, real_max) = match float {
        Float::Single => ("float", "FLT_MAX"),
        Float::Double => ("double", "DBL_MAX"),
    };
    let mut marks = export.marks();
    marks.extend([("real", Value::Text(real.to_owned())), ("real_max", Value::Text(real_max.to_owned()))]);
    fill(&TEMPLATE.concat(), &marks, |value| match value {
        Value::Number(number) => hexadecimal(*number, float),
        // The value of an absent term is not looked at.
        Value::Optional(number) => hexadecimal(number.unwrap_or(0.0), float),
        Value::Flag(flag) => flag.to_string(),
        Value::Text(text) => text.clone(),
    })
}
