//! Placeholder while building.
use super::{Export, Language};
pub(super) const LANGUAGE: Language = Language { id: "plcopen", title: "", extension: "", write };
fn write(_: &Export) -> String { String::new() }
