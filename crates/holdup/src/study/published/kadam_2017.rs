//! The tables of Kadam (2017), recomputed under the conventions that the paper states and under those that its
//! numbers show.
//!
//! The paper states: PID settings as in its parameter table, PD as Kc(1 + Td s), the servo run as one run of
//! three setpoints, the servo-plus-regulatory run as one run. Its text gives Wang–Cluett's β as 3 where the table
//! of settings is that of β = 4. It names no derivative filter; N = 100 rad/s is the one its energies show.

use super::judge::{Candidate, Floor, Printed};
use super::{Cell, PaperError};
use crate::analysis::bounds::Bounds;
use crate::analysis::metrics::Metrics;
use crate::analysis::response::{Scenario, simulate};
use crate::model::forms::Parallel;
use crate::model::text::{Problem, TextError};
use crate::model::{ClosedLoop, Controller, Observer, Process, Seconds};
use crate::study::StudyProblem;
use crate::tuning::{Parameters, Tuning, rule};

/// The printed numbers.
const PRINTED: &str = include_str!("kadam-2017.toml");

/// Bandwidth of the derivative filter [rad/s].
const FILTER: f64 = 100.0;

/// Keys of the rows in the data, their names, and the rules.
const ROWS: [(&str, &str); 4] = [
    ("wang_cluett", "Wang–Cluett"),
    ("sree_chidambaram", "Sree–Chidambaram"),
    ("ali_majhi", "Ali–Majhi"),
    ("proposed", "Proposed PD"),
];

type Pick = fn(&Metrics) -> Option<f64>;

const ISE: Pick = |m| m.ise;
const IAE: Pick = |m| m.iae;
const ENERGY: Pick = |m| m.control_energy;

/// One reading of the settings of a row.
struct Loop {
    controller: Controller,
    name: String,
    departure: Option<&'static str>,
}

/// All cells, in the order of the paper.
pub(super) fn cells() -> Result<Vec<Cell>, PaperError> {
    let paper = Paper::new()?;
    let mut cells = paper.parameters()?;
    let step = paper.scenario(vec![(0.0, 1.0)], vec![], 200.0)?;
    let load = paper.scenario(vec![], vec![(0.0, 1.0)], 200.0)?;
    let columns: [(&str, &str, Pick); 3] = [
        ("rise_s", "rise time [s]", |m| m.rise_time.map(|t| t.0)),
        ("settling_s", "settling time [s]", |m| m.settling_time.map(|t| t.0)),
        ("overshoot_pct", "overshoot [%]", |m| m.overshoot.map(|ratio| 100.0 * ratio)),
    ];
    paper.single(&mut cells, ("time_domain", "table1"), &columns, &step, false)?;
    let columns: [(&str, &str, Pick); 3] =
        [("ise", "ISE", ISE), ("iae", "IAE", IAE), ("itae", "ITAE", |m| m.itae)];
    paper.single(&mut cells, ("step_indices", "table2"), &columns, &step, false)?;
    let columns: [(&str, &str, Pick); 1] = [("", "control signal energy", ENERGY)];
    paper.single(&mut cells, ("control_energy", "table3"), &columns, &step, false)?;
    paper.servo(
        &mut cells,
        ("servo_ise", "tab_servo_ISE"),
        ["ISE, SP = 1", "ISE, SP = 3", "ISE, SP = 2"],
        ISE,
    )?;
    paper.servo(
        &mut cells,
        ("servo_iae", "tab_servo_IAE"),
        ["IAE, SP = 1", "IAE, SP = 3", "IAE, SP = 2"],
        IAE,
    )?;
    let columns: [(&str, &str, Pick); 3] =
        [("ise", "ISE", ISE), ("iae", "IAE", IAE), ("energy", "control signal energy", ENERGY)];
    paper.single(&mut cells, ("regulatory", "tab6"), &columns, &load, true)?;
    paper.servo_and_regulatory(&mut cells, &columns, &step, &load)?;
    Ok(cells)
}

struct Paper {
    printed: toml::Table,
    process: Process,
}

impl Paper {
    fn new() -> Result<Self, PaperError> {
        let printed = PRINTED
            .parse::<toml::Table>()
            .map_err(|error| TextError::at("", Problem::Syntax { message: error.message().to_owned() }))?;
        let process = Process::integrating(0.0506, Seconds(6.0)).map_err(StudyProblem::from)?;
        Ok(Self { printed, process })
    }

    /// The text of a printed number.
    fn text(&self, table: &str, row: &str, key: &str) -> Result<&str, PaperError> {
        let row = self.printed.get(table).and_then(|table| table.get(row));
        let value = row.and_then(|row| match key.parse::<usize>() {
            Ok(index) => row.get(index),
            Err(_) if key.is_empty() => Some(row),
            Err(_) => row.get(key),
        });
        value.and_then(toml::Value::as_str).ok_or_else(|| {
            let allowed = "a number as text";
            TextError::at(format!("{table}.{key}"), Problem::Missing { allowed }).into()
        })
    }

    fn number(&self, table: &str, row: &str, key: &str) -> Result<f64, PaperError> {
        Ok(crate::model::quantity::read_number(key, self.text(table, row, key)?)?)
    }

    fn printed(
        &self,
        (table, label): (&str, &'static str),
        (row, name): (&str, &'static str),
        key: &str,
        column: &'static str,
    ) -> Result<Printed<'_>, PaperError> {
        let (text, value) = (self.text(table, row, key)?, self.number(table, row, key)?);
        Ok(Printed { table: label, row: name, column, text, value })
    }

    fn tune(&self, id: &str, set: &[(&str, f64)]) -> Result<Tuning, PaperError> {
        let parameters = set.iter().fold(Parameters::new(), |all, (name, value)| all.set(*name, *value));
        let tuned = rule(id).and_then(|rule| rule.tune(&self.process, &parameters));
        Ok(tuned.map_err(StudyProblem::from)?)
    }

    fn scenario(
        &self,
        setpoint: Vec<(f64, f64)>,
        load: Vec<(f64, f64)>,
        horizon: f64,
    ) -> Result<Scenario, PaperError> {
        Scenario::new(setpoint, load, Seconds(horizon), 0.0).map_err(|error| {
            TextError::at("scenario", Problem::Conflict { reason: error.to_string().into() }).into()
        })
    }

    fn metrics(&self, controller: &Controller, scenario: &Scenario) -> Result<Metrics, PaperError> {
        let response = simulate(&ClosedLoop::new(&self.process, controller), scenario)
            .map_err(|error| StudyProblem::Response { scenario: "published".to_owned(), error })?;
        Ok(response.metrics)
    }

    /// The readings of the settings of a row, the stated one first; with the observer where the paper uses it.
    fn loops(&self, row: &str, with_observer: bool) -> Result<Vec<Loop>, PaperError> {
        let table = "controller_parameters";
        let (kc, td) = (self.number(table, row, "kc")?, self.number(table, row, "td_s")?);
        let model = |error| PaperError::from(StudyProblem::from(error));
        let filtered = |controller: Controller| controller.with_filter_bandwidth(FILTER).map_err(model);
        let time = |controller: Controller| controller.with_derivative_time(Seconds(td)).map_err(model);
        let plain = Controller::proportional(kc).map_err(model)?;
        if row == "proposed" {
            let parallel = Parallel { proportional_gain: kc, integral_gain: None, derivative_gain: Some(td) };
            let (mut ideal, mut parallel) =
                (filtered(time(plain)?)?, filtered(parallel.controller().map_err(model)?)?);
            if with_observer {
                let observer = Observer::new(kc).map_err(model)?;
                (ideal, parallel) = (ideal.with_observer(observer), parallel.with_observer(observer));
            }
            return Ok(vec![
                Loop {
                    controller: ideal,
                    name: "printed settings, Kc(1 + Td s)".to_owned(),
                    departure: None,
                },
                Loop {
                    controller: parallel,
                    name: "printed settings, Kc + 1.0343 s (parallel form)".to_owned(),
                    departure: Some(
                        "the derivative gain is 1.0343, not the derivative time: u = Kc e + 1.0343 de/dt",
                    ),
                },
            ]);
        }
        let ti = self.number(table, row, "ti_s")?;
        let controller = filtered(time(plain.with_integral_time(Seconds(ti)).map_err(model)?)?)?;
        let mut loops = vec![Loop { controller, name: "printed settings".to_owned(), departure: None }];
        if row == "wang_cluett" {
            let text = self.tune("pid-wang-cluett-z1", &[("beta", 3.0)])?;
            loops[0].name = "printed settings (β = 4)".to_owned();
            loops.push(Loop {
                controller: filtered(text.controller)?,
                name: "settings of β = 3".to_owned(),
                departure: Some(
                    "the settings are those of β = 3, which the text states, not the printed ones of β = 4",
                ),
            });
        }
        Ok(loops)
    }

    /// The settings themselves.
    fn parameters(&self) -> Result<Vec<Cell>, PaperError> {
        let asked = [("Ts", 40.0), ("Am", 2.0), ("phi_m", std::f64::consts::PI)];
        let mut cells = Vec::new();
        for row in ROWS {
            let tuned = match row.0 {
                "wang_cluett" => vec![
                    ("rule with β = 3", None, self.tune("pid-wang-cluett-z1", &[("beta", 3.0)])?),
                    (
                        "rule with β = 4",
                        Some("the settings are those of β = 4, although the text states β = 3"),
                        self.tune("pid-wang-cluett-z1", &[("beta", 4.0)])?,
                    ),
                ],
                "sree_chidambaram" => vec![("rule", None, self.tune("pid-sree-chidambaram", &[])?)],
                "ali_majhi" => vec![("rule", None, self.tune("pid-ali-majhi", &[])?)],
                _ => vec![(
                    "equations 9, 12, 13: Ts = 40 s, Am = 2, φ_m = 180°",
                    None,
                    self.tune("pd-kadam", &asked)?,
                )],
            };
            let columns: [(&str, &str, fn(&Controller) -> Option<f64>); 3] = [
                ("kc", "Kc", |c| Some(c.proportional_gain())),
                ("ti_s", "Ti [s]", Controller::integral_time),
                ("td_s", "Td [s]", Controller::derivative_time),
            ];
            for (key, column, pick) in
                columns.into_iter().filter(|(key, ..)| *key != "ti_s" || row.0 != "proposed")
            {
                let candidates: Vec<Candidate> = tuned
                    .iter()
                    .map(|(name, departure, tuning)| Candidate {
                        convention: (*name).to_owned(),
                        computed: pick(&tuning.controller),
                        departure: departure.map(str::to_owned),
                    })
                    .collect();
                let place = ("controller_parameters", "TableControlParameters");
                cells.push(self.printed(place, row, key, column)?.judge(&candidates, &[]));
            }
        }
        Ok(cells)
    }

    /// A table whose cells are metrics of one scenario.
    fn single(
        &self,
        cells: &mut Vec<Cell>,
        place: (&str, &'static str),
        columns: &[(&str, &'static str, Pick)],
        scenario: &Scenario,
        with_observer: bool,
    ) -> Result<(), PaperError> {
        let run = format!("N = 100 rad/s, {} s", scenario.horizon());
        for row in ROWS {
            let mut results = Vec::new();
            for reading in self.loops(row.0, with_observer)? {
                let metrics = self.metrics(&reading.controller, scenario)?;
                results.push((reading, metrics));
            }
            for &(key, column, pick) in columns {
                let candidates: Vec<Candidate> = results
                    .iter()
                    .map(|(reading, metrics)| candidate(reading, &run, None, pick(metrics)))
                    .collect();
                let floors = self.floors(column, row.0, scenario)?;
                cells.push(self.printed(place, row, key, column)?.judge(&candidates, &floors));
            }
        }
        Ok(())
    }

    /// What no cell of an index can lie below: the bounds of every controller, and ∫|e| ≥ |∫e|.
    fn floors(&self, column: &str, row: &str, scenario: &Scenario) -> Result<Vec<Floor>, PaperError> {
        let bounds = Bounds::of(&self.process, scenario);
        let least = match column {
            "ISE" => bounds.ise,
            "IAE" => bounds.iae,
            "ITAE" => bounds.itae,
            _ => None,
        };
        let d = self.process.dead_time();
        let event = if scenario.load().is_empty() {
            format!("the error is the whole step until the dead time of {d} s is over")
        } else {
            format!(
                "the load moves the output freely for the dead time of {d} s before any controller sees it act"
            )
        };
        let of_all = least.map(|least| Floor {
            least,
            why: format!("no controller has an {column} below {}: {event}", rounded(least)),
        });
        let kc = self.number("controller_parameters", row, "kc")?;
        let k = self.process.process_gain();
        // Exact for the whole time axis; both loops have settled to 1e-9 at 200 s.
        let identity = match (row, column, scenario.load().is_empty()) {
            ("proposed", "IAE", true) => Some((1.0 / (k * kc), "1/(K Kc)")),
            ("proposed", "IAE", false) => Some((1.0 / (k * kc * kc), "1/(K Kc Ko)")),
            _ => None,
        };
        let of_loop = identity.map(|(least, formula)| Floor {
            least,
            why: format!("∫|e| ≥ |∫e| = {formula} = {} is an identity of this loop", rounded(least)),
        });
        Ok(of_all.into_iter().chain(of_loop).collect())
    }

    /// A servo table: three setpoints in one run, or each move alone.
    fn servo(
        &self,
        cells: &mut Vec<Cell>,
        place: (&str, &'static str),
        columns: [&'static str; 3],
        pick: Pick,
    ) -> Result<(), PaperError> {
        let moves = [(0.0, 1.0), (100.0, 3.0), (200.0, 2.0)];
        let sizes = [1.0, 2.0, 1.0];
        for row in ROWS {
            let mut candidates = [Vec::new(), Vec::new(), Vec::new()];
            for reading in self.loops(row.0, false)? {
                let mut before = 0.0;
                for (index, candidates) in candidates.iter_mut().enumerate() {
                    let (horizon, events) = (100.0 * (index as f64 + 1.0), moves[..=index].to_vec());
                    let up_to =
                        pick(&self.metrics(&reading.controller, &self.scenario(events, vec![], horizon)?)?);
                    let run = "N = 100 rad/s, one run, interval of 100 s";
                    candidates.push(candidate(&reading, run, None, up_to.map(|up_to| up_to - before)));
                    before = up_to.unwrap_or(before);
                }
                for (candidates, size) in candidates.iter_mut().zip(sizes) {
                    let alone = self.scenario(vec![(0.0, size)], vec![], 200.0)?;
                    let departure = "each move is simulated alone, from rest, for 200 s";
                    let computed = pick(&self.metrics(&reading.controller, &alone)?);
                    let run = "N = 100 rad/s, each move alone, 200 s";
                    candidates.push(candidate(&reading, run, Some(departure), computed));
                }
            }
            for (index, candidates) in candidates.iter().enumerate() {
                let printed = self.printed(place, row, &index.to_string(), columns[index])?;
                cells.push(printed.judge(candidates, &[]));
            }
        }
        Ok(())
    }

    /// Setpoint step, then a load: one run, or the sum of two.
    fn servo_and_regulatory(
        &self,
        cells: &mut Vec<Cell>,
        columns: &[(&str, &'static str, Pick)],
        step: &Scenario,
        load: &Scenario,
    ) -> Result<(), PaperError> {
        let both = self.scenario(vec![(0.0, 1.0)], vec![(100.0, 1.0)], 300.0)?;
        for row in ROWS {
            let mut results = Vec::new();
            for reading in self.loops(row.0, true)? {
                let of = |scenario| self.metrics(&reading.controller, scenario);
                let metrics = [of(&both)?, of(step)?, of(load)?];
                results.push((reading, metrics));
            }
            for &(key, column, pick) in columns {
                let candidates: Vec<Candidate> = results
                    .iter()
                    .flat_map(|(reading, [both, step, load])| {
                        let sum = pick(step).zip(pick(load)).map(|(step, load)| step + load);
                        let departure = "the number is the sum of two separate runs of 200 s";
                        [
                            candidate(reading, "N = 100 rad/s, one run of 300 s", None, pick(both)),
                            candidate(reading, "N = 100 rad/s, two runs added", Some(departure), sum),
                        ]
                    })
                    .collect();
                cells.push(
                    self.printed(("servo_and_regulatory", "table7"), row, key, column)?
                        .judge(&candidates, &[]),
                );
            }
        }
        Ok(())
    }
}

fn candidate(reading: &Loop, run: &str, departure: Option<&str>, computed: Option<f64>) -> Candidate {
    let departures: Vec<&str> = reading.departure.into_iter().chain(departure).collect();
    Candidate {
        convention: format!("{}, {run}", reading.name),
        computed,
        departure: (!departures.is_empty()).then(|| departures.join("; ")),
    }
}

/// Four significant digits for a sentence.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
