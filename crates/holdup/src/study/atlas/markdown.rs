//! The atlas as a Markdown file: `docs/atlas.md`.

use std::fmt::Write;

use super::{Atlas, AtlasRule, FIGURES, process_words};
use crate::tuning::Applies;

const HEAD: &str = "# The rule atlas

Generated from the registry by `cargo test --test atlas`; do not edit.

Every rule with the defaults of its parameters on the normalised process. Integrals are those of unit steps over all
time; % is the share of the best possible, 100 being what no controller beats; – is infinite or absent. The loop is
broken at the process input. A rule with * is dominated: another recommended rule of the same table is nowhere worse in
both IAE, M_s and noise gain, and somewhere better. *Published* says how many of the values that its source prints are
reproduced. `holdup rules ID` shows the page of one rule, `holdup rules --report atlas.html` the atlas with its plane.
";

/// Writes the atlas. The same rules give the same bytes.
///
/// ```
/// use holdup::study::atlas::{Atlas, markdown};
/// let text = markdown::markdown(&Atlas::of(|entry| entry.id == "pi-simc"));
/// assert!(text.contains("| pi-simc | PI | Skogestad 2003 | 16.00 |"));
/// ```
#[must_use]
pub fn markdown(atlas: &Atlas) -> String {
    let mut text = HEAD.to_owned();
    for applies in Applies::ALL {
        let rules: Vec<&AtlasRule> =
            atlas.rules.iter().filter(|rule| rule.entry.process == applies).collect();
        if rules.is_empty() {
            continue;
        }
        // Writing to a string cannot fail.
        let _ = write!(text, "\n## {}\n\n| rule | structure | source |", process_words(applies));
        for name in FIGURES {
            text += &format!(" {name} |");
        }
        text += " published | provenance | status |\n|---|---|---|";
        text += &"--:|".repeat(FIGURES.len());
        text += "---|---|---|\n";
        for rule in rules {
            text += &row(rule);
        }
    }
    let reasons: Vec<String> = atlas.rules.iter().filter_map(reason).collect();
    if !reasons.is_empty() {
        text += "\n## Not recommended, and why\n\n";
        text += &reasons.concat();
    }
    text
}

fn row(rule: &AtlasRule) -> String {
    let entry = rule.entry;
    let dominated = rule.figures.as_ref().is_ok_and(|rule| rule.dominated_by.is_some());
    let mark = if dominated { " \\*" } else { "" };
    let mut row = format!("| {}{mark} | {} | {} {} |", entry.id, entry.structure, entry.authors, entry.year);
    rule.figures().iter().for_each(|figure| row += &format!(" {figure} |"));
    row + &format!(" {} | {} | {} |\n", rule.verdict(), entry.provenance.text(), entry.status.word())
}

fn reason(rule: &AtlasRule) -> Option<String> {
    let why = rule.entry.status.reason()?;
    Some(format!("- `{}` ({}): {why}\n", rule.entry.id, rule.entry.status.word()))
}
