//! What surrounds the law in the plant: time, actuator, measurement.

use holdup_control::{Limits, Observer, Pid, Scalar, SettingError, Settings, Watch, segments_needed};

use super::ExportError;
use crate::model::{Controller, Process, Seconds, sampled_law};

/// The precision that the target computes in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Float {
    /// 32 bits: `f32`, `float`, `REAL`.
    Single,
    /// 64 bits: `f64`, `double`, `LREAL`.
    #[default]
    Double,
}

/// What surrounds the law in the plant: time, actuator, measurement.
///
/// What may be absent is `None`: no limit, no safe output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Installation {
    /// Nominal sample period [s], above 0 and at most the dead time. The law runs on the one measured.
    pub sample_period: Seconds,
    /// The precision that the target computes in.
    pub float: Float,
    /// Low limit of the manipulated variable [output unit].
    pub output_low: Option<f64>,
    /// High limit of the manipulated variable [output unit].
    pub output_high: Option<f64>,
    /// Rate limit of the manipulated variable [output unit/s], up and down.
    pub rate_limit: Option<f64>,
    /// Tracking time of the anti-windup [s]; absent, the integral time.
    pub tracking_time: Option<Seconds>,
    /// Bias of the manipulated variable [output unit].
    pub bias: f64,
    /// Time in which a bias moved by a transfer returns to its set value [s]; absent, it stays.
    pub bleed_time: Option<Seconds>,
    /// Range of the measurement, low and high [input unit]: one outside it is none.
    pub measurement_range: Option<(f64, f64)>,
    /// Age at which a measurement is stale [s].
    pub stale_time: Option<Seconds>,
    /// Failure time [s] and the safe output [output unit] that is taken after it.
    pub failure: Option<(Seconds, f64)>,
    /// Segments of the delay line; absent, those that are needed and a quarter more.
    pub segments: Option<usize>,
}

impl Installation {
    /// The longest delay line: 2 MiB of `f64`, more than any controller that would run this has to spare.
    pub const MOST_SEGMENTS: usize = 131_072;

    /// Sampled about so often, in double precision, no limits, no watch over the measurement.
    #[must_use]
    pub fn sampled(sample_period: Seconds) -> Self {
        Self {
            sample_period,
            float: Float::Double,
            output_low: None,
            output_high: None,
            rate_limit: None,
            tracking_time: None,
            bias: 0.0,
            bleed_time: None,
            measurement_range: None,
            stale_time: None,
            failure: None,
            segments: None,
        }
    }

    /// The settings of the controller in this installation, rounded to the precision of the target.
    pub(super) fn settings(
        &self,
        process: &Process,
        controller: &Controller,
    ) -> Result<Settings<f64>, ExportError> {
        let Seconds(h) = self.sample_period;
        if !(h.is_finite() && h > 0.0 && h <= process.dead_time()) {
            let allowed = format!("above 0 and at most the dead time of {} s", process.dead_time());
            return Err(ExportError::out_of_range("sample_period", h, allowed));
        }
        let settings = match self.float {
            // What single precision cannot hold is found while it is built in it.
            Float::Single => converted(&self.settings_in::<f32>(process, controller)?)?,
            Float::Double => self.settings_in::<f64>(process, controller)?,
        };
        if let Some(observer) = settings.law().observer
            && observer.sample_period() > observer.dead_time()
        {
            let allowed = format!("at most the model's dead time of {} s", observer.dead_time());
            return Err(ExportError::out_of_range("sample_period", h, allowed));
        }
        Ok(settings)
    }

    fn settings_in<T: Scalar>(
        &self,
        process: &Process,
        controller: &Controller,
    ) -> Result<Settings<T>, ExportError> {
        let t = T::from_f64;
        let law = sampled_law::<T>(process, controller, self.sample_period)?;
        let mut pid = law.pid.with_bias(t(self.bias), self.bleed_time.map(|Seconds(time)| t(time)))?;
        if let Some(Seconds(tracking_time)) = self.tracking_time {
            pid = pid.with_tracking_time(t(tracking_time))?;
        }
        let mut limits = Limits::new(self.output_low.map(t), self.output_high.map(t))?;
        if let Some(rate) = self.rate_limit {
            limits = limits.with_rate(t(rate))?;
        }
        let mut watch = Watch::none();
        if let Some((low, high)) = self.measurement_range {
            watch = watch.with_range(t(low), t(high))?;
        }
        if let Some(Seconds(stale_time)) = self.stale_time {
            watch = watch.with_stale_time(t(stale_time))?;
        }
        if let Some((Seconds(failure_time), safe_output)) = self.failure {
            watch = watch.with_failure(t(failure_time), t(safe_output))?;
        }
        let settings = Settings::new(pid).with_limits(limits)?.with_watch(watch)?;
        Ok(match law.observer {
            Some(observer) => settings.with_observer(observer)?,
            None => settings,
        })
    }

    /// Segments that the delay line needs, and those that it gets.
    pub(super) fn segments(&self, settings: &Settings<f64>) -> Result<(usize, usize), ExportError> {
        let Some(observer) = settings.law().observer else {
            let allowed = "absent: only an observer has a delay line";
            let refused = |segments: usize| Err(ExportError::out_of_range("segments", segments, allowed));
            return self.segments.map_or(Ok((0, 0)), refused);
        };
        let needed = match self.float {
            Float::Single => {
                segments_needed(f32::from_f64(observer.dead_time()), f32::from_f64(observer.sample_period()))
            }
            Float::Double => observer.segments_needed(),
        };
        if needed > Self::MOST_SEGMENTS {
            let allowed = format!(
                "longer: the delay line would need {needed} segments, and at most {} are exported",
                Self::MOST_SEGMENTS
            );
            return Err(ExportError::out_of_range("sample_period", observer.sample_period(), allowed));
        }
        let segments = self.segments.unwrap_or((needed + needed.div_ceil(4)).min(Self::MOST_SEGMENTS));
        if segments < needed || segments > Self::MOST_SEGMENTS {
            let allowed = format!(
                "{needed} to {}: a dead time of {} s at {} s needs {needed}",
                Self::MOST_SEGMENTS,
                observer.dead_time(),
                observer.sample_period()
            );
            return Err(ExportError::out_of_range("segments", segments, allowed));
        }
        Ok((needed, segments))
    }
}

/// The same settings in another precision, every number rounded to it.
pub(super) fn converted<A: Scalar, B: Scalar>(settings: &Settings<A>) -> Result<Settings<B>, SettingError> {
    let (law, limits, watch) = (settings.law(), settings.limits(), settings.watch());
    let to = |value: A| B::from_f64(value.to_f64());
    let mut pid = Pid::proportional(to(law.pid.proportional_gain()))?
        .with_action(law.pid.action())
        .with_setpoint_weights(to(law.pid.setpoint_weight()), to(law.pid.derivative_setpoint_weight()))?
        .with_bias(to(law.pid.bias()), law.pid.bleed_time().map(to))?;
    if let Some(derivative_time) = law.pid.derivative_time() {
        pid = pid.with_derivative(to(derivative_time), law.pid.filter_time().map(to))?;
    }
    if let Some(tracking_time) = law.pid.tracking_time() {
        pid = pid.with_tracking_time(to(tracking_time))?;
    }
    if let Some(integral_time) = law.pid.integral_time() {
        pid = pid.with_integral(to(integral_time))?;
    }
    let mut new_limits = Limits::new(limits.low().map(to), limits.high().map(to))?;
    if let Some(rate) = limits.rate() {
        new_limits = new_limits.with_rate(to(rate))?;
    }
    let mut new_watch = Watch::none();
    if let Some((low, high)) = watch.range() {
        new_watch = new_watch.with_range(to(low), to(high))?;
    }
    if let Some(stale_time) = watch.stale_time() {
        new_watch = new_watch.with_stale_time(to(stale_time))?;
    }
    if let (Some(failure_time), Some(safe_output)) = (watch.failure_time(), watch.safe_output()) {
        new_watch = new_watch.with_failure(to(failure_time), to(safe_output))?;
    }
    let new = Settings::new(pid).with_limits(new_limits)?.with_watch(new_watch)?;
    let Some(observer) = law.observer else { return Ok(new) };
    let mut new_observer = Observer::new(
        to(observer.observer_gain()),
        to(observer.model_gain()),
        to(observer.dead_time()),
        to(observer.sample_period()),
    )?;
    if let Some((derivative_time, filter_time)) = observer.lead() {
        new_observer = new_observer.with_lead(to(derivative_time), to(filter_time))?;
    }
    new.with_observer(if observer.predicts() { new_observer.predicting() } else { new_observer })
}
