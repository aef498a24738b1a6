//! The controller that was running, from what the manipulated variable did when the controlled variable moved.
//!
//! In automatic, op = Kc·(e + ∫e/Ti + Td·e′) + constant, so that its change over a few rows is a linear function of the
//! changes of e, ∫e and e′. Differences over one row are blurred by what the historian rounds, differences over many by
//! what the rows do not tell (a hand on the bias): the span is chosen that explains most.

use serde::Serialize;

use super::identify::{dot, solve};
use super::survey::quantum;
use super::{Operation, Record};

/// Rows over which changes are taken.
const SPANS: [usize; 5] = [1, 2, 5, 10, 20];

/// Share of the changes of the manipulated variable that a controller must explain to be taken for one.
pub(crate) const EXPLAINS: f64 = 0.8;

/// The same where the integral action shows only beside the derivative.
const BY_DERIVATIVE: f64 = 0.98;

/// Rows that the manipulated variable must stand at its least or greatest value to be taken as limited.
const LIMITED: usize = 3;

/// A number with its 95 % interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Estimate {
    /// The best value.
    pub value: f64,
    /// From the lower to the upper end.
    pub interval: [f64; 2],
}

impl Estimate {
    fn new(value: f64, deviation: f64) -> Self {
        Self { value, interval: [value - 1.96 * deviation, value + 1.96 * deviation] }
    }

    /// The same, wider by what another way to see it differs by.
    fn widened(self, other: Option<Self>) -> Self {
        let apart = other.map_or(0.0, |other| other.value - self.value);
        Self::new(self.value, ((self.interval[1] - self.value) / 1.96).hypot(apart))
    }
}

/// The controller that was running.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RunningController {
    /// `P`, `PI` or `PID`.
    pub structure: &'static str,
    /// Proportional gain [input unit/output unit]: positive where the output rises when the controlled variable falls.
    pub proportional_gain: Estimate,
    /// Integral time [s]; absent where no integral action is seen.
    #[serde(rename = "integral_time_s")]
    pub integral_time: Option<Estimate>,
    /// Derivative time [s]; absent where no derivative action is seen.
    #[serde(rename = "derivative_time_s")]
    pub derivative_time: Option<Estimate>,
    /// Share of the setpoint that the proportional action sees; absent where the setpoint does not move.
    pub setpoint_weight: Option<f64>,
    /// Share of the changes of the manipulated variable that this controller explains.
    pub explained: f64,
    /// Rows over which the changes were taken.
    pub span_rows: usize,
    /// Rows between the controlled variable and the controller's answer to it.
    pub delay_rows: usize,
    /// Whether the integral goes on between the rows: the controller runs more often than rows are written.
    pub between_rows: bool,
}

/// How the integral is taken between rows.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Sum {
    /// The controller runs once for each row.
    Backward,
    /// It runs more often than rows are written.
    Trapezoid,
}

/// Whether the manipulated variable stands at a limit, row by row.
pub(crate) fn limited(record: &Record) -> Vec<bool> {
    let values = record.manipulated_variable();
    let [low, high] = values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| [low.min(value), high.max(value)]);
    let mut limited = vec![false; values.len()];
    let mut start = 0;
    while start < values.len() {
        let end = (start..values.len()).find(|&k| values[k] != values[start]).unwrap_or(values.len());
        if end - start >= LIMITED && (values[start] == low || values[start] == high) {
            // The whole record at one value is no limit.
            limited[start..end].fill(low < high);
        }
        start = end;
    }
    limited
}

/// Recovers the controller from the rows in automatic in which the manipulated variable is not limited. `None` where no
/// controller explains what the manipulated variable does.
///
/// ```
/// use holdup::record::Record;
/// use holdup::record::controller::recover;
///
/// // A P controller of gain 2 on a level that swings.
/// let time: Vec<f64> = (0..100).map(f64::from).collect();
/// let level: Vec<f64> = time.iter().map(|t| 50.0 + (0.3 * t).sin() + 0.5 * (0.11 * t).cos()).collect();
/// let valve = level.iter().map(|level| 30.0 + 2.0 * (50.0 - level)).collect();
/// let controller = recover(&Record::new(time, level, valve)?.with_setpoint(vec![50.0; 100])?).ok_or("none")?;
/// assert_eq!(controller.structure, "P");
/// assert!((controller.proportional_gain.value - 2.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn recover(record: &Record) -> Option<RunningController> {
    let mut best: Option<RunningController> = None;
    // What the row's own value and the controller's differ by (stamps, rounding, compression) weighs less in changes over
    // more rows: what the changes over fewer rows give shows how much of it is left.
    let mut beside: Option<RunningController> = None;
    for delay in 0..=1 {
        for sum in [Sum::Backward, Sum::Trapezoid] {
            let signals = Signals::new(record, delay, sum);
            let found: Vec<_> = SPANS.iter().map(|&span| signals.controller(span, delay)).collect();
            for (place, candidate) in found.iter().enumerate() {
                // A wider span must be clearly better: it explains a random walk more easily.
                let margin = |best: &RunningController| {
                    let explained = candidate.as_ref().map_or(0.0, |candidate| candidate.explained);
                    1.0 - explained < 0.8 * (1.0 - best.explained)
                };
                if candidate.is_some() && best.as_ref().is_none_or(margin) {
                    best.clone_from(candidate);
                    let other = if place > 0 { place - 1 } else { 1 };
                    beside.clone_from(&found[other]);
                }
            }
        }
    }
    let mut best = best.filter(|best| best.explained >= EXPLAINS)?;
    let mut once_a_row = None;
    if best.structure != "P" && !best.between_rows && !to_rounding(record, &best) {
        // Over even rows both sums explain the same, by gains and times that differ by half a row.
        let between = Signals::new(record, best.delay_rows, Sum::Trapezoid);
        let found = between.controller(best.span_rows, best.delay_rows);
        if let Some(found) = found.filter(|found| found.structure == best.structure) {
            once_a_row = Some(std::mem::replace(&mut best, found));
        }
    }
    let beside = beside.filter(|beside| beside.structure == best.structure);
    let wider = |own: Estimate, of: fn(&RunningController) -> Option<Estimate>| {
        let seen = |other: &Option<RunningController>| other.as_ref().and_then(of);
        own.widened(seen(&beside)).widened(seen(&once_a_row))
    };
    best.proportional_gain = wider(best.proportional_gain, |of| Some(of.proportional_gain));
    best.integral_time = best.integral_time.map(|time| wider(time, |of| of.integral_time));
    best.derivative_time = best.derivative_time.map(|time| wider(time, |of| of.derivative_time));
    Some(best)
}

/// Whether a law that runs once a row leaves no more than the rounding of the rows' values: then it does run so.
fn to_rounding(record: &Record, found: &RunningController) -> bool {
    let output = record.manipulated_variable();
    let changes = output.windows(found.span_rows + 1).map(|rows| rows[found.span_rows] - rows[0]);
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let square = changes.map(|change| change * change).sum::<f64>() / output.len() as f64;
    // A rounded value is off by a variance of q²/12, a difference of two by twice that; numbers have sixteen digits.
    let [of_output, of_level] = [output, record.controlled_variable()].map(quantum);
    let rounding = (of_output.powi(2) + (found.proportional_gain.value * of_level).powi(2)) / 6.0;
    (1.0 - found.explained) * square <= 2.5 * rounding + 1e-12 * square
}

/// The signals that enter the law.
struct Signals {
    output: Vec<f64>,
    /// −y, Σe, −y′, r.
    inputs: [Vec<f64>; 4],
    usable: Vec<bool>,
    moves: bool,
    time: Vec<f64>,
    has_setpoint: bool,
    between_rows: bool,
}

impl Signals {
    fn new(record: &Record, delay: usize, sum: Sum) -> Self {
        let rows = record.len();
        let time = record.time();
        let level = record.controlled_variable();
        let setpoint = record.setpoint();
        let first = setpoint.map_or(level[0], |setpoint| setpoint[0]);
        let later = |k: usize| k.saturating_sub(delay);
        let error = |k: usize| setpoint.map_or(first, |setpoint| setpoint[k]) - level[later(k)];
        let mut integral = vec![0.0; rows];
        let mut rate = vec![0.0; rows];
        for k in 1..rows {
            let step = time[k] - time[k - 1];
            let mean = match sum {
                Sum::Backward => error(k),
                Sum::Trapezoid => f64::midpoint(error(k), error(k - 1)),
            };
            integral[k] = integral[k - 1] + step * mean;
            rate[k] = -(level[later(k)] - level[later(k - 1)]) / step;
        }
        let limited = limited(record);
        let manual = |k: usize| record.operation().is_some_and(|of| of[k] == Operation::Manual);
        let moves = setpoint.is_some_and(|setpoint| setpoint.windows(2).any(|pair| pair[0] != pair[1]));
        Self {
            output: record.manipulated_variable().to_vec(),
            inputs: [
                (0..rows).map(|k| -level[later(k)]).collect(),
                integral,
                rate,
                (0..rows).map(|k| setpoint.map_or(0.0, |setpoint| setpoint[k])).collect(),
            ],
            usable: (0..rows).map(|k| k > delay && !limited[k] && !manual(k)).collect(),
            moves,
            time: time.to_vec(),
            has_setpoint: setpoint.is_some(),
            between_rows: sum == Sum::Trapezoid,
        }
    }

    /// Changes over `span` rows of a signal, where all rows between are usable.
    fn changes(of: &[f64], span: usize, starts: &[usize]) -> Vec<f64> {
        starts.iter().map(|&k| of[k + span] - of[k]).collect()
    }

    fn controller(&self, span: usize, delay: usize) -> Option<RunningController> {
        let rows = self.output.len();
        // Rows that are not usable, counted from the start, tell at once whether a stretch holds one.
        let mut bad = vec![0_usize; rows + 1];
        for k in 0..rows {
            bad[k + 1] = bad[k] + usize::from(!self.usable[k]);
        }
        let starts: Vec<usize> =
            (0..rows.saturating_sub(span)).filter(|&k| bad[k + span + 1] == bad[k]).collect();
        if starts.len() < 30.max(4 * span) {
            return None;
        }
        let response = Self::changes(&self.output, span, &starts);
        let [level, integral, rate, setpoint] =
            [0, 1, 2, 3].map(|k| Self::changes(&self.inputs[k], span, &starts));
        let together: Vec<f64> = level.iter().zip(&setpoint).map(|(y, r)| y + r).collect();
        // Without a setpoint its place is an unknown constant: e is known up to one, ∫e up to a straight line.
        let bias: Vec<f64> = starts.iter().map(|&k| self.time[k + span] - self.time[k]).collect();
        let fit = |columns: Vec<&Vec<f64>>, with_integral: bool| {
            let mut columns: Vec<Vec<f64>> = columns.into_iter().cloned().collect();
            if with_integral && !self.has_setpoint {
                columns.push(bias.clone());
            }
            Regression::robust(&columns, &response, span)
        };
        let p = fit(vec![&together], false)?;
        let mut chosen = (p, "P");
        let pi = fit(vec![&together, &integral], true);
        if let Some(pi) = pi.filter(|pi| pi.better_than(&chosen.0) && pi.ratio(1) > 0.0) {
            chosen = (pi, "PI");
        }
        // Where the derivative does most, the integral shows only beside it; but the rate of an integrating process is its
        // input a dead time ago, which must not pass for a controller.
        let pid = fit(vec![&together, &integral, &rate], true)
            .filter(|pid| chosen.1 == "PI" || pid.explained > BY_DERIVATIVE);
        if let Some(pid) =
            pid.filter(|pid| pid.better_than(&chosen.0) && pid.ratio(1) > 0.0 && pid.ratio(2) > 0.0)
        {
            chosen = (pid, "PID");
        }
        // Whether the proportional action sees the setpoint in full shows where the setpoint moves.
        let mut setpoint_weight = self.moves.then_some(1.0);
        if self.moves {
            let columns = match chosen.1 {
                "P" => vec![&level, &setpoint],
                "PI" => vec![&level, &setpoint, &integral],
                _ => vec![&level, &setpoint, &integral, &rate],
            };
            if let Some(mut apart) = fit(columns, chosen.1 != "P")
                && apart.better_than(&chosen.0)
                && (apart.coefficients[1] - apart.coefficients[0]).abs()
                    > 4.0 * apart.deviations[0].hypot(apart.deviations[1])
            {
                setpoint_weight = Some(apart.ratio(1));
                apart.coefficients.remove(1);
                apart.deviations.remove(1);
                chosen.0 = apart;
            }
        }
        let (regression, structure) = chosen;
        let gain = regression.coefficients[0];
        let ratio = |k: usize| {
            let relative = (regression.deviations[0] / gain)
                .hypot(regression.deviations[k] / regression.coefficients[k]);
            (regression.ratio(k), relative)
        };
        let integral_time = (structure != "P").then(|| {
            let (ratio, relative) = ratio(1);
            Estimate::new(1.0 / ratio, relative / ratio)
        });
        let derivative_time = (structure == "PID").then(|| {
            let (ratio, relative) = ratio(2);
            Estimate::new(ratio, relative * ratio)
        });
        (gain != 0.0).then_some(RunningController {
            structure,
            proportional_gain: Estimate::new(gain, regression.deviations[0]),
            integral_time,
            derivative_time,
            setpoint_weight,
            explained: regression.explained,
            span_rows: span,
            delay_rows: delay,
            between_rows: self.between_rows && structure != "P",
        })
    }
}

/// A linear regression through the origin in which single rows have little weight.
struct Regression {
    coefficients: Vec<f64>,
    deviations: Vec<f64>,
    squares: f64,
    explained: f64,
    /// Rows over the span: differences that overlap are not independent.
    independent: f64,
}

impl Regression {
    /// Weighted least squares with the weights of P. J. Huber, Ann. Math. Statist. 35 (1964) 73, three rounds.
    fn robust(columns: &[Vec<f64>], response: &[f64], span: usize) -> Option<Self> {
        let mut weights = vec![1.0; response.len()];
        let mut found = None;
        for _ in 0..4 {
            let weighted = |a: &[f64], b: &[f64]| -> f64 {
                a.iter().zip(b).zip(&weights).map(|((a, b), w)| a * b * w).sum()
            };
            let normal: Vec<Vec<f64>> =
                columns.iter().map(|a| columns.iter().map(|b| weighted(a, b)).collect()).collect();
            let right: Vec<f64> = columns.iter().map(|a| weighted(a, response)).collect();
            let coefficients = solve(normal.clone(), right)?;
            let residual: Vec<f64> = (0..response.len())
                .map(|row| {
                    response[row] - coefficients.iter().zip(columns).map(|(c, x)| c * x[row]).sum::<f64>()
                })
                .collect();
            let squares = weighted(&residual, &residual);
            #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
            let independent = response.len() as f64 / span as f64;
            let variance = squares / independent.max(1.0) / f64::from(u32::try_from(span).unwrap_or(1));
            let deviations = (0..columns.len())
                .map(|k| {
                    let unit = (0..columns.len()).map(|i| if i == k { 1.0 } else { 0.0 }).collect();
                    // The overlap makes each independent row appear `span` times.
                    #[expect(clippy::cast_precision_loss, reason = "at most 20")]
                    let own = solve(normal.clone(), unit).map_or(f64::INFINITY, |x| x[k] * span as f64);
                    (variance * own).sqrt()
                })
                .collect();
            let mut sizes: Vec<f64> = residual.iter().map(|value| value.abs()).collect();
            let middle = sizes.len() / 2;
            let typical = *sizes.select_nth_unstable_by(middle, f64::total_cmp).1 / 0.6745;
            found = Some(Self {
                coefficients,
                deviations,
                squares,
                explained: 1.0 - dot(&residual, &residual) / dot(response, response),
                independent,
            });
            if typical <= 0.0 {
                break;
            }
            weights = residual.iter().map(|value| (2.0 * typical / value.abs()).min(1.0)).collect();
        }
        found.filter(|found| found.coefficients.iter().all(|value| value.is_finite()))
    }

    /// Whether one more coefficient is worth it: by more than chance (Schwarz) and by more than a thousandth.
    fn better_than(&self, simpler: &Self) -> bool {
        let gain = self.independent * (simpler.squares / self.squares.max(f64::MIN_POSITIVE)).ln();
        gain > 2.0 * self.independent.max(3.0).ln() && 1.0 - simpler.explained > 1e-6
    }

    /// A coefficient over the first.
    fn ratio(&self, k: usize) -> f64 {
        self.coefficients[k] / self.coefficients[0]
    }
}
