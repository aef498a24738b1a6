//! What is to be as small as possible.

use std::cell::OnceCell;

use super::design::{Design, Structure};
use super::filter::Filter;
use super::limits::{Limits, Quantity};
use crate::analysis::bounds::Bounds;
use crate::analysis::frequency::family::Family;
use crate::analysis::frequency::margins;
use crate::analysis::infinite_horizon::{InfiniteHorizon, Input, to_infinity_unproven};
use crate::analysis::noise::{Noise, variance_gain};
use crate::analysis::response::Scenario;
use crate::model::{ClosedLoop, Controller, Process, Seconds};
use crate::tuning::robust::{Boxes, most, proven_size};

/// Times of a loop (dead time and lag) after which a response must be over.
const LONGEST: f64 = 2e4;

/// What is to be as small as possible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Objective {
    /// IAE after a unit load step, over all time \[output unit · s\].
    LoadIae,
    /// IAE after a unit setpoint step, over all time \[output unit · s\].
    SetpointIae,
    /// Weighted mean of load IAE and setpoint IAE, each as a multiple of the least that any controller has \[–\].
    Weighted {
        /// Weight of the load, from 0 to 1; the setpoint has the rest.
        load: f64,
    },
    /// ISE after a unit load step \[output unit² · s\].
    LoadIse,
    /// ISE after a unit setpoint step \[output unit² · s\].
    SetpointIse,
    /// Integral of the squared controller output after a unit setpoint step \[input unit² · s\].
    ControlEnergy,
    /// Total variation of the controller output after a unit load step \[input unit\].
    TotalVariation,
    /// The reciprocal of the size of the largest family of processes that keeps a sensitivity peak \[–\].
    RobustBox {
        /// Shape of the family.
        family: Family,
        /// The sensitivity peak.
        sensitivity_peak: f64,
    },
    /// A limited quantity itself: what is the nearest feasible value?
    Extreme(Quantity),
}

impl Objective {
    /// Its name on the command line and in the JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::LoadIae => "load_iae",
            Self::SetpointIae => "setpoint_iae",
            Self::Weighted { .. } => "weighted_iae",
            Self::LoadIse => "load_ise",
            Self::SetpointIse => "setpoint_ise",
            Self::ControlEnergy => "control_energy",
            Self::TotalVariation => "total_variation",
            Self::RobustBox { .. } => "robust_box",
            Self::Extreme(quantity) => quantity.name(),
        }
    }

    /// The value for a **stable** loop; absent where it is infinite or out of reach.
    ///
    /// ```
    /// use holdup::model::{Controller, Process, Seconds};
    /// use holdup::tuning::optimise::Objective;
    /// let process = Process::integrating(1.0, Seconds(1.0))?;
    /// let simc = Controller::proportional(0.5)?.with_integral_time(Seconds(8.0))?;
    /// assert!((Objective::LoadIae.of(&process, &simc).unwrap() - 16.0).abs() < 1e-7);
    /// assert_eq!(Objective::LoadIae.of(&process, &Controller::proportional(0.5)?), None);
    /// # Ok::<(), holdup::model::ModelError>(())
    /// ```
    #[must_use]
    pub fn of(self, process: &Process, controller: &Controller) -> Option<f64> {
        let design = Design { proving: true, ..Design::new(process, Structure::P, Filter::None, false) };
        self.value(&design, controller, &Transients::new(&design, controller))
    }

    /// Whether it looks at a setpoint step.
    pub(super) fn is_of_setpoint(self) -> bool {
        match self {
            Self::Weighted { load } => load < 1.0,
            Self::Extreme(quantity) => quantity.is_of_setpoint(),
            _ => matches!(self, Self::SetpointIae | Self::SetpointIse | Self::ControlEnergy),
        }
    }

    /// Why this objective has no optimum for this structure under these limits.
    pub(super) fn degenerate(self, design: &Design, limits: &Limits) -> Option<String> {
        let structure = design.structure;
        let of_load = match self {
            Self::Weighted { load } => load > 0.0,
            _ => matches!(self, Self::LoadIae | Self::LoadIse | Self::TotalVariation),
        };
        if (of_load || limits.of(Quantity::LoadIae).is_some()) && !structure.rejects_load() {
            return Some(format!(
                "{} is infinite: a {} controller leaves an error behind after a load step; a structure with integral action or observer is needed",
                if of_load { self.name() } else { "load_iae" },
                structure.name()
            ));
        }
        let fast = [Quantity::LoadIae, Quantity::SetpointIae, Quantity::SetpointSettlingTime];
        let slow_is_best =
            matches!(self, Self::ControlEnergy | Self::TotalVariation | Self::RobustBox { .. });
        if slow_is_best && fast.iter().all(|quantity| limits.of(*quantity).is_none()) {
            return Some(format!(
                "{} is least for no control at all: a limit on load_iae, setpoint_iae or setpoint_settling_time_s is needed beside it",
                self.name()
            ));
        }
        if matches!(self, Self::ControlEnergy) && design.unfiltered() {
            return Some(
                "control_energy of an unfiltered derivative is infinite after a setpoint step: the filter must be free or a ratio that is held".to_owned(),
            );
        }
        if let Some(limit) = limits.list().iter().find(|limit| limit.quantity.needs_filter())
            && design.unfiltered()
        {
            return Some(format!(
                "{} of an unfiltered derivative is infinite: the filter must be free or a ratio that is held",
                limit.quantity.name()
            ));
        }
        None
    }

    /// The value for a stable loop; absent where it is infinite or out of reach.
    pub(super) fn value(
        self,
        design: &Design,
        controller: &Controller,
        transients: &Transients<'_>,
    ) -> Option<f64> {
        let process = &design.process;
        let over = |input: Input| transients.after(input);
        match self {
            Self::LoadIae | Self::Extreme(Quantity::LoadIae) => over(Input::Load)?.iae,
            Self::SetpointIae | Self::Extreme(Quantity::SetpointIae) => over(Input::Setpoint)?.iae,
            Self::Extreme(Quantity::SetpointSettlingTime) => over(Input::Setpoint)?.settling_time,
            Self::Extreme(Quantity::VarianceGain(noise)) => transients.variance(noise),
            Self::LoadIse => over(Input::Load)?.ise,
            Self::SetpointIse => over(Input::Setpoint)?.ise,
            Self::ControlEnergy => over(Input::Setpoint)?.control_energy,
            Self::TotalVariation => over(Input::Load)?.total_variation,
            Self::Weighted { load } => {
                let part = |weight: f64, input: Input| {
                    if weight == 0.0 {
                        return Some(0.0);
                    }
                    Some(weight * over(input)?.iae? / least_iae(process, input)?)
                };
                Some(part(load, Input::Load)? + part(1.0 - load, Input::Setpoint)?)
            }
            Self::RobustBox { family, sensitivity_peak } => {
                let boxes = Boxes::new(process, &family, sensitivity_peak).filter(|_| !design.proving);
                let size = match boxes {
                    Some(boxes) => boxes.touching(controller, most(&family)).ok()?.size,
                    None => proven_size(process, controller, &family, sensitivity_peak)?,
                };
                (size > 0.0).then(|| 1.0 / size)
            }
            Self::Extreme(quantity) => {
                let achieved = margins(&ClosedLoop::new(process, controller)).ok()?;
                let value = quantity.of(controller, &achieved).filter(|value| value.is_finite())?;
                Some(if quantity.is_greatest() { value } else { -value })
            }
        }
    }
}

/// The responses of a loop to unit steps, each followed once, when it is asked for.
pub(super) struct Transients<'a> {
    process: &'a Process,
    controller: &'a Controller,
    longest: f64,
    load: OnceCell<Option<InfiniteHorizon>>,
    setpoint: OnceCell<Option<InfiniteHorizon>>,
}

impl<'a> Transients<'a> {
    /// Variance of the controller output for noise of variance 1; `None` where it is infinite or out of reach.
    pub(super) fn variance(&self, noise: Noise) -> Option<f64> {
        variance_gain(self.process, self.controller, noise)
    }

    pub(super) fn new(design: &'a Design, controller: &'a Controller) -> Self {
        let (load, setpoint) = (OnceCell::new(), OnceCell::new());
        Self { process: &design.process, controller, longest: LONGEST * design.time, load, setpoint }
    }

    /// The same with those out of reach that must be followed for longer than this \[s\].
    pub(super) fn up_to(mut self, longest: f64) -> Self {
        self.longest = self.longest.min(longest);
        self
    }

    /// The area of the error after a unit load step, which no IAE is less than: a sum that costs no simulation. `None` where
    /// the structure is not one of those searched.
    pub(super) fn load_area(&self) -> Option<f64> {
        let controller = self.controller;
        let area = match (controller.integral_time(), controller.observer()) {
            (Some(time), None) => time / controller.proportional_gain(),
            (None, Some(observer))
                if observer.model_gain().is_none() && observer.model_dead_time().is_none() =>
            {
                1.0 / (self.process.process_gain() * controller.proportional_gain() * observer.gain())
            }
            _ => return None,
        };
        (self.process.integrators() == 1).then_some(area.abs())
    }

    /// Integrals over all time, without the proof of the rest: the optimum gets that at the end. `None` where they are out of
    /// reach or the loop swings for so long that they are no candidate.
    pub(super) fn after(&self, input: Input) -> Option<&InfiniteHorizon> {
        let cell = match input {
            Input::Load => &self.load,
            Input::Setpoint => &self.setpoint,
        };
        cell.get_or_init(|| to_infinity_unproven(self.process, self.controller, input, self.longest).ok())
            .as_ref()
    }
}

/// The least IAE that any controller has after a unit step.
pub(super) fn least_iae(process: &Process, input: Input) -> Option<f64> {
    let time = Seconds(10.0 * (process.dead_time() + process.lag().unwrap_or(0.0)));
    let scenario = match input {
        Input::Load => Scenario::unit_load_step(time),
        Input::Setpoint => Scenario::unit_setpoint_step(time),
    };
    Bounds::of(process, &scenario.ok()?).iae
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Observer;

    #[test]
    fn the_area_after_a_load_step_is_the_iae_of_a_response_that_keeps_its_sign_and_less_of_one_that_swings() {
        let process = Process::integrating(2.0, Seconds(1.0)).unwrap();
        let pi = |gain: f64, time: f64| {
            Controller::proportional(gain).unwrap().with_integral_time(Seconds(time)).unwrap()
        };
        let observed = |gain: f64, of_observer: f64| {
            Controller::proportional(gain).unwrap().with_observer(Observer::new(of_observer).unwrap())
        };
        for (controller, swings) in [
            (pi(0.2, 12.0), false),
            (pi(0.3, 4.0), true),
            (observed(0.1, 0.05), false),
            (observed(0.6, 0.5), true),
        ] {
            let design = Design::new(&process, Structure::P, Filter::None, false);
            let transients = Transients::new(&design, &controller);
            let (area, iae) =
                (transients.load_area().unwrap(), transients.after(Input::Load).unwrap().iae.unwrap());
            // The simulation is right to 1e-9.
            assert!(
                if swings { area < 0.999 * iae } else { (area / iae - 1.0).abs() < 1e-8 },
                "{controller:?} {area} {iae}"
            );
        }
    }
}
