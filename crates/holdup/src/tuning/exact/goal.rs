//! One robustness that a whole loop must have, and how far a loop is from it.

use crate::analysis::frequency::Margins;
use crate::tuning::Specification;

/// One robustness that the whole loop must have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Goal {
    /// Sensitivity peak, > 1.
    SensitivityPeak(f64),
    /// Gain margin, > 1.
    GainMargin(f64),
    /// Phase margin [rad], > 0.
    PhaseMargin(f64),
}

impl Goal {
    /// How far the loop is from the goal, greater than 0 where it is less robust.
    pub(super) fn error(self, achieved: &Margins) -> f64 {
        if !achieved.stable {
            return f64::INFINITY;
        }
        match self {
            Self::SensitivityPeak(peak) => {
                achieved.sensitivity_peak.map_or(f64::INFINITY, |found| found - peak)
            }
            // Reciprocals: no gain margin at all is an infinite one.
            Self::GainMargin(margin) => achieved.gain_margin.map_or(0.0, |found| 1.0 / found) - 1.0 / margin,
            Self::PhaseMargin(margin) => achieved.phase_margin.map_or(-margin, |found| margin - found.0),
        }
    }

    /// What a loop with this error achieves.
    pub(super) fn achieved(self, error: f64) -> Specification {
        let none = Specification::default();
        match self {
            Self::SensitivityPeak(peak) => Specification { sensitivity_peak: Some(peak + error), ..none },
            Self::GainMargin(margin) => {
                Specification { gain_margin: Some(1.0 / (1.0 / margin + error)), ..none }
            }
            Self::PhaseMargin(margin) => Specification { phase_margin: Some(margin - error), ..none },
        }
    }
}
