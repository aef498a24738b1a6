//! An integrator with dead time, exact under a held input, and the loop around it.

use holdup_control::{Input, Output, Scalar, Settings, State};

use crate::laws::Line;

/// y' = u(t − 1) + load(t − 1), at rest at 0 before 0.
#[derive(Clone, Debug)]
pub(crate) struct Plant {
    /// Time, and ∫ of the input up to it; the input is constant between.
    area: Vec<(f64, f64)>,
    cursor: usize,
}

const DEAD_TIME: f64 = 1.0;

impl Plant {
    pub(crate) fn new() -> Self {
        Self { area: vec![(-DEAD_TIME - 1.0, 0.0), (0.0, 0.0)], cursor: 0 }
    }

    pub(crate) fn time(&self) -> f64 {
        self.area.last().unwrap().0
    }

    /// Holds the input for `duration` [s] and returns the output then.
    pub(crate) fn hold(&mut self, input: f64, duration: f64) -> f64 {
        let (time, area) = *self.area.last().unwrap();
        self.area.push((time + duration, area + input * duration));
        self.output()
    }

    pub(crate) fn output(&mut self) -> f64 {
        let time = self.time() - DEAD_TIME;
        while self.area[self.cursor + 1].0 < time {
            self.cursor += 1;
        }
        let ((t0, a0), (t1, a1)) = (self.area[self.cursor], self.area[self.cursor + 1]);
        a0 + (a1 - a0) * (time - t0) / (t1 - t0)
    }
}

/// A law in its loop.
#[derive(Clone, Debug)]
pub(crate) struct Loop<T> {
    pub(crate) settings: Settings<T>,
    pub(crate) state: State<T, Line<T>>,
    pub(crate) plant: Plant,
    pub(crate) load: f64,
    pub(crate) controlled_variable: f64,
    pub(crate) output: f64,
}

impl<T: Scalar> Loop<T> {
    pub(crate) fn at_rest(settings: Settings<T>) -> Self {
        let state = crate::laws::at_rest(&settings);
        Self { settings, state, plant: Plant::new(), load: 0.0, controlled_variable: 0.0, output: 0.0 }
    }

    /// One sample as `input` says, then the output is held for the sample period.
    pub(crate) fn sample(&mut self, input: &Input<T>) -> Output<T> {
        let output = self.state.update(&self.settings, input);
        self.output = output.manipulated_variable.to_f64();
        self.controlled_variable = self.plant.hold(self.output + self.load, input.sample_period.to_f64());
        output
    }

    /// One sample in automatic.
    pub(crate) fn automatic(&mut self, sample_period: f64, setpoint: f64) -> Output<T> {
        let t = T::from_f64;
        let input = Input::automatic(t(sample_period), t(setpoint), t(self.controlled_variable));
        self.sample(&input)
    }

    /// Samples in automatic for `duration` [s].
    pub(crate) fn run(&mut self, duration: f64, sample_period: f64, setpoint: f64) {
        let until = self.plant.time() + duration - 0.5 * sample_period;
        while self.plant.time() < until {
            self.automatic(sample_period, setpoint);
        }
    }
}
