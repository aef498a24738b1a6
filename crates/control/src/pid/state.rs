//! Running state of the PID terms, and the terms.

use super::Pid;
use crate::{Scalar, Sum};

/// What was last measured, and the setpoint then.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample<T> {
    /// Setpoint [input unit].
    pub setpoint: T,
    /// Controlled variable [input unit]; the predicted one in a law that predicts.
    pub controlled_variable: T,
}

/// Running state of the PID terms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PidState<T> {
    /// The newest good sample; none before the first.
    pub sample: Option<Sample<T>>,
    /// Filtered slope of c r − y [input unit/s].
    pub slope: T,
    /// Integral term [output unit].
    pub integral: Sum<T>,
    /// What a transfer added to the set value of the bias and has not yet bled away [output unit].
    pub bias_offset: T,
    /// How fast it bleeds [output unit/s].
    pub bleed_rate: T,
}

impl<T: Scalar> PidState<T> {
    /// A new sample came, `elapsed` [s] after the one before: the derivative's slope moves.
    pub(crate) fn measure(&mut self, pid: &Pid<T>, new: Sample<T>, elapsed: T) {
        if let Some(last) = self.sample {
            let tf = pid.filter_time().unwrap_or(T::ZERO);
            let c = pid.derivative_setpoint_weight();
            let rise =
                c * (new.setpoint - last.setpoint) - (new.controlled_variable - last.controlled_variable);
            self.slope = (tf * self.slope + rise) / (tf + elapsed);
        }
        self.sample = Some(new);
    }

    /// The setpoint moved while the law was not in charge: that gives no derivative action later.
    pub(crate) fn forget_setpoint(&mut self, setpoint: T) {
        if let Some(sample) = &mut self.sample {
            sample.setpoint = setpoint;
        }
    }

    /// The integral moves on by `h` [s]; `shortfall` [output unit] is the output applied in that time less the
    /// one wanted.
    pub(crate) fn integrate(&mut self, pid: &Pid<T>, setpoint: T, shortfall: T, h: T) {
        let kc = pid.signed_gain();
        if let (Some(sample), Some(ti), Some(tt)) = (self.sample, pid.integral_time(), pid.tracking_time()) {
            let error = setpoint - sample.controlled_variable;
            self.integral.add(kc * h / ti * error + shortfall * h / (tt + h));
        }
    }

    /// The bias goes back to its set value for `h` [s].
    pub(crate) fn bleed(&mut self, h: T) {
        let step = self.bleed_rate * h;
        if (step > T::ZERO && step < self.bias_offset) || (step < T::ZERO && step > self.bias_offset) {
            self.bias_offset = self.bias_offset - step;
        } else if step != T::ZERO {
            self.bias_offset = T::ZERO;
            self.bleed_rate = T::ZERO;
        }
    }

    /// Proportional and derivative term together [output unit].
    pub(crate) fn proportional_derivative(&self, pid: &Pid<T>, setpoint: T) -> T {
        let Some(sample) = self.sample else { return T::ZERO };
        let kc = pid.signed_gain();
        let b = pid.setpoint_weight();
        let td = pid.derivative_time().unwrap_or(T::ZERO);
        kc * (b * setpoint - sample.controlled_variable) + kc * td * self.slope
    }

    /// Takes up `offset` [output unit] in the bias, to bleed from now on.
    pub(crate) fn set_bias_offset(&mut self, pid: &Pid<T>, offset: T) {
        self.bias_offset = offset;
        self.bleed_rate = pid.bleed_time().map_or(T::ZERO, |bleed_time| offset / bleed_time);
    }
}
