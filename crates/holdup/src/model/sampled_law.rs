//! The law that runs in the plant, of a controller: the settings of `holdup_control`.

use holdup_control::{Law, Observer, Pid, Scalar, SettingError};
use thiserror::Error;

use super::compensator::CompensatorLaw;
use super::controller::Controller;
use super::process::Process;
use super::quantity::Seconds;

/// Why a controller has no sampled law.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum NoSampledLaw {
    /// A term that `holdup_control` does not have.
    #[error("{name}: {reason}")]
    Term {
        /// Name of the term or of the structure.
        name: &'static str,
        /// Why it cannot stand, and what can.
        reason: &'static str,
    },
    /// A number that is none for the law, or no longer one in its precision.
    #[error("{0}")]
    Setting(#[from] SettingError),
}

/// The law of a controller on a process, sampled about every `sample_period` [s]; in the precision `T`.
///
/// The gain keeps its sign, so the action is always reverse. An observer without a model of its own takes that of the
/// process. The modified Smith predictor becomes P action on the predicted output with an observer: the same law.
///
/// ```
/// use holdup::model::{Controller, Observer, Process, Seconds, sampled_law};
/// let level = Process::integrating(0.0506, Seconds(6.0))?;
/// let p = Controller::proportional(1.5)?.with_observer(Observer::new(0.7)?);
/// let law = sampled_law::<f32>(&level, &p, Seconds(0.5))?;
/// assert_eq!(law.observer.map(|observer| observer.segments_needed()), Some(15));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`NoSampledLaw`] for an output filter, for a compensator other than the modified Smith predictor, for an observer
/// whose model would have a lag or two integrators, and for settings that are out of range in `T`.
pub fn sampled_law<T: Scalar>(
    process: &Process,
    controller: &Controller,
    sample_period: Seconds,
) -> Result<Law<T>, NoSampledLaw> {
    let t = T::from_f64;
    let h = t(sample_period.0);
    let refused = |name, reason| Err(NoSampledLaw::Term { name, reason });
    if let Some(compensator) = controller.compensator() {
        let CompensatorLaw::ModifiedSmith { main_gain, disturbance_gain, lead } = compensator.law() else {
            let reason = "has no sampled law: of the compensators only SP+DOB has one";
            return refused(compensator.structure(), reason);
        };
        let (gain, dead_time) = (compensator.model_gain(), compensator.model_dead_time());
        let mut observer = Observer::new(t(disturbance_gain), t(gain), t(dead_time), h)?.predicting();
        if let Some(lead) = lead {
            observer = observer.with_lead(t(lead.derivative_time), t(lead.filter_time))?;
        }
        return Ok(Law { pid: Pid::proportional(t(main_gain))?, observer: Some(observer) });
    }
    if controller.output_filter().is_some() {
        return refused("output_filter", "has no sampled law: a filter of the derivative has one");
    }
    let mut pid = Pid::proportional(t(controller.proportional_gain()))?
        .with_setpoint_weights(t(controller.setpoint_weight()), t(controller.derivative_setpoint_weight()))?;
    if let Some(integral_time) = controller.integral_time() {
        pid = pid.with_integral(t(integral_time))?;
    }
    if let Some(derivative_time) = controller.derivative_time() {
        let filter_time = controller.derivative_filter().map(|filter| t(filter.time()));
        pid = pid.with_derivative(t(derivative_time), filter_time)?;
    }
    let Some(observer) = controller.observer() else { return Ok(Law { pid, observer: None }) };
    if !process.is_plain() {
        let reason =
            "has no sampled law on this process: the observer's model is one integrator with dead time";
        return refused("observer_gain", reason);
    }
    let model_gain = t(observer.model_gain().unwrap_or(process.process_gain()));
    let dead_time = t(observer.model_dead_time().unwrap_or(process.dead_time()));
    Ok(Law { pid, observer: Some(Observer::new(t(observer.gain()), model_gain, dead_time, h)?) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::notation::{read_controller, read_process};
    use crate::model::{Compensator, Lead};

    fn law(process: &str, controller: &str) -> Result<Law<f64>, NoSampledLaw> {
        let process = read_process(process).unwrap();
        sampled_law(&process, &read_controller(controller).unwrap(), Seconds(0.5))
    }

    #[test]
    fn every_setting_reaches_the_law() {
        let law = law("K=-0.05,d=6", "Kc=-2,Ti=15,Td=3,N=4,Ko=-1,Km=-0.04,dm=7,b=0.5,c=0").unwrap();
        let (pid, observer) = (law.pid, law.observer.unwrap());
        assert_eq!((pid.proportional_gain(), pid.integral_time()), (-2.0, Some(15.0)));
        assert_eq!((pid.derivative_time(), pid.filter_time()), (Some(3.0), Some(0.25)));
        assert_eq!((pid.setpoint_weight(), pid.derivative_setpoint_weight()), (0.5, 0.0));
        assert_eq!((observer.observer_gain(), observer.model_gain()), (-1.0, -0.04));
        assert_eq!((observer.dead_time(), observer.sample_period()), (7.0, 0.5));
    }

    #[test]
    fn a_modified_smith_predictor_is_p_action_on_the_prediction() {
        let lead = Some(Lead { derivative_time: 2.0, filter_time: 0.2 });
        let smith = CompensatorLaw::ModifiedSmith { main_gain: 0.2, disturbance_gain: 0.1, lead };
        let controller = Controller::from(Compensator::new(smith, 1.0, Seconds(5.0)).unwrap());
        let process = read_process("K=1.1,d=5,T=1").unwrap();
        let law = sampled_law::<f64>(&process, &controller, Seconds(0.5)).unwrap();
        let observer = law.observer.unwrap();
        assert_eq!(law.pid.proportional_gain(), 0.2);
        assert!(observer.predicts());
        assert_eq!((observer.observer_gain(), observer.lead()), (0.1, Some((2.0, 0.2))));
        assert_eq!((observer.model_gain(), observer.dead_time()), (1.0, 5.0));
    }

    #[test]
    fn what_has_no_sampled_law_is_named() {
        for (process, controller, named) in [
            ("K=1,d=6", "Kc=1,a1=1", "output_filter"),
            ("K=1,d=6,T=1", "Kc=1,Ko=1", "observer_gain"),
            ("K=1,d=6,integrators=2", "Kc=1,Td=1,Ko=1", "observer_gain"),
            ("K=1,d=6", "Kc=1,Ko=-1", "observer_gain = -1"),
        ] {
            let error = law(process, controller).unwrap_err().to_string();
            assert!(error.starts_with(named), "{error}");
        }
        let huba = CompensatorLaw::InverseModel { main_gain: 0.4, filter_time: 2.0 };
        let controller = Controller::from(Compensator::new(huba, 1.0, Seconds(2.0)).unwrap());
        let process = read_process("K=1,d=2").unwrap();
        let error = sampled_law::<f32>(&process, &controller, Seconds(0.5)).unwrap_err().to_string();
        assert!(error.starts_with("P+inverse-DOB: has no sampled law"), "{error}");
        // Below the smallest f32.
        let small = read_controller("Kc=1e-60").unwrap();
        let error = sampled_law::<f32>(&process, &small, Seconds(0.5)).unwrap_err().to_string();
        assert!(error.starts_with("proportional_gain = 0: must be finite and not 0"), "{error}");
    }
}
