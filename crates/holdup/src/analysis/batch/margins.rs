//! Margins of many loops: in lanes where that is proven, one by one where it is not.

use rayon::prelude::*;

use super::super::frequency::{FrequencyError, Margins, margins};
use super::form::Settings;
use super::kernel::{self, Answers};
use super::lanes::WIDTH;
use crate::model::{ClosedLoop, Controller, Process, Radians, Seconds};

/// Blocks that one thread takes at a time.
const SHARE: usize = 32;

/// An unstable loop has no margins.
const NOTHING: Robustness = Robustness {
    stable: false,
    gain_margin: None,
    gain_margin_low: None,
    phase_margin: None,
    delay_margin: None,
    sensitivity_peak: None,
    complementary_sensitivity_peak: None,
};

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
    /// Complementary sensitivity peak `M_t` [–], as [`Margins::complementary_sensitivity_peak`]; `None` also where only the
    /// margins and `M_s` were asked for.
    pub complementary_sensitivity_peak: Option<f64>,
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
            complementary_sensitivity_peak: margins.complementary_sensitivity_peak,
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

/// The margins and the sensitivity peak of each of these controllers on one process.
///
/// Each result agrees with that of [`margins`] to 1e-9 (relative). Fast, some million loops a second and core, are
/// loops of an integrator with or without lag under P, PI, PD or PID control with 2·Td < Ti and the
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
    many(controllers.len(), |i| (process, &controllers[i]), false)
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
    many(processes.len(), |i| (&processes[i], controller), false)
}

/// As [`margins_of_controllers`], with the peaks of sensitivity and complementary sensitivity.
///
/// Where `M_t` is that of low frequencies, 1, as with little proportional action alone, a loop is analysed by itself.
///
/// ```
/// use holdup::analysis::batch::robustness_of_controllers;
/// use holdup::model::{Controller, Process, Seconds};
/// let process = Process::integrating(0.0506, Seconds(6.0))?;
/// let pi = Controller::proportional(1.6)?.with_integral_time(Seconds(48.0))?;
/// let found = robustness_of_controllers(&process, &[pi]).loops[0]?;
/// assert!(found.complementary_sensitivity_peak < found.sensitivity_peak);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn robustness_of_controllers(process: &Process, controllers: &[Controller]) -> ManyMargins {
    many(controllers.len(), |i| (process, &controllers[i]), true)
}

/// As [`margins_of_processes`], with the peaks of sensitivity and complementary sensitivity; see
/// [`robustness_of_controllers`].
///
/// ```
/// use holdup::analysis::batch::robustness_of_processes;
/// use holdup::model::{Controller, Process, Seconds};
/// let pi = Controller::proportional(1.6)?.with_integral_time(Seconds(48.0))?;
/// let nominal = Process::integrating(0.0506, Seconds(6.0))?;
/// let found = robustness_of_processes(&[nominal, nominal.perturbed(1.2, 1.2)?], &pi);
/// let peaks: Vec<_> =
///     found.loops.iter().flatten().filter_map(|found| found.complementary_sensitivity_peak).collect();
/// assert!(peaks[0] < peaks[1]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn robustness_of_processes(processes: &[Process], controller: &Controller) -> ManyMargins {
    many(processes.len(), |i| (&processes[i], controller), true)
}

/// The margins and the sensitivity peak of one loop, without its crossovers: as [`margins_of_controllers`] for a slice of
/// one, several times as fast as [`margins`] where the lanes apply. For a search that asks one loop after the other.
///
/// # Errors
/// [`FrequencyError`] as [`margins`].
///
/// ```
/// use holdup::analysis::batch::margins_of;
/// use holdup::model::{Controller, Process, Seconds};
/// let process = Process::integrating(0.0506, Seconds(6.0))?;
/// let pi = Controller::proportional(1.6)?.with_integral_time(Seconds(48.0))?;
/// assert!(margins_of(&process, &pi)?.sensitivity_peak < Some(1.7));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn margins_of(process: &Process, controller: &Controller) -> Result<Robustness, FrequencyError> {
    let mut settings = Settings::default();
    if settings.set(0, process, controller) {
        let answer = |answers: &Answers| robustness(answers, 0, process.dead_time());
        let quick = answer(&kernel::quick(&settings, false));
        if let Some(found) = quick.or_else(|| answer(&kernel::thorough(&settings, false))) {
            return Ok(found);
        }
    }
    exact(process, controller, false)
}

/// One result.
type Found = Result<Robustness, FrequencyError>;

/// Of a block of loops, one bit each: which need a closer look, and which the lanes are not made for.
#[derive(Clone, Copy, Default)]
struct Left {
    again: u32,
    alone: u32,
}

fn many<'a>(
    count: usize,
    of: impl Fn(usize) -> (&'a Process, &'a Controller) + Sync,
    both: bool,
) -> ManyMargins {
    let (mut blocks, mut left): (Vec<[Found; WIDTH]>, Vec<Left>) = (Vec::new(), Vec::new());
    let quick = |block: usize| {
        let first = block * WIDTH;
        quick(WIDTH.min(count - first), |lane| of(first + lane), both)
    };
    let all = (0..count.div_ceil(WIDTH)).into_par_iter().with_min_len(SHARE);
    all.map(quick).unzip_into_vecs(&mut blocks, &mut left);
    let mut loops = blocks.into_flattened();
    loops.truncate(count);

    let places = |bits: fn(&Left) -> u32| -> Vec<usize> {
        let of_block = |(block, left): (usize, &Left)| {
            let bits = bits(left);
            (0..WIDTH).filter(move |lane| bits >> lane & 1 == 1).map(move |lane| block * WIDTH + lane)
        };
        left.iter().enumerate().flat_map(of_block).collect()
    };
    let (again, mut alone) = (places(|left| left.again), places(|left| left.alone));
    let thorough = |block: &[usize]| thorough(block, &of, both);
    let closer: Vec<Option<Robustness>> = again.par_chunks(WIDTH).flat_map_iter(thorough).collect();
    for (&place, found) in again.iter().zip(closer) {
        match found {
            Some(found) => loops[place] = Ok(found),
            None => alone.push(place),
        }
    }
    let alone_of = |&place: &usize| {
        let (process, controller) = of(place);
        exact(process, controller, both)
    };
    let found: Vec<Found> = alone.par_iter().map(alone_of).collect();
    for (&place, found) in alone.iter().zip(found) {
        loops[place] = found;
    }
    ManyMargins { loops, one_by_one: alone.len() }
}

/// The answer by the exact analysis.
fn exact(process: &Process, controller: &Controller, both: bool) -> Found {
    let found = margins(&ClosedLoop::new(process, controller)).map(|margins| Robustness::from(&margins))?;
    let complementary = found.complementary_sensitivity_peak.filter(|_| both);
    Ok(Robustness { complementary_sensitivity_peak: complementary, ..found })
}

/// The answers of a block, so many of them, by few steps.
fn quick<'a>(
    width: usize,
    of: impl Fn(usize) -> (&'a Process, &'a Controller),
    both: bool,
) -> ([Found; WIDTH], Left) {
    let (mut settings, mut left) = (Settings::default(), Left::default());
    for lane in 0..width {
        let (process, controller) = of(lane);
        left.alone |= u32::from(!settings.set(lane, process, controller)) << lane;
    }
    let answers = kernel::quick(&settings, both);
    let mut found = [Ok(NOTHING); WIDTH];
    for lane in 0..width {
        match robustness(&answers, lane, settings.dead_time[lane]) {
            Some(answer) => found[lane] = Ok(answer),
            None => left.again |= 1 << lane,
        }
    }
    left.again &= !left.alone;
    (found, left)
}

/// The answers of the loops at these places by more steps, where they are proven.
fn thorough<'a>(
    places: &[usize],
    of: &impl Fn(usize) -> (&'a Process, &'a Controller),
    both: bool,
) -> Vec<Option<Robustness>> {
    let mut settings = Settings::default();
    for (lane, &place) in places.iter().enumerate() {
        let (process, controller) = of(place);
        settings.set(lane, process, controller);
    }
    let answers = kernel::thorough(&settings, both);
    (0..places.len()).map(|lane| robustness(&answers, lane, settings.dead_time[lane])).collect()
}

/// The answer for one lane, where it is proven.
fn robustness(answers: &Answers, lane: usize, dead_time: f64) -> Option<Robustness> {
    if answers.decided[lane] == 0.0 {
        return None;
    }
    if answers.phase[lane] <= 0.0 {
        return Some(NOTHING);
    }
    (answers.proven[lane] != 0.0).then(|| Robustness {
        stable: true,
        gain_margin: Some(answers.gain[lane]),
        gain_margin_low: None,
        phase_margin: Some(Radians(answers.phase[lane])),
        delay_margin: Some(Seconds(answers.delay[lane] * dead_time)),
        sensitivity_peak: Some(answers.peak[lane]),
        complementary_sensitivity_peak: Some(answers.complementary_peak[lane]).filter(|peak| *peak > 0.0),
    })
}
