//! Every rule that applies to a process, with what it achieves and what it costs, beside what is possible.

mod order;

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use super::entry::{Applies, Entry, Status};
use super::parameters::Parameters;
use super::{Tuning, rules};
use crate::analysis::bounds::Bounds;
use crate::analysis::frequency::{Margins, margins};
use crate::analysis::infinite_horizon::{InfiniteHorizon, Input, to_infinity};
use crate::analysis::response::Scenario;
use crate::model::{ClosedLoop, Process, Seconds};

pub use order::{ORDERS, Order};

/// Rules whose loop has a greater sensitivity peak rank behind those that have not, where nothing else is asked for.
pub const ROBUST: f64 = 2.0;

/// One rule with its place among the others.
#[derive(Debug, Clone)]
pub struct Ranked {
    /// The rule.
    pub entry: &'static Entry,
    /// The controller that it gives.
    pub tuning: Tuning,
    /// What the loop achieves, broken at the process input.
    pub achieved: Margins,
    /// Unit setpoint step; absent where the loop is unstable or the response out of reach.
    pub setpoint: Option<InfiniteHorizon>,
    /// Unit load step; absent where the loop is unstable or the response out of reach.
    pub load: Option<InfiniteHorizon>,
    /// The least IAE of any controller for the setpoint and for the load step [output unit · s].
    pub least: [Option<f64>; 2],
    /// High-frequency gain from measurement to controller output; absent where it is infinite.
    pub noise_gain: Option<f64>,
    /// A recommended rule of the ranking that is nowhere worse and somewhere better: load and setpoint IAE, sensitivity peak,
    /// noise gain.
    pub dominated_by: Option<&'static str>,
    /// What a reader must know; that the loop is unstable comes first.
    pub warnings: Vec<String>,
}

impl Ranked {
    /// IAE after a unit load step over all time [output unit · s]; absent where infinite.
    #[must_use]
    pub fn load_iae(&self) -> Option<f64> {
        self.load.as_ref().and_then(|load| load.iae)
    }

    /// IAE after a unit setpoint step over all time [output unit · s]; absent where infinite.
    #[must_use]
    pub fn setpoint_iae(&self) -> Option<f64> {
        self.setpoint.as_ref().and_then(|setpoint| setpoint.iae)
    }

    /// Load IAE in percent of the best possible: 100 is what no controller beats.
    #[must_use]
    pub fn load_percent(&self) -> Option<f64> {
        Some(100.0 * self.least[1]? / self.load_iae()?)
    }

    /// Setpoint IAE in percent of the best possible.
    #[must_use]
    pub fn setpoint_percent(&self) -> Option<f64> {
        Some(100.0 * self.least[0]? / self.setpoint_iae()?)
    }

    /// What one rule gives with the defaults of its parameters.
    ///
    /// # Errors
    /// A sentence, if the rule gives no controller or the loop is out of the reach of double precision.
    pub fn of(entry: &'static Entry, process: &Process) -> Result<Self, String> {
        let tuning = entry.tune(process, &Parameters::new()).map_err(|error| error.to_string())?;
        let closed_loop = ClosedLoop::new(process, &tuning.controller);
        let achieved = margins(&closed_loop).map_err(|error| error.to_string())?;
        let mut warnings: Vec<String> = tuning.warnings.iter().chain(&achieved.warnings).cloned().collect();
        let mut run = |input| {
            if !achieved.stable {
                return None;
            }
            match to_infinity(process, &tuning.controller, input) {
                Ok(integrals) => {
                    warnings.extend(integrals.warnings.iter().cloned());
                    Some(integrals)
                }
                Err(error) => {
                    warnings.push(error.to_string());
                    None
                }
            }
        };
        let (setpoint, load) = (run(Input::Setpoint), run(Input::Load));
        if !achieved.stable {
            warnings.insert(0, "unstable: this rule gives an unstable loop here".to_owned());
        }
        let noise_gain = tuning.controller.noise_gain();
        let (least, dominated_by) = (least_iae(process), None);
        Ok(Self { entry, tuning, achieved, setpoint, load, least, noise_gain, dominated_by, warnings })
    }

    /// Lower is better: robust before fragile, what is not recommended behind that, unstable last.
    fn class(&self) -> u8 {
        let robust = self.achieved.sensitivity_peak.is_some_and(|peak| peak <= ROBUST * (1.0 + 1e-9));
        match (self.achieved.stable, self.entry.status) {
            (false, _) => 4,
            (true, Status::Wrong(_)) => 3,
            (true, Status::History(_)) => 2,
            (true, Status::Recommended) => u8::from(!robust),
        }
    }

    /// Greater is better: the geometric mean of the two percentages.
    fn balance(&self) -> f64 {
        (self.setpoint_percent().unwrap_or(0.0) * self.load_percent().unwrap_or(0.0)).sqrt()
    }

    /// The quantities that decide whether a rule is dominated; absent is infinite.
    fn costs(&self) -> [f64; 4] {
        let costs = [self.load_iae(), self.setpoint_iae(), self.achieved.sensitivity_peak, self.noise_gain];
        costs.map(|cost| cost.unwrap_or(f64::INFINITY))
    }
}

/// The process on which rules are compared: K = 1, d = 1 s and, where there is a lag, T = 1 s.
///
/// # Panics
/// Never: 1 is a valid gain and a valid time.
#[must_use]
pub fn normalised(applies: Applies) -> Process {
    let (gain, time) = (1.0, Seconds(1.0));
    let process = match applies {
        Applies::Integrating => Process::integrating(gain, time),
        Applies::IntegratingWithLag => {
            Process::integrating(gain, time).and_then(|process| process.with_lag(time))
        }
        Applies::DoubleIntegrating => Process::double_integrating(gain, time),
    };
    process.expect("1 is a valid gain and a valid time")
}

/// The least IAE after a unit setpoint and a unit load step.
fn least_iae(process: &Process) -> [Option<f64>; 2] {
    let horizon = Seconds(10.0 * process.dead_time());
    [Scenario::unit_setpoint_step(horizon), Scenario::unit_load_step(horizon)]
        .map(|scenario| scenario.ok().and_then(|scenario| Bounds::of(process, &scenario).iae))
}

/// The rules of a process in their order.
#[derive(Debug, Clone)]
pub struct Ranking {
    /// The rules, best first, those with an unstable loop last.
    pub rules: Vec<Ranked>,
    /// Rules that apply and give no controller without more information, and why.
    pub left_out: Vec<(&'static str, String)>,
}

/// Ranks the rules among `wanted` that apply to the process, with the defaults of their parameters.
///
/// Integrals run to an infinite horizon. Dominated rules stay, marked.
///
/// ```
/// use holdup::model::{Process, Seconds};
/// use holdup::tuning::ranking::{ORDERS, rank};
/// let process = Process::integrating(0.0506, Seconds(6.0))?;
/// let ranking = rank(&process, &ORDERS[1], |entry| entry.structure == "PI" && entry.year > 2000);
/// assert!(ranking.rules[0].load_iae() <= ranking.rules[1].load_iae());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rank(process: &Process, order: &Order, wanted: impl Fn(&Entry) -> bool) -> Ranking {
    let entries: Vec<&'static Entry> =
        rules().iter().copied().filter(|entry| entry.applies(process) && wanted(entry)).collect();
    let (mut ranked, mut left_out) = (Vec::new(), Vec::new());
    for (entry, result) in entries.iter().zip(computed(&entries, process)) {
        match result {
            Ok(rule) => ranked.push(rule),
            Err(why) => left_out.push((entry.id, why)),
        }
    }
    let key = |rule: &Ranked| order.key(rule).unwrap_or(f64::INFINITY);
    ranked.sort_by(|a, b| {
        b.achieved
            .stable
            .cmp(&a.achieved.stable)
            .then(key(a).total_cmp(&key(b)))
            .then(a.entry.id.cmp(b.entry.id))
    });
    mark_dominated(&mut ranked);
    Ranking { rules: ranked, left_out }
}

/// One result for each entry, in their order, on all cores.
fn computed(entries: &[&'static Entry], process: &Process) -> Vec<Result<Ranked, String>> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(Vec::with_capacity(entries.len()));
    let threads = std::thread::available_parallelism().map_or(1, usize::from).min(entries.len());
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some((index, entry)) = {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    entries.get(index).map(|entry| (index, *entry))
                } {
                    let result = Ranked::of(entry, process);
                    results.lock().unwrap_or_else(PoisonError::into_inner).push((index, result));
                }
            });
        }
    });
    let mut results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    results.sort_by_key(|(index, _)| *index);
    results.into_iter().map(|(_, result)| result).collect()
}

/// Marks each stable rule by the first recommended one in the ranking that is nowhere worse and somewhere better.
fn mark_dominated(ranked: &mut [Ranked]) {
    let to_be_used = |rule: &&Ranked| rule.achieved.stable && rule.entry.status == Status::Recommended;
    let costs: Vec<(&'static str, [f64; 4])> =
        ranked.iter().filter(to_be_used).map(|rule| (rule.entry.id, rule.costs())).collect();
    for rule in ranked.iter_mut().filter(|rule| rule.achieved.stable) {
        let own = rule.costs();
        let better = |other: &[f64; 4]| {
            // Equal to within the accuracy of the integrals is not better.
            let nowhere_worse = other.iter().zip(&own).all(|(o, c)| o <= c);
            nowhere_worse && other.iter().zip(&own).any(|(o, c)| *o < c * (1.0 - 1e-8))
        };
        rule.dominated_by = costs.iter().find(|(_, other)| better(other)).map(|(id, _)| *id);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ranking(gain: f64, dead_time: f64) -> Ranking {
        let process = Process::integrating(gain, Seconds(dead_time)).unwrap();
        rank(&process, &ORDERS[0], |entry| entry.structure.starts_with('P') && entry.year > 1995)
    }

    #[test]
    fn the_ranking_does_not_depend_on_the_units_of_gain_and_time() {
        let (one, other) = (ranking(1.0, 1.0), ranking(-0.05, 6.0));
        for (a, b) in one.rules.iter().zip(&other.rules) {
            assert_eq!(a.entry.id, b.entry.id);
            let percent = |rule: &Ranked| (rule.load_percent(), rule.setpoint_percent());
            // Integrals are good to 1e-9; roots that choose a controller to somewhat less.
            for (x, y) in [(percent(a).0, percent(b).0), (percent(a).1, percent(b).1)] {
                assert_eq!(x.is_some(), y.is_some(), "{}", a.entry.id);
                assert!((x.unwrap_or(1.0) / y.unwrap_or(1.0) - 1.0).abs() < 1e-7, "{}", a.entry.id);
            }
        }
    }

    #[test]
    fn no_rule_beats_the_bound_and_unstable_rules_come_last() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let ranking = rank(&process, &ORDERS[1], |entry| entry.structure != "PD+DOB");
        let unstable = ranking.rules.iter().position(|rule| !rule.achieved.stable);
        for (index, rule) in ranking.rules.iter().enumerate() {
            for percent in [rule.load_percent(), rule.setpoint_percent()].into_iter().flatten() {
                assert!(percent <= 100.0 * (1.0 + 1e-9), "{}: {percent} %", rule.entry.id);
            }
            if unstable.is_some_and(|first| index >= first) {
                assert!(rule.warnings[0].starts_with("unstable"), "{}", rule.entry.id);
            }
        }
    }
}
