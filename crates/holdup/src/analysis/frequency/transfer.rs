//! The loop transfer function at any frequency, and points of its curve to draw.

use num_complex::Complex;

use super::characteristic::Characteristic;
use super::error::FrequencyError;
use crate::model::{ClosedLoop, Controller, ModelError, Process, Seconds};

/// The loop transfer function L, broken at the process input, evaluated without approximation.
///
/// ```
/// use holdup::analysis::frequency::LoopTransfer;
/// use holdup::model::{ClosedLoop, Controller, Process, Seconds};
/// let process = Process::integrating(1.0, Seconds(1.0))?;
/// let l = LoopTransfer::new(&ClosedLoop::new(&process, &Controller::proportional(0.5)?))?;
/// let at = l.at(std::f64::consts::FRAC_PI_2); // 0.5·e^(−jω)/(jω) = −0.5/(π/2)
/// assert!((at.re + 1.0 / std::f64::consts::PI).abs() < 1e-15 && at.im.abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct LoopTransfer {
    characteristic: Characteristic,
}

/// One point of a frequency response.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrequencyPoint {
    /// Frequency [rad/s].
    pub omega: f64,
    /// Loop transfer function there [–].
    pub value: Complex<f64>,
}

impl LoopTransfer {
    /// The loop transfer function of a closed loop.
    ///
    /// # Errors
    /// [`FrequencyError`] if the numbers of the loop are out of the reach of double precision.
    pub fn new(closed_loop: &ClosedLoop) -> Result<Self, FrequencyError> {
        Ok(Self { characteristic: Characteristic::new(closed_loop)? })
    }

    /// `L(jω)` [–] at ω [rad/s]; infinite or not a number at ω = 0, where the integrator has its pole.
    #[must_use]
    pub fn at(&self, omega: f64) -> Complex<f64> {
        let omega = omega * self.characteristic.dead_time;
        self.characteristic.numerator.on_axis(omega)[0] / self.characteristic.denominator.on_axis(omega)[0]
    }

    /// Sensitivity `S(jω) = 1/(1 + L)` [–] at ω [rad/s]; 0 at ω = 0.
    #[must_use]
    pub fn sensitivity(&self, omega: f64) -> Complex<f64> {
        let omega = omega * self.characteristic.dead_time;
        self.characteristic.denominator.on_axis(omega)[0] / self.characteristic.closed.on_axis(omega)[0]
    }

    /// Complementary sensitivity `T(jω) = L/(1 + L)` [–] at ω [rad/s]; 1 at ω = 0.
    #[must_use]
    pub fn complementary_sensitivity(&self, omega: f64) -> Complex<f64> {
        let omega = omega * self.characteristic.dead_time;
        self.characteristic.numerator.on_axis(omega)[0] / self.characteristic.closed.on_axis(omega)[0]
    }

    /// Points of the curve L(jω) from `from` to `to` [rad/s], for drawing only: the chord between two of them
    /// leaves the curve by at most about `tolerance`, relative to the distance from the origin where that is
    /// more than 1. At most 20 000 points.
    #[must_use]
    pub fn curve(&self, from: f64, to: f64, tolerance: f64) -> Vec<FrequencyPoint> {
        const MOST: usize = 20_000;
        let mut points = Vec::new();
        if !(from > 0.0 && to > from && to.is_finite() && tolerance > 0.0) {
            return points;
        }
        let point = |omega: f64| FrequencyPoint { omega, value: self.at(omega) };
        points.push(point(from));
        let mut last = points[0];
        let mut stack = vec![(point(to), 0)];
        while let Some((end, depth)) = stack.pop() {
            let middle = point((last.omega * end.omega).sqrt());
            let chord = (last.value + end.value) * 0.5;
            let allowed = tolerance * middle.value.norm().max(1.0);
            // A chord may agree with the curve by chance where the curve turns round in between.
            let turns = (end.omega - last.omega) * self.characteristic.dead_time > 1.0
                && middle.value.norm() > tolerance;
            let coarse = depth < 5 || turns || (middle.value - chord).norm() > allowed;
            if coarse && depth < 24 && points.len() + stack.len() < MOST {
                stack.push((end, depth + 1));
                stack.push((middle, depth + 1));
            } else {
                points.push(end);
                last = end;
            }
        }
        points
    }
}

/// The loop without its observer: the PID law on the process.
#[must_use]
pub fn loop_without_observer(process: &Process, controller: &Controller) -> ClosedLoop {
    ClosedLoop::new(process, &controller.without_observer())
}

/// The observer's own loop: a proportional loop of gain Ko on the observer's model of the process. With a
/// perfect model the sensitivity of the whole is the product of this one's and that of
/// [`loop_without_observer`]. `None` without an observer.
///
/// # Errors
/// [`ModelError`] if the observer's gain or model is outside the range of a controller or process.
pub fn observer_loop(process: &Process, controller: &Controller) -> Result<Option<ClosedLoop>, ModelError> {
    let Some(observer) = controller.observer() else { return Ok(None) };
    let gain = observer.model_gain().unwrap_or(process.process_gain());
    let dead_time = Seconds(observer.model_dead_time().unwrap_or(process.dead_time()));
    let model = match process.integrators() {
        1 => Process::integrating(gain, dead_time)?,
        _ => Process::double_integrating(gain, dead_time)?,
    };
    let model = process.lag().map_or(Ok(model), |lag| model.with_lag(Seconds(lag)))?;
    Ok(Some(ClosedLoop::new(&model, &Controller::proportional(observer.gain())?)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Observer;

    #[test]
    fn sensitivity_of_a_perfect_observer_is_a_product() {
        let process = Process::integrating(0.5, Seconds(2.0)).unwrap();
        let pd = Controller::proportional(0.4).unwrap().with_derivative_time(Seconds(0.5)).unwrap();
        let with = pd.with_observer(Observer::new(0.3).unwrap());
        let whole = LoopTransfer::new(&ClosedLoop::new(&process, &with)).unwrap();
        let law = LoopTransfer::new(&loop_without_observer(&process, &with)).unwrap();
        let observer = LoopTransfer::new(&observer_loop(&process, &with).unwrap().unwrap()).unwrap();
        for omega in [0.01, 0.3, 1.0, 4.0, 30.0] {
            let product = law.sensitivity(omega) * observer.sensitivity(omega);
            // Two ways through a dozen roundings.
            assert!((whole.sensitivity(omega) - product).norm() < 1e-13);
            let sum = whole.sensitivity(omega) + whole.complementary_sensitivity(omega);
            assert!((sum - 1.0).norm() < 1e-13);
        }
    }

    #[test]
    fn curve_stays_near_its_chords_and_ends_where_asked() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let closed = ClosedLoop::new(&process, &Controller::proportional(0.8).unwrap());
        let l = LoopTransfer::new(&closed).unwrap();
        let curve = l.curve(0.05, 50.0, 1e-3);
        assert_eq!((curve[0].omega, curve.last().unwrap().omega), (0.05, 50.0));
        for pair in curve.windows(2) {
            let middle = l.at((pair[0].omega * pair[1].omega).sqrt());
            let chord = (pair[0].value + pair[1].value) * 0.5;
            assert!((middle - chord).norm() <= 1.001e-3 * middle.norm().max(1.0));
        }
        assert!(curve.len() < 2000);
        assert!(l.curve(1.0, f64::INFINITY, 1e-3).is_empty());
    }
}
