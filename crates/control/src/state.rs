//! Running state of a controller.

use crate::setting_error::require;
use crate::{DelayLine, Law, ObserverState, PidState, Sample, Scalar, Segment, SettingError, Settings, Sum};

/// Running state of a controller: plain data. A copy of it is a save, and running on from the copy continues bit for
/// bit.
///
/// The storage `S` of the delay line is `[]` without an observer, `[Segment<T>; N]` with one on a target and
/// `Vec<Segment<T>>` in a simulation.
///
/// ```
/// use holdup_control::{Input, Limits, Observer, Pid, Segment, Settings, State};
///
/// let pd = Pid::proportional(1.5321)?.with_derivative(1.0343, Some(0.01))?;
/// let settings = Settings::new(pd)
///     .with_observer(Observer::new(1.5321, 0.0506, 6.0, 0.5)?)?
///     .with_limits(Limits::new(Some(-5.0), Some(5.0))?)?;
///
/// // At rest at level 0 with the valve at 0; then the setpoint is 1.
/// let mut state = State::at_rest(&settings, [Segment::default(); 15], 0.0, 0.0, 0.0)?;
/// let output = state.update(&settings, &Input::automatic(0.5, 1.0, 0.0));
/// assert!(output.manipulated_variable > 1.5);
/// # Ok::<(), holdup_control::SettingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<T, S> {
    /// The law in use: the one of the settings last given.
    pub law: Law<T>,
    /// State of the PID terms.
    pub pid: PidState<T>,
    /// State of the observer.
    pub observer: ObserverState<T>,
    /// The observer's delay line.
    pub line: DelayLine<T, S>,
    /// Setpoint last used [input unit].
    pub setpoint: T,
    /// Feed-forward last used [output unit].
    pub feed_forward: T,
    /// Controlled variable last measured well [input unit].
    pub controlled_variable: T,
    /// Time since then [s].
    pub age: Sum<T>,
    /// What the PID terms asked for last, without bias, feed-forward and estimate: `u_pd` [output unit].
    pub unassisted: T,
    /// What the law wanted last, before the limits [output unit].
    pub wanted: T,
    /// The manipulated variable returned last [output unit].
    pub manipulated_variable: T,
    /// True when the last measurement was good and the states follow it.
    pub follows: bool,
    /// True when the last output was the law's.
    pub automatic: bool,
}

impl<T: Scalar, S: AsRef<[Segment<T>]> + AsMut<[Segment<T>]>> State<T, S> {
    /// A controller that is switched on at this manipulated variable [output unit]: its first automatic output is
    /// that one, whatever the measurement.
    ///
    /// # Errors
    /// An output that is not finite, or whose distance from the bias is not; storage too short for the observer's dead
    /// time, with the length needed.
    pub fn switched_on(
        settings: &Settings<T>,
        storage: S,
        manipulated_variable: T,
    ) -> Result<Self, SettingError> {
        let manipulated_variable = require::finite("manipulated_variable", manipulated_variable)?;
        let manipulated_variable = settings.limits().within(manipulated_variable);
        let line = match settings.law().observer {
            Some(observer) => DelayLine::new(storage, observer.dead_time(), observer.sample_period())?,
            None => DelayLine::unused(storage),
        };
        // Until a measurement tells more, the load is taken to be the one that this output balances.
        let balanced = settings.law().pid.bias() - manipulated_variable;
        let requirement = "must not differ from the bias by more than the number format holds";
        require::that(balanced.is_finite(), "manipulated_variable", manipulated_variable, requirement)?;
        let load_estimate = settings.law().observer.map_or(T::ZERO, |_| balanced);
        Ok(Self {
            law: *settings.law(),
            pid: PidState::default(),
            observer: ObserverState { load_estimate, ..ObserverState::default() },
            line,
            setpoint: T::ZERO,
            feed_forward: T::ZERO,
            controlled_variable: T::ZERO,
            age: Sum::new(T::ZERO),
            unassisted: T::ZERO,
            wanted: manipulated_variable,
            manipulated_variable,
            follows: false,
            automatic: false,
        })
    }

    /// A controller that has long been in automatic at this setpoint [input unit], controlled variable [input unit]
    /// and manipulated variable [output unit]: it answers the next change of any of them at once.
    ///
    /// # Errors
    /// A value that is not finite, or that makes a term of the law infinite; storage too short for the observer's dead
    /// time, with the length needed.
    pub fn at_rest(
        settings: &Settings<T>,
        storage: S,
        setpoint: T,
        controlled_variable: T,
        manipulated_variable: T,
    ) -> Result<Self, SettingError> {
        let mut state = Self::switched_on(settings, storage, manipulated_variable)?;
        state.setpoint = require::finite("setpoint", setpoint)?;
        state.controlled_variable = require::finite("controlled_variable", controlled_variable)?;
        state.pid.sample = Some(state.seen());
        if let Some(observer) = settings.law().observer {
            // At rest it is the load estimate that holds the output, not the integral.
            state.observer.start(&observer, controlled_variable, state.observer.load_estimate);
        }
        state.seat(state.manipulated_variable);
        let held = state.pid.integral.value() + state.pid.bias_offset + state.observer.load_estimate;
        let requirement = "must be so near to the setpoint that the law's terms are finite";
        let sound = held.is_finite() && state.unassisted.is_finite();
        require::that(sound, "controlled_variable", controlled_variable, requirement)?;
        // A prediction at rest has nothing under way.
        if !state.law.observer.is_some_and(|observer| observer.predicts()) {
            state.line.fill(state.unassisted);
        }
        state.follows = true;
        state.automatic = true;
        Ok(state)
    }

    /// Checks that the storage is long enough for other settings.
    ///
    /// # Errors
    /// Storage too short for the observer's dead time, with the length needed.
    pub fn fits(&self, settings: &Settings<T>) -> Result<(), SettingError> {
        let needed = settings.segments_needed();
        let segments = self.line.storage.as_ref().len();
        if segments < needed { Err(SettingError::LineTooShort { segments, needed }) } else { Ok(()) }
    }

    /// What the PID terms look at now: the setpoint and the controlled variable, predicted where the law predicts.
    pub(crate) fn seen(&self) -> Sample<T> {
        let mut controlled_variable = self.controlled_variable;
        if let Some(observer) = self.law.observer
            && observer.predicts()
        {
            controlled_variable = controlled_variable + observer.model_gain() * self.line.area();
        }
        Sample { setpoint: self.setpoint, controlled_variable }
    }

    /// What is added to the output beside the terms and the observer's model: feed-forward and bias [output unit].
    pub(crate) fn assistance(&self) -> T {
        self.feed_forward + (self.law.pid.bias() + self.pid.bias_offset)
    }

    /// Makes `target` [output unit] the wanted output: the integral gives way; where there is none, the load
    /// estimate; where there is no observer, the bias.
    pub(crate) fn seat(&mut self, target: T) {
        let terms = self.pid.proportional_derivative(&self.law.pid, self.setpoint);
        self.pid.set_bias_offset(&self.law.pid, T::ZERO);
        self.unassisted = terms;
        if self.law.pid.integral_time().is_some() {
            let integral = target - self.assistance() + self.observer.load_estimate - terms;
            self.pid.integral = Sum::new(integral);
            self.unassisted = terms + integral;
        } else if let Some(observer) = self.law.observer {
            let load_estimate = terms + self.assistance() - target;
            self.observer.seat(&observer, load_estimate);
        } else {
            let offset = target - (terms + self.assistance());
            self.pid.set_bias_offset(&self.law.pid, offset);
        }
        self.wanted = target;
    }

    /// Takes another law, its load estimate where the old one's was. The wanted output is the caller's to seat.
    pub(crate) fn adopt(&mut self, law: &Law<T>) {
        let old = self.law.observer;
        self.law = *law;
        if let Some(observer) = law.observer {
            if old.is_none() {
                self.line.dead_time = observer.dead_time();
                self.line.fill(self.unassisted);
                self.observer.start(&observer, self.controlled_variable, T::ZERO);
            } else if old != law.observer {
                self.line.set_dead_time(observer.dead_time());
                self.observer.seat(&observer, self.observer.load_estimate);
            }
        } else {
            self.observer = ObserverState::default();
        }
        if law.pid.integral_time().is_none() {
            self.pid.integral = Sum::new(T::ZERO);
        }
        let seen = self.seen().controlled_variable;
        if let Some(sample) = &mut self.pid.sample {
            sample.controlled_variable = seen;
        }
    }
}
