//! What a loop achieves: its margins, crossovers and peaks.

use std::f64::consts::{PI, TAU};

use serde::ser::{Serialize, SerializeStruct, Serializer};

use super::characteristic::Characteristic;
use super::envelope::{Envelope, Steady};
use super::error::FrequencyError;
use super::functions::{Curve, Functions};
use super::lifted::Lifted;
use super::scan::{Findings, LISTED, Scan};
use super::winding::{self, Uncounted};
use crate::model::{ClosedLoop, Radians, Seconds};

/// Bands of an octave through which Δ is followed before the verdict is given up.
const WORK: usize = 400_000;

/// What a loop achieves, broken at the process input: stability, margins, crossovers and peaks.
///
/// Gain and dead time vary in the process alone: an observer keeps its model. Made by [`margins`] only. Of an unstable loop the margins and peaks are `None`, the crossovers are listed.
/// Serialises with the names and units of the JSON contract; the warnings are not part of that.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Margins {
    /// Whether every closed-loop pole has a negative real part; a pole on the imaginary axis is not stable.
    pub stable: bool,
    /// Gain margin [–]: the smallest factor greater than 1 on the loop gain at which stability is lost; that of
    /// a neutral loop is at most `1/high_frequency_gain`.
    pub gain_margin: Option<f64>,
    /// Lower gain margin [–]: the largest factor less than 1 at which stability is lost.
    pub gain_margin_low: Option<f64>,
    /// Phase margin [rad], in (−π, π]: the one of smallest modulus over all gain crossovers.
    pub phase_margin: Option<Radians>,
    /// Delay margin [s]: the smallest extra dead time of the process at which stability is lost.
    pub delay_margin: Option<Seconds>,
    /// Lower delay margin [s]: the smallest cut of the dead time of the process at which stability is lost;
    /// `None` where the loop stays stable down to no dead time at all.
    pub delay_margin_low: Option<Seconds>,
    /// Gain crossovers [rad/s], |L| = 1, in rising order.
    pub gain_crossovers: Vec<f64>,
    /// Phase crossovers [rad/s], L real and negative, in rising order: the first 32 of infinitely many. The
    /// gain margins consider them all.
    pub phase_crossovers: Vec<f64>,
    /// Frequency [rad/s] up to which that list is complete; `None` where it holds them all.
    pub phase_crossovers_complete_to: Option<f64>,
    /// Sensitivity peak `M_s` [–], the supremum of |1/(1 + L)|.
    pub sensitivity_peak: Option<f64>,
    /// Frequency of the sensitivity peak [rad/s], one of them where peaks agree to 1e-11; `None` where it is a limit that no frequency attains.
    pub sensitivity_peak_frequency: Option<f64>,
    /// Complementary sensitivity peak `M_t` [–], the supremum of |L/(1 + L)|.
    pub complementary_sensitivity_peak: Option<f64>,
    /// Frequency of the complementary peak [rad/s]; `None` where it is a limit that no frequency attains.
    pub complementary_sensitivity_peak_frequency: Option<f64>,
    /// High-frequency gain |L(j∞)| [–]: K·Kc·Td of an unfiltered derivative on the plain integrator, else 0.
    pub high_frequency_gain: f64,
    /// Number of closed-loop poles with positive real part; `None` where one lies on the imaginary axis,
    /// where there are infinitely many or where they could not be counted: the warnings say which.
    pub unstable_poles: Option<usize>,
    /// What a reader of the numbers has to know, one sentence each.
    pub warnings: Vec<String>,
}

/// The margins of a closed loop.
///
/// ```
/// use holdup::analysis::frequency::margins;
/// use holdup::model::{ClosedLoop, Controller, Process, Seconds};
/// let process = Process::integrating(0.0506, Seconds(6.0))?;
/// let simc = Controller::proportional(0.5 / (0.0506 * 6.0))?.with_integral_time(Seconds(48.0))?;
/// let achieved = margins(&ClosedLoop::new(&process, &simc))?;
/// assert!(achieved.stable);
/// assert!((achieved.gain_margin.unwrap() - 2.96340).abs() < 5e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FrequencyError`] if the numbers of the loop are out of the reach of double precision. An unstable loop is
/// not an error.
pub fn margins(closed_loop: &ClosedLoop) -> Result<Margins, FrequencyError> {
    let characteristic = Characteristic::new(closed_loop)?;
    let envelope = Envelope::new(&characteristic);
    let functions = Functions::new(&characteristic);
    let unstable_poles = winding::unstable_poles(&characteristic, &envelope, WORK);
    let stable = unstable_poles == Ok(0);
    let limit = characteristic.high_frequency_gain;
    let steady = Steady::new(&characteristic);
    let lifted = Lifted::new(&characteristic);
    let found = Scan::new(&functions, &envelope, &steady, lifted.as_ref(), limit, stable).run();
    Ok(assemble(&characteristic, &functions, &found, unstable_poles))
}

fn assemble(
    characteristic: &Characteristic,
    functions: &Functions,
    found: &Findings,
    unstable_poles: Result<usize, Uncounted>,
) -> Margins {
    let d = characteristic.dead_time;
    let stable = unstable_poles == Ok(0);
    let in_seconds = |list: &[f64]| list.iter().map(|omega| omega / d).collect::<Vec<_>>();
    let when_stable = |value: Option<f64>| value.filter(|_| stable);
    let phases: Vec<(f64, f64)> = found
        .gain_crossovers
        .iter()
        .map(|&omega| {
            let direction = functions.direction(omega)[0];
            (omega, (-direction).arg())
        })
        .collect();
    // Extra dead time turns L clockwise, a cut counterclockwise, until it points at −1.
    let least = |turn: fn(f64) -> f64| {
        phases.iter().map(|&(omega, phase)| turn(phase) / omega).min_by(f64::total_cmp)
    };
    let delay = least(|phase| phase.rem_euclid(TAU));
    let cut = least(|phase| (-phase).rem_euclid(TAU)).filter(|&dead_times| dead_times <= 1.0);
    let phase = phases.iter().map(|p| p.1).min_by(|a, b| a.abs().total_cmp(&b.abs()));
    // The closed end of (−π, π] is the upper one.
    let phase = phase.map(|phase| if phase <= -PI { PI } else { phase });
    let peak_at = |omega: Option<f64>| when_stable(omega.map(|omega| omega / d));
    Margins {
        stable,
        gain_margin: when_stable((found.below_one > 0.0).then(|| 1.0 / found.below_one)),
        gain_margin_low: when_stable(found.above_one.map(|gain| 1.0 / gain)),
        phase_margin: when_stable(phase).map(Radians),
        delay_margin: when_stable(delay).map(|dead_times| Seconds(dead_times * d)),
        delay_margin_low: when_stable(cut).map(|dead_times| Seconds(dead_times * d)),
        gain_crossovers: in_seconds(&found.gain_crossovers),
        phase_crossovers: in_seconds(&found.phase_crossovers),
        phase_crossovers_complete_to: found
            .phase_crossovers
            .last()
            .filter(|_| found.phase_crossovers.len() >= LISTED)
            .map(|last| last / d),
        sensitivity_peak: when_stable(Some(found.sensitivity.value)),
        sensitivity_peak_frequency: peak_at(found.sensitivity.omega),
        complementary_sensitivity_peak: when_stable(Some(found.complementary.value)),
        complementary_sensitivity_peak_frequency: peak_at(found.complementary.omega),
        high_frequency_gain: characteristic.high_frequency_gain,
        unstable_poles: unstable_poles.ok(),
        warnings: warnings(characteristic, found, unstable_poles),
    }
}

fn warnings(
    characteristic: &Characteristic,
    found: &Findings,
    unstable_poles: Result<usize, Uncounted>,
) -> Vec<String> {
    let limit = characteristic.high_frequency_gain;
    let mut sentences = Vec::new();
    match unstable_poles {
        Ok(0) => {}
        Ok(1) => sentences
            .push("The loop is unstable: 1 closed-loop pole in the right half plane; it has no margins.".into()),
        Ok(n) => sentences
            .push(format!("The loop is unstable: {n} closed-loop poles in the right half plane; it has no margins.")),
        Err(Uncounted::Infinite) => sentences.push(format!(
            "The loop is unstable: its gain at infinite frequency is {limit}, and 1 or more makes infinitely many unstable poles; it has no margins."
        )),
        Err(Uncounted::OnAxis) => sentences.push(
            "The loop is not stable: a closed-loop pole lies on the imaginary axis, or too near to tell; it has no margins.".into(),
        ),
        Err(Uncounted::GivenUp) => sentences.push(
            "The loop is not proven stable: its frequencies reach too far beyond its dead time to be followed; no margins are given.".into(),
        ),
    }
    if unstable_poles == Ok(0) {
        if found.gain_crossovers.is_empty() {
            sentences.push("The loop gain never is 1: phase margin and delay margin are infinite.".into());
        }
        if found.below_one == 0.0 {
            sentences
                .push("No greater loop gain makes the loop unstable: the gain margin is infinite.".into());
        }
        for (name, peak) in
            [("sensitivity", found.sensitivity), ("complementary sensitivity", found.complementary)]
        {
            if peak.omega.is_none() {
                sentences.push(format!(
                    "The {name} peak is the limit at infinite frequency; no finite frequency attains it."
                ));
            }
        }
    }
    if let Some(omega) = found.unfinished_from {
        let omega = omega / characteristic.dead_time;
        sentences.push(format!(
            "The search was given up at {omega:e} rad/s: crossovers and peaks beyond it are not proven absent."
        ));
    }
    sentences
}

impl Serialize for Margins {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut s = serializer.serialize_struct("Margins", 14)?;
        s.serialize_field("stable", &self.stable)?;
        s.serialize_field("gain_margin", &self.gain_margin)?;
        s.serialize_field("gain_margin_low", &self.gain_margin_low)?;
        s.serialize_field("phase_margin_deg", &self.phase_margin.map(Radians::degrees))?;
        s.serialize_field("delay_margin_s", &self.delay_margin.map(|t| t.0))?;
        s.serialize_field("delay_margin_low_s", &self.delay_margin_low.map(|t| t.0))?;
        s.serialize_field("gain_crossovers_rad_s", &self.gain_crossovers)?;
        s.serialize_field("phase_crossovers_rad_s", &self.phase_crossovers)?;
        s.serialize_field("phase_crossovers_complete_to_rad_s", &self.phase_crossovers_complete_to)?;
        s.serialize_field("sensitivity_peak", &self.sensitivity_peak)?;
        s.serialize_field("sensitivity_peak_rad_s", &self.sensitivity_peak_frequency)?;
        s.serialize_field("complementary_sensitivity_peak", &self.complementary_sensitivity_peak)?;
        s.serialize_field(
            "complementary_sensitivity_peak_rad_s",
            &self.complementary_sensitivity_peak_frequency,
        )?;
        s.serialize_field("high_frequency_gain", &self.high_frequency_gain)?;
        s.end()
    }
}
