//! The fit of the integrating process to many rows at once, where noise is white: all dead times in one pass.
//!
//! On even rows every dead time is weighed at once (`even`); otherwise the general search serves.

use serde::Serialize;
use thiserror::Error;

use super::even;
use super::kind::{Hold, Kind, Load};
use super::noise::{Noise, Whitener};
use super::problem::{Problem, Whitened};
use super::search::search;
use crate::model::Seconds;
use crate::record::Record;

/// Share of the record that the dead time may take at most, where no limit is given.
const SHARE: f64 = 0.25;

/// Rows that the dead time may take at most, where no limit is given.
const MOST_ROWS: f64 = 2000.0;

/// The greatest dead time that is looked for \[s\], where none is given: a quarter of the record and at most 2000 rows.
#[must_use]
pub fn greatest_dead_time(record: &Record) -> f64 {
    let span = record.time()[record.len() - 1] - record.time()[0];
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let step = span / (record.len() - 1) as f64;
    (SHARE * span).min(MOST_ROWS * step)
}

/// Why a point fit gives nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum PointError {
    /// The input does not move, or moves only where no row shows it.
    #[error("the manipulated variable does not move: no dead time and no gain can be seen")]
    Still,
}

/// Gain and dead time of the integrating process by least squares, with white noise assumed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PointFit {
    /// Process gain [output unit/(input unit·s)].
    pub process_gain: f64,
    /// Dead time [s].
    #[serde(rename = "dead_time_s")]
    pub dead_time: f64,
    /// Standard deviation of what the fit leaves [output unit].
    pub residual: f64,
}

/// Fits the integrating process with unknown initial value and unknown constant load, the input held, at rest before the
/// record. The dead time is the global best from 0 to `greatest` \[s\].
///
/// # Errors
/// [`PointError::Still`] where the input does not move.
///
/// ```
/// use holdup::model::Seconds;
/// use holdup::record::Record;
/// use holdup::record::identify::point_fit;
///
/// // A tank, the valve opened by 10 % at 20 s and closed again at 60 s; gain 0.002 /s, dead time 7.3 s.
/// let time: Vec<f64> = (0..200).map(f64::from).collect();
/// let valve: Vec<f64> = time.iter().map(|t| if (20.0..60.0).contains(t) { 60.0 } else { 50.0 }).collect();
/// let level = time.iter().map(|t| 40.0 + 0.002 * 10.0 * (t - 27.3).clamp(0.0, 40.0)).collect();
/// let fit = point_fit(&Record::new(time, level, valve)?, Seconds(50.0))?;
/// assert!((fit.process_gain - 0.002).abs() < 1e-12 && (fit.dead_time - 7.3).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn point_fit(record: &Record, greatest: Seconds) -> Result<PointFit, PointError> {
    let time = record.time();
    let rows = time.len();
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let step = (time[rows - 1] - time[0]) / (rows - 1) as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most the number of rows")]
    let delays = ((greatest.0 / step).ceil().max(1.0) as usize).min(rows / 2).max(1);
    let input = record.manipulated_variable();
    if input.iter().all(|value| *value == input[0]) {
        return Err(PointError::Still);
    }
    if rows > 8 && even::are_even(time, step) {
        let fit = even::fit(input, record.controlled_variable(), delays).ok_or(PointError::Still)?;
        return Ok(PointFit {
            process_gain: fit.gain / step,
            dead_time: fit.dead_time * step,
            residual: deviation(fit.squares, rows),
        });
    }
    let problem = Problem::new(record, 0, 1, Hold::Constant, Load::Constant);
    let white = Whitener::new(&Noise::WHITE, &problem.times);
    let whitened = Whitened::new(&problem, &white, Kind::Integrating);
    let fit = search(&whitened, step, greatest.0).ok_or(PointError::Still)?;
    Ok(PointFit { process_gain: fit.gain, dead_time: fit.dead_time, residual: deviation(fit.squares, rows) })
}

/// Standard deviation of residuals after four numbers have been fitted.
#[expect(clippy::cast_precision_loss, reason = "a number of rows")]
fn deviation(squares: f64, rows: usize) -> f64 {
    (squares / rows.saturating_sub(4).max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;

    fn plant(rows: u32, dead_time: f64, noise: f64) -> Record {
        let mut random = ChaCha8Rng::seed_from_u64(7);
        let time: Vec<f64> = (0..rows).map(|k| 0.5 * f64::from(k)).collect();
        let mut value = 30.0;
        let input: Vec<f64> = time
            .iter()
            .map(|_| {
                if random.random_range(0.0..1.0) < 0.05 {
                    value = random.random_range(20.0..40.0);
                }
                value
            })
            .collect();
        let of = super::super::input::Input::new(&time, &input, Hold::Constant);
        let mut level = of.column(super::super::input::Shape::Integral, dead_time, &time);
        for (value, t) in level.iter_mut().zip(&time) {
            *value = 0.02 * *value + 5.0 + 0.001 * t + noise * random.random_range(-1.0..1.0);
        }
        Record::new(time, level, input).unwrap()
    }

    /// The fast path finds what the general search finds: with noise the same minimum, to the rounding of the sums (1e-7
    /// of the dead time, whose place at a minimum is known to the square root of rounding only).
    #[test]
    fn all_at_once_is_one_by_one() {
        for (rows, greatest) in [(400, 8.0), (3000, 90.0), (5000, 40.0)] {
            let record = plant(rows, 6.37, 0.3);
            let fit = point_fit(&record, Seconds(greatest)).unwrap();
            let problem = Problem::new(&record, 0, 1, Hold::Constant, Load::Constant);
            let white = Whitener::new(&Noise::WHITE, &problem.times);
            let slow = search(&Whitened::new(&problem, &white, Kind::Integrating), 0.5, greatest).unwrap();
            assert!((fit.dead_time - slow.dead_time).abs() < 1e-7 * slow.dead_time, "{fit:?} {slow:?}");
            assert!((fit.process_gain - slow.gain).abs() < 1e-9 * slow.gain);
        }
    }

    /// 1e-9: rounding of sums over 5000 rows of 1e3, on a condition of 1e2.
    #[test]
    fn without_noise_the_plant_comes_back() {
        for (rows, dead_time) in [(60, 1.3), (600, 0.0), (600, 0.2), (600, 17.77), (5000, 123.456)] {
            let fit = point_fit(&plant(rows, dead_time, 0.0), Seconds(140.0)).unwrap();
            assert!((fit.dead_time - dead_time).abs() < 1e-9 * dead_time.max(1.0), "{fit:?}");
            assert!((fit.process_gain - 0.02).abs() < 2e-11);
        }
    }

    /// No other dead time leaves less: on short records with every kind of input, against a dense grid of dead times. 1e-9:
    /// the squares are differences of sums.
    #[test]
    fn no_dead_time_of_a_grid_leaves_less() {
        let mut random = ChaCha8Rng::seed_from_u64(11);
        let mut fitted = 0;
        for case in 0..200 {
            let rows = random.random_range(9..90_u32);
            let (chance, noise) = ([0.05, 0.3, 1.0][case % 3], [0.0, 0.1, 3.0][case / 3 % 3]);
            let mut value = [0.0, 1e3][case % 2];
            let mut input = Vec::new();
            for _ in 0..rows {
                if random.random_range(0.0..1.0) < chance {
                    value += random.random_range(-1.0..1.0);
                }
                input.push(value);
            }
            let time: Vec<f64> = (0..rows).map(f64::from).collect();
            let dead_time = random.random_range(0.0..f64::from(rows) / 2.0);
            let of = super::super::input::Input::new(&time, &input, Hold::Constant);
            let mut level = of.column(super::super::input::Shape::Integral, dead_time, &time);
            for value in &mut level {
                *value = 0.1 * *value + noise * random.random_range(-1.0..1.0);
            }
            let record = Record::new(time, level, input).unwrap();
            let greatest = random.random_range(1..=rows / 2);
            let Ok(fit) = point_fit(&record, Seconds(f64::from(greatest))) else { continue };
            fitted += 1;
            let problem = Problem::new(&record, 0, 1, Hold::Constant, Load::Constant);
            let white = Whitener::new(&Noise::WHITE, &problem.times);
            let whitened = Whitened::new(&problem, &white, Kind::Integrating);
            let found = whitened.at(fit.dead_time, 0.0).squares;
            let total = whitened.rest(1.0).1.iter().map(|y| y * y).sum::<f64>();
            for part in 0..=8 * greatest {
                let other = whitened.at(f64::from(part) / 8.0, 0.0).squares;
                assert!(found <= other + 1e-9 * total, "{case}: {fit:?}, {found} against {other}");
            }
        }
        assert!(fitted > 150, "{fitted}");
    }

    #[test]
    fn an_input_that_stands_still_is_refused() {
        let time: Vec<f64> = (0..50).map(f64::from).collect();
        let record = Record::new(time.clone(), time, vec![3.0; 50]).unwrap();
        assert_eq!(point_fit(&record, Seconds(5.0)), Err(PointError::Still));
    }
}
