//! The fit of the integrating process to many rows at once, where noise is white: all dead times in one pass.
//!
//! The sum of squares at dead time k sample periods needs the products of the controlled variable with the input's integral
//! k rows earlier: a correlation, by fast Fourier transforms. The products of the integral with itself and with its
//! neighbour slide along the record. Between two multiples of the sample period the best dead time solves a linear
//! equation (see `search`).

use std::cell::RefCell;

use realfft::RealFftPlanner;
use realfft::num_complex::Complex;
use serde::Serialize;
use thiserror::Error;

use super::kind::{Hold, Kind, Load};
use super::noise::{Noise, Whitener};
use super::problem::{Problem, Whitened};
use super::search::search;
use super::squares::dot;
use crate::model::Seconds;
use crate::record::Record;

thread_local! {
    /// Twiddle factors are worth keeping between calls.
    static PLANNER: RefCell<RealFftPlanner<f64>> = RefCell::new(RealFftPlanner::new());
}

/// Share of the record that the dead time may take at most, where no limit is given.
const SHARE: f64 = 0.25;

/// Rows that the dead time may take at most, where no limit is given.
const MOST_ROWS: f64 = 2000.0;

/// Lags up to which the correlation is summed as it stands.
const FEW: usize = 24;

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
    let still = record.manipulated_variable().windows(2).all(|pair| pair[0] == pair[1]);
    if still {
        return Err(PointError::Still);
    }
    let even = time.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() <= 1e-6 * step);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most the number of rows")]
    let lags = ((greatest.0 / step).ceil().max(1.0) as usize).min(rows / 2).max(1);
    if even && rows > 8 {
        return fast(record, step, lags).ok_or(PointError::Still);
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

/// Values that are worked on side by side.
const LANES: usize = 8;

/// Takes the mean and the straight line out of a column over even rows.
#[expect(clippy::cast_precision_loss, reason = "a number of rows")]
fn level(column: &mut [f64]) {
    let n = column.len() as f64;
    let middle = (n - 1.0) / 2.0;
    let spread = n * (n * n - 1.0) / 12.0;
    // Twice: once leaves rounding of the size of the column.
    for _ in 0..2 {
        let (mut sums, mut moments) = ([0.0; LANES], [0.0; LANES]);
        let mut places: [f64; LANES] = std::array::from_fn(|lane| lane as f64 - middle);
        let (blocks, rest) = column.as_chunks::<LANES>();
        for block in blocks {
            for lane in 0..LANES {
                sums[lane] += block[lane];
                moments[lane] += places[lane] * block[lane];
                places[lane] += LANES as f64;
            }
        }
        let (mut sum, mut moment): (f64, f64) = (sums.iter().sum(), moments.iter().sum());
        for (value, place) in rest.iter().zip(places) {
            sum += value;
            moment += place * value;
        }
        let slope = moment / spread;
        let start = sum / n - slope * middle;
        let mut lines: [f64; LANES] = std::array::from_fn(|lane| start + slope * lane as f64);
        let (blocks, rest) = column.as_chunks_mut::<LANES>();
        let mut base = 0.0;
        for block in blocks {
            for lane in 0..LANES {
                block[lane] -= lines[lane] + base;
            }
            base += slope * LANES as f64;
        }
        for (value, line) in rest.iter_mut().zip(&mut lines) {
            *value -= *line + base;
        }
    }
}

/// The fit on an even grid.
#[expect(clippy::cast_precision_loss, reason = "a number of rows")]
fn fast(record: &Record, step: f64, lags: usize) -> Option<PointFit> {
    let rows = record.len();
    let input = record.manipulated_variable();
    let mean = input[..rows - 1].iter().sum::<f64>() / (rows - 1) as f64;
    // The integral of the input in units of the step, from `lags` rows before the record on.
    let mut integral = Vec::with_capacity(rows + lags);
    let first = input[0] - mean;
    integral.extend((0..lags).map(|k| first * (k as f64 - lags as f64)));
    let mut sum = 0.0;
    for value in input {
        integral.push(sum);
        sum += value - mean;
    }
    let mut response = record.controlled_variable().to_vec();
    level(&mut response);
    let with = correlation(&integral, &response, lags);
    let (lag, between) = best_piece(&integral, &with, rows, lags)?;
    // The same piece, column by column: v at its left end, and what the column gains per step of dead time.
    let mut column = integral[lags - lag..lags - lag + rows].to_vec();
    let mut change: Vec<f64> =
        (0..rows).map(|i| mean - input[(i + lags - lag).saturating_sub(lags + 1)]).collect();
    level(&mut column);
    level(&mut change);
    let [vv, vw, ww] = [dot(&column, &column), dot(&column, &change), dot(&change, &change)];
    let [vy, wy] = [dot(&column, &response), dot(&change, &response)];
    let determinant = vv * ww - vw * vw;
    let [along, across] = [(vy * ww - wy * vw) / determinant, (wy * vv - vy * vw) / determinant];
    let exact = across / along;
    let (gain, share) = if exact.is_finite() && (exact - between).abs() < 0.5 && (0.0..=1.0).contains(&exact)
    {
        (along, exact)
    } else {
        let squares = vv + between * (2.0 * vw + between * ww);
        ((vy + between * wy) / squares, between)
    };
    let squares = (0..rows).map(|i| (response[i] - gain * (column[i] + share * change[i])).powi(2)).sum();
    Some(PointFit {
        process_gain: gain / step,
        dead_time: (lag as f64 + share) * step,
        residual: deviation(squares, rows),
    })
    .filter(|fit| fit.process_gain.is_finite() && fit.process_gain != 0.0)
}

/// The best lag and share of the step beyond it; `with` holds the products of response and integral at each lag.
#[expect(clippy::cast_precision_loss, reason = "a number of rows")]
fn best_piece(integral: &[f64], with: &[f64], rows: usize, lags: usize) -> Option<(usize, f64)> {
    let n = rows as f64;
    let (middle, spread) = ((n - 1.0) / 2.0, n * (n * n - 1.0) / 12.0);
    let window = &integral[lags..lags + rows];
    let mut sum: f64 = window.iter().sum();
    let mut moment: f64 = window.iter().enumerate().map(|(i, value)| (i as f64 - middle) * value).sum();
    let mut squares = dot(window, window);
    let mut neighbour = dot(window, &integral[lags - 1..lags - 1 + rows]);
    let (per_row, per_spread) = (1.0 / n, 1.0 / spread);
    let mut best: Option<(f64, usize, f64)> = None;
    // Own squares, mean and moment at the left end of the piece.
    let mut left = [squares - sum * sum * per_row - moment * moment * per_spread, sum, moment];
    for lag in 0..lags {
        // The window goes back by one row: one value enters at the front, one leaves at the end.
        let start = lags - lag;
        let (enters, leaves) = (integral[start - 1], integral[start - 1 + rows]);
        moment += sum - leaves * (n - middle) + enters * (0.0 - middle);
        sum += enters - leaves;
        squares += enters * enters - leaves * leaves;
        let right = [squares - sum * sum * per_row - moment * moment * per_spread, sum, moment];
        let cross = neighbour - left[1] * right[1] * per_row - left[2] * right[2] * per_spread;
        if start >= 2 {
            let before = integral[start - 2];
            neighbour += enters * before - integral[start - 1 + rows] * integral[start - 2 + rows];
        }
        let (c, b) = (with[lag], with[lag + 1] - with[lag]);
        let (e, g) = (cross - left[0], left[0] - 2.0 * cross + right[0]);
        let f = ((c * e - b * left[0]) / (b * e - c * g)).clamp(0.0, 1.0);
        // The right end is the left end of the next piece.
        for f in [0.0, if f.is_nan() { 1.0 } else { f }] {
            let own = left[0] + f * (2.0 * e + f * g);
            let with = c + b * f;
            let better = own > 0.0 && with * with > own * best.map_or(0.0, |(score, ..)| score);
            if better {
                best = Some((with * with / own, lag, f));
            }
        }
        left = right;
    }
    best.map(|(_, lag, f)| (lag, f))
}

/// Σ response_i · integral_(i + lags − k) for each lag k.
fn correlation(integral: &[f64], response: &[f64], lags: usize) -> Vec<f64> {
    let rows = response.len();
    if lags <= FEW {
        return (0..=lags).map(|lag| dot(response, &integral[lags - lag..lags - lag + rows])).collect();
    }
    // Long records in blocks that stay in the cache; the spectra of their correlations add up.
    let block = (4 * lags).next_power_of_two().max(1024);
    let whole = fast_length(rows + lags);
    // Two transforms for each block and one back, against three of the whole.
    let work = |length: usize, transforms: usize| transforms * length * length.ilog2() as usize;
    let blocks = rows.div_ceil(block - lags);
    let in_blocks = block < whole && work(block, 2 * blocks + 1) < work(whole, 3);
    let length = if in_blocks { block } else { whole };
    let taken = length - lags;
    PLANNER.with_borrow_mut(|planner| {
        let (forward, inverse) = (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));
        let (mut ahead, mut back) = (forward.make_scratch_vec(), inverse.make_scratch_vec());
        let (mut of_integral, mut of_response) = (forward.make_output_vec(), forward.make_output_vec());
        let (mut first, mut second) = (forward.make_input_vec(), forward.make_input_vec());
        let mut spectrum = vec![Complex::new(0.0, 0.0); length / 2 + 1];
        for start in (0..rows).step_by(taken) {
            let end = (start + taken).min(rows);
            let reach = end - start + lags;
            first[..reach].copy_from_slice(&integral[start..start + reach]);
            first[reach..].fill(0.0);
            second[..end - start].copy_from_slice(&response[start..end]);
            second[end - start..].fill(0.0);
            // The lengths are those that the plan made.
            let _ = forward.process_with_scratch(&mut first, &mut of_integral, &mut ahead);
            let _ = forward.process_with_scratch(&mut second, &mut of_response, &mut ahead);
            for ((sum, a), b) in spectrum.iter_mut().zip(&of_integral).zip(&of_response) {
                *sum += a * b.conj();
            }
        }
        // A real signal has a real mean and, of even length, a real last component.
        spectrum[0].im = 0.0;
        spectrum[length / 2].im = 0.0;
        let _ = inverse.process_with_scratch(&mut spectrum, &mut first, &mut back);
        #[expect(clippy::cast_precision_loss, reason = "a length")]
        let scale = 1.0 / length as f64;
        (0..=lags).map(|lag| scale * first[lags - lag]).collect()
    })
}

/// The least even length of the form 2^a·3^b·5^c that is not smaller: transforms of such lengths are fast.
fn fast_length(least: usize) -> usize {
    let smooth = |length: usize| {
        let mut rest = length;
        for factor in [2, 3, 5] {
            while rest.is_multiple_of(factor) {
                rest /= factor;
            }
        }
        rest == 1
    };
    (least.next_multiple_of(2)..).step_by(2).find(|length| smooth(*length)).unwrap_or(least)
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

    #[test]
    fn an_input_that_stands_still_is_refused() {
        let time: Vec<f64> = (0..50).map(f64::from).collect();
        let record = Record::new(time.clone(), time, vec![3.0; 50]).unwrap();
        assert_eq!(point_fit(&record, Seconds(5.0)), Err(PointError::Still));
    }
}
