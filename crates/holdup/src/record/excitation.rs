//! What in a record tells the process apart from its controller.
//!
//! In automatic with a constant setpoint a linear controller makes the input a function of the output: process gain and dead
//! time then follow from what is assumed of the noise, and of a steady oscillation the inverse of the controller fits
//! perfectly. What helps is movement that does not come from the output: setpoint moves, a hand, a limit. The loop is run again
//! on that alone, and what its input and output say about gain and dead time is the part of the information that needs no
//! noise model (L. Ljung, System Identification, 2nd ed. (1999), section 13.4; U. Forssell and L. Ljung, Automatica 35 (1999)
//! 1215).

use serde::Serialize;

use super::controller::{RunningController, limited};
use super::identify::{Basis, Fit, Joint, Problem, dot};
use super::replay::{Drive, Law, run};
use super::{Operation, Record};

/// Beyond this a loop that runs away is no longer followed: squares of its signals must stay numbers.
const LARGEST: f64 = 1e100;

/// What moved the loop from outside.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Excitation {
    /// Whether a controller moved the actuator in most rows.
    pub closed_loop: bool,
    /// Rows at which the setpoint moves.
    pub setpoint_moves: usize,
    /// Rows at which a hand moves the actuator.
    pub moves_by_hand: usize,
    /// Rows in automatic at which the actuator stands at a limit.
    pub limited_rows: usize,
    /// Sign of the recovered controller's gain, and with it of the process gain; 0 where it is not known.
    #[serde(skip)]
    pub(crate) sign: f64,
}

impl Excitation {
    /// Looks at a record whose controller, if one is seen, is this.
    pub(crate) fn of(record: &Record, controller: Option<&RunningController>) -> Self {
        let operation = |k: usize| record.operation().map_or(Operation::Unknown, |of| of[k]);
        let rows = record.len();
        let count = |what: Operation| (0..rows).filter(|&k| operation(k) == what).count();
        let (automatic, manual) = (count(Operation::Automatic), count(Operation::Manual));
        let unknown = rows - automatic - manual;
        let closed_loop = 2 * automatic > rows || (controller.is_some() && 2 * (automatic + unknown) > rows);
        let input = record.manipulated_variable();
        let by_hand = |k: usize| !closed_loop || operation(k) == Operation::Manual;
        let moves_by_hand = (1..rows).filter(|&k| by_hand(k) && input[k] != input[k - 1]).count();
        let setpoint_moves = record
            .setpoint()
            .map_or(0, |setpoint| setpoint.windows(2).filter(|pair| pair[0] != pair[1]).count());
        let stands = limited(record);
        let limited_rows = (0..rows).filter(|&k| closed_loop && !by_hand(k) && stands[k]).count();
        let sign = controller.map_or(0.0, |controller| controller.proportional_gain.value.signum());
        Self { closed_loop, setpoint_moves, moves_by_hand, limited_rows, sign }
    }

    /// Whether anything at all moved the loop from outside.
    #[must_use]
    pub fn any(&self) -> bool {
        !self.closed_loop || self.setpoint_moves + self.moves_by_hand + self.limited_rows > 0
    }

    /// What there is, in words.
    #[must_use]
    pub fn text(&self) -> String {
        if !self.closed_loop {
            return "moves of the manipulated variable that do not come from the controlled variable"
                .to_owned();
        }
        let parts = [
            (self.setpoint_moves, "rows with a setpoint move"),
            (self.moves_by_hand, "rows moved by hand"),
            (self.limited_rows, "rows at a limit"),
        ];
        let parts: Vec<String> = parts
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, what)| format!("{count} {what}"))
            .collect();
        if parts.is_empty() { "nothing".to_owned() } else { parts.join(", ") }
    }
}

/// What the movement from outside alone says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Outside {
    /// Standard deviation of the gain over the gain.
    pub(crate) relative_deviation: f64,
    /// Distance of the estimate by instruments from the fit, in standard deviations.
    pub(crate) disagreement: f64,
    /// Variances of gain and dead time over those of the fit, which uses the answer of the controller to the noise too.
    pub(crate) excess: [f64; 2],
}

/// Controlled and manipulated variable as setpoint, hand and limits alone would have moved them, as deviations: the loop is
/// run with the recovered controller. `None` where that runs away.
pub(crate) fn moved_from_outside(
    record: &Record,
    fit: Fit,
    controller: &RunningController,
) -> Option<(Vec<f64>, Vec<f64>)> {
    let law = Law::recovered(controller).ok()?;
    let (time, input) = (record.time(), record.manipulated_variable());
    let rows = record.len();
    let setpoint: Vec<f64> =
        record.setpoint().map_or_else(|| vec![0.0; rows], |r| r.iter().map(|value| value - r[0]).collect());
    let stands = limited(record);
    let operation = |k: usize| record.operation().map_or(Operation::Unknown, |of| of[k]);
    let hand = |k: usize| operation(k) == Operation::Manual || (stands[k] && k > 0 && stands[k - 1]);
    let by_hand: Vec<Option<f64>> =
        (0..rows).map(|k| (k > 0 && hand(k)).then(|| input[k] - input[k - 1])).collect();
    let nothing = vec![0.0; rows];
    let drive = Drive { setpoint: &setpoint, by_hand: &by_hand, load: &nothing, disturbance: &nothing };
    let moved = run(&law, fit, time, &drive).ok()?;
    moved.0.iter().chain(&moved.1).all(|value| value.abs() < LARGEST).then_some(moved)
}

/// What the movement from outside says about the fit.
pub(crate) fn outside(
    record: &Record,
    problem: &Problem<'_>,
    joint: &Joint,
    controller: &RunningController,
) -> Outside {
    let Some((_, moved)) = moved_from_outside(record, joint.fit, controller) else {
        return Outside { relative_deviation: f64::INFINITY, disagreement: 0.0, excess: [1.0; 2] };
    };
    // Gain and dead time by the columns that the movement from outside makes.
    let fit = &joint.fit;
    let whitener = joint.whitener(problem);
    let shape = fit.kind.shape(fit.lag);
    let own =
        Basis::of(problem.own_columns(fit.kind, fit.lag).into_iter().map(|column| whitener.whiten(column)));
    let of_outside = problem.with_input(record, &moved);
    let column = |of: &Problem<'_>, rate: bool| {
        let shape = if rate { shape.rate() } else { shape };
        let factor = if rate { -fit.gain } else { 1.0 };
        let column = of.column(shape, fit.dead_time).into_iter().map(|value| factor * value).collect();
        own.projected(whitener.whiten(column))
    };
    let instruments = [column(&of_outside, false), column(&of_outside, true)];
    let columns = [column(problem, false), column(problem, true)];
    let response = own.projected(whitener.whiten(problem.response.clone()));
    let residual: Vec<f64> = response.iter().zip(&columns[0]).map(|(y, v)| y - fit.gain * v).collect();
    let variance = fit.squares / joint.freedom;
    let [zz, zs, ss] = [
        dot(&instruments[0], &instruments[0]),
        dot(&instruments[0], &instruments[1]),
        dot(&instruments[1], &instruments[1]),
    ];
    let determinant = zz * ss - zs * zs;
    // A dead time that the movement does not show leaves the gain.
    let gain_variance =
        if determinant > 1e-9 * zz * ss { variance * ss / determinant } else { variance / zz };
    let deviation = gain_variance.sqrt();
    let [vv, vs, ww] =
        [dot(&columns[0], &columns[0]), dot(&columns[0], &columns[1]), dot(&columns[1], &columns[1])];
    let whole = vv * ww - vs * vs;
    let excess = [ss / determinant * whole / ww, zz / determinant * whole / vv]
        .map(|excess| if excess.is_finite() { excess.max(1.0) } else { 1.0 });
    let cross = |a: usize, b: usize| dot(&instruments[a], &columns[b]);
    let [a, b, c, d] = [cross(0, 0), cross(0, 1), cross(1, 0), cross(1, 1)];
    let [p, q] = [dot(&instruments[0], &residual), dot(&instruments[1], &residual)];
    let change = (p * d - q * b) / (a * d - b * c);
    let disagreement = (change / deviation).abs();
    Outside {
        relative_deviation: if deviation.is_finite() { deviation / fit.gain.abs() } else { f64::INFINITY },
        disagreement: if disagreement.is_finite() { disagreement } else { 0.0 },
        excess,
    }
}
