//! The closed loop in the form the solvers run: sparse rows, blocks of coupled states, and the equilibrium that each setpoint and
//! load would have; of one loop, or of several of one structure together.

#![expect(
    clippy::inline_always,
    reason = "only what is inlined is compiled for the instruction set chosen at run time"
)]

use smallvec::{SmallVec, smallvec};

use super::number::Number;
use crate::model::ClosedLoop;
use crate::model::closed_loop::{Source, Sum};

/// Sources by index, and their weights.
pub(super) type Terms<T = f64> = SmallVec<[(usize, T); 4]>;
/// A number for each state or channel.
pub(super) type Point<T = f64> = SmallVec<[T; 8]>;

/// A weighted sum, sorted by kind of source.
#[derive(Debug, Clone)]
pub(super) struct Row<T = f64> {
    pub(super) states: Terms<T>,
    pub(super) delayed: Terms<T>,
    pub(super) setpoint: T,
    pub(super) load: T,
    pub(super) setpoint_rate: T,
}

impl<T: Number> Row<T> {
    #[inline(always)]
    fn zero(token: T::Token) -> Self {
        let zero = T::all(token, 0.0);
        Self { states: Terms::new(), delayed: Terms::new(), setpoint: zero, load: zero, setpoint_rate: zero }
    }

    /// The same sum of each loop.
    #[inline(always)]
    fn new<'s>(token: T::Token, of: impl Fn(usize) -> &'s Sum) -> Self {
        let mut row = Self::zero(token);
        for (k, &(source, weight)) in of(0).terms().iter().enumerate() {
            if weight == 0.0 {
                continue;
            }
            let weight = T::from_fn(token, |l| of(l).terms()[k].1);
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

    /// The part of the sum that comes from setpoint and load.
    #[inline(always)]
    pub(super) fn constant(&self, setpoint: T, load: T) -> T {
        self.setpoint * setpoint + self.load * load
    }

    /// The sum for given values of its sources.
    #[inline(always)]
    fn of(&self, point: &[T], states: usize, (setpoint, load): (T, T)) -> T {
        let mut sum = setpoint.like(0.0);
        for &(i, weight) in &self.states {
            sum += weight * point[i];
        }
        for &(c, weight) in &self.delayed {
            sum += weight * point[states + c];
        }
        sum + self.constant(setpoint, load)
    }
}

impl Row {
    fn state(&self, index: usize) -> f64 {
        self.states.iter().find(|(i, _)| *i == index).map_or(0.0, |(_, w)| *w)
    }

    /// Weight of the signal of this channel.
    pub(super) fn channel(&self, index: usize) -> f64 {
        self.delayed.iter().find(|(c, _)| *c == index).map_or(0.0, |(_, w)| *w)
    }
}

/// Where everything comes to rest under a constant setpoint and load, or the origin where there is no such point.
#[derive(Debug, Clone)]
pub(super) struct Rest<T = f64> {
    pub(super) states: Point<T>,
    pub(super) delayed: Point<T>,
    pub(super) error: T,
    pub(super) manipulated: T,
    pub(super) load_estimate: T,
}

/// The closed loop, or several of one structure, ready to run.
#[derive(Debug, Clone)]
pub(super) struct System<T = f64> {
    /// Rate of each state.
    pub(super) rates: Vec<Row<T>>,
    /// Input of each channel.
    pub(super) inputs: Vec<Row<T>>,
    /// Delay of each channel [s].
    pub(super) delays: Point<T>,
    /// Index of the state that is the controlled variable.
    pub(super) output: usize,
    /// Controller output.
    pub(super) manipulated: Row<T>,
    /// Load estimate of the observer.
    pub(super) load_estimate: Option<Row<T>>,
    /// Ranges of states that drive each other; earlier blocks drive later ones.
    pub(super) blocks: SmallVec<[(usize, usize); 8]>,
    /// Whether the input of channel 0 is the controller output plus constants.
    pub(super) input_is_manipulated: bool,
    /// Whether [`Rest`] is an equilibrium; otherwise constants force the deviations.
    pub(super) has_rest: bool,
    rest_of_setpoint: Rest<T>,
    rest_of_load: Rest<T>,
}

impl System {
    /// The system of a single loop.
    pub(super) fn new(closed_loop: &ClosedLoop) -> Self {
        Self::of((), |_| closed_loop)
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

/// Whether these loops have the same rows, with weights that are 0 in all of them or in none.
pub(super) fn are_alike(loops: &[ClosedLoop]) -> bool {
    let Some((first, others)) = loops.split_first() else { return true };
    let same_sum = |a: &Sum, b: &Sum| {
        let same = |(a, b): (&(Source, f64), &(Source, f64))| a.0 == b.0 && (a.1 == 0.0) == (b.1 == 0.0);
        a.terms().len() == b.terms().len() && a.terms().iter().zip(b.terms()).all(same)
    };
    others.iter().all(|other| {
        first.rates().len() == other.rates().len()
            && first.rates().iter().zip(other.rates()).all(|(a, b)| same_sum(a, b))
            && first.channels().len() == other.channels().len()
            && first.channels().iter().zip(other.channels()).all(|(a, b)| same_sum(&a.input, &b.input))
            && first.windows() == other.windows()
            && first.controlled_variable() == other.controlled_variable()
            && same_sum(first.manipulated_variable(), other.manipulated_variable())
            && match (first.load_estimate(), other.load_estimate()) {
                (None, None) => true,
                (Some(a), Some(b)) => same_sum(a, b),
                _ => false,
            }
    })
}

impl<T: Number> System<T> {
    /// The system of loops that are alike; see [`are_alike`].
    #[inline(always)]
    pub(super) fn of<'l>(token: T::Token, loops: impl Fn(usize) -> &'l ClosedLoop) -> Self {
        let first = loops(0);
        let mut rates: Vec<Row<T>> = Vec::with_capacity(first.rates().len());
        for i in 0..first.rates().len() {
            rates.push(Row::new(
                token,
                #[inline(always)]
                |l| &loops(l).rates()[i],
            ));
        }
        let mut inputs: Vec<Row<T>> = Vec::with_capacity(first.channels().len());
        let mut delays = Point::new();
        for c in 0..first.channels().len() {
            inputs.push(Row::new(
                token,
                #[inline(always)]
                |l| &loops(l).channels()[c].input,
            ));
            delays.push(T::from_fn(
                token,
                #[inline(always)]
                |l| loops(l).channels()[c].delay,
            ));
        }
        let manipulated = Row::new(
            token,
            #[inline(always)]
            |l| loops(l).manipulated_variable(),
        );
        let load_estimate = first.load_estimate().map(
            #[inline(always)]
            |own| {
                Row::new(
                    token,
                    #[inline(always)]
                    |l| loops(l).load_estimate().unwrap_or(own),
                )
            },
        );
        let same = |a: &Terms<T>, b: &Terms<T>| {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.0 == b.0 && (a.1 - b.1).is_zero())
        };
        let input_is_manipulated =
            same(&inputs[0].states, &manipulated.states) && same(&inputs[0].delayed, &manipulated.delayed);
        let points = equilibria(token, (&rates, &inputs), &held(first, &delays));
        let blocks = blocks(&rates);
        let (zero, one) = (T::all(token, 0.0), T::all(token, 1.0));
        let mut system = Self {
            rates,
            inputs,
            delays,
            output: first.controlled_variable(),
            manipulated,
            load_estimate,
            blocks,
            input_is_manipulated,
            has_rest: points.is_some(),
            rest_of_setpoint: Rest::origin(zero),
            rest_of_load: Rest::origin(zero),
        };
        let size = system.rates.len() + system.inputs.len();
        let [of_setpoint, of_load] = points.unwrap_or_else(|| [smallvec![zero; size], smallvec![zero; size]]);
        system.rest_of_setpoint = system.rest_at(&of_setpoint, (one, zero));
        system.rest_of_load = system.rest_at(&of_load, (zero, one));
        system
    }

    /// What is seen of a point of rest.
    #[inline(always)]
    fn rest_at(&self, point: &[T], at: (T, T)) -> Rest<T> {
        let n = self.rates.len();
        let (states, delayed) = point.split_at(n);
        let (input, manipulated) = (&self.inputs[0], &self.manipulated);
        let zero = at.0.like(0.0);
        Rest {
            error: at.0 - states[self.output],
            manipulated: if self.has_rest && self.input_is_manipulated {
                // Exact where the general sum would leave rounding: at rest the process input is what it must be.
                delayed[0]
                    - (input.load - manipulated.load) * at.1
                    - (input.setpoint - manipulated.setpoint) * at.0
            } else {
                manipulated.of(point, n, at)
            },
            load_estimate: match &self.load_estimate {
                Some(row) => row.of(point, n, at),
                None => zero,
            },
            states: states.iter().copied().collect(),
            delayed: delayed.iter().copied().collect(),
        }
    }

    /// The point of rest for this setpoint and load.
    #[inline(always)]
    pub(super) fn rest(&self, setpoint: f64, load: f64) -> Rest<T> {
        let token = self.delays[0].token();
        let at = (T::all(token, setpoint), T::all(token, load));
        let (r, d) = (&self.rest_of_setpoint, &self.rest_of_load);
        Rest {
            states: mixed(at, &r.states, &d.states),
            delayed: mixed(at, &r.delayed, &d.delayed),
            error: mix(at, r.error, d.error),
            manipulated: mix(at, r.manipulated, d.manipulated),
            load_estimate: mix(at, r.load_estimate, d.load_estimate),
        }
    }
}

#[inline(always)]
fn mix<T: Number>((setpoint, load): (T, T), a: T, b: T) -> T {
    setpoint * a + load * b
}

#[inline(always)]
fn mixed<T: Number>(at: (T, T), a: &[T], b: &[T]) -> Point<T> {
    let mut mixed = Point::new();
    for (a, b) in a.iter().zip(b) {
        mixed.push(mix(at, *a, *b));
    }
    mixed
}

impl<T: Number> Rest<T> {
    #[inline(always)]
    fn origin(zero: T) -> Self {
        Self {
            states: Point::new(),
            delayed: Point::new(),
            error: zero,
            manipulated: zero,
            load_estimate: zero,
        }
    }
}

/// Smallest runs of states such that no state is driven by a later run.
fn blocks<T>(rates: &[Row<T>]) -> SmallVec<[(usize, usize); 8]> {
    let mut blocks = SmallVec::new();
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

/// What a state that is the integral over a window holds at rest: the state, the channel, and the window's length.
type Held<T> = SmallVec<[(usize, usize, T); 2]>;

/// At rest the rate of a window is 0 whatever it holds; what it holds is its input times its length.
fn held<T: Number>(closed_loop: &ClosedLoop, delays: &[T]) -> Held<T> {
    closed_loop
        .windows()
        .iter()
        .map(|window| (window.state, window.channel, delays[window.channel]))
        .collect()
}

/// One equation: the weights of states and delayed signals, and the right-hand sides of setpoint and load.
type Line<T> = SmallVec<[T; 8]>;

/// States and delayed signals at which nothing moves under a unit setpoint, and under a unit load; `None` where there is no unique
/// such point.
///
/// Rows with one unknown are eliminated first, so that what is zero by structure (the process input of an
/// integrating process, the error under integral action) comes out as exactly zero.
#[inline(always)]
fn equilibria<T: Number>(
    token: T::Token,
    (rates, inputs): (&[Row<T>], &[Row<T>]),
    held: &Held<T>,
) -> Option<[Point<T>; 2]> {
    let (n, channels) = (rates.len(), inputs.len());
    let size = n + channels;
    let (zero, one) = (T::all(token, 0.0), T::all(token, 1.0));
    let mut matrix: SmallVec<[Line<T>; 6]> = SmallVec::with_capacity(size);
    for (index, row) in rates.iter().chain(inputs).enumerate() {
        let mut line: Line<T> = smallvec![zero; size + 2];
        if let Some(&(state, channel, length)) = held.iter().find(|held| held.0 == index) {
            line[state] = one;
            line[n + channel] = -length;
        } else {
            row.states.iter().for_each(
                #[inline(always)]
                |&(i, w)| line[i] += w,
            );
            row.delayed.iter().for_each(
                #[inline(always)]
                |&(c, w)| line[n + c] += w,
            );
            (line[size], line[size + 1]) = (-row.setpoint, -row.load);
        }
        if index >= n {
            line[index] += -one;
        }
        // Rows of one scale, so that the choice of the largest pivot means something.
        let mut scale = zero;
        for v in &line[..size] {
            scale = scale.max(v.abs());
        }
        if !scale.is_zero() {
            for v in &mut line {
                *v = *v / scale;
            }
        }
        matrix.push(line);
    }
    let mut order: SmallVec<[usize; 8]> = SmallVec::new();
    for step in 0..size {
        let mut fewest = (usize::MAX, 0);
        for (i, line) in matrix.iter().enumerate().skip(step) {
            let mut count = 0;
            for v in &line[..size] {
                count += usize::from(!v.is_zero());
            }
            if count > 0 && count < fewest.0 {
                fewest = (count, i);
            }
        }
        if fewest.0 > size {
            return None;
        }
        matrix.swap(step, fewest.1);
        let (before, rest) = matrix.split_at_mut(step);
        let (pivot_row, after) = rest.split_first_mut()?;
        let (mut column, mut most) = (0, 0.0);
        for (k, v) in pivot_row[..size].iter().enumerate() {
            let least = v.abs().smallest();
            if least >= most {
                (column, most) = (k, least);
            }
        }
        if most < 1e-13 {
            return None;
        }
        order.push(column);
        for line in before.iter_mut().chain(after) {
            if line[column].is_zero() {
                continue;
            }
            let factor = line[column] / pivot_row[column];
            for (v, p) in line.iter_mut().zip(pivot_row.iter()) {
                *v = *v - factor * *p;
            }
            line[column] = zero;
        }
    }
    let mut points: [Point<T>; 2] = [smallvec![zero; size], smallvec![zero; size]];
    let mut finite = true;
    for (line, column) in matrix.iter().zip(order) {
        for (k, point) in points.iter_mut().enumerate() {
            point[column] = line[size + k] / line[column];
            finite &= point[column].is_finite();
        }
    }
    finite.then_some(points)
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
