//! What the paper's numbers turn out to be, from the judged cells and from the loops themselves.

use super::super::{Cell, Finding, PublishedError, Verdict};
use super::{FILTER_BANDWIDTH, scenario};
use crate::analysis::frequency::{Margins, margins};
use crate::analysis::response::simulate;
use crate::model::{ClosedLoop, Controller, Observer, Process, Seconds};
use crate::tuning::{Parameters, rule};

/// The findings, the weightiest first.
pub(super) fn of(process: &Process, cells: &[Cell]) -> Result<Vec<Finding>, PublishedError> {
    Ok(vec![
        specified_margins(process)?,
        settling_families(process)?,
        observer_cost(process)?,
        impossible_cells(cells),
        two_readings(
            cells,
            "wang_cluett",
            "Wang–Cluett is used with two different tunings",
            ["β = 3, as in the text", "β = 4, as in the parameter table"],
        ),
        two_readings(
            cells,
            "proposed",
            "The proposed PD was simulated with a derivative gain of 1.0343, not a derivative time of 1.0343 s",
            ["ideal form, derivative time 1.0343 s", "parallel form, derivative gain 1.0343"],
        ),
        unexplained_cells(cells),
    ])
}

fn specified_margins(process: &Process) -> Result<Finding, PublishedError> {
    let tuning = rule("pd-kadam")?.tune(process, &Parameters::new())?;
    let achieved = margins(&ClosedLoop::new(process, &tuning.controller))?;
    Ok(Finding {
        title: "The specified margins are not achieved, and cannot be".to_owned(),
        text: format!(
            "Asked for a gain margin of 2 and a phase margin of 180°, the loop (ideal derivative) has {}. \
             The tangent in (9) has the period π, so 180° and 0° give the same derivative time, and no PD \
             controller with a derivative time of 0 or more has a phase margin of 180° on an integrator with \
             dead time. (13) puts the gain crossover above the phase crossover, which no gain margin above 1 \
             allows, because |L| of a PD loop falls strictly with frequency.",
            describe(&achieved)
        ),
        points: tuning.warnings,
    })
}

fn settling_families(process: &Process) -> Result<Finding, PublishedError> {
    let family = |name: &'static str, values: [f64; 4]| -> Result<String, PublishedError> {
        let mut settled = Vec::new();
        for value in values {
            let controller = rule("pd-kadam")?
                .tune(process, &Parameters::new().set(name, value))?
                .controller
                .with_filter_bandwidth(FILTER_BANDWIDTH)?;
            let run =
                simulate(&ClosedLoop::new(process, &controller), &scenario(&[(0.0, 1.0)], &[], 400.0)?)?;
            let time = run.metrics.settling_time;
            settled.push(time.map_or("none".to_owned(), |Seconds(t)| format!("{t:.1}")));
        }
        Ok(settled.join(" / "))
    };
    Ok(Finding {
        title: "The settling time does not follow its specification, nor the gain margin as stated"
            .to_owned(),
        text: format!(
            "For T_s = 40 / 50 / 60 / 70 s the response settles to 2 % after {} s; for A_m = 1 / 1.5 / 2 / 2.5 \
             after {} s. From T_s > 8·d on, equation (9) gives a negative derivative time, and “ignore the \
             negative sign” drops the phase equation altogether.",
            family("Ts", [40.0, 50.0, 60.0, 70.0])?,
            family("Am", [1.0, 1.5, 2.0, 2.5])?
        ),
        points: Vec::new(),
    })
}

fn observer_cost(process: &Process) -> Result<Finding, PublishedError> {
    let pd = rule("pd-kadam")?.tune(process, &Parameters::new())?.controller;
    let kc = pd.proportional_gain();
    let with_observer = pd.with_observer(Observer::new(kc)?);
    let parallel = Controller::proportional(kc)?
        .with_derivative_time(Seconds(pd.derivative_time().unwrap_or_default() / kc))?
        .with_filter_bandwidth(FILTER_BANDWIDTH)?;
    let of = |controller: &Controller| -> Result<String, PublishedError> {
        Ok(describe(&margins(&ClosedLoop::new(process, controller))?))
    };
    Ok(Finding {
        title: "The observer costs robustness that the paper does not report".to_owned(),
        text: "Both loops broken at the process input. Ko = Kc is the paper's choice, not a necessity: `dob-exact` \
               finds the observer gain for a stated M_s of the whole."
            .to_owned(),
        points: vec![
            format!("ideal derivative, PD loop alone: {}", of(&pd)?),
            format!("ideal derivative, with the observer: {}", of(&with_observer)?),
            format!("as simulated (parallel form, N = 100 rad/s), PD loop alone: {}", of(&parallel)?),
            format!("as simulated, with the observer: {}", of(&parallel.with_observer(Observer::new(kc)?))?),
        ],
    })
}

fn impossible_cells(cells: &[Cell]) -> Finding {
    let broken: Vec<String> = cells
        .iter()
        .filter(|c| c.verdict == Verdict::Impossible)
        .map(|c| {
            format!("{} (computed {:.4}): {}", name(c), c.computed, c.reason.as_deref().unwrap_or_default())
        })
        .collect();
    Finding {
        title: format!("{} printed cells are impossible", broken.len()),
        text: "They break a bound that holds for every controller, or an exact identity of the stated loop."
            .to_owned(),
        points: broken,
    }
}

fn two_readings(cells: &[Cell], row: &str, title: &str, conventions: [&str; 2]) -> Finding {
    let count = |convention: &str| {
        let of_row = |c: &&Cell| c.row == row && c.convention.starts_with(convention);
        let reproduced = cells.iter().filter(of_row).filter(|c| c.verdict == Verdict::Reproduced);
        let names: Vec<String> = reproduced.map(|c| format!("{} {}", c.table, c.column)).collect();
        format!("“{convention}” reproduces {} cells: {}", names.len(), names.join(", "))
    };
    Finding {
        title: title.to_owned(),
        text: "No single reading reproduces the row.".to_owned(),
        points: conventions.map(count).to_vec(),
    }
}

fn unexplained_cells(cells: &[Cell]) -> Finding {
    let named: Vec<String> = cells
        .iter()
        .filter(|c| matches!(c.verdict, Verdict::Close | Verdict::NotReproduced))
        .map(|c| {
            let percent = 100.0 * (c.computed / c.printed - 1.0);
            format!("{}, computed {:.5}: {percent:+.1} %", name(c), c.computed)
        })
        .collect();
    Finding {
        title: format!("{} cells differ without an explanation", named.len()),
        text: "No listed convention brings them within 0.5 %.".to_owned(),
        points: named,
    }
}

fn name(cell: &Cell) -> String {
    format!("{} {} {} = {}", cell.table, cell.row, cell.column, cell.printed)
}

fn describe(margins: &Margins) -> String {
    let number = |x: Option<f64>| x.map_or("none".to_owned(), |x| format!("{x:.3}"));
    format!(
        "gain margin {}, phase margin {}°, M_s {}, delay margin {} s",
        number(margins.gain_margin),
        number(margins.phase_margin.map(crate::model::Radians::degrees)),
        number(margins.sensitivity_peak),
        number(margins.delay_margin.map(|Seconds(t)| t))
    )
}
