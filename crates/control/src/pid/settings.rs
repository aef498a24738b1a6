//! Settings of the PID terms.

use crate::setting_error::require;
use crate::{Scalar, SettingError};

/// Which way the output goes when the controlled variable rises.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Action {
    /// Down, with a positive proportional gain: for a process of positive gain (a level and its inlet valve).
    #[default]
    Reverse,
    /// Up, with a positive proportional gain: for a process of negative gain (a level and its outlet valve).
    Direct,
}

/// Settings of P, PI, PD and PID action: one law in ideal (ISA standard) form, terms absent or present.
///
/// u = Kc (b r − y) + Kc/Ti ∫(r − y) + Kc Td s/(1 + Tf s) (c r − y) + bias
///
/// The output rises with the setpoint when Kc is positive and the action reverse; direct action turns the sign of Kc. At a sample period h, with the
/// shift z, the sampled law is
///
/// - integral: Kc/Ti · h z/(z − 1), the backward difference;
/// - derivative: Kc Td · (z − 1)/((Tf + h) z − Tf), the backward difference too, stable for every h and Tf ≥ 0.
///
/// Both take the h measured, not one assumed.
///
/// ```
/// use holdup_control::Pid;
///
/// let pd = Pid::proportional(1.5321)?.with_derivative(1.0343, Some(0.01))?;
/// let pi = Pid::proportional(2.0)?.with_integral(30.0)?.with_setpoint_weights(0.7, 0.0)?;
/// assert_eq!((pd.integral_time(), pi.integral_time()), (None, Some(30.0)));
/// assert!(pi.with_integral(0.0).is_err()); // no integral is no `with_integral`, never a code
/// # Ok::<(), holdup_control::SettingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pid<T> {
    proportional_gain: T,
    action: Action,
    integral_time: Option<T>,
    derivative: Option<Derivative<T>>,
    setpoint_weight: T,
    derivative_setpoint_weight: T,
    tracking_time: Option<T>,
    bias: T,
    bleed_time: Option<T>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Derivative<T> {
    pub(crate) time: T,
    pub(crate) filter_time: Option<T>,
}

impl<T: Scalar> Pid<T> {
    /// P action of this gain [output/input unit]; reverse action, both setpoint weights 1, no bias.
    ///
    /// # Errors
    /// A gain that is 0 or not finite.
    pub fn proportional(proportional_gain: T) -> Result<Self, SettingError> {
        Ok(Self {
            proportional_gain: require::nonzero("proportional_gain", proportional_gain)?,
            action: Action::Reverse,
            integral_time: None,
            derivative: None,
            setpoint_weight: T::ONE,
            derivative_setpoint_weight: T::ONE,
            tracking_time: None,
            bias: T::ZERO,
            bleed_time: None,
        })
    }

    /// The same with this action: direct action turns the sign of the proportional gain.
    #[must_use]
    pub fn with_action(mut self, action: Action) -> Self {
        self.action = action;
        self
    }

    /// The same with integral action of this integral time [s].
    ///
    /// # Errors
    /// A time that is not finite and above 0.
    pub fn with_integral(mut self, integral_time: T) -> Result<Self, SettingError> {
        self.integral_time = Some(require::positive("integral_time", integral_time)?);
        Ok(self)
    }

    /// The same with derivative action of this derivative time [s], filtered with this filter time [s], or not
    /// filtered.
    ///
    /// # Errors
    /// A derivative time that is negative or not finite; a filter time that is not finite and above 0.
    pub fn with_derivative(
        mut self,
        derivative_time: T,
        filter_time: Option<T>,
    ) -> Result<Self, SettingError> {
        let time = require::not_negative("derivative_time", derivative_time)?;
        if let Some(filter_time) = filter_time {
            require::positive("filter_time", filter_time)?;
        }
        self.derivative = Some(Derivative { time, filter_time });
        Ok(self)
    }

    /// The same with these weights [–] of the setpoint in the proportional (b) and derivative (c) action.
    ///
    /// # Errors
    /// A weight that is not finite.
    pub fn with_setpoint_weights(
        mut self,
        setpoint_weight: T,
        derivative_setpoint_weight: T,
    ) -> Result<Self, SettingError> {
        self.setpoint_weight = require::finite("setpoint_weight", setpoint_weight)?;
        self.derivative_setpoint_weight =
            require::finite("derivative_setpoint_weight", derivative_setpoint_weight)?;
        Ok(self)
    }

    /// The same with this tracking time [s] of the anti-windup: how fast the integral follows the output that was
    /// really applied. Absent, it is the integral time; 0 is at once.
    ///
    /// # Errors
    /// A time that is negative or not finite.
    pub fn with_tracking_time(mut self, tracking_time: T) -> Result<Self, SettingError> {
        self.tracking_time = Some(require::not_negative("tracking_time", tracking_time)?);
        Ok(self)
    }

    /// The same with this bias [output unit], added to the output, and this bleed time [s].
    ///
    /// Where the law has neither integral nor observer, a transfer without bump moves the bias; it then goes back
    /// to its set value in a straight line over the bleed time. Absent, it stays where the transfer left it.
    ///
    /// # Errors
    /// A bias that is not finite; a time that is not finite and above 0.
    pub fn with_bias(mut self, bias: T, bleed_time: Option<T>) -> Result<Self, SettingError> {
        self.bias = require::finite("bias", bias)?;
        if let Some(bleed_time) = bleed_time {
            require::positive("bleed_time", bleed_time)?;
        }
        self.bleed_time = bleed_time;
        Ok(self)
    }

    /// Proportional gain Kc [output/input unit], as set.
    #[must_use]
    pub fn proportional_gain(&self) -> T {
        self.proportional_gain
    }

    /// Which way the output goes.
    #[must_use]
    pub fn action(&self) -> Action {
        self.action
    }

    /// Integral time Ti [s].
    #[must_use]
    pub fn integral_time(&self) -> Option<T> {
        self.integral_time
    }

    /// Derivative time Td [s].
    #[must_use]
    pub fn derivative_time(&self) -> Option<T> {
        self.derivative.map(|derivative| derivative.time)
    }

    /// Filter time Tf [s] of the derivative.
    #[must_use]
    pub fn filter_time(&self) -> Option<T> {
        self.derivative.and_then(|derivative| derivative.filter_time)
    }

    /// Setpoint weight b [–].
    #[must_use]
    pub fn setpoint_weight(&self) -> T {
        self.setpoint_weight
    }

    /// Derivative setpoint weight c [–].
    #[must_use]
    pub fn derivative_setpoint_weight(&self) -> T {
        self.derivative_setpoint_weight
    }

    /// Tracking time Tt [s] in use: the one set, else the integral time.
    #[must_use]
    pub fn tracking_time(&self) -> Option<T> {
        self.tracking_time.or(self.integral_time)
    }

    /// Set value of the bias [output unit].
    #[must_use]
    pub fn bias(&self) -> T {
        self.bias
    }

    /// Bleed time [s] of the bias.
    #[must_use]
    pub fn bleed_time(&self) -> Option<T> {
        self.bleed_time
    }

    /// Proportional gain with the sign that the action gives it.
    pub(crate) fn signed_gain(&self) -> T {
        match self.action {
            Action::Reverse => self.proportional_gain,
            Action::Direct => -self.proportional_gain,
        }
    }
}
