//! The other forms in which settings are printed: series (interacting) and parallel (independent gains).
//!
//! A controller is stored in ideal form, `Kc·(1 + 1/(Ti·s) + Td·s)`. Series is
//! `Kc·(1 + 1/(Ti·s))·(1 + Td·s)`, parallel `Kp + Ki/s + Kd·s`. The derivative filter, the setpoint weights,
//! the output filter and the observer belong to the ideal form and stay as they are.

use thiserror::Error;

use super::controller::Controller;
use super::error::ModelError;
use super::quantity::Seconds;

/// The form in which settings are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Form {
    /// `Kc·(1 + 1/(Ti·s) + Td·s)`.
    #[default]
    Ideal,
    /// `Kc·(1 + 1/(Ti·s))·(1 + Td·s)`.
    Series,
    /// `Kp + Ki/s + Kd·s`.
    Parallel,
}

/// Why a controller has no settings in a form.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FormError {
    /// The zeros of the controller are complex, which two real factors cannot give.
    #[error(
        "series form needs integral_time >= 4 * derivative_time: integral_time is {integral_time} s, \
         derivative_time is {derivative_time} s"
    )]
    NoSeries {
        /// Integral time Ti [s] of the ideal form.
        integral_time: f64,
        /// Derivative time Td [s] of the ideal form.
        derivative_time: f64,
    },
    /// The settings do not make a controller.
    #[error(transparent)]
    Model(#[from] ModelError),
}

/// Settings in series form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Series {
    /// Proportional gain of the series form [input unit / output unit].
    pub proportional_gain: f64,
    /// Integral time of the series form [s], where there is integral action.
    pub integral_time: Option<f64>,
    /// Derivative time of the series form [s], where there is derivative action.
    pub derivative_time: Option<f64>,
}

impl Series {
    /// The series settings of a controller; of the two that exist where Ti > 4·Td, the one with the longer
    /// integral time.
    ///
    /// ```
    /// use holdup::model::{Controller, Seconds, forms::Series};
    /// let pid = Controller::proportional(2.0)?.with_integral_time(Seconds(9.0))?.with_derivative_time(Seconds(2.0))?;
    /// let series = Series::of(&pid).unwrap();
    /// assert!((series.integral_time.unwrap() - 6.0).abs() < 1e-14);
    /// # Ok::<(), holdup::model::ModelError>(())
    /// ```
    ///
    /// # Errors
    /// [`FormError::NoSeries`] unless Ti ≥ 4·Td.
    pub fn of(controller: &Controller) -> Result<Self, FormError> {
        let proportional_gain = controller.proportional_gain();
        let (integral_time, derivative_time) = (controller.integral_time(), controller.derivative_time());
        let (Some(ti), Some(td)) = (integral_time, derivative_time) else {
            return Ok(Self { proportional_gain, integral_time, derivative_time });
        };
        if ti < 4.0 * td {
            return Err(FormError::NoSeries { integral_time: ti, derivative_time: td });
        }
        // The larger root by the sum, the smaller from it by the product: no cancellation.
        let longer = 0.5 * (1.0 + (1.0 - 4.0 * (td / ti)).sqrt());
        Ok(Self {
            proportional_gain: proportional_gain * longer,
            integral_time: Some(ti * longer),
            derivative_time: Some(td / longer),
        })
    }

    /// The controller of these settings, in ideal form.
    ///
    /// # Errors
    /// [`ModelError`] if a setting is out of its range.
    pub fn controller(&self) -> Result<Controller, ModelError> {
        let plain = ideal(self.proportional_gain, self.integral_time, self.derivative_time)?;
        match (plain.integral_time(), plain.derivative_time()) {
            (Some(ti), Some(td)) => {
                let gain = self.proportional_gain * (1.0 + td / ti);
                ideal(gain, Some(ti + td), Some(td / (1.0 + td / ti)))
            }
            _ => Ok(plain),
        }
    }
}

/// Settings in parallel form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parallel {
    /// Proportional gain Kp [input unit / output unit].
    pub proportional_gain: f64,
    /// Integral gain Ki [input unit / (output unit · s)], where there is integral action.
    pub integral_gain: Option<f64>,
    /// Derivative gain Kd [input unit · s / output unit], where there is derivative action.
    pub derivative_gain: Option<f64>,
}

impl Parallel {
    /// The parallel settings of a controller.
    #[must_use]
    pub fn of(controller: &Controller) -> Self {
        let kc = controller.proportional_gain();
        Self {
            proportional_gain: kc,
            integral_gain: controller.integral_time().map(|ti| kc / ti),
            derivative_gain: controller.derivative_time().map(|td| kc * td),
        }
    }

    /// The controller of these settings, in ideal form: Ti = Kp/Ki, Td = Kd/Kp.
    ///
    /// ```
    /// use holdup::model::forms::Parallel;
    /// let pd = Parallel { proportional_gain: 2.0, integral_gain: None, derivative_gain: Some(3.0) };
    /// assert_eq!(pd.controller()?.derivative_time(), Some(1.5));
    /// # Ok::<(), holdup::model::ModelError>(())
    /// ```
    ///
    /// # Errors
    /// [`ModelError`] if a setting is out of its range or has another sign than the proportional gain.
    pub fn controller(&self) -> Result<Controller, ModelError> {
        let kp = self.proportional_gain;
        ideal(kp, None, None)?;
        if self.integral_gain.is_some_and(|ki| (ki < 0.0) != (kp < 0.0)) {
            let reason = "the integral gain must have the sign of the proportional gain";
            return Err(ModelError::Conflict { name: "integral_gain", reason });
        }
        if self.derivative_gain.is_some_and(|kd| kd != 0.0 && (kd < 0.0) != (kp < 0.0)) {
            let reason = "the derivative gain must have the sign of the proportional gain";
            return Err(ModelError::Conflict { name: "derivative_gain", reason });
        }
        ideal(kp, self.integral_gain.map(|ki| kp / ki), self.derivative_gain.map(|kd| kd / kp))
    }
}

fn ideal(
    gain: f64,
    integral_time: Option<f64>,
    derivative_time: Option<f64>,
) -> Result<Controller, ModelError> {
    let mut controller = Controller::proportional(gain)?;
    if let Some(ti) = integral_time {
        controller = controller.with_integral_time(Seconds(ti))?;
    }
    if let Some(td) = derivative_time {
        controller = controller.with_derivative_time(Seconds(td))?;
    }
    Ok(controller)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    #[test]
    fn series_exists_up_to_four_derivative_times_and_not_beyond() {
        let edge = ideal(1.0, Some(8.0), Some(2.0)).unwrap();
        let series = Series::of(&edge).unwrap();
        assert_eq!((series.integral_time, series.derivative_time), (Some(4.0), Some(4.0)));
        let beyond = ideal(1.0, Some(8.0 - 1e-9), Some(2.0)).unwrap();
        assert!(matches!(Series::of(&beyond), Err(FormError::NoSeries { .. })));
    }

    #[test]
    fn the_paper_s_pd_read_as_parallel_has_a_shorter_derivative_time() {
        let pd = Parallel { proportional_gain: 1.5321, integral_gain: None, derivative_gain: Some(1.0343) };
        assert_relative_eq!(
            pd.controller().unwrap().derivative_time().unwrap(),
            0.675_086_482_605_574,
            max_relative = 1e-14
        );
    }

    #[test]
    fn gains_of_opposite_sign_are_refused() {
        let wrong = Parallel { proportional_gain: -2.0, integral_gain: Some(0.1), derivative_gain: None };
        assert!(wrong.controller().is_err());
    }

    proptest! {
        // Three roundings each way, and a square root that halves the error at the edge: 1e-7 there.
        #[test]
        fn series_and_back_is_the_same_controller(kc in -9.0..9.0_f64, td in 0.01..10.0_f64, ratio in 4.0..100.0_f64) {
            prop_assume!(kc != 0.0);
            let given = ideal(kc, Some(ratio * td), Some(td)).unwrap();
            if let Ok(series) = Series::of(&given) {
                let back = series.controller().unwrap();
                assert_relative_eq!(back.proportional_gain(), kc, max_relative = 1e-14);
                assert_relative_eq!(back.integral_time().unwrap(), ratio * td, max_relative = 1e-14);
                assert_relative_eq!(back.derivative_time().unwrap(), td, max_relative = 1e-14);
            }
        }

        #[test]
        fn parallel_and_back_is_the_same_controller(kc in -9.0..9.0_f64, ti in 0.01..100.0_f64, td in 0.01..10.0_f64) {
            prop_assume!(kc != 0.0);
            let back = Parallel::of(&ideal(kc, Some(ti), Some(td)).unwrap()).controller().unwrap();
            assert_relative_eq!(back.integral_time().unwrap(), ti, max_relative = 1e-14);
            assert_relative_eq!(back.derivative_time().unwrap(), td, max_relative = 1e-14);
        }
    }
}
