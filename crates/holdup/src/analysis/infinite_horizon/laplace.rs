//! The Laplace transform of the error after a unit step, from the same description that the simulation propagates.

use num_complex::Complex64;

use crate::model::ClosedLoop;
use crate::model::closed_loop::{Source, Sum};

/// Where the unit step enters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// The setpoint r.
    Setpoint,
    /// The load disturbance D at the process input.
    Load,
}

/// E(s) = R(s) − Y(s) [output unit · s] at a point that is no pole of the closed loop and not 0.
///
/// States and channel inputs are the unknowns of one linear system; `None` where it is singular.
pub(super) fn error(closed_loop: &ClosedLoop, input: Input, s: Complex64) -> Option<Complex64> {
    let states = closed_loop.rates().len();
    let size = states + closed_loop.channels().len();
    let step = s.inv();
    let mut rows = vec![vec![Complex64::ZERO; size + 1]; size];
    for (index, sum) in closed_loop.rates().iter().enumerate() {
        rows[index][index] += s;
        subtract(&mut rows[index], closed_loop, sum, input, s);
    }
    for (index, channel) in closed_loop.channels().iter().enumerate() {
        rows[states + index][states + index] += 1.0;
        subtract(&mut rows[states + index], closed_loop, &channel.input, input, s);
    }
    let solution = solved(rows)?;
    let setpoint = if input == Input::Setpoint { step } else { Complex64::ZERO };
    Some(setpoint - solution[closed_loop.controlled_variable()])
}

/// Takes a sum to the left side of its equation; the last column is the right side.
fn subtract(row: &mut [Complex64], closed_loop: &ClosedLoop, sum: &Sum, input: Input, s: Complex64) {
    let states = closed_loop.rates().len();
    let right = row.len() - 1;
    for &(source, weight) in sum.terms() {
        match source {
            Source::State(index) => row[index] -= weight,
            Source::Delayed(index) => {
                row[states + index] -= weight * (-s * closed_loop.channels()[index].delay).exp();
            }
            Source::Setpoint if input == Input::Setpoint => row[right] += weight / s,
            Source::SetpointRate if input == Input::Setpoint => row[right] += weight,
            Source::Load if input == Input::Load => row[right] += weight / s,
            Source::Setpoint | Source::SetpointRate | Source::Load => {}
        }
    }
}

/// Gauss's elimination with the largest pivot of each column.
fn solved(mut rows: Vec<Vec<Complex64>>) -> Option<Vec<Complex64>> {
    let size = rows.len();
    for column in 0..size {
        let pivot =
            (column..size).max_by(|&a, &b| rows[a][column].norm().total_cmp(&rows[b][column].norm()))?;
        rows.swap(column, pivot);
        let (done, rest) = rows.split_at_mut(column + 1);
        let top = &done[column];
        if top[column].norm() == 0.0 || !top[column].is_finite() {
            return None;
        }
        for row in rest {
            let factor = row[column] / top[column];
            for (cell, above) in row.iter_mut().zip(top).skip(column) {
                *cell -= factor * above;
            }
        }
    }
    let mut solution = vec![Complex64::ZERO; size];
    for index in (0..size).rev() {
        let known: Complex64 = (index + 1..size).map(|k| rows[index][k] * solution[k]).sum();
        solution[index] = (rows[index][size] - known) / rows[index][index];
    }
    Some(solution)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Controller, Process, Seconds};

    #[test]
    fn the_error_is_that_of_the_textbook() {
        let process = Process::integrating(2.0, Seconds(0.7)).unwrap();
        let pi = Controller::proportional(0.3).unwrap().with_integral_time(Seconds(5.0)).unwrap();
        let closed_loop = ClosedLoop::new(&process, &pi);
        let s = Complex64::new(-0.1, 1.3);
        let plant = 2.0 * (-0.7 * s).exp() / s;
        let open = plant * 0.3 * (1.0 + 1.0 / (5.0 * s));
        let (setpoint, load) = (1.0 / s / (1.0 + open), -plant / s / (1.0 + open));
        // A few dozen roundings.
        assert!((error(&closed_loop, Input::Setpoint, s).unwrap() - setpoint).norm() < 1e-13);
        assert!((error(&closed_loop, Input::Load, s).unwrap() - load).norm() < 1e-13);
    }
}
