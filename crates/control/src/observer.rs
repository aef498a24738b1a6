//! The disturbance observer, and the modified Smith predictor made of it.

use crate::delay_line::segments_needed;
use crate::setting_error::require;
use crate::{DelayLine, Scalar, Segment, SettingError, Sum};

/// Settings of the disturbance observer.
///
/// The load estimate D̂ = Ko (y − `y_m`) is subtracted from the output of the PID terms, u = `u_pd` − D̂. The model
/// `y_m` = Km/s e^(−dm s) is driven by `u_applied` + D̂, which is `u_pd` while nothing limits. (Kadam 2017, section 4, Fig.
/// "disobs", with limits.)
///
/// With [`Observer::predicting`] the PID terms act on y + Km ∫ of what the model was given and has not yet shown:
/// the modified Smith predictor of Matausek and Micic (1996), with P action Kr = 1/(Km Tr) and K0 = Ko. With
/// [`Observer::with_lead`] as well, D̂ = Ko (1 + Td s)/(1 + Tf s) (y − `y_m)`: the one of 1999.
///
/// Sampled, the model is exact for a held drive, at any fraction of a sample; the lead is the backward difference,
/// ((Td + h) z − Td)/((Tf + h) z − Tf). D̂ moves only with a new sample.
///
/// The model's gain and dead time may change while running: D̂ stays where it is (in a predictor without integral it
/// takes up what the prediction moves, so that the output stays).
///
/// ```
/// use holdup_control::Observer;
///
/// let observer = Observer::new(1.5321, 0.0506, 6.0, 0.5)?; // Ko, Km [1/s], dm [s], at 0.5 s
/// assert_eq!(observer.segments_needed(), 15);
/// assert!(Observer::new(1.5321, -0.0506, 6.0, 0.5).is_err()); // it would feed its estimate back
/// # Ok::<(), holdup_control::SettingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Observer<T> {
    gain: T,
    model_gain: T,
    dead_time: T,
    sample_period: T,
    lead: Option<(T, T)>,
    predicts: bool,
}

impl<T: Scalar> Observer<T> {
    /// An observer of gain Ko [output/input unit] with a model of gain Km [input unit/(output unit·s)] and dead
    /// time [s], at a nominal sample period [s].
    ///
    /// The sample period only says how long the delay line must be; the law runs on the one measured.
    ///
    /// # Errors
    /// A gain that is 0 or not finite, gains of different sign, a time that is not finite and above 0.
    pub fn new(
        observer_gain: T,
        model_gain: T,
        dead_time: T,
        sample_period: T,
    ) -> Result<Self, SettingError> {
        require::nonzero("observer_gain", observer_gain)?;
        require::nonzero("model_gain", model_gain)?;
        let same_sign = (observer_gain > T::ZERO) == (model_gain > T::ZERO);
        require::that(same_sign, "observer_gain", observer_gain, "must have the sign of model_gain")?;
        require::positive("dead_time", dead_time)?;
        require::positive("sample_period", sample_period)?;
        Ok(Self { gain: observer_gain, model_gain, dead_time, sample_period, lead: None, predicts: false })
    }

    /// The same with a lead (1 + Td s)/(1 + Tf s) in the estimate: derivative time [s], filter time [s].
    ///
    /// # Errors
    /// A derivative time that is negative or not finite; a filter time that is not finite and above 0.
    pub fn with_lead(mut self, derivative_time: T, filter_time: T) -> Result<Self, SettingError> {
        let derivative_time = require::not_negative("derivative_time", derivative_time)?;
        let filter_time = require::positive("filter_time", filter_time)?;
        self.lead = Some((derivative_time, filter_time));
        Ok(self)
    }

    /// The same with the PID terms acting on the predicted controlled variable: the modified Smith predictor.
    #[must_use]
    pub fn predicting(mut self) -> Self {
        self.predicts = true;
        self
    }

    /// Observer gain Ko [output/input unit].
    #[must_use]
    pub fn observer_gain(&self) -> T {
        self.gain
    }

    /// Gain Km of the model [input unit/(output unit·s)].
    #[must_use]
    pub fn model_gain(&self) -> T {
        self.model_gain
    }

    /// Dead time dm of the model [s].
    #[must_use]
    pub fn dead_time(&self) -> T {
        self.dead_time
    }

    /// Nominal sample period [s].
    #[must_use]
    pub fn sample_period(&self) -> T {
        self.sample_period
    }

    /// Derivative time and filter time [s] of the lead.
    #[must_use]
    pub fn lead(&self) -> Option<(T, T)> {
        self.lead
    }

    /// True when the PID terms act on the predicted controlled variable.
    #[must_use]
    pub fn predicts(&self) -> bool {
        self.predicts
    }

    /// Segments that the delay line needs.
    #[must_use]
    pub fn segments_needed(&self) -> usize {
        segments_needed(self.dead_time, self.sample_period)
    }
}

/// Running state of the disturbance observer, its delay line apart.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ObserverState<T> {
    /// The model's output `y_m` [input unit].
    pub model: Sum<T>,
    /// The load estimate D̂ [output unit].
    pub load_estimate: T,
    /// y − `y_m` at the newest good sample [input unit].
    pub innovation: T,
    /// Filtered slope of y − `y_m` [input unit/s]; moves only with a lead.
    pub slope: T,
}

impl<T: Scalar> ObserverState<T> {
    /// The model runs on by `h` [s], driven by `drive` [output unit].
    pub(crate) fn advance<S: AsRef<[Segment<T>]> + AsMut<[Segment<T>]>>(
        &mut self,
        observer: &Observer<T>,
        line: &mut DelayLine<T, S>,
        drive: T,
        h: T,
    ) {
        self.model.add(observer.model_gain * line.advance(drive, h));
    }

    /// A new sample came, `elapsed` [s] after the one before: D̂ from y and `y_m`.
    pub(crate) fn measure(&mut self, observer: &Observer<T>, controlled_variable: T, elapsed: T) {
        let innovation = self.model.below(controlled_variable);
        let mut leading = innovation;
        if let Some((td, tf)) = observer.lead {
            self.slope = (tf * self.slope + (innovation - self.innovation)) / (tf + elapsed);
            leading = innovation + (td - tf) * self.slope;
        }
        self.innovation = innovation;
        self.load_estimate = observer.gain * leading;
    }

    /// Puts the model where the load estimate is `load_estimate` [output unit] at this controlled variable.
    pub(crate) fn start(&mut self, observer: &Observer<T>, controlled_variable: T, load_estimate: T) {
        self.innovation = load_estimate / observer.gain;
        self.slope = T::ZERO;
        self.load_estimate = load_estimate;
        self.model = Sum::new(controlled_variable - self.innovation);
    }

    /// Shifts the model so that the load estimate would have been `load_estimate` [output unit] at the newest sample;
    /// what the model has moved since then stays.
    pub(crate) fn seat(&mut self, observer: &Observer<T>, load_estimate: T) {
        let innovation = load_estimate / observer.gain;
        self.model.add(self.innovation - innovation);
        self.innovation = innovation;
        self.slope = T::ZERO;
        self.load_estimate = load_estimate;
    }
}
