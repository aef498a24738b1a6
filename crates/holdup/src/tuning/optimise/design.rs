//! The controllers of a structure: their free settings apart from the proportional gain.

use super::filter::Filter;
use crate::model::{Controller, ModelError, Observer, Process, Seconds};

/// The structure whose settings are free.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Structure {
    /// Kc.
    P,
    /// Kc and Ti.
    Pi,
    /// Kc, Ti and the setpoint weight b.
    PiWeighted,
    /// Kc and Td, and the filter time where [`Filter`] says so.
    Pd,
    /// Kc, Ti and Td, and the filter time where [`Filter`] says so.
    Pid,
    /// PID with the setpoint weight b; no derivative action on the setpoint.
    PidWeighted,
    /// Kc and the observer gain Ko.
    PObserver,
    /// Kc, Td and the observer gain Ko, and the filter time where [`Filter`] says so.
    PdObserver,
}

/// Names of the structures, as on the command line.
const NAMES: [(&str, Structure); 8] = [
    ("p", Structure::P),
    ("pi", Structure::Pi),
    ("pi-b", Structure::PiWeighted),
    ("pd", Structure::Pd),
    ("pid", Structure::Pid),
    ("pid-b", Structure::PidWeighted),
    ("p+dob", Structure::PObserver),
    ("pd+dob", Structure::PdObserver),
];

/// Parts nearer to 0 or 1 are at an end of the range.
const AT_END: f64 = 1e-5;

/// A free setting, as the search sees it: a number from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Variable {
    IntegralTime,
    DerivativeTime,
    /// Ratio of filter time to derivative time.
    FilterRatio,
    /// Ratio of observer gain to proportional gain.
    ObserverRatio,
    SetpointWeight,
}

impl Variable {
    /// Least and greatest value: times in dead times (lag included), ratios as they are. All but the weight are searched by
    /// their logarithm.
    fn range(self) -> [f64; 2] {
        match self {
            Self::IntegralTime => [1.05, 60.0],
            Self::DerivativeTime => [0.02, 2.0],
            Self::FilterRatio => [0.005, 3.0],
            Self::ObserverRatio => [0.005, 5.0],
            Self::SetpointWeight => [0.0, 1.5],
        }
    }

    /// What it is, in words, and the unit in which it is searched.
    fn words(self) -> [&'static str; 2] {
        match self {
            Self::IntegralTime => ["integral time", " times dead time and lag"],
            Self::DerivativeTime => ["derivative time", " times dead time and lag"],
            Self::FilterRatio => ["filter time", " times the derivative time"],
            Self::ObserverRatio => ["observer gain", " times the proportional gain"],
            Self::SetpointWeight => ["setpoint weight", ""],
        }
    }

    fn value(self, part: f64) -> f64 {
        let [low, high] = self.range();
        match self {
            Self::SetpointWeight => low + (high - low) * part,
            _ => low * (high / low).powf(part),
        }
    }
}

impl Structure {
    /// The structure of this name: p, pi, pi-b, pd, pid, pid-b, p+dob, pd+dob.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        NAMES.iter().find(|(known, _)| *known == name).map(|(_, structure)| *structure)
    }

    /// Every name.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMES.iter().map(|(name, _)| *name)
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        NAMES.iter().find(|(_, structure)| *structure == self).map_or("", |(name, _)| name)
    }

    /// Whether a constant load leaves no error behind.
    #[must_use]
    pub fn rejects_load(self) -> bool {
        !matches!(self, Self::P | Self::Pd)
    }

    /// Whether there is derivative action.
    #[must_use]
    pub fn differentiates(self) -> bool {
        matches!(self, Self::Pd | Self::Pid | Self::PidWeighted | Self::PdObserver)
    }

    /// Whether there is integral action.
    #[must_use]
    pub fn integrates(self) -> bool {
        matches!(self, Self::Pi | Self::PiWeighted | Self::Pid | Self::PidWeighted)
    }

    /// Whether there is a disturbance observer.
    #[must_use]
    pub fn observes(self) -> bool {
        matches!(self, Self::PObserver | Self::PdObserver)
    }

    /// Whether the setpoint weight is a free setting.
    pub(super) fn weights_setpoint(self) -> bool {
        matches!(self, Self::PiWeighted | Self::PidWeighted)
    }

    /// The free settings beside the gain.
    fn variables(self, filter: Filter) -> Vec<Variable> {
        use Variable::{DerivativeTime, FilterRatio, IntegralTime, ObserverRatio, SetpointWeight};
        let mut list = match self {
            Self::P => vec![],
            Self::Pi => vec![IntegralTime],
            Self::PiWeighted => vec![IntegralTime, SetpointWeight],
            Self::Pd => vec![DerivativeTime],
            Self::Pid => vec![IntegralTime, DerivativeTime],
            Self::PidWeighted => vec![IntegralTime, DerivativeTime, SetpointWeight],
            Self::PObserver => vec![ObserverRatio],
            Self::PdObserver => vec![DerivativeTime, ObserverRatio],
        };
        if filter == Filter::Free && self.differentiates() {
            list.push(FilterRatio);
        }
        list
    }
}

/// A process and the controllers of a structure for it.
#[derive(Debug, Clone)]
pub(super) struct Design {
    pub(super) process: Process,
    pub(super) structure: Structure,
    pub(super) filter: Filter,
    pub(super) variables: Vec<Variable>,
    /// Unit of time \[s\]: dead time and lag.
    pub(super) time: f64,
    /// Unit of gain, with its sign \[input/output unit\].
    pub(super) gain: f64,
    /// Whether the size of a box is proven while it is searched.
    pub(super) proving: bool,
}

impl Design {
    /// The search space. A setpoint weight is searched only where a setpoint step is looked at (`of_setpoint`): nothing else
    /// depends on it, and it stays at 1.
    pub(super) fn new(process: &Process, structure: Structure, filter: Filter, of_setpoint: bool) -> Self {
        let time = process.dead_time() + process.lag().unwrap_or(0.0);
        let gain = 1.0 / (process.process_gain() * time.powi(i32::from(process.integrators())));
        let mut variables = structure.variables(filter);
        variables.retain(|variable| of_setpoint || *variable != Variable::SetpointWeight);
        Self { process: *process, structure, filter, variables, time, gain, proving: false }
    }

    pub(super) fn weights_setpoint(&self) -> bool {
        self.variables.contains(&Variable::SetpointWeight)
    }

    /// Whether there is a derivative without filter.
    pub(super) fn unfiltered(&self) -> bool {
        self.structure.differentiates() && self.filter == Filter::None
    }

    /// What ended at an end of the range that is searched, one sentence each.
    pub(super) fn at_ends(&self, parts: &[f64]) -> Vec<String> {
        let sentence = |(variable, part): (&Variable, &f64)| {
            let [name, unit] = variable.words();
            let [low, high] = variable.range();
            let (end, value, way) = if *part >= 1.0 - AT_END {
                ("upper", high, "larger")
            } else if *part <= AT_END {
                ("lower", low, "smaller")
            } else {
                return None;
            };
            Some(format!(
                "The {name} ended at the {end} end of the range searched, {value}{unit}: a {way} one may be better still."
            ))
        };
        self.variables.iter().zip(parts).filter_map(sentence).collect()
    }

    /// How much more gain than 1/(K·d) a loop bears whose lag is part of the unit of time.
    pub(super) fn headroom(&self) -> f64 {
        (self.time / self.process.dead_time()).powi(i32::from(self.process.integrators()))
    }

    /// The controller of these parts (each from 0 to 1, in the order of the variables) and of this gain in units of
    /// 1/(K·d).
    pub(super) fn controller(&self, parts: &[f64], gain: f64) -> Result<Controller, ModelError> {
        let proportional_gain = gain * self.gain;
        let mut controller = Controller::proportional(proportional_gain)?;
        let value = |wanted: Variable| {
            let index = self.variables.iter().position(|variable| *variable == wanted)?;
            Some(wanted.value(parts[index]))
        };
        if let Some(time) = value(Variable::IntegralTime) {
            controller = controller.with_integral_time(Seconds(time * self.time))?;
        }
        if let Some(time) = value(Variable::DerivativeTime) {
            controller = controller.with_derivative_time(Seconds(time * self.time))?;
            let held = if let Filter::Held(ratio) = self.filter { Some(ratio) } else { None };
            if let Some(ratio) = value(Variable::FilterRatio).or(held) {
                controller = controller.with_filter_time(Seconds(ratio * time * self.time))?;
            }
        }
        if let Some(ratio) = value(Variable::ObserverRatio) {
            controller = controller.with_observer(Observer::new(ratio * proportional_gain)?);
        }
        if let Some(weight) = value(Variable::SetpointWeight) {
            controller = controller.with_setpoint_weights(weight, 0.0)?;
        }
        Ok(controller)
    }
}
