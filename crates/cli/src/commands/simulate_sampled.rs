//! `holdup simulate --sample-period`: the law that runs in the plant, with its equipment.

use std::fmt::Write as _;

use holdup::analysis::bounds::Bounds;
use holdup::analysis::metrics::Metrics;
use holdup::analysis::response::sampled::{
    Equipment, LoadRamp, SampledLoop, SampledResponse, SampledTrajectory,
};
use holdup::analysis::response::{Scenario, Trajectory, plot_times, simulate, trajectory};
use holdup::model::{ClosedLoop, Controller, Process};
use holdup::study::PercentOfBest;
use holdup::study::figures::{Axis, Figure, FigureError, Panel, Reference, Series, Tone, terminal};
use serde_json::json;

use super::simulate::{csv, table_of, times};
use super::view::{controller_line, figure_file, process_line, staircase};
use crate::args::SimulateArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::sampled::sampled_fault;
use crate::table::number;

/// Times in a figure, beside those of the samples.
const POINTS: usize = 2001;

/// What is simulated.
struct Case {
    controller: Controller,
    process: Process,
    scenario: Scenario,
    ramps: Vec<LoadRamp>,
    sampled: SampledLoop,
    /// The same loop without sampling, where the scenario is one for it.
    continuous: Option<ClosedLoop>,
}

/// Simulates the loop with this equipment.
pub(crate) fn run(
    args: &SimulateArgs,
    (process, controller): (Process, Controller),
    (scenario, ramps): (Scenario, Vec<LoadRamp>),
    equipment: &Equipment,
    console: Console,
) -> Result<Answer, Fault> {
    let actual = args.sampled.actual_process()?.unwrap_or(process);
    let sampled =
        SampledLoop::new(&process, &controller, equipment).map_err(|error| sampled_fault(&error))?;
    let sampled = sampled.on(&actual);
    sampled.require_stable().map_err(|error| sampled_fault(&error))?;
    let continuous = sampled.continuous().filter(|_| ramps.is_empty());
    let case = Case { controller, process: actual, scenario, ramps, sampled, continuous };
    let file_times = times(args, case.scenario.horizon())?;
    let chosen = args.csv.as_ref().map_or(&[][..], |_| &file_times);
    let (run, signals) = case.run(chosen)?;
    let without = case.continuous.as_ref().map(|closed| simulate(closed, &case.scenario));
    let without = without.transpose().map_err(Fault::input)?.map(|response| response.metrics);
    let bounds = case.bounds();
    let percent_of_best = PercentOfBest::of(&run.response.metrics, &bounds);
    let mut warnings = run.response.warnings.clone();
    if run.limited_samples > 0 {
        warnings.push(format!(
            "a limit holds the output at {} of {} samples: what the linear design promises does not hold there",
            run.limited_samples, run.samples
        ));
    }
    let mut all = warnings.clone();
    all.extend(bounds.reasons.iter().cloned());
    let settings = equipment.settings();
    let json = json!({
        "metrics": run.response.metrics,
        "bounds": bounds,
        "percent_of_best": percent_of_best,
        "final": {
            "controlled_variable": run.response.final_controlled_variable,
            "manipulated_variable": run.response.final_manipulated_variable,
            "valve_position": run.final_valve_position,
        },
        "overflow_at_s": run.response.overflow_at.map(|time| time.0),
        "horizon_s": case.scenario.horizon(),
        "sampled": {
            "sample_period_s": settings.sample_period,
            "samples": run.samples,
            "lost_samples": run.lost_samples,
            "limited_samples": run.limited_samples,
            "seed": settings.seed,
            "initial_manipulated": settings.initial_manipulated,
            "delay_line_segments": case.sampled.law().segments_needed(),
        },
        "continuous": without.map(|metrics| json!({ "metrics": metrics })),
        "warnings": all,
    });
    let mut files = Vec::new();
    if let Some(path) = &args.csv {
        files.push((path.clone(), csv(&signals.signals, Some(&signals.valve_position))));
    }
    if let Some(path) = &args.plot {
        files.push((path.clone(), figure_file(path, &case.figure(POINTS)?)?));
    }
    let mut text = String::new();
    if !console.json {
        text = case.text(&run, without.as_ref(), &bounds, console)?;
    }
    Ok(Answer { json, text, warnings, files })
}

impl Case {
    fn run(&self, times: &[f64]) -> Result<(SampledResponse, SampledTrajectory), Fault> {
        self.sampled.simulate(&self.scenario, &self.ramps, times).map_err(|error| sampled_fault(&error))
    }

    /// Bounds hold for steps and without noise.
    fn bounds(&self) -> Bounds {
        let settings = self.sampled.equipment().settings();
        let none = |reason: &str| Bounds { reasons: vec![reason.to_owned()], ..Bounds::default() };
        if !self.ramps.is_empty() {
            return none("no bounds: they are known for load steps, not for ramps");
        }
        if settings.noise > 0.0 {
            return none("no bounds: they hold without measurement noise");
        }
        Bounds::of(&self.process, &self.scenario)
    }

    fn text(
        &self,
        run: &SampledResponse,
        without: Option<&Metrics>,
        bounds: &Bounds,
        console: Console,
    ) -> Result<String, Fault> {
        let settings = self.sampled.equipment().settings();
        let mut text = format!(
            "{}, one sample every {} s\non {}, to {} s\n\n",
            controller_line(&self.controller),
            number(settings.sample_period),
            process_line(&self.process),
            number(self.scenario.horizon())
        );
        let columns: Vec<(&str, &Metrics)> = [("sampled", &run.response.metrics)]
            .into_iter()
            .chain(without.map(|metrics| ("continuous", metrics)))
            .collect();
        text += &table_of(&columns, bounds, console);
        let _ = writeln!(
            text,
            " at the end: y = {}, u = {}, valve = {}",
            number(run.response.final_controlled_variable),
            number(run.response.final_manipulated_variable),
            number(run.final_valve_position),
        );
        let _ = writeln!(
            text,
            " {} samples, {} lost, {} at a limit\n",
            run.samples, run.lost_samples, run.limited_samples
        );
        text += &terminal::chart(&self.figure(4 * console.width)?, console.width, console.colour);
        Ok(text)
    }

    fn figure(&self, points: usize) -> Result<Figure, Fault> {
        let times = self.sampled.plot_times(&self.scenario, &self.ramps, points);
        let (_, signals) = self.run(&times)?;
        let continuous = self.continuous.as_ref().map(|closed| {
            let times = plot_times(closed, &self.scenario, points);
            trajectory(closed, &self.scenario, &times).map_err(Fault::input)
        });
        self.draw(&signals, continuous.transpose()?.as_ref()).map_err(Fault::input)
    }

    fn draw(
        &self,
        signals: &SampledTrajectory,
        continuous: Option<&Trajectory>,
    ) -> Result<Figure, FigureError> {
        let settings = self.sampled.equipment().settings();
        let rest = settings.initial_manipulated;
        let SampledTrajectory { signals, valve_position } = signals;
        let over = |name: &str, values: &[f64]| Series::new(name, signals.time.clone(), values.to_vec());
        let grey = |series: Series| series.with_tone(Tone::Neutral).with_width(1.5);
        let time = || Axis::linear("time [s]");
        let scenario = &self.scenario;
        let (times, setpoint) = staircase(scenario.setpoint(), scenario.initial(), scenario.horizon());
        let mut output = Panel::new(time(), Axis::linear("controlled variable"))
            .with_series(grey(Series::new("setpoint", times, setpoint)?)?)
            .with_series(over("sampled", &signals.controlled_variable)?);
        let mut input = Panel::new(time(), Axis::linear("manipulated variable"))
            .with_series(over("sampled", &signals.manipulated_variable)?);
        if let Some(run) = continuous {
            let at = |values: Vec<f64>| Series::new("continuous", run.time.clone(), values);
            output = output.with_series(at(run.controlled_variable.clone())?);
            let manipulated = run.manipulated_variable.iter().map(|u| rest + u).collect();
            input = input.with_series(at(manipulated)?);
        }
        if *valve_position != signals.manipulated_variable {
            input = input.with_series(over("valve", valve_position)?);
        }
        for (limit, name) in
            settings.limits.iter().flat_map(|&(low, high)| [(low, "low limit"), (high, "high limit")])
        {
            // A limit far from all that happens would flatten the curves.
            let reach = |sum: (f64, f64), v: &f64| (sum.0.min(*v), sum.1.max(*v));
            let (least, most) = signals.manipulated_variable.iter().fold((rest, rest), reach);
            if limit >= least - 0.5 * (most - least) && limit <= most + 0.5 * (most - least) {
                input = input.with_reference(Reference::horizontal(limit, name)?);
            }
        }
        let title = format!(
            "{}, sampled every {} s",
            controller_line(&self.controller),
            number(settings.sample_period)
        );
        let mut panels = vec![output, input];
        if signals.load.iter().any(|load| *load != 0.0) {
            let load = grey(over("load", &signals.load)?)?;
            let mut panel = Panel::new(time(), Axis::linear("load")).with_series(load);
            if let Some(estimate) = &signals.load_estimate {
                panel = panel.with_series(over("load estimate", estimate)?);
            }
            panels.push(panel);
        }
        Figure::new(&title, panels)
    }
}
