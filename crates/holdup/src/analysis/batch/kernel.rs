//! Margins of a block of loops, in lanes, on the instruction set of the machine that runs it.

use super::crossovers::Crossovers;
use super::form::{Forms, Settings};
use super::lanes::{Lanes, WIDTH};
use super::mesh::{COARSE, FINE, Mesh};
use super::peak::Peaks;

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

/// The answers for these loops by few steps and the coarse mesh.
pub(super) fn quick(settings: &Settings) -> Answers {
    block(settings, &COARSE, &Effort { gain: 3, phase: 2, peak: 2, stride: 2 })
}

/// The answers by more steps, from closer starts, on the fine mesh.
pub(super) fn thorough(settings: &Settings) -> Answers {
    block(settings, &FINE, &Effort { gain: 12, phase: 8, peak: 2, stride: 2 })
}

#[multiversion::multiversion(targets("x86_64+avx512f", "x86_64+avx2"))]
fn block(settings: &Settings, mesh: &Mesh, effort: &Effort) -> Answers {
    let forms = Forms::new(settings);
    let at = Crossovers::new(&forms, effort);
    let peaks = Peaks::new(&forms, &at, mesh, effort);
    let mut answers = Answers {
        decided: at.decided,
        proven: peaks.proven,
        phase: at.phase,
        delay: [0.0; WIDTH],
        gain: at.margin,
        peak: [0.0; WIDTH],
    };
    for i in 0..WIDTH {
        answers.delay[i] = at.phase[i] / at.gain[i];
        answers.peak[i] = 1.0 / peaks.squared[i].sqrt();
    }
    answers
}
