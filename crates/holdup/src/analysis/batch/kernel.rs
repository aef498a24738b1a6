//! Margins of a block of loops, in lanes, on the instruction set of the machine that runs it.

use super::crossovers::Crossovers;
use super::form::{Forms, Settings};
use super::lanes::{Lanes, WIDTH};
use super::mesh::{COARSE, FINE, Mesh};
use super::peak::Peaks;
use crate::analysis::widest;

/// What is known of a block of loops.
pub(super) struct Answers {
    /// 1 where gain crossover and verdict are proven.
    pub(super) decided: Lanes,
    /// 1 where all else is proven, too; of stable loops only.
    pub(super) proven: Lanes,
    /// φ at the gain crossover: a loop is stable where it is positive, and then it is the phase margin [rad].
    pub(super) phase: Lanes,
    /// Delay margin, in dead times.
    pub(super) delay: Lanes,
    /// Gain margin.
    pub(super) gain: Lanes,
    /// Sensitivity peak.
    pub(super) peak: Lanes,
    /// Complementary sensitivity peak, where it is asked for; else 0.
    pub(super) complementary_peak: Lanes,
}

/// How much is done for each answer.
pub(super) struct Effort {
    /// Steps of Newton's method for the gain crossover.
    pub(super) gain: usize,
    /// Steps of Halley's method for the phase crossover.
    pub(super) phase: usize,
    /// Steps of Newton's method for the sensitivity peak, but one.
    pub(super) peak: usize,
    /// Every how many places of the mesh the peak is looked for.
    pub(super) stride: usize,
}

/// The answers for these loops by few steps and the coarse mesh; with both peaks, or that of the sensitivity alone.
pub(super) fn quick(settings: &Settings, both: bool) -> Answers {
    block(settings, &COARSE, &Effort { gain: 3, phase: 2, peak: 2, stride: 2 }, both)
}

/// The answers by more steps, from closer starts, on the fine mesh.
pub(super) fn thorough(settings: &Settings, both: bool) -> Answers {
    block(settings, &FINE, &Effort { gain: 12, phase: 8, peak: 2, stride: 2 }, both)
}

fn block(settings: &Settings, mesh: &Mesh, effort: &Effort, both: bool) -> Answers {
    widest(
        #[inline(always)]
        || {
            let forms = Forms::new(settings);
            let at = Crossovers::new(&forms, effort);
            let peaks = Peaks::new::<false>(&forms, &at, mesh, effort);
            let mut answers = Answers {
                decided: at.decided,
                proven: peaks.proven,
                phase: at.phase,
                delay: [0.0; WIDTH],
                gain: at.margin,
                peak: [0.0; WIDTH],
                complementary_peak: [0.0; WIDTH],
            };
            for i in 0..WIDTH {
                answers.delay[i] = at.phase[i] / at.gain[i];
                answers.peak[i] = 1.0 / peaks.squared[i].sqrt();
            }
            if both {
                let peaks = Peaks::new::<true>(&forms, &at, mesh, effort);
                for i in 0..WIDTH {
                    answers.proven[i] *= peaks.proven[i];
                    answers.complementary_peak[i] = 1.0 / peaks.squared[i].sqrt();
                }
            }
            answers
        },
    )
}
