//! Averaging level control: the least movement of the valve that keeps the level within an excursion.
//!
//! A vessel that smooths the flow is to use its volume: after the largest step of the inflow the level may move by a stated
//! excursion, and the valve is to move as gently as that allows. What is made small is the greatest rate of change of the
//! valve (K. A. McDonald, T. J. McAvoy and A. Tits, AIChE J. 32, 1986, 75–86). No controller does better than to wait for the
//! dead time and then to move at a constant rate r until the flows are equal: the level has then moved by
//! `|K|·(D·d + D²/(2r))`.

use thiserror::Error;

use crate::analysis::frequency::{FrequencyError, Margins, margins};
use crate::analysis::response::{ResponseError, Scenario, simulate, trajectory};
use crate::model::{ClosedLoop, Controller, ModelError, Process, Seconds};

/// Integral times that are searched, in units of 1/(K·Kc): a damping ratio of about 0.35 to 3.
const INTEGRAL: [f64; 2] = [0.5, 36.0];
/// Times an excursion that is too large: more than any rate.
const EXCEEDS: f64 = 1e200;
/// Integral times that are looked at first.
const ROW: u32 = 16;
/// Steps of the golden section, to 1e-3 of the step of that row: the rate is flat at its minimum.
const STEPS: usize = 14;
/// Halvings of the gain, at most.
const HALVINGS: usize = 50;
/// Relative width at which the gain is found.
const FINEST: f64 = 1e-9;
/// What the longest of the times of the movement is multiplied by: a P loop is within 6e-6 of its end, a PI loop has
/// reached its greatest excursion by 4/(K·Kc).
const TIMES_OF_P: f64 = 12.0;
const TIMES_OF_PI: f64 = 6.0;
/// Times at which the rate is looked at before its extremum is refined.
const TIMES: u32 = 600;

/// What is asked of the vessel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Demand {
    /// The largest step of the load \[input unit\], at the process input.
    pub load_step: f64,
    /// How far the level may move \[output unit\].
    pub excursion: f64,
    /// The greatest sensitivity peak that is allowed \[–\].
    pub sensitivity_peak: f64,
}

/// The gentlest PI controller, beside P alone and the best possible.
#[derive(Debug, Clone)]
pub struct Averaging {
    /// PI: the controller.
    pub controller: Controller,
    /// Its greatest rate of change of the valve \[input unit/s\].
    pub rate: f64,
    /// How far it lets the level move \[output unit\].
    pub excursion: f64,
    /// What its loop achieves.
    pub achieved: Margins,
    /// P alone, which uses the excursion as its lasting error: Kc = D/excursion; and its rate \[input unit/s\]. Absent where its
    /// loop is not stable, exceeds the sensitivity peak or moves the level farther.
    pub proportional: Option<(Controller, f64)>,
    /// The least rate that any controller has \[input unit/s\].
    pub least_rate: f64,
}

/// Why there is none.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LevelError {
    /// The process is not a plain integrator with dead time.
    #[error(
        "averaging level control is for the plain integrator with dead time: this process has a lag or a second integrator"
    )]
    NotPlain,
    /// A demand out of its range.
    #[error("{name} is {value}: {allowed} is allowed")]
    Range {
        /// What.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// No controller keeps the level within the excursion.
    #[error(
        "an excursion of {excursion} is not possible: before the dead time is over a load step of {load_step} alone moves the level by {least}"
    )]
    Impossible {
        /// The excursion asked for.
        excursion: f64,
        /// The load step.
        load_step: f64,
        /// The least excursion of any controller.
        least: f64,
    },
    /// No PI controller does, at this sensitivity peak.
    #[error(
        "no PI controller keeps the level within {excursion} at a sensitivity peak of {sensitivity_peak}: the least is {least}"
    )]
    Infeasible {
        /// The excursion asked for.
        excursion: f64,
        /// The sensitivity peak.
        sensitivity_peak: f64,
        /// The least excursion found.
        least: f64,
    },
    /// No gain is as robust as asked for.
    #[error("no PI controller that may keep the level has a sensitivity peak of {sensitivity_peak} or less")]
    Fragile {
        /// The sensitivity peak.
        sensitivity_peak: f64,
    },
    /// A controller that is none.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A loop out of reach.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
    /// A response out of reach.
    #[error(transparent)]
    Response(#[from] ResponseError),
}

/// The PI controller with the least greatest rate of the valve.
///
/// ```
/// use holdup::model::{Process, Seconds};
/// use holdup::tuning::optimise::level::{Demand, averaging};
/// // A drum: 10 % more inflow may move the level by 20 %.
/// let process = Process::integrating(0.01, Seconds(5.0))?;
/// let found = averaging(&process, &Demand { load_step: 10.0, excursion: 20.0, sensitivity_peak: 2.0 })?;
/// assert!(found.excursion <= 20.0 && found.rate >= found.least_rate);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`LevelError`]: the demand is out of range or not possible, with the least excursion that is.
pub fn averaging(process: &Process, demand: &Demand) -> Result<Averaging, LevelError> {
    let positive = |name, value: f64| match value {
        value if value > 0.0 && value.is_finite() => Ok(value),
        _ => Err(LevelError::Range { name, value, allowed: "a finite number greater than 0" }),
    };
    let (load, excursion) =
        (positive("the load step", demand.load_step)?, positive("the excursion", demand.excursion)?);
    if demand.sensitivity_peak.is_nan() || demand.sensitivity_peak <= 1.0 {
        let (name, value) = ("the sensitivity peak", demand.sensitivity_peak);
        return Err(LevelError::Range { name, value, allowed: "a number greater than 1" });
    }
    if !process.is_plain() {
        return Err(LevelError::NotPlain);
    }
    let gain = process.process_gain().abs();
    let least = gain * load * process.dead_time();
    if excursion <= least {
        return Err(LevelError::Impossible { excursion, load_step: load, least });
    }
    let least_rate = gain * load * load / (2.0 * (excursion - least));
    let pi = |damping: f64| gentlest(process, demand, Some(damping));
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let rate =
        |found: &Result<Gentle, LevelError>| found.as_ref().map_or(f64::INFINITY, |gentle| gentle.rate);
    // Where the integral time is too short no gain is robust: the golden section starts about the best of a row.
    let [low, high] = INTEGRAL.map(f64::ln);
    let step = (high - low) / f64::from(ROW);
    // Where none keeps the excursion, the one that exceeds it least says how far it is off.
    let merit = |found: &Result<Gentle, LevelError>| match found {
        Err(LevelError::Infeasible { least, .. }) => EXCEEDS * least,
        other => rate(other),
    };
    let row = (0..=ROW).map(|i| low + step * f64::from(i)).map(|at| (at, merit(&pi(at.exp()))));
    let best = row.min_by(|x, y| x.1.total_cmp(&y.1)).map_or(low, |found| found.0);
    let (mut a, mut b) = ((best - step).max(low), (best + step).min(high));
    let (mut c, mut d) = (b - golden * (b - a), a + golden * (b - a));
    let (mut at_c, mut at_d) = (pi(c.exp()), pi(d.exp()));
    for _ in 0..STEPS {
        if merit(&at_c) <= merit(&at_d) {
            (b, d, at_d) = (d, c, at_c);
            c = b - golden * (b - a);
            at_c = pi(c.exp());
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + golden * (b - a);
            at_d = pi(d.exp());
        }
    }
    let best = if merit(&at_c) <= merit(&at_d) { at_c } else { at_d }?;
    let proportional = gentlest(process, demand, None).ok().map(|gentle| (gentle.controller, gentle.rate));
    Ok(Averaging {
        controller: best.controller,
        rate: best.rate,
        excursion: best.excursion,
        achieved: margins(&ClosedLoop::new(process, &best.controller))?,
        proportional,
        least_rate,
    })
}

struct Gentle {
    controller: Controller,
    rate: f64,
    excursion: f64,
}

/// The least gain that keeps the excursion; the integral time is `integral`/(K·Kc).
fn gentlest(process: &Process, demand: &Demand, integral: Option<f64>) -> Result<Gentle, LevelError> {
    let unit = 1.0 / (process.process_gain() * process.dead_time());
    let with = |gain: f64| -> Result<Controller, LevelError> {
        let controller = Controller::proportional(gain * unit)?;
        Ok(match integral {
            Some(ratio) => controller.with_integral_time(Seconds(ratio * process.dead_time() / gain))?,
            None => controller,
        })
    };
    let robust = |controller: &Controller| -> Result<bool, LevelError> {
        let achieved = margins(&ClosedLoop::new(process, controller))?;
        Ok(achieved.sensitivity_peak.is_some_and(|peak| peak <= demand.sensitivity_peak))
    };
    // P alone needs load/excursion; no integral action makes a twentieth of that enough.
    let floor = (0.05 * demand.load_step / (demand.excursion * unit.abs())).min(0.5);
    if !robust(&with(floor)?)? {
        return Err(LevelError::Fragile { sensitivity_peak: demand.sensitivity_peak });
    }
    // The greatest gain of the sensitivity peak lets the level move least; from there down to the excursion.
    let (mut high, mut low) = (2.0, floor);
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        *(if robust(&with(middle)?)? { &mut low } else { &mut high }) = middle;
        if high - low < FINEST * low {
            break;
        }
    }
    let top = low;
    let least = excursion(process, &with(top)?, demand.load_step)?;
    if least > demand.excursion {
        let (excursion, sensitivity_peak) = (demand.excursion, demand.sensitivity_peak);
        return Err(LevelError::Infeasible { excursion, sensitivity_peak, least });
    }
    let (mut keeps, mut exceeds) = (top, floor);
    for _ in 0..HALVINGS {
        let middle = (keeps * exceeds).sqrt();
        let moved = excursion(process, &with(middle)?, demand.load_step)?;
        *(if moved <= demand.excursion { &mut keeps } else { &mut exceeds }) = middle;
        if keeps / exceeds < 1.0 + FINEST {
            break;
        }
    }
    let controller = with(keeps)?;
    let moved = excursion(process, &controller, demand.load_step)?;
    Ok(Gentle { controller, rate: greatest_rate(process, &controller, demand.load_step)?, excursion: moved })
}

/// Until when the movement of interest lasts \[s\].
fn duration(process: &Process, controller: &Controller) -> f64 {
    let time = 1.0 / (process.process_gain() * controller.proportional_gain());
    let times = if controller.integral_time().is_some() { TIMES_OF_PI } else { TIMES_OF_P };
    20.0 * process.dead_time() + times * time
}

/// The greatest deviation of the level after the load step \[output unit\].
fn excursion(process: &Process, controller: &Controller, load_step: f64) -> Result<f64, LevelError> {
    let scenario = Scenario::unit_load_step(Seconds(duration(process, controller))).map_err(out_of_reach)?;
    let response = simulate(&ClosedLoop::new(process, controller), &scenario)?;
    Ok(load_step * response.metrics.peak.unwrap_or(f64::INFINITY))
}

fn out_of_reach(_: impl std::error::Error) -> LevelError {
    LevelError::Range { name: "the duration of the movement", value: f64::INFINITY, allowed: "a finite time" }
}

/// The greatest |du/dt| after the load step \[input unit/s\]: `u̇ = −Kc·(ẏ + y/Ti)` with `ẏ = K·(u + D)` one dead time ago.
fn greatest_rate(process: &Process, controller: &Controller, load_step: f64) -> Result<f64, LevelError> {
    let (d, horizon) = (process.dead_time(), duration(process, controller));
    let closed = ClosedLoop::new(process, controller);
    let scenario = Scenario::unit_load_step(Seconds(horizon)).map_err(out_of_reach)?;
    let rates = |times: &[f64]| -> Result<Vec<f64>, LevelError> {
        let before: Vec<f64> = times.iter().map(|time| (time - d).max(0.0)).collect();
        let earlier = trajectory(&closed, &scenario, &before)?.manipulated_variable;
        let level = trajectory(&closed, &scenario, times)?.controlled_variable;
        Ok(level
            .iter()
            .zip(&earlier)
            .map(|(y, u)| {
                let slope = process.process_gain() * (u + 1.0);
                let reset = controller.integral_time().map_or(0.0, |time| y / time);
                (controller.proportional_gain() * (slope + reset)).abs()
            })
            .collect())
    };
    let (mut from, mut to) = (d, horizon);
    let mut greatest = 0.0_f64;
    // The extremum lies between the neighbours of the greatest value: looked at again, closer, until it is flat.
    for _ in 0..4 {
        let step = (to - from) / f64::from(TIMES);
        // The last sum may exceed the horizon by a rounding.
        let times: Vec<f64> = (0..=TIMES).map(|i| (from + step * f64::from(i)).min(horizon)).collect();
        let found = rates(&times)?;
        let at = (0..found.len()).max_by(|&a, &b| found[a].total_cmp(&found[b])).unwrap_or(0);
        greatest = greatest.max(found[at]);
        (from, to) = (times[at.saturating_sub(1)], times[(at + 1).min(times.len() - 1)]);
    }
    Ok(load_step * greatest)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn process() -> Process {
        Process::integrating(-0.01, Seconds(5.0)).unwrap()
    }

    fn demand(excursion: f64) -> Demand {
        Demand { load_step: 10.0, excursion, sensitivity_peak: 2.0 }
    }

    #[test]
    fn the_excursion_is_used_up_and_no_rate_beats_the_least() {
        let found = averaging(&process(), &demand(20.0)).unwrap();
        // The gain is found to 1e-9.
        assert!(found.excursion <= 20.0 && found.excursion > 20.0 * (1.0 - 1e-7), "{found:?}");
        // (20 − 0.01·10·5) and a constant rate: K·D²/(2·19.5).
        assert!((found.least_rate - 0.01 * 100.0 / 39.0).abs() < 1e-15);
        assert!(found.rate > found.least_rate);
        assert!(found.controller.proportional_gain() < 0.0);
    }

    #[test]
    fn without_much_dead_time_p_alone_starts_with_its_greatest_rate() {
        // P: u = D·(1 − e^(−K·Kc·t)), Kc = D/excursion: the greatest rate is K·D²/excursion, twice the least possible.
        let process = Process::integrating(0.01, Seconds(1.0)).unwrap();
        let found = averaging(&process, &demand(20.0)).unwrap();
        let (controller, rate) = found.proportional.unwrap();
        // The dead time, 1 s of 200 s, changes it by half a percent; the level comes within 6e-6 of its end in 12 times.
        assert!((controller.proportional_gain() / 0.5 - 1.0).abs() < 1e-4);
        assert!((rate / 0.05 - 1.0).abs() < 0.01 && (found.least_rate / 0.025 - 1.0).abs() < 0.01);
    }

    #[test]
    fn neighbours_are_not_gentler() {
        let found = averaging(&process(), &demand(6.0)).unwrap();
        let (kc, ti) = (found.controller.proportional_gain(), found.controller.integral_time().unwrap());
        for factor in [0.8, 0.95, 1.05, 1.25] {
            let ratio = (process().process_gain() * kc * ti) * factor;
            let other = gentlest(&process(), &demand(6.0), Some(ratio)).unwrap();
            // The ratio is found to some 1e-3, the rate is flat there.
            assert!(other.rate >= found.rate * (1.0 - 1e-6), "{factor}");
        }
    }

    #[test]
    fn an_excursion_below_that_of_the_dead_time_is_refused_with_the_least() {
        let refused = averaging(&process(), &demand(0.4)).unwrap_err();
        assert!(matches!(refused, LevelError::Impossible { least, .. } if (least - 0.5).abs() < 1e-15));
        let refused = averaging(&process(), &demand(0.6)).unwrap_err();
        assert!(matches!(refused, LevelError::Infeasible { least, .. } if least > 0.6), "{refused}");
        assert!(averaging(&process(), &demand(-1.0)).is_err());
    }
}
