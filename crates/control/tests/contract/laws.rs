//! The laws under contract, on the process K = 1, d = 1 that they are tuned for.

use holdup_control::{Limits, Observer, Pid, Scalar, Segment, Settings, State};

/// Nominal sample period [s].
pub(crate) const PERIOD: f64 = 0.1;
/// Segments of the delay line: enough for a dead time of 1.5 s at 0.05 s.
pub(crate) const SEGMENTS: usize = 40;

pub(crate) type Line<T> = [Segment<T>; SEGMENTS];

/// A law by its numbers, so that it can be built in `f32` and in `f64`, and apart from the crate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Law {
    pub(crate) proportional_gain: f64,
    pub(crate) integral_time: Option<f64>,
    /// Derivative time, filter time.
    pub(crate) derivative: Option<(f64, Option<f64>)>,
    /// b, c.
    pub(crate) weights: (f64, f64),
    /// Ko, and the lead's derivative and filter time.
    pub(crate) observer: Option<(f64, Option<(f64, f64)>)>,
    pub(crate) predicts: bool,
}

const P: Law = Law {
    proportional_gain: 0.4,
    integral_time: None,
    derivative: None,
    weights: (1.0, 1.0),
    observer: None,
    predicts: false,
};
const PD: Law = Law { derivative: Some((0.4, Some(0.2))), ..P };

pub(crate) const ALL: [(&str, Law); 10] = [
    ("p", P),
    ("pi", Law { integral_time: Some(8.0), ..P }),
    ("pd", PD),
    ("pd_without_filter", Law { derivative: Some((0.4, None)), weights: (1.0, 0.0), ..P }),
    ("pid", Law { integral_time: Some(8.0), ..PD }),
    ("pid_with_setpoint_weights", Law { integral_time: Some(8.0), weights: (0.6, 0.0), ..PD }),
    ("pd_with_observer", Law { observer: Some((0.3, None)), ..PD }),
    ("pid_with_observer", Law { integral_time: Some(12.0), observer: Some((0.2, None)), ..PD }),
    (
        "smith_predictor_1996",
        Law { proportional_gain: 1.0, observer: Some((0.5, None)), predicts: true, ..P },
    ),
    (
        "smith_predictor_1999",
        Law { proportional_gain: 1.0, observer: Some((0.7, Some((0.4, 0.2)))), predicts: true, ..P },
    ),
];

/// The law of this name.
pub(crate) fn law(name: &str) -> Law {
    ALL.iter().find(|(known, _)| *known == name).expect("a law under contract").1
}

impl Law {
    pub(crate) fn settings<T: Scalar>(&self) -> Settings<T> {
        self.settings_with_model(1.0, 1.0)
    }

    pub(crate) fn settings_with_model<T: Scalar>(&self, model_gain: f64, dead_time: f64) -> Settings<T> {
        let t = T::from_f64;
        let mut pid = Pid::proportional(t(self.proportional_gain)).unwrap();
        pid = pid.with_setpoint_weights(t(self.weights.0), t(self.weights.1)).unwrap();
        if let Some(integral_time) = self.integral_time {
            pid = pid.with_integral(t(integral_time)).unwrap();
        }
        if let Some((derivative_time, filter_time)) = self.derivative {
            pid = pid.with_derivative(t(derivative_time), filter_time.map(t)).unwrap();
        }
        let settings = Settings::new(pid.with_bias(t(0.0), Some(t(5.0))).unwrap());
        let Some((gain, lead)) = self.observer else { return settings };
        let mut observer =
            Observer::new(t(gain), t(model_gain), t(dead_time), t(PERIOD * dead_time)).unwrap();
        if let Some((derivative_time, filter_time)) = lead {
            observer = observer.with_lead(t(derivative_time), t(filter_time)).unwrap();
        }
        settings.with_observer(if self.predicts { observer.predicting() } else { observer }).unwrap()
    }

    pub(crate) fn limited<T: Scalar>(&self, low: f64, high: f64) -> Settings<T> {
        let limits = Limits::new(Some(T::from_f64(low)), Some(T::from_f64(high))).unwrap();
        self.settings().with_limits(limits).unwrap()
    }

    /// True when a constant load leaves no error.
    pub(crate) fn rejects_loads(&self) -> bool {
        self.integral_time.is_some() || self.observer.is_some()
    }
}

/// A state at rest at 0, whose line is long enough for the sample periods that the tests use.
pub(crate) fn at_rest<T: Scalar>(settings: &Settings<T>) -> State<T, Line<T>> {
    State::at_rest(settings, [Segment::default(); SEGMENTS], T::ZERO, T::ZERO, T::ZERO).unwrap()
}
