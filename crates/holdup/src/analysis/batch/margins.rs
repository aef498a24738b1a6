//! Margins of many loops: in lanes where that is proven, one by one where it is not.

use rayon::prelude::*;

use super::super::frequency::{FrequencyError, Margins, margins};
use super::form::Settings;
use super::kernel::{self, Answers};
use super::lanes::WIDTH;
use crate::model::{ClosedLoop, Controller, Process, Radians, Seconds};

/// Loops that one thread takes at a time.
const SHARE: usize = 32 * WIDTH;

/// The numbers of [`Margins`] that tell how robust a loop is; of an unstable loop they are `None`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Robustness {
    /// Whether every closed-loop pole has a negative real part.
    pub stable: bool,
    /// Gain margin [–], as [`Margins::gain_margin`].
    pub gain_margin: Option<f64>,
    /// Lower gain margin [–], as [`Margins::gain_margin_low`].
    pub gain_margin_low: Option<f64>,
    /// Phase margin [rad], as [`Margins::phase_margin`].
    pub phase_margin: Option<Radians>,
    /// Delay margin [s], as [`Margins::delay_margin`].
    pub delay_margin: Option<Seconds>,
    /// Sensitivity peak `M_s` [–], as [`Margins::sensitivity_peak`].
    pub sensitivity_peak: Option<f64>,
}

impl From<&Margins> for Robustness {
    fn from(margins: &Margins) -> Self {
        Self {
            stable: margins.stable,
            gain_margin: margins.gain_margin,
            gain_margin_low: margins.gain_margin_low,
            phase_margin: margins.phase_margin,
            delay_margin: margins.delay_margin,
            sensitivity_peak: margins.sensitivity_peak,
        }
    }
}

/// The margins of many loops, in the order of the slice.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ManyMargins {
    /// Of each loop its margins.
    ///
    /// # Errors
    /// In each place [`FrequencyError`], as [`margins`] gives it for that loop.
    pub loops: Vec<Result<Robustness, FrequencyError>>,
    /// How many loops were analysed one by one, because the fast way did not apply or proved nothing [–].
    pub one_by_one: usize,
}

/// The margins of each of these controllers on one process.
///
/// Each result agrees with that of [`margins`] to 1e-9 (relative). Fast, some ten million loops a second and core, are
/// stable and unstable loops of an integrator with or without lag under P, PI, PD or PID control with 2·Td < Ti and the
/// sign of negative feedback, where they have no lower gain margin; all others take as long as [`margins`] does.
///
/// ```
/// use holdup::analysis::batch::margins_of_controllers;
/// use holdup::model::{Controller, Process, Seconds};
/// let process = Process::integrating(0.0506, Seconds(6.0))?;
/// let gains = [0.5, 1.0, 1.5, 2.0];
/// let controllers: Result<Vec<_>, _> =
///     gains.iter().map(|&gain| Controller::proportional(gain)?.with_integral_time(Seconds(48.0))).collect();
/// let found = margins_of_controllers(&process, &controllers?);
/// let peaks: Vec<f64> = found.loops.iter().flatten().filter_map(|found| found.sensitivity_peak).collect();
/// assert_eq!(peaks.len(), 4);
/// assert!(peaks[1] < peaks[2] && peaks[2] < peaks[3]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn margins_of_controllers(process: &Process, controllers: &[Controller]) -> ManyMargins {
    many(controllers.len(), |i| (process, &controllers[i]))
}

/// The margins of one controller on each of these processes; see [`margins_of_controllers`].
///
/// ```
/// use holdup::analysis::batch::margins_of_processes;
/// use holdup::model::{Controller, Process, Seconds};
/// let pi = Controller::proportional(1.6)?.with_integral_time(Seconds(48.0))?;
/// let nominal = Process::integrating(0.0506, Seconds(6.0))?;
/// let processes = [nominal, nominal.perturbed(1.2, 1.2)?, nominal.perturbed(1.2, 3.0)?];
/// let found = margins_of_processes(&processes, &pi);
/// let stable: Vec<bool> = found.loops.iter().flatten().map(|found| found.stable).collect();
/// assert_eq!(stable, [true, true, false]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn margins_of_processes(processes: &[Process], controller: &Controller) -> ManyMargins {
    many(processes.len(), |i| (&processes[i], controller))
}

fn many<'a>(count: usize, of: impl Fn(usize) -> (&'a Process, &'a Controller) + Sync) -> ManyMargins {
    let nothing = Robustness {
        stable: false,
        gain_margin: None,
        gain_margin_low: None,
        phase_margin: None,
        delay_margin: None,
        sensitivity_peak: None,
    };
    let mut loops = vec![Ok(nothing); count];
    let share = |(number, places): (usize, &mut [Result<Robustness, FrequencyError>])| {
        let first = number * SHARE;
        fill(places, &|i| of(first + i))
    };
    let one_by_one = loops.par_chunks_mut(SHARE).enumerate().map(share).sum();
    ManyMargins { loops, one_by_one }
}

/// Fills the places; returns how many loops were analysed one by one.
fn fill<'a>(
    places: &mut [Result<Robustness, FrequencyError>],
    of: &impl Fn(usize) -> (&'a Process, &'a Controller),
) -> usize {
    let (mut again, mut alone) = (Vec::new(), Vec::new());
    for first in (0..places.len()).step_by(WIDTH) {
        let mut settings = Settings::default();
        let width = WIDTH.min(places.len() - first);
        let mut fits = [false; WIDTH];
        for lane in 0..width {
            let (process, controller) = of(first + lane);
            fits[lane] = settings.set(lane, process, controller);
        }
        let answers = kernel::quick(&settings);
        for lane in 0..width {
            let place = first + lane;
            if !fits[lane] {
                alone.push(place);
            } else if let Some(found) = robustness(&answers, lane, settings.dead_time[lane]) {
                places[place] = Ok(found);
            } else {
                again.push(place);
            }
        }
    }
    for block in again.chunks(WIDTH) {
        let mut settings = Settings::default();
        for (lane, &place) in block.iter().enumerate() {
            let (process, controller) = of(place);
            settings.set(lane, process, controller);
        }
        let answers = kernel::thorough(&settings);
        for (lane, &place) in block.iter().enumerate() {
            match robustness(&answers, lane, settings.dead_time[lane]) {
                Some(found) => places[place] = Ok(found),
                None => alone.push(place),
            }
        }
    }
    for &place in &alone {
        let (process, controller) = of(place);
        places[place] =
            margins(&ClosedLoop::new(process, controller)).map(|margins| Robustness::from(&margins));
    }
    alone.len()
}

/// The answer for one lane, where it is proven.
fn robustness(answers: &Answers, lane: usize, dead_time: f64) -> Option<Robustness> {
    if answers.decided[lane] == 0.0 {
        return None;
    }
    let stable = answers.phase[lane] > 0.0;
    if stable && answers.proven[lane] == 0.0 {
        return None;
    }
    let when_stable = |value: f64| stable.then_some(value);
    Some(Robustness {
        stable,
        gain_margin: when_stable(answers.gain[lane]),
        gain_margin_low: None,
        phase_margin: when_stable(answers.phase[lane]).map(Radians),
        delay_margin: when_stable(answers.delay[lane] * dead_time).map(Seconds),
        sensitivity_peak: when_stable(answers.peak[lane]),
    })
}
