//! Placeholder while building.
use super::{Export, Language};
pub(super) const LANGUAGE: Language = Language { id: "st", title: "", extension: "", write };
fn write(_: &Export) -> String { String::new() }
