//! The controller as it runs in the plant: from the settings of a design to those of `holdup-control`.

use holdup_control::{Observer, Pid, Settings};

use super::compensator::CompensatorLaw;
use super::controller::Controller;
use super::error::{ModelError, positive};
use super::process::Process;
use super::quantity::Seconds;

/// The settings with which `holdup-control` runs this controller, one sample every `sample_period` [s]; without
/// limits and watch, which are the equipment's.
///
/// The gains keep their signs, so the action is always the reverse one. The observer's model is the one given with the controller, else
/// that of `process`.
///
/// ```
/// use holdup::model::{Process, Seconds, notation::read_controller, sampled_law::sampled_law};
/// let level = Process::integrating(0.0506, Seconds(6.0))?;
/// let settings = sampled_law(&level, &read_controller("Kc=1.5321,Td=1.0343,N=100,Ko=1.5321")?, Seconds(0.5))?;
/// assert_eq!(settings.law().pid.filter_time(), Some(0.01));
/// assert_eq!(settings.segments_needed(), 15); // of the delay line
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ModelError`] if the sample period is not positive and finite, or if there is no sampled law for this: an
/// output filter, an observer whose model has a lag or two integrators, a compensator other than the modified Smith
/// predictor, an observer whose gain and model differ in sign.
pub fn sampled_law(
    process: &Process,
    controller: &Controller,
    sample_period: Seconds,
) -> Result<Settings<f64>, ModelError> {
    let h = positive("sample_period", sample_period.0)?;
    let conflict = |name, reason| Err(ModelError::Conflict { name, reason });
    let refused = |name, reason| move |_| ModelError::Conflict { name, reason };
    let out_of_range = refused("controller", "a setting is out of the range of the sampled law");
    let settled = |gain: f64| Pid::proportional(gain).map_err(out_of_range);
    if let Some(compensator) = controller.compensator() {
        let CompensatorLaw::ModifiedSmith { main_gain, disturbance_gain, lead } = compensator.law() else {
            return conflict(
                "controller",
                "has no sampled law: of the dead-time compensators only the modified Smith predictor has one",
            );
        };
        let (gain, dead_time) = (compensator.model_gain(), compensator.model_dead_time());
        let signs = refused("disturbance_gain", "must have the sign of model_gain");
        let mut observer = Observer::new(disturbance_gain, gain, dead_time, h).map_err(signs)?;
        if let Some(lead) = lead {
            observer = observer.with_lead(lead.derivative_time, lead.filter_time).map_err(out_of_range)?;
        }
        let signs = refused("main_gain", "must have the sign of model_gain");
        return Settings::new(settled(main_gain)?).with_observer(observer.predicting()).map_err(signs);
    }
    if controller.output_filter().is_some() {
        return conflict(
            "output_filter",
            "has no sampled law: filter the derivative instead, or simulate without a sample period",
        );
    }
    let mut pid = settled(controller.proportional_gain())?
        .with_setpoint_weights(controller.setpoint_weight(), controller.derivative_setpoint_weight())
        .map_err(out_of_range)?;
    if let Some(ti) = controller.integral_time() {
        pid = pid.with_integral(ti).map_err(out_of_range)?;
    }
    if let Some(td) = controller.derivative_time() {
        let tf = controller.derivative_filter().map(super::controller::DerivativeFilter::time);
        pid = pid.with_derivative(td, tf).map_err(out_of_range)?;
    }
    let settings = Settings::new(pid);
    let Some(observer) = controller.observer() else { return Ok(settings) };
    if !process.is_plain() {
        return conflict(
            "observer_gain",
            "has no sampled law on this process: the sampled observer's model is one integrator without lag",
        );
    }
    let gain = observer.model_gain().unwrap_or(process.process_gain());
    let dead_time = observer.model_dead_time().unwrap_or(process.dead_time());
    let signs = refused("observer_gain", "must have the sign of the gain of its model");
    let observer = Observer::new(observer.gain(), gain, dead_time, h).map_err(signs)?;
    let signs = refused("proportional_gain", "must have the sign of the gain of the observer's model");
    settings.with_observer(observer).map_err(signs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::notation::read_controller;
    use crate::model::{Compensator, Lead};

    fn refusal(process: &Process, controller: &Controller) -> String {
        sampled_law(process, controller, Seconds(0.5)).unwrap_err().to_string()
    }

    #[test]
    fn what_has_no_sampled_law_is_refused_by_name() {
        let level = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let lagging = level.with_lag(Seconds(2.0)).unwrap();
        let observer = read_controller("Kc=0.4,Ko=0.3").unwrap();
        assert!(refusal(&level, &read_controller("Kc=0.4,a1=1").unwrap()).starts_with("output_filter: "));
        assert!(refusal(&lagging, &observer).contains("one integrator without lag"));
        assert!(refusal(&level, &read_controller("Kc=0.4,Ko=-0.3").unwrap()).starts_with("observer_gain: "));
        assert!(sampled_law(&level, &observer, Seconds(0.0)).unwrap_err().to_string().contains("sample_period"));
    }

    #[test]
    fn the_modified_smith_predictor_keeps_its_lead_and_its_model() {
        let lead = Some(Lead { derivative_time: 0.4, filter_time: 0.2 });
        let law = CompensatorLaw::ModifiedSmith { main_gain: 1.0, disturbance_gain: 0.7, lead };
        let controller = Controller::from(Compensator::new(law, 1.5, Seconds(2.0)).unwrap());
        let level = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let settings = sampled_law(&level, &controller, Seconds(0.5)).unwrap();
        let observer = settings.law().observer.unwrap();
        assert!(observer.predicts());
        assert_eq!((observer.model_gain(), observer.dead_time()), (1.5, 2.0));
        assert_eq!(observer.lead(), Some((0.4, 0.2)));
    }
}
