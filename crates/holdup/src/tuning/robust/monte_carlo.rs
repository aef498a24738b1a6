//! Monte Carlo: many perturbed processes under one controller, in bounded memory.

use std::ops::ControlFlow;

use rayon::prelude::*;
use serde::Serialize;
use thiserror::Error;

use super::draws::Draws;
use super::quantiles::Quantiles;
use crate::analysis::batch::{Robustness, robustness_of_processes};
use crate::analysis::frequency::FrequencyError;
use crate::analysis::metrics::{METRICS, Metrics};
use crate::analysis::response::{Scenario, simulate, trajectory};
use crate::model::{ClosedLoop, Controller, ModelError, Process};

/// Processes between two reports of progress; also what is held in memory at once.
const CHUNK: u64 = 4096;
/// Normal quantile of a two-sided interval of 95 %.
const NORMAL_95: f64 = 1.959_963_984_540_054;

/// The shares of the percentiles, with their names.
const SHARES: [(&str, f64); 9] = [
    ("least", 0.0),
    ("p1", 0.01),
    ("p5", 0.05),
    ("p25", 0.25),
    ("p50", 0.5),
    ("p75", 0.75),
    ("p95", 0.95),
    ("p99", 0.99),
    ("greatest", 1.0),
];

/// One perturbed process and what the loop does with it.
#[derive(Debug, Clone)]
pub struct Run {
    /// Number of the process, from 0; with the seed it determines everything else.
    pub index: u64,
    /// The process.
    pub process: Process,
    /// Margins and peaks, broken at the process input.
    pub margins: Robustness,
    /// Metrics of the scenario, where one is given and its response is in reach.
    pub metrics: Option<Metrics>,
    /// The controlled variable at the times asked for; empty without them or out of reach.
    pub response: Vec<f64>,
}

/// A number of a run, as it is listed in files and summed up in percentiles.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    /// Name in files and in the JSON.
    pub name: &'static str,
    /// Its value; absent where it is infinite or has no meaning.
    pub value: fn(&Run) -> Option<f64>,
}

/// The numbers of a run apart from the metrics of its scenario, which follow in the order of [`METRICS`].
pub static COLUMNS: &[Column] = &[
    Column { name: "gain_margin", value: |run| run.margins.gain_margin },
    Column {
        name: "phase_margin_deg",
        value: |run| run.margins.phase_margin.map(crate::model::Radians::degrees),
    },
    Column { name: "delay_margin_s", value: |run| run.margins.delay_margin.map(|time| time.0) },
    Column { name: "sensitivity_peak", value: |run| run.margins.sensitivity_peak },
    Column {
        name: "complementary_sensitivity_peak",
        value: |run| run.margins.complementary_sensitivity_peak,
    },
];

/// What is to be computed.
#[derive(Debug, Clone)]
pub struct MonteCarlo<'a> {
    /// The nominal process: an observer without a model of its own keeps this one.
    pub process: Process,
    /// The controller.
    pub controller: Controller,
    /// The factors.
    pub draws: Draws,
    /// Number of processes, ≥ 1.
    pub samples: u64,
    /// What happens to each loop; without it only margins are computed.
    pub scenario: Option<&'a Scenario>,
    /// Times \[s\] of the response band, rising, within the scenario's horizon.
    pub times: &'a [f64],
}

/// Why no process was computed.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MonteCarloError {
    /// There is nothing to do.
    #[error("the number of samples is 0: at least 1 is needed")]
    NoSamples,
    /// A perturbed process is none.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A loop is out of reach.
    #[error(transparent)]
    Frequency(#[from] FrequencyError),
}

/// Percentiles of one number over the runs that have it.
#[derive(Debug, Clone, Serialize)]
pub struct Percentiles {
    /// What it is a number of.
    pub name: &'static str,
    /// Runs that have it.
    pub count: u64,
    /// Name of the percentile and its value; the least and the greatest are exact, the others right to 6.1e-5.
    pub values: Vec<(&'static str, f64)>,
}

/// What is known after the last run.
#[derive(Debug, Clone)]
pub struct Summary {
    /// Number of processes that were computed: less than asked for where the computation was stopped.
    pub samples: u64,
    /// Share of the stable ones \[–\].
    pub stable_fraction: f64,
    /// Interval of 95 % of that share (Wilson 1927).
    pub stable_fraction_interval: [f64; 2],
    /// Percentiles of every number, over the stable loops.
    pub percentiles: Vec<Percentiles>,
    /// For each of the times, the 5th, 25th, 50th, 75th and 95th percentile of the controlled variable.
    pub bands: Vec<[f64; 5]>,
    /// Stable loops whose response was out of reach: they have margins and no metrics.
    pub without_response: u64,
}

impl MonteCarlo<'_> {
    /// Computes all processes on all cores; `each` gets the runs in the order of their index, a few thousand at a time, and
    /// may break off.
    ///
    /// The result depends on the seed and on nothing else.
    ///
    /// # Errors
    /// [`MonteCarloError`] for no samples, or a loop out of the reach of double precision.
    pub fn run(&self, mut each: impl FnMut(&[Run]) -> ControlFlow<()>) -> Result<Summary, MonteCarloError> {
        if self.samples == 0 {
            return Err(MonteCarloError::NoSamples);
        }
        let controller = self.controller.with_model_of(&self.process)?;
        let mut count = Count::new(self.scenario.is_some(), self.times.len());
        let mut done = 0;
        while done < self.samples {
            let end = (done + CHUNK).min(self.samples);
            let drawn: Result<Vec<(u64, Process)>, MonteCarloError> =
                (done..end).into_par_iter().map(|index| Ok((index, self.drawn(index)?))).collect();
            let (indices, processes): (Vec<u64>, Vec<Process>) = drawn?.into_iter().unzip();
            let margins = robustness_of_processes(&processes, &controller).loops;
            let runs: Result<Vec<Run>, MonteCarloError> = indices
                .into_par_iter()
                .zip(processes)
                .zip(margins)
                .map(|((index, process), margins)| Ok(self.one(&controller, index, process, margins?)))
                .collect();
            let runs = runs?;
            for run in &runs {
                count.add(run, self.scenario.is_some());
            }
            done = end;
            if each(&runs).is_break() {
                break;
            }
        }
        Ok(count.summary(done))
    }

    fn drawn(&self, index: u64) -> Result<Process, MonteCarloError> {
        let [gain, dead_time] = self.draws.factors(index);
        Ok(self.process.perturbed(gain, dead_time)?)
    }

    fn one(&self, controller: &Controller, index: u64, process: Process, margins: Robustness) -> Run {
        let closed = ClosedLoop::new(&process, controller);
        let scenario = self.scenario.filter(|_| margins.stable);
        let metrics =
            scenario.and_then(|scenario| simulate(&closed, scenario).ok()).map(|found| found.metrics);
        let response = scenario.filter(|_| !self.times.is_empty());
        let response = response.and_then(|scenario| trajectory(&closed, scenario, self.times).ok());
        let response = response.map_or_else(Vec::new, |found| found.controlled_variable);
        Run { index, process, margins, metrics, response }
    }
}

/// What is counted run by run.
struct Count {
    stable: u64,
    without_response: u64,
    columns: Vec<Quantiles>,
    metrics: Vec<Quantiles>,
    bands: Vec<Quantiles>,
}

impl Count {
    fn new(with_metrics: bool, times: usize) -> Self {
        let metrics = if with_metrics { METRICS.len() } else { 0 };
        let of = |length| vec![Quantiles::default(); length];
        Self {
            stable: 0,
            without_response: 0,
            columns: of(COLUMNS.len()),
            metrics: of(metrics),
            bands: of(times),
        }
    }

    fn add(&mut self, run: &Run, with_scenario: bool) {
        if !run.margins.stable {
            return;
        }
        self.stable += 1;
        for (column, quantiles) in COLUMNS.iter().zip(&mut self.columns) {
            if let Some(value) = (column.value)(run) {
                quantiles.add(value);
            }
        }
        match &run.metrics {
            Some(metrics) => {
                for (metric, quantiles) in METRICS.iter().zip(&mut self.metrics) {
                    if let Some(value) = (metric.value)(metrics) {
                        quantiles.add(value);
                    }
                }
            }
            None => self.without_response += u64::from(with_scenario),
        }
        for (value, quantiles) in run.response.iter().zip(&mut self.bands) {
            quantiles.add(*value);
        }
    }

    fn summary(self, samples: u64) -> Summary {
        let names = COLUMNS.iter().map(|column| column.name).chain(METRICS.iter().map(|metric| metric.name));
        let lists = self.columns.iter().chain(&self.metrics);
        let percentiles = names.zip(lists).map(|(name, quantiles)| Percentiles {
            name,
            count: quantiles.count(),
            values: SHARES.iter().filter_map(|&(name, share)| Some((name, quantiles.at(share)?))).collect(),
        });
        let band = |quantiles: &Quantiles| {
            [0.05, 0.25, 0.5, 0.75, 0.95].map(|share| quantiles.at(share).unwrap_or(f64::NAN))
        };
        let (stable_fraction, stable_fraction_interval) = wilson(self.stable, samples);
        Summary {
            samples,
            stable_fraction,
            stable_fraction_interval,
            percentiles: percentiles.collect(),
            bands: self.bands.iter().filter(|quantiles| quantiles.count() > 0).map(band).collect(),
            without_response: self.without_response,
        }
    }
}

/// A share and its interval of 95 % (E. B. Wilson, J. Amer. Stat. Assoc. 22, 1927, 209–212).
#[expect(clippy::cast_precision_loss, reason = "counts below 2⁵³")]
fn wilson(hits: u64, samples: u64) -> (f64, [f64; 2]) {
    let (n, z) = (samples as f64, NORMAL_95);
    let share = hits as f64 / n;
    let middle = (share + z * z / (2.0 * n)) / (1.0 + z * z / n);
    let half = z / (1.0 + z * z / n) * (share * (1.0 - share) / n + z * z / (4.0 * n * n)).sqrt();
    let low = if hits == 0 { 0.0 } else { middle - half };
    let high = if hits == samples { 1.0 } else { middle + half };
    (share, [low, high])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::frequency::family::{Family, Goal, worst_case};
    use crate::model::Seconds;
    use crate::tuning::robust::Distribution;

    fn carlo(samples: u64, times: &[f64]) -> MonteCarlo<'_> {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let controller = Controller::proportional(0.5).unwrap().with_integral_time(Seconds(8.0)).unwrap();
        let family = Family::ranges([0.8, 1.2], [0.8, 1.2]).unwrap();
        let draws = Draws::new(family, Distribution::Uniform, 3);
        MonteCarlo { process, controller, draws, samples, scenario: None, times }
    }

    #[test]
    fn no_run_exceeds_the_guarantee_and_the_order_is_that_of_the_index() {
        let family = Family::ranges([0.8, 1.2], [0.8, 1.2]).unwrap();
        let carlo = carlo(5000, &[]);
        let bound = worst_case(&carlo.process, &carlo.controller, &family, Goal::Worst).unwrap();
        let bound = bound.sensitivity_peak.unwrap();
        let mut next = 0;
        let summary = carlo
            .run(|runs| {
                for run in runs {
                    assert_eq!(run.index, next);
                    next += 1;
                    assert!(run.margins.sensitivity_peak.unwrap() <= bound);
                }
                ControlFlow::Continue(())
            })
            .unwrap();
        assert_eq!((summary.samples, summary.stable_fraction), (5000, 1.0));
        let peaks = summary.percentiles.iter().find(|list| list.name == "sensitivity_peak").unwrap();
        let greatest = peaks.values.last().unwrap().1;
        // 5000 draws come within a few percent of the corner.
        assert!(greatest <= bound && greatest > 0.95 * bound, "{greatest} {bound}");
    }

    #[test]
    fn one_thread_gives_what_all_give() {
        let scenario = Scenario::unit_load_step(Seconds(60.0)).unwrap();
        let times = [1.0, 5.0, 20.0];
        let carlo = MonteCarlo { scenario: Some(&scenario), ..carlo(200, &times) };
        let all = carlo.run(|_| ControlFlow::Continue(())).unwrap();
        let single = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        let one = single.install(|| carlo.run(|_| ControlFlow::Continue(()))).unwrap();
        assert_eq!(format!("{all:?}"), format!("{one:?}"));
        assert_eq!(all.bands.len(), 3);
        // Before any dead time has passed no level has moved: the least factor on it is 0.8.
        let early = MonteCarlo { times: &[0.5], ..carlo }.run(|_| ControlFlow::Continue(())).unwrap();
        assert_eq!(early.bands, [[0.0; 5]]);
    }

    #[test]
    fn a_stop_keeps_what_is_done() {
        let summary = carlo(20_000, &[]).run(|_| ControlFlow::Break(())).unwrap();
        assert_eq!(summary.samples, CHUNK);
        assert_eq!(carlo(0, &[]).run(|_| ControlFlow::Continue(())).unwrap_err(), MonteCarloError::NoSamples);
    }

    #[test]
    fn the_interval_of_a_share_is_that_of_wilson() {
        // 8 of 10: 0.490 to 0.943, the example that textbooks print.
        let (share, [low, high]) = wilson(8, 10);
        assert_eq!(share, 0.8);
        assert!((low - 0.4901).abs() < 1e-4 && (high - 0.9433).abs() < 1e-4, "{low} {high}");
    }
}
