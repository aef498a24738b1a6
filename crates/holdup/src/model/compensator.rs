//! Dead-time compensators: controllers that carry a model of the process with its dead time.

use super::error::{ModelError, finite, non_zero, out_of_range, positive};
use super::quantity::Seconds;

/// The lead `(Td·s + 1)/(Tf·s + 1)` in a feedback of the prediction error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lead {
    /// Time Td of the numerator [s], ≥ 0.
    pub derivative_time: f64,
    /// Time Tf of the denominator [s], > 0.
    pub filter_time: f64,
}

/// The law of a dead-time compensator. r is the setpoint, y the controlled variable, u the controller output;
/// Km and dm are gain and dead time of the model of [`Compensator`]. Gains have the sign of the process gain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CompensatorLaw {
    /// The modified Smith predictor of Mataušek and Micić: `u = v − K0·lead(s)·ε`, `v = Kr·(r − ŷ − ε)`, with
    /// `ŷ = Km·v/s` and `ε = y − e^(−dm·s)·ŷ`. With a perfect model `y/r = e^(−d·s)/(Tr·s + 1)`,
    /// Tr = 1/(K·Kr), and `S = [1 − e^(−d·s)/(Tr·s + 1)]·s/(s + K·K0·lead(s)·e^(−d·s))`.
    ModifiedSmith {
        /// Main gain Kr on the predicted output [input unit / output unit].
        main_gain: f64,
        /// Gain K0 on the prediction error [input unit / output unit].
        disturbance_gain: f64,
        /// The lead of the 1999 version.
        lead: Option<Lead>,
    },
    /// The two-degree-of-freedom compensator of which Zhong's observer, the Åström–Hang–Lim predictor and the
    /// filtered Smith predictor with P primary control are three descriptions:
    /// `u = s·r/(Km·(T·s + 1)) − Q·(s·y/Km − e^(−dm·s)·u)`, `Q = (β·s + 1)/(a2·s² + a1·s + 1)`, β = a1 + dm. With
    /// a perfect model `y/r = e^(−d·s)/(T·s + 1)` and the complementary sensitivity is `Q·e^(−d·s)`.
    TwoDegree {
        /// Time T of the setpoint response [s].
        setpoint_time: f64,
        /// Coefficient a1 [s] of the denominator of Q.
        a1: f64,
        /// Coefficient a2 [s²] of the denominator of Q.
        a2: f64,
    },
    /// Huba's P control with inverse-model observer: `u = Kc·(r − y) − D̂`,
    /// `D̂ = (s·y/Km − e^(−dm·s)·u)/(Tf·s + 1)`. With a perfect model `S = S_p·(1 − e^(−d·s)/(Tf·s + 1))`, `S_p` that
    /// of the P loop.
    InverseModel {
        /// Proportional gain Kc [input unit / output unit].
        main_gain: f64,
        /// Time Tf of the observer's filter [s].
        filter_time: f64,
    },
    /// First-order active disturbance rejection, linear: `u = (ωc·(r − z1) − z2)/Km` with the observer
    /// `z1' = z2 + 2·ωo·(y − z1) + Km·u`, `z2' = ωo²·(y − z1)`. It knows no dead time. From y to u it is a PI
    /// controller with an output filter.
    DisturbanceRejection {
        /// Bandwidth ωc of the control [rad/s].
        controller_bandwidth: f64,
        /// Bandwidth ωo of the observer [rad/s].
        observer_bandwidth: f64,
    },
}

/// A dead-time compensator: its law and its model of the process, `Km·e^(−dm·s)/s`.
///
/// The model belongs to the controller: on a process of another gain, dead time or order it stays what it is.
///
/// ```
/// use holdup::model::{Compensator, CompensatorLaw, Controller, Seconds};
/// let law = CompensatorLaw::ModifiedSmith { main_gain: 0.2, disturbance_gain: 0.1, lead: None };
/// let controller = Controller::from(Compensator::new(law, 1.0, Seconds(5.0))?);
/// assert_eq!((controller.structure(), controller.proportional_gain()), ("SP+DOB", 0.2));
/// # Ok::<(), holdup::model::ModelError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compensator {
    law: CompensatorLaw,
    model_gain: f64,
    model_dead_time: f64,
}

impl Compensator {
    /// A compensator of this law with a model of gain Km [output unit / (input unit · s)] and dead time dm [s].
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] if a gain is 0 or not finite, or a time or bandwidth not positive and finite.
    pub fn new(law: CompensatorLaw, model_gain: f64, model_dead_time: Seconds) -> Result<Self, ModelError> {
        non_zero("model_gain", model_gain)?;
        positive("model_dead_time", model_dead_time.0)?;
        match law {
            CompensatorLaw::ModifiedSmith { main_gain, disturbance_gain, lead } => {
                non_zero("main_gain", main_gain)?;
                non_zero("disturbance_gain", disturbance_gain)?;
                if let Some(Lead { derivative_time, filter_time }) = lead {
                    if !(derivative_time.is_finite() && derivative_time >= 0.0) {
                        let allowed = "a finite number, 0 or greater";
                        return Err(out_of_range("lead_time", derivative_time, allowed));
                    }
                    positive("filter_time", filter_time)?;
                }
            }
            CompensatorLaw::TwoDegree { setpoint_time, a1, a2 } => {
                positive("setpoint_time", setpoint_time)?;
                positive("a1", a1)?;
                positive("a2", a2)?;
            }
            CompensatorLaw::InverseModel { main_gain, filter_time } => {
                non_zero("main_gain", main_gain)?;
                positive("filter_time", filter_time)?;
            }
            CompensatorLaw::DisturbanceRejection { controller_bandwidth, observer_bandwidth } => {
                positive("controller_bandwidth", controller_bandwidth)?;
                positive("observer_bandwidth", observer_bandwidth)?;
            }
        }
        let compensator = Self { law, model_gain, model_dead_time: model_dead_time.0 };
        // The gains that the law makes of its settings must be numbers too.
        non_zero("main_gain", compensator.main_gain())?;
        finite("noise_gain", compensator.noise_gain())?;
        Ok(compensator)
    }

    /// The law with its settings.
    #[must_use]
    pub fn law(&self) -> CompensatorLaw {
        self.law
    }

    /// Gain Km of the model [output unit / (input unit · s)].
    #[must_use]
    pub fn model_gain(&self) -> f64 {
        self.model_gain
    }

    /// Dead time dm of the model [s].
    #[must_use]
    pub fn model_dead_time(&self) -> f64 {
        self.model_dead_time
    }

    /// Name of the structure: `SP+DOB`, `2DOF-DTC`, `P+inverse-DOB` or `ADRC`.
    #[must_use]
    pub fn structure(&self) -> &'static str {
        match self.law {
            CompensatorLaw::ModifiedSmith { .. } => "SP+DOB",
            CompensatorLaw::TwoDegree { .. } => "2DOF-DTC",
            CompensatorLaw::InverseModel { .. } => "P+inverse-DOB",
            CompensatorLaw::DisturbanceRejection { .. } => "ADRC",
        }
    }

    /// Gain of the proportional control that the law rests on [input unit / output unit]: Kr, Kc, 1/(Km·T) of the
    /// two-degree-of-freedom compensator, ωc/Km of active disturbance rejection.
    #[must_use]
    pub fn main_gain(&self) -> f64 {
        match self.law {
            CompensatorLaw::ModifiedSmith { main_gain, .. }
            | CompensatorLaw::InverseModel { main_gain, .. } => main_gain,
            CompensatorLaw::TwoDegree { setpoint_time, .. } => 1.0 / (self.model_gain * setpoint_time),
            CompensatorLaw::DisturbanceRejection { controller_bandwidth, .. } => {
                controller_bandwidth / self.model_gain
            }
        }
    }

    /// High-frequency limit of the gain from measurement to controller output [input unit / output unit].
    #[must_use]
    pub fn noise_gain(&self) -> f64 {
        let gain = match self.law {
            CompensatorLaw::ModifiedSmith { main_gain, disturbance_gain, lead } => {
                main_gain
                    + disturbance_gain * lead.map_or(1.0, |lead| lead.derivative_time / lead.filter_time)
            }
            CompensatorLaw::TwoDegree { a1, a2, .. } => (a1 + self.model_dead_time) / (a2 * self.model_gain),
            CompensatorLaw::InverseModel { main_gain, filter_time } => {
                main_gain + 1.0 / (self.model_gain * filter_time)
            }
            CompensatorLaw::DisturbanceRejection { .. } => 0.0,
        };
        gain.abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_out_of_range_are_named() {
        let message =
            |law, gain, dead_time| Compensator::new(law, gain, Seconds(dead_time)).unwrap_err().to_string();
        let huba = |main_gain, filter_time| CompensatorLaw::InverseModel { main_gain, filter_time };
        assert!(message(huba(0.0, 1.0), 1.0, 1.0).starts_with("main_gain is 0"));
        assert!(message(huba(1.0, -1.0), 1.0, 1.0).starts_with("filter_time is -1"));
        assert!(message(huba(1.0, 1.0), f64::NAN, 1.0).starts_with("model_gain is NaN"));
        assert!(message(huba(1.0, 1.0), 1.0, 0.0).starts_with("model_dead_time is 0"));
        let two = CompensatorLaw::TwoDegree { setpoint_time: 1.0, a1: 1.0, a2: 0.0 };
        assert!(message(two, 1.0, 1.0).starts_with("a2 is 0"));
        let overflow = CompensatorLaw::TwoDegree { setpoint_time: 1e-300, a1: 1.0, a2: 1.0 };
        assert!(message(overflow, 1e-300, 1.0).starts_with("main_gain is inf"));
    }
}
