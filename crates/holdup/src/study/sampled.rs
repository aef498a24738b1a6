//! The sampled side of a study: its equipment, and what each loop does with it.

use serde::Serialize;

use super::run::{End, finite};
use super::{ControllerResult, Row, Study, StudyScenario};
use crate::analysis::frequency::Margins;
use crate::analysis::frequency::sampled::sampled_margins;
use crate::analysis::metrics::Metrics;
use crate::analysis::response::sampled::{
    Equipment, EquipmentError, EquipmentSettings, LoadRamp, SampledError, SampledLoop,
};
use crate::analysis::response::{Scenario, Trajectory};
use crate::model::loop_file::process_section;
use crate::model::text::TextError;
use crate::model::toml_section::Section;
use crate::model::{Controller, Process, Seconds};

/// The table `[sampled]` of a study file.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyEquipment {
    /// Sampling, sensor and valve, the same for all controllers.
    pub equipment: Equipment,
    /// The process that is simulated, where it is another than the one that the controllers are designed on.
    pub actual_process: Option<Process>,
}

/// One controller on one scenario, sampled.
#[derive(Debug, Clone, Serialize)]
pub struct SampledRow {
    /// What it does.
    pub metrics: Metrics,
    /// The end of the run.
    #[serde(rename = "final")]
    pub end: End,
    /// Number of samples.
    pub samples: u64,
    /// Number of measurements lost.
    pub lost_samples: u64,
    /// Number of samples at which a limit held the output.
    pub limited_samples: u64,
}

/// The sampled loops of a scenario, by the names of their rows.
#[derive(Debug, Clone, Default)]
pub struct SampledLoops {
    loops: Vec<(String, SampledLoop)>,
    ramps: Vec<LoadRamp>,
}

impl SampledLoops {
    /// The loops of those rows that were run sampled.
    pub(super) fn of(
        study: &Study,
        scenario: &StudyScenario,
        rows: &[Row],
        controllers: &[ControllerResult],
    ) -> Self {
        let built = |row: &Row| {
            row.sampled.as_ref()?;
            let controller = controllers.iter().find(|result| result.name == row.controller)?.chosen?;
            Some((format!("{}, sampled", row.controller), built(study, &controller)?.ok()?))
        };
        Self { loops: rows.iter().filter_map(built).collect(), ramps: scenario.load_ramps.clone() }
    }

    /// Whether the scenario is one for sampled loops only: with load ramps.
    #[must_use]
    pub fn alone(&self) -> bool {
        !self.ramps.is_empty()
    }

    /// What they do over their scenario, for drawing beside continuous loops: manipulated variables as deviations from
    /// their rest.
    ///
    /// # Errors
    /// [`SampledError`] if the horizon has too many samples.
    pub fn trajectories(
        &self,
        scenario: &Scenario,
        points: usize,
    ) -> Result<Vec<(String, Trajectory)>, SampledError> {
        let drawn = |(name, sampled): &(String, SampledLoop)| {
            let times = sampled.plot_times(scenario, &self.ramps, points);
            let (_, mut run) = sampled.simulate(scenario, &self.ramps, &times)?;
            let rest = sampled.equipment().settings().initial_manipulated;
            run.signals.manipulated_variable.iter_mut().for_each(|u| *u -= rest);
            Ok((name.clone(), run.signals))
        };
        self.loops.iter().map(drawn).collect()
    }
}

/// The sampled loop of a controller; none where the study has no equipment.
fn built(study: &Study, controller: &Controller) -> Option<Result<SampledLoop, SampledError>> {
    let sampled = study.sampled.as_ref()?;
    let process = sampled.actual_process.unwrap_or(study.process);
    Some(SampledLoop::new(&study.process, controller, &sampled.equipment).map(|built| built.on(&process)))
}

const KEYS: [&str; 15] = [
    "sample_period_s",
    "limits",
    "initial_manipulated",
    "rate_limit",
    "deadband",
    "stiction",
    "output_quantum",
    "measurement_quantum",
    "noise",
    "seed",
    "jitter_s",
    "drop",
    "computation_delay_s",
    "actual_process",
    "about",
];

/// Reads the table `[sampled]`.
pub(super) fn equipment_section(section: &Section<'_>) -> Result<StudyEquipment, TextError> {
    section.only(&KEYS)?;
    let pair = |key: &str, allowed: &'static str| match section.numbers(key)?.as_deref() {
        None => Ok(None),
        Some(&[one, other]) => Ok(Some((one, other))),
        Some(values) => Err(section.refuse(key, &format!("{values:?}"), allowed)),
    };
    let deadband = section.number("deadband")?;
    if deadband.is_some() && section.has("stiction") {
        let reason = "cannot stand beside stiction: deadband = D is stiction = [D, 0.0]".into();
        return Err(section.error("deadband", crate::model::text::Problem::Conflict { reason }));
    }
    let stiction = pair("stiction", "a list of two numbers [S, J]")?;
    let seed = section.number("seed")?.unwrap_or(0.0);
    if !(0.0..=9e15).contains(&seed) || seed.fract() != 0.0 {
        return Err(section.refuse("seed", &seed.to_string(), "a whole number from 0 to 9e15"));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number in range")]
    let seed = seed as u64;
    let settings = EquipmentSettings {
        sample_period: section.require_number("sample_period_s")?,
        limits: pair("limits", "a list of two numbers [low, high]")?,
        rate_limit: section.number("rate_limit")?,
        initial_manipulated: section.number("initial_manipulated")?.unwrap_or(0.0),
        stiction: deadband.map(|deadband| (deadband, 0.0)).or(stiction),
        output_quantum: section.number("output_quantum")?,
        measurement_quantum: section.number("measurement_quantum")?,
        noise: section.number("noise")?.unwrap_or(0.0),
        seed,
        jitter: section.number("jitter_s")?.unwrap_or(0.0),
        drop: section.number("drop")?.unwrap_or(0.0),
        computation_delay: section.number("computation_delay_s")?.unwrap_or(0.0),
    };
    let equipment = Equipment::new(settings).map_err(|error| refused(section, &error))?;
    let actual_process =
        section.section("actual_process")?.map(|actual| process_section(&actual)).transpose()?;
    Ok(StudyEquipment { equipment, actual_process })
}

/// The refusal of a setting, under the key of the file.
fn refused(section: &Section<'_>, error: &EquipmentError) -> TextError {
    let (value, allowed) = error.bare();
    let key = match error.name() {
        "sample_period" => "sample_period_s",
        "jitter" => "jitter_s",
        "computation_delay" => "computation_delay_s",
        "stiction" if section.has("deadband") => "deadband",
        other => other,
    };
    section.refuse(key, &value, allowed)
}

/// Reads the ramps of a scenario: start, end, change.
pub(super) fn ramps(section: &Section<'_>, horizon: f64) -> Result<Vec<LoadRamp>, TextError> {
    let mut ramps = Vec::new();
    for [start, end, change] in section.triples("load_ramp")?.unwrap_or_default() {
        let ramp = LoadRamp::new(start, end, change).map_err(|error| {
            let line = error.to_string();
            let (value, allowed) = line.split_once(": must be ").unwrap_or((line.as_str(), ""));
            let value = value.strip_prefix("load_ramp is ").unwrap_or(value);
            section.refuse("load_ramp", value, allowed.to_owned())
        })?;
        if end > horizon {
            let allowed = format!("over at the horizon of {horizon} s");
            return Err(section.refuse("load_ramp", &format!("one that ends at {end} s"), allowed));
        }
        ramps.push(ramp);
    }
    Ok(ramps)
}

/// The margins of the sampled loop of a controller, or why there are none.
pub(super) fn achieved(study: &Study, result: &mut ControllerResult) {
    let Some(controller) = &result.chosen else { return };
    let Some(built) = built(study, controller) else { return };
    match built.map_err(|error| named(&error)).and_then(|sampled| margins_of(&sampled)) {
        Ok(margins) => {
            result.warnings.extend(margins.warnings.iter().cloned());
            result.achieved_sampled = Some(margins);
        }
        Err(reason) => result.warnings.push(format!("no sampled margins: {reason}")),
    }
}

fn margins_of(sampled: &SampledLoop) -> Result<Margins, String> {
    let settings = sampled.equipment().settings();
    let (h, delay) = (Seconds(settings.sample_period), Seconds(settings.computation_delay));
    let found = sampled_margins(sampled.law().law(), sampled.process(), h, delay);
    found.map(|found| found.margins).map_err(|error| error.to_string())
}

/// The sampled run of a controller on a scenario, where the study has equipment; or why there is none.
pub(super) fn run(
    study: &Study,
    controller: &Controller,
    scenario: &StudyScenario,
) -> Result<Option<SampledRow>, String> {
    let Some(built) = built(study, controller) else { return Ok(None) };
    let run = built
        .and_then(|sampled| sampled.simulate(&scenario.scenario, &scenario.load_ramps, &[]))
        .map_err(|error| format!("no sampled run: {}", named(&error)))?
        .0;
    Ok(Some(SampledRow {
        metrics: run.response.metrics,
        end: End {
            controlled_variable: finite(run.response.final_controlled_variable),
            manipulated_variable: finite(run.response.final_manipulated_variable),
        },
        samples: run.samples,
        lost_samples: run.lost_samples,
        limited_samples: run.limited_samples,
    }))
}

fn named(error: &SampledError) -> String {
    error.called(if error.setting() == Some("sample_period") {
        "sampled.sample_period_s"
    } else {
        "load_ramp"
    })
}

#[cfg(test)]
mod tests {
    use crate::study::{read_study, run_study};

    const STUDY: &str = r#"
title = "sampled"
process = { process_gain = 0.0506, dead_time_s = 6.0 }
[sampled]
sample_period_s = 0.5
limits = [0.0, 100.0]
initial_manipulated = 40.0
[[controller]]
name = "SIMC"
rule = "pi-simc"
[[scenario]]
name = "load"
load = [[10.0, 1.0]]
horizon_s = 200.0
"#;

    fn refusal(from: &str, to: &str) -> String {
        assert!(STUDY.contains(from), "{from}");
        read_study(&STUDY.replace(from, to)).unwrap_err().to_string()
    }

    #[test]
    fn each_fault_names_line_key_value_and_what_is_allowed() {
        for (from, to, parts) in [
            ("limits", "limit", "unknown key 'sampled.limit': did you mean 'limits'?"),
            ("[0.0, 100.0]", "[100.0, 0.0]", "sampled.limits is 100: must be a low limit below"),
            ("[0.0, 100.0]", "[100.0]", "sampled.limits is [100.0]: must be a list of two numbers"),
            ("0.5", "-0.5", "sampled.sample_period_s is -0.5"),
            ("40.0", "140.0", "sampled.initial_manipulated is 140: must be within the limits"),
            ("limits", "noise = -1.0\nlimits", "sampled.noise is -1"),
            ("limits", "seed = 0.5\nlimits", "sampled.seed is 0.5"),
            ("limits", "deadband = 1.0\nstiction = [1.0, 0.0]\nlimits", "sampled.deadband: cannot stand"),
            (
                "horizon_s",
                "load_ramp = [[5.0, 300.0, 1.0]]\nhorizon_s",
                "scenario.load_ramp is one that ends",
            ),
            ("horizon_s", "load_ramp = [[5.0, 4.0, 1.0]]\nhorizon_s", "scenario.load_ramp is 4: must be"),
            ("horizon_s", "load_ramp = [[5.0, 4.0]]\nhorizon_s", "a list of [start, end, change]"),
            ("[sampled]\nsample_period_s = 0.5", "[sampled]", "sampled.sample_period_s is missing"),
        ] {
            let error = refusal(from, to);
            assert!(error.contains(parts), "{to}: {error}");
        }
        let without = STUDY.replace(
            "[sampled]\nsample_period_s = 0.5\nlimits = [0.0, 100.0]\ninitial_manipulated = 40.0\n",
            "",
        );
        let without = without.replace("horizon_s", "load_ramp = [[5.0, 30.0, 1.0]]\nhorizon_s");
        assert!(read_study(&without).unwrap_err().to_string().contains("needs the table [sampled]"));
    }

    #[test]
    fn a_row_compares_continuous_and_sampled() {
        let result = run_study(&read_study(STUDY).unwrap()).unwrap();
        let row = &result.scenarios[0].rows[0];
        let sampled = row.sampled.as_ref().unwrap();
        assert_eq!(sampled.samples, 401);
        // Ti/Kc, with and without samples: the error keeps its sign, and the integral holds the load.
        let ratio = sampled.metrics.iae.unwrap() / row.metrics.iae.unwrap();
        assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
        assert!((sampled.end.manipulated_variable.unwrap() - 39.0).abs() < 0.05);
        let achieved = result.controllers[0].achieved_sampled.as_ref().unwrap();
        assert!(achieved.gain_margin < result.controllers[0].achieved.as_ref().unwrap().gain_margin);
    }

    #[test]
    fn a_controller_without_a_sampled_law_is_said_and_not_refused() {
        let text = STUDY.replace("rule = \"pi-simc\"", "rule = \"dob-huba-p\"");
        let result = run_study(&read_study(&text).unwrap()).unwrap();
        assert!(result.scenarios[0].rows[0].sampled.is_none());
        assert!(result.warnings.iter().any(|warning| warning.contains("has no sampled law")));
    }
}
