//! The closed loop: process, controller and observer as one linear system with delayed signals.
//!
//! This one description gives both the frequency response ([`crate::analysis`] takes determinants of it) and
//! the states that the simulation propagates.

use smallvec::SmallVec;

use super::compensated_loop::compensated_loop;
use super::controller::Controller;
use super::process::Process;

/// Where a signal takes a part of its value from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// The setpoint r.
    Setpoint,
    /// The time derivative of the setpoint: an impulse where the setpoint steps.
    SetpointRate,
    /// The load disturbance D at the process input.
    Load,
    /// State of this index.
    State(usize),
    /// Input of the channel of this index, one delay ago.
    Delayed(usize),
}

/// A weighted sum of sources.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sum(SmallVec<[(Source, f64); 4]>);

impl Sum {
    /// This sum plus `weight` times `source`.
    #[must_use]
    pub fn plus(mut self, source: Source, weight: f64) -> Self {
        self.add(source, weight);
        self
    }

    fn add(&mut self, source: Source, weight: f64) {
        match self.0.iter_mut().find(|(s, _)| *s == source) {
            Some((_, w)) => *w += weight,
            None => self.0.push((source, weight)),
        }
    }

    /// This sum plus `weight` times `other`.
    #[must_use]
    pub fn plus_sum(mut self, other: &Sum, weight: f64) -> Self {
        for &(source, w) in &other.0 {
            self.add(source, weight * w);
        }
        self
    }

    /// The sources, each once, and their weights.
    #[must_use]
    pub fn terms(&self) -> &[(Source, f64)] {
        &self.0
    }

    /// The weight of one source, 0 where it does not occur.
    #[must_use]
    pub fn weight(&self, source: Source) -> f64 {
        self.0.iter().find(|(s, _)| *s == source).map_or(0.0, |(_, w)| *w)
    }
}

/// A signal that acts one delay later.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// Delay [s], > 0.
    pub delay: f64,
    /// What enters the channel.
    pub input: Sum,
}

/// A state that is the integral of a channel's input over the last delay of that channel.
///
/// Its rate is the input minus the delayed input, which alone would let any constant be added: the integral over the
/// window is the one without. Δ of the loop holds the factor s of that difference, and analysis divides it out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Window {
    /// Index of the state.
    pub state: usize,
    /// Index of the channel.
    pub channel: usize,
}

/// Process, controller and observer, closed: `ẋ = rates`, every delayed signal a [`Channel`].
///
/// Channel 0 is the process input `u + D`, delayed by the dead time of the process: breaking it breaks the
/// loop at the process input.
///
/// ```
/// use holdup::model::{ClosedLoop, Controller, Process, Seconds};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let pi = Controller::proportional(0.5)?.with_integral_time(Seconds(8.0))?;
/// let closed = ClosedLoop::new(&process, &pi);
/// assert_eq!(closed.rates().len(), 2); // the output and the integral of the error
/// # Ok::<(), holdup::model::ModelError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ClosedLoop {
    pub(super) rates: Vec<Sum>,
    pub(super) channels: Vec<Channel>,
    pub(super) windows: Vec<Window>,
    pub(super) controlled_variable: usize,
    pub(super) manipulated_variable: Sum,
    pub(super) load_estimate: Option<Sum>,
}

impl ClosedLoop {
    /// The loop of this process and this controller, observer included.
    #[must_use]
    pub fn new(process: &Process, controller: &Controller) -> Self {
        if let Some(compensator) = controller.compensator() {
            return compensated_loop(process, &compensator);
        }
        let mut rates = Vec::new();
        let (y, y_rate) = process_states(&mut rates, process, process.process_gain(), 0);
        let mut u_pd = control_law(&mut rates, controller, y, &y_rate);
        if let Some(filter) = controller.output_filter() {
            u_pd = output_filter(&mut rates, &u_pd, filter.a1, filter.a2);
        }
        let mut channels = Vec::new();
        let mut u = u_pd.clone();
        let mut load_estimate = None;
        if let Some(observer) = controller.observer() {
            let model_gain = observer.model_gain().unwrap_or(process.process_gain());
            let (y_m, _) = process_states(&mut rates, process, model_gain, 1);
            let estimate = Sum::default()
                .plus(Source::State(y), observer.gain())
                .plus(Source::State(y_m), -observer.gain());
            u = u.plus_sum(&estimate, -1.0);
            load_estimate = Some(estimate);
            let delay = observer.model_dead_time().unwrap_or(process.dead_time());
            channels.push(Channel { delay, input: u_pd });
        }
        channels.insert(0, Channel { delay: process.dead_time(), input: u.clone().plus(Source::Load, 1.0) });
        let windows = Vec::new();
        Self { rates, channels, windows, controlled_variable: y, manipulated_variable: u, load_estimate }
    }

    /// The same loop with noise of the measurement in the place of the setpoint: what the controller takes as the controlled
    /// variable is `y` plus the noise, and the setpoint rests at 0.
    ///
    /// `None` where the noise goes through a derivative without filter, and with a dead-time compensator.
    #[must_use]
    pub fn with_noise_for_setpoint(&self, controller: &Controller) -> Option<Self> {
        let unfiltered = controller.derivative_time().is_some() && controller.derivative_filter().is_none();
        if unfiltered || controller.compensator().is_some() {
            return None;
        }
        let measured = Source::State(self.controlled_variable);
        // The rates of a process have no part of its output: whatever takes it is the controller.
        let noisy = |sum: &Sum| {
            let mut list = sum.0.clone();
            list.retain(|(source, _)| !matches!(source, Source::Setpoint | Source::SetpointRate));
            let sum = Sum(list);
            let weight = sum.weight(measured);
            if weight == 0.0 { sum } else { sum.plus(Source::Setpoint, weight) }
        };
        let mut closed = self.clone();
        closed.rates = self.rates.iter().map(noisy).collect();
        for channel in &mut closed.channels {
            channel.input = noisy(&channel.input);
        }
        closed.manipulated_variable = noisy(&self.manipulated_variable);
        closed.load_estimate = self.load_estimate.as_ref().map(noisy);
        Some(closed)
    }

    /// The rate of change of each state.
    #[must_use]
    pub fn rates(&self) -> &[Sum] {
        &self.rates
    }

    /// The delayed signals; the first is the process input.
    #[must_use]
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// The states that are integrals over a moving window.
    #[must_use]
    pub fn windows(&self) -> &[Window] {
        &self.windows
    }

    /// Index of the state that is the controlled variable y.
    #[must_use]
    pub fn controlled_variable(&self) -> usize {
        self.controlled_variable
    }

    /// The controller output u.
    #[must_use]
    pub fn manipulated_variable(&self) -> &Sum {
        &self.manipulated_variable
    }

    /// The load estimate D̂ of the observer or compensator, where there is one.
    #[must_use]
    pub fn load_estimate(&self) -> Option<&Sum> {
        self.load_estimate.as_ref()
    }
}

/// Appends the states of a process (or of its model) of gain `gain` fed by channel `channel`; returns the
/// index of its output and the output's rate.
pub(super) fn process_states(
    rates: &mut Vec<Sum>,
    process: &Process,
    gain: f64,
    channel: usize,
) -> (usize, Sum) {
    let mut rate = Sum::default().plus(Source::Delayed(channel), gain);
    if let Some(lag) = process.lag() {
        let index = rates.len();
        rates.push(Sum::default().plus_sum(&rate, 1.0 / lag).plus(Source::State(index), -1.0 / lag));
        rate = Sum::default().plus(Source::State(index), 1.0);
    }
    for _ in 1..process.integrators() {
        rates.push(rate);
        rate = Sum::default().plus(Source::State(rates.len() - 1), 1.0);
    }
    rates.push(rate.clone());
    (rates.len() - 1, rate)
}

/// Appends the controller's states; returns the output of its ideal form.
fn control_law(rates: &mut Vec<Sum>, controller: &Controller, y: usize, y_rate: &Sum) -> Sum {
    let (kc, b, c) = (
        controller.proportional_gain(),
        controller.setpoint_weight(),
        controller.derivative_setpoint_weight(),
    );
    let mut u = Sum::default().plus(Source::Setpoint, kc * b).plus(Source::State(y), -kc);
    if let Some(ti) = controller.integral_time() {
        let integral = rates.len();
        rates.push(Sum::default().plus(Source::Setpoint, kc / ti).plus(Source::State(y), -kc / ti));
        u = u.plus(Source::State(integral), 1.0);
    }
    match (controller.derivative_time(), controller.derivative_filter()) {
        (None, _) => u,
        (Some(td), None) => u.plus(Source::SetpointRate, kc * td * c).plus_sum(y_rate, -kc * td),
        (Some(td), Some(filter)) => {
            let n = filter.bandwidth();
            let filtered = rates.len();
            let difference = Sum::default().plus(Source::Setpoint, c).plus(Source::State(y), -1.0);
            rates.push(Sum::default().plus_sum(&difference, n).plus(Source::State(filtered), -n));
            u.plus_sum(&difference, kc * td * n).plus(Source::State(filtered), -kc * td * n)
        }
    }
}

/// Appends the states of `1/(a2·s² + a1·s + 1)` fed by `input`; returns its output.
fn output_filter(rates: &mut Vec<Sum>, input: &Sum, a1: f64, a2: f64) -> Sum {
    let output = rates.len();
    let driven = |weight: f64| Sum::default().plus_sum(input, weight).plus(Source::State(output), -weight);
    if a2 == 0.0 {
        rates.push(driven(1.0 / a1));
    } else {
        let rate = output + 1;
        rates.push(Sum::default().plus(Source::State(rate), 1.0));
        rates.push(driven(1.0 / a2).plus(Source::State(rate), -a1 / a2));
    }
    Sum::default().plus(Source::State(output), 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Observer, Seconds};

    #[test]
    fn unfiltered_derivative_on_the_plain_integrator_feeds_the_delayed_input_back() {
        let process = Process::integrating(2.0, Seconds(1.0)).unwrap();
        let pd = Controller::proportional(0.3).unwrap().with_derivative_time(Seconds(0.5)).unwrap();
        let closed = ClosedLoop::new(&process, &pd);
        assert_eq!(closed.rates().len(), 1);
        assert_eq!(closed.manipulated_variable().weight(Source::Delayed(0)), -0.3 * 0.5 * 2.0);
    }

    #[test]
    fn observer_adds_a_model_and_its_channel() {
        let process = Process::integrating(2.0, Seconds(1.0)).unwrap();
        let observer = Observer::new(0.4).unwrap().with_model_dead_time(Seconds(1.5)).unwrap();
        let controller = Controller::proportional(0.3).unwrap().with_observer(observer);
        let closed = ClosedLoop::new(&process, &controller);
        assert_eq!(closed.channels().len(), 2);
        assert_eq!(closed.channels()[1].delay, 1.5);
        assert_eq!(closed.manipulated_variable().weight(Source::State(0)), -0.3 - 0.4);
    }
}
