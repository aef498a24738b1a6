//! Which limits exclude each other, and how far one has to give way.

use std::fmt;

use super::design::Design;
use super::limits::{Limit, Limits, Quantity};
use super::objective::Objective;
use super::progress::Progress;
use super::search::{Nothing, find};

/// Limits that no controller of the structure keeps together.
#[derive(Debug, Clone, PartialEq)]
pub struct Conflict {
    /// The structure.
    pub structure: &'static str,
    /// Every limit that, left out, lets the others be kept; with its nearest feasible value where the others stay. All limits
    /// where no single one is to blame.
    pub limits: Vec<(Limit, Option<f64>)>,
}

impl fmt::Display for Conflict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no {} controller keeps these limits together: ", self.structure)?;
        for (index, (limit, nearest)) in self.limits.iter().enumerate() {
            write!(f, "{}{limit}", if index == 0 { "" } else { ", " })?;
            if let Some(nearest) = nearest {
                let shown = limit.quantity.shown(*nearest);
                write!(
                    f,
                    " (the nearest that the others allow is {})",
                    rounded(shown, limit.quantity.is_greatest())
                )?;
            }
        }
        Ok(())
    }
}

/// Five digits, on the side that is feasible.
fn rounded(value: f64, up: bool) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    #[expect(clippy::cast_possible_truncation, reason = "an exponent")]
    let scale = 10.0_f64.powi(4 - value.abs().log10().floor() as i32);
    let scaled = value * scale;
    (if up { scaled.ceil() } else { scaled.floor() }) / scale
}

/// Why nothing was found.
pub(super) fn conflict(design: &Design, limits: &Limits, known: Nothing) -> Conflict {
    let nearest = |limit: &Limit| {
        if let (Quantity::SetpointSettlingTime, Nothing::Settles(known)) = (limit.quantity, known) {
            return known;
        }
        let others = limits.clone().without(limit.quantity);
        let found = find(design, Objective::Extreme(limit.quantity), &others, &Progress::silent()).ok()?;
        let value = found.best.value;
        Some(if limit.quantity.is_greatest() { value } else { -value })
    };
    let found: Vec<(Limit, Option<f64>)> =
        limits.list().iter().map(|limit| (*limit, nearest(limit))).collect();
    let to_blame: Vec<(Limit, Option<f64>)> =
        found.iter().filter(|(_, nearest)| nearest.is_some()).copied().collect();
    Conflict {
        structure: design.structure.name(),
        limits: if to_blame.is_empty() { found } else { to_blame },
    }
}
