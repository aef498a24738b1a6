//! The closed loop in the form the solver runs: sparse rows, blocks of coupled states, and the equilibrium that each
//! setpoint and load would have.

use smallvec::{SmallVec, smallvec};

use crate::model::ClosedLoop;
use crate::model::closed_loop::{Source, Sum, Window};

/// Sources by index, and their weights.
pub(super) type Terms = SmallVec<[(usize, f64); 4]>;
/// A number for each state or channel.
pub(super) type Point = SmallVec<[f64; 8]>;

/// A weighted sum, sorted by kind of source.
#[derive(Debug, Clone, Default)]
pub(super) struct Row {
    pub(super) states: Terms,
    pub(super) delayed: Terms,
    pub(super) setpoint: f64,
    pub(super) load: f64,
    pub(super) setpoint_rate: f64,
}

impl Row {
    fn new(sum: &Sum) -> Self {
        let mut row = Self::default();
        for &(source, weight) in sum.terms().iter().filter(|(_, weight)| *weight != 0.0) {
            match source {
                Source::Setpoint => row.setpoint += weight,
                Source::SetpointRate => row.setpoint_rate += weight,
                Source::Load => row.load += weight,
                Source::State(i) => row.states.push((i, weight)),
                Source::Delayed(c) => row.delayed.push((c, weight)),
            }
        }
        row
    }

    fn state(&self, index: usize) -> f64 {
        self.states.iter().find(|(i, _)| *i == index).map_or(0.0, |(_, w)| *w)
    }

    /// Weight of the signal of this channel.
    pub(super) fn channel(&self, index: usize) -> f64 {
        self.delayed.iter().find(|(c, _)| *c == index).map_or(0.0, |(_, w)| *w)
    }

    /// The part of the sum that comes from setpoint and load.
    pub(super) fn constant(&self, setpoint: f64, load: f64) -> f64 {
        self.setpoint * setpoint + self.load * load
    }

    /// The sum for given values of its sources.
    pub(super) fn of(&self, states: &[f64], delayed: &[f64], setpoint: f64, load: f64) -> f64 {
        self.states.iter().map(|&(i, w)| w * states[i]).sum::<f64>()
            + self.delayed.iter().map(|&(c, w)| w * delayed[c]).sum::<f64>()
            + self.constant(setpoint, load)
    }
}

/// Where everything comes to rest under a constant setpoint and load, or the origin where there is no such point.
#[derive(Debug, Clone)]
pub(super) struct Rest {
    pub(super) states: Point,
    pub(super) delayed: Point,
    pub(super) error: f64,
    pub(super) manipulated: f64,
    pub(super) load_estimate: f64,
}

/// The closed loop, ready to run.
#[derive(Debug, Clone)]
pub(super) struct System {
    /// Rate of each state.
    pub(super) rates: Vec<Row>,
    /// Input of each channel.
    pub(super) inputs: Vec<Row>,
    /// Delay of each channel [s].
    pub(super) delays: Vec<f64>,
    /// Index of the state that is the controlled variable.
    pub(super) output: usize,
    /// Controller output.
    pub(super) manipulated: Row,
    /// Load estimate of the observer.
    pub(super) load_estimate: Option<Row>,
    /// Ranges of states that drive each other; earlier blocks drive later ones.
    pub(super) blocks: Vec<(usize, usize)>,
    /// Whether the input of channel 0 is the controller output plus constants.
    pub(super) input_is_manipulated: bool,
    /// Whether [`Rest`] is an equilibrium; otherwise constants force the deviations.
    pub(super) has_rest: bool,
    rest_of_setpoint: Rest,
    rest_of_load: Rest,
}

impl System {
    pub(super) fn new(closed_loop: &ClosedLoop) -> Self {
        let rates: Vec<Row> = closed_loop.rates().iter().map(Row::new).collect();
        let inputs: Vec<Row> = closed_loop.channels().iter().map(|c| Row::new(&c.input)).collect();
        let manipulated = Row::new(closed_loop.manipulated_variable());
        let load_estimate = closed_loop.load_estimate().map(Row::new);
        let output = closed_loop.controlled_variable();
        let input_is_manipulated =
            inputs[0].states == manipulated.states && inputs[0].delayed == manipulated.delayed;
        let points = resting(closed_loop, &rates, &inputs);
        let has_rest = points.is_some();
        let n = rates.len();
        let [of_setpoint, of_load] = points.unwrap_or_else(|| {
            let origin: Point = smallvec![0.0; n + inputs.len()];
            [origin.clone(), origin]
        });
        let rest = |point: Point, setpoint: f64, load: f64| {
            let (states, delayed): (Point, Point) = (point[..n].into(), point[n..].into());
            let manipulated = if has_rest && input_is_manipulated {
                // Exact where the general sum would leave rounding: at rest the process input is what it must be.
                delayed[0]
                    - (inputs[0].load - manipulated.load) * load
                    - (inputs[0].setpoint - manipulated.setpoint) * setpoint
            } else {
                manipulated.of(&states, &delayed, setpoint, load)
            };
            let load_estimate =
                load_estimate.as_ref().map_or(0.0, |row| row.of(&states, &delayed, setpoint, load));
            Rest { error: setpoint - states[output], states, delayed, manipulated, load_estimate }
        };
        let (rest_of_setpoint, rest_of_load) = (rest(of_setpoint, 1.0, 0.0), rest(of_load, 0.0, 1.0));
        let delays = closed_loop.channels().iter().map(|c| c.delay).collect();
        let blocks = blocks(&rates);
        Self {
            rates,
            inputs,
            delays,
            output,
            manipulated,
            load_estimate,
            blocks,
            input_is_manipulated,
            has_rest,
            rest_of_setpoint,
            rest_of_load,
        }
    }

    /// The point of rest for this setpoint and load.
    pub(super) fn rest(&self, setpoint: f64, load: f64) -> Rest {
        let (r, d) = (&self.rest_of_setpoint, &self.rest_of_load);
        let mix = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| setpoint * a + load * b).collect();
        Rest {
            states: mix(&r.states, &d.states),
            delayed: mix(&r.delayed, &d.delayed),
            error: setpoint * r.error + load * d.error,
            manipulated: setpoint * r.manipulated + load * d.manipulated,
            load_estimate: setpoint * r.load_estimate + load * d.load_estimate,
        }
    }

    /// How a state drives itself.
    pub(super) fn own_rate(&self, state: usize) -> f64 {
        self.rates[state].state(state)
    }

    /// Rate of the fastest pole that the states have among themselves [1/s].
    pub(super) fn fastest(&self) -> f64 {
        let mut fastest = 0.0f64;
        for &(from, to) in &self.blocks {
            for i in from..to {
                fastest = fastest.max(self.own_rate(i).abs());
                for j in i + 1..to {
                    fastest = fastest.max((self.rates[i].state(j) * self.rates[j].state(i)).abs().sqrt());
                }
            }
        }
        fastest
    }

    /// The matrix of a block of coupled states, row by row, times `factor`.
    pub(super) fn block_matrix(&self, (from, to): (usize, usize), factor: f64) -> Vec<f64> {
        (from..to).flat_map(|i| (from..to).map(move |j| factor * self.rates[i].state(j))).collect()
    }
}

/// Smallest runs of states such that no state is driven by a later run.
fn blocks(rates: &[Row]) -> Vec<(usize, usize)> {
    let mut blocks = Vec::new();
    let (mut from, mut to) = (0, 0);
    for (i, row) in rates.iter().enumerate() {
        let last = row.states.iter().map(|&(j, _)| j + 1).max().unwrap_or(0);
        to = to.max(last).max(i + 1);
        if to == i + 1 {
            blocks.push((from, to));
            from = to;
        }
    }
    blocks
}

/// The [`equilibria`] of a loop. At rest the rate of a window is 0 whatever it holds; what it holds is its input times its length.
fn resting(closed_loop: &ClosedLoop, rates: &[Row], inputs: &[Row]) -> Option<[Point; 2]> {
    let held = |window: &Window| Row {
        states: smallvec![(window.state, 1.0)],
        delayed: smallvec![(window.channel, -closed_loop.channels()[window.channel].delay)],
        ..Row::default()
    };
    let held: SmallVec<[Row; 1]> = closed_loop.windows().iter().map(held).collect();
    let mut rates: SmallVec<[&Row; 8]> = rates.iter().collect();
    for (window, row) in closed_loop.windows().iter().zip(&held) {
        rates[window.state] = row;
    }
    equilibria(&rates, inputs)
}

/// States and delayed signals at which nothing moves under a unit setpoint, and under a unit load; `None` where there is no unique
/// such point.
///
/// Rows with one unknown are eliminated first, so that what is zero by structure (the process input of an
/// integrating process, the error under integral action) comes out as exactly zero.
fn equilibria(rates: &[&Row], inputs: &[Row]) -> Option<[Point; 2]> {
    let (n, channels) = (rates.len(), inputs.len());
    let size = n + channels;
    let mut matrix: SmallVec<[Line; 6]> = SmallVec::with_capacity(size);
    for (index, row) in rates.iter().copied().chain(inputs).enumerate() {
        let mut line: Line = smallvec![0.0; size + 2];
        row.states.iter().for_each(|&(i, w)| line[i] += w);
        row.delayed.iter().for_each(|&(c, w)| line[n + c] += w);
        if index >= n {
            line[index] -= 1.0;
        }
        (line[size], line[size + 1]) = (-row.setpoint, -row.load);
        // Rows of one scale, so that the choice of the largest pivot means something.
        let scale = line[..size].iter().fold(0.0f64, |m, v| m.max(v.abs()));
        if scale > 0.0 {
            for v in &mut line {
                *v /= scale;
            }
        }
        matrix.push(line);
    }
    let mut order: SmallVec<[usize; 8]> = SmallVec::new();
    for step in 0..size {
        let count = |line: &Line| line[..size].iter().map(|v| usize::from(*v != 0.0)).sum::<usize>();
        let (_, row) = (step..size).map(|i| (count(&matrix[i]), i)).filter(|(count, _)| *count > 0).min()?;
        matrix.swap(step, row);
        let (before, rest) = matrix.split_at_mut(step);
        let (pivot_row, after) = rest.split_first_mut()?;
        let (column, pivot) = largest(&pivot_row[..size]);
        if pivot.abs() < 1e-13 {
            return None;
        }
        order.push(column);
        for line in before.iter_mut().chain(after).filter(|line| line[column] != 0.0) {
            let factor = line[column] / pivot;
            for (v, p) in line.iter_mut().zip(pivot_row.iter()) {
                *v -= factor * p;
            }
            line[column] = 0.0;
        }
    }
    let mut points: [Point; 2] = [smallvec![0.0; size], smallvec![0.0; size]];
    for (line, column) in matrix.iter().zip(order) {
        points[0][column] = line[size] / line[column];
        points[1][column] = line[size + 1] / line[column];
    }
    points.iter().flatten().all(|v| v.is_finite()).then_some(points)
}

/// One equation: the weights of states and delayed signals, and the right-hand sides of setpoint and load.
type Line = SmallVec<[f64; 8]>;

/// The last of the numbers of largest magnitude, and its place.
fn largest(line: &[f64]) -> (usize, f64) {
    line.iter().copied().enumerate().fold(
        (0, 0.0),
        |most: (usize, f64), at| {
            if at.1.abs() >= most.1.abs() { at } else { most }
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::response::{Scenario, simulate};
    use crate::model::{Controller, Observer, Process, Seconds};

    fn system(controller: Controller) -> System {
        System::new(&ClosedLoop::new(&Process::integrating(0.0506, Seconds(6.0)).unwrap(), &controller))
    }

    #[test]
    fn at_rest_integral_action_has_no_error_and_carries_the_load_exactly() {
        let pid = Controller::proportional(2.95).unwrap().with_integral_time(Seconds(15.0)).unwrap();
        let pid = pid.with_derivative_time(Seconds(3.0)).unwrap().with_filter_bandwidth(100.0).unwrap();
        let rest = system(pid).rest(3.0, 1.0);
        assert_eq!((rest.error, rest.manipulated), (0.0, -1.0));
        assert_eq!(rest.delayed[..], [0.0]);
    }

    #[test]
    fn at_rest_proportional_control_leaves_the_error_that_the_load_needs() {
        let rest = system(Controller::proportional(2.0).unwrap()).rest(3.0, 1.0);
        assert_eq!((rest.error, rest.manipulated), (-0.5, -1.0));
    }

    #[test]
    fn two_dead_times_over_a_long_horizon_are_said_to_be_beyond_proof() {
        let process = Process::integrating(0.0506, Seconds(6.0)).unwrap();
        let observer = Observer::new(0.5).unwrap().with_model_dead_time(Seconds(6.6)).unwrap();
        let two = ClosedLoop::new(&process, &Controller::proportional(1.0).unwrap().with_observer(observer));
        let one = ClosedLoop::new(&process, &Controller::proportional(1.0).unwrap());
        let warned = |closed: &ClosedLoop, horizon: f64| {
            let step = Scenario::unit_setpoint_step(Seconds(horizon)).unwrap();
            simulate(closed, &step).unwrap().warnings.iter().any(|w| w.starts_with("two dead times"))
        };
        assert!(warned(&two, 1321.0) && !warned(&two, 1320.0) && !warned(&one, 5000.0));
    }

    #[test]
    fn at_rest_the_observer_estimates_the_load() {
        let observed = Controller::proportional(2.0).unwrap().with_observer(Observer::new(0.7).unwrap());
        let rest = system(observed).rest(3.0, 1.0);
        assert_eq!((rest.error, rest.manipulated), (0.0, -1.0));
        assert!((rest.load_estimate - 1.0).abs() < 1e-15);
    }
}
