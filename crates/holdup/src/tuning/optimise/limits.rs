//! Limits that a loop must keep.

use std::fmt;

use super::gain::FAR_OUTSIDE;
use super::objective::Transients;
use crate::analysis::frequency::Margins;
use crate::analysis::infinite_horizon::Input;
use crate::analysis::noise::Noise;
use crate::model::Controller;

/// What is limited.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// Sensitivity peak M_s \[–\], at most.
    SensitivityPeak,
    /// Complementary sensitivity peak M_t \[–\], at most.
    ComplementarySensitivityPeak,
    /// Gain margin \[–\], at least.
    GainMargin,
    /// Phase margin \[rad\], at least.
    PhaseMargin,
    /// Delay margin \[s\], at least.
    DelayMargin,
    /// Gain from measurement to controller output at high frequency \[input/output unit\], at most.
    NoiseGain,
    /// IAE after a unit load step \[output unit · s\], at most.
    LoadIae,
    /// IAE after a unit setpoint step \[output unit · s\], at most.
    SetpointIae,
    /// Last time after a unit setpoint step at which the error is more than 2 % of it \[s\], at most.
    ///
    /// It jumps where a swing of the error just reaches 2 %. A load step has no band to settle in.
    SetpointSettlingTime,
    /// Variance of the controller output as a multiple of that of this noise of the measurement \[(input/output unit)²\], at
    /// most.
    VarianceGain(Noise),
}

impl Quantity {
    /// Its name in the JSON and, with hyphens, on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::SensitivityPeak => "sensitivity_peak",
            Self::ComplementarySensitivityPeak => "complementary_sensitivity_peak",
            Self::GainMargin => "gain_margin",
            Self::PhaseMargin => "phase_margin_deg",
            Self::DelayMargin => "delay_margin_s",
            Self::NoiseGain => "noise_gain",
            Self::LoadIae => "load_iae",
            Self::SetpointIae => "setpoint_iae",
            Self::SetpointSettlingTime => "setpoint_settling_time_s",
            Self::VarianceGain(_) => "variance_gain",
        }
    }

    /// Whether the limit is a greatest value; else it is a least one.
    #[must_use]
    pub fn is_greatest(self) -> bool {
        !matches!(self, Self::GainMargin | Self::PhaseMargin | Self::DelayMargin)
    }

    /// Whether it is infinite where the derivative is not filtered.
    #[must_use]
    pub fn needs_filter(self) -> bool {
        matches!(self, Self::NoiseGain | Self::VarianceGain(Noise::Held { .. }))
    }

    /// Whether it is about a setpoint step.
    #[must_use]
    pub fn is_of_setpoint(self) -> bool {
        matches!(self, Self::SetpointIae | Self::SetpointSettlingTime)
    }

    /// A value for reading: degrees for an angle.
    #[must_use]
    pub fn shown(self, value: f64) -> f64 {
        if self == Self::PhaseMargin { value.to_degrees() } else { value }
    }

    /// The value of a stable loop that costs no simulation; infinite where there is none to lose.
    pub(super) fn of(self, controller: &Controller, achieved: &Margins) -> Option<f64> {
        let unlimited = |value: Option<f64>| Some(value.unwrap_or(f64::INFINITY));
        match self {
            Self::SensitivityPeak => unlimited(achieved.sensitivity_peak),
            Self::ComplementarySensitivityPeak => unlimited(achieved.complementary_sensitivity_peak),
            Self::GainMargin => unlimited(achieved.gain_margin),
            // A negative phase margin of a stable loop is lost by less delay: its modulus counts.
            Self::PhaseMargin => unlimited(achieved.phase_margin.map(|angle| angle.0.abs())),
            Self::DelayMargin => unlimited(achieved.delay_margin.map(|time| time.0)),
            Self::NoiseGain => unlimited(controller.noise_gain().map(f64::abs)),
            Self::LoadIae | Self::SetpointIae | Self::SetpointSettlingTime | Self::VarianceGain(_) => None,
        }
    }

    /// Whether its value comes from the responses.
    pub(super) fn is_of_responses(self) -> bool {
        matches!(self, Self::LoadIae | Self::SetpointIae | Self::SetpointSettlingTime | Self::VarianceGain(_))
    }

    /// The value of a stable loop that its responses have; `None` where it is infinite.
    pub(super) fn of_transients(self, transients: &Transients<'_>) -> Option<f64> {
        match self {
            Self::LoadIae => transients.after(Input::Load)?.iae,
            Self::SetpointIae => transients.after(Input::Setpoint)?.iae,
            Self::SetpointSettlingTime => transients.after(Input::Setpoint)?.settling_time,
            Self::VarianceGain(noise) => transients.variance(noise),
            _ => Some(0.0),
        }
    }
}

/// One limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// What is limited.
    pub quantity: Quantity,
    /// The greatest or least value that is allowed, in its unit.
    pub value: f64,
}

impl Limit {
    /// Whether a value keeps the limit.
    #[must_use]
    pub fn allows(self, value: f64) -> bool {
        if self.quantity.is_greatest() { value <= self.value } else { value >= self.value }
    }
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.quantity.is_greatest() { "<=" } else { ">=" };
        write!(f, "{} {sign} {}", self.quantity.name(), self.quantity.shown(self.value))
    }
}

/// All limits of a design.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Limits {
    list: Vec<Limit>,
}

impl Limits {
    /// These limits and one more; a second limit of a quantity replaces the first.
    #[must_use]
    pub fn with(mut self, quantity: Quantity, value: f64) -> Self {
        self.list.retain(|limit| limit.quantity != quantity);
        self.list.push(Limit { quantity, value });
        self
    }

    /// These limits without that of a quantity.
    #[must_use]
    pub fn without(mut self, quantity: Quantity) -> Self {
        self.list.retain(|limit| limit.quantity != quantity);
        self
    }

    /// The limits, in the order in which they were given.
    #[must_use]
    pub fn list(&self) -> &[Limit] {
        &self.list
    }

    /// The limit of a quantity.
    #[must_use]
    pub fn of(&self, quantity: Quantity) -> Option<f64> {
        self.list.iter().find(|limit| limit.quantity == quantity).map(|limit| limit.value)
    }

    /// By how much a loop keeps every limit that costs no simulation, relative and at most 1; −∞ where it is not stable.
    pub(super) fn slack(&self, controller: &Controller, achieved: &Margins) -> f64 {
        if !achieved.stable {
            return f64::NEG_INFINITY;
        }
        let of = |limit: &Limit| {
            let value = limit.quantity.of(controller, achieved)?;
            Some(if limit.quantity.is_greatest() {
                limit.value / value - 1.0
            } else {
                value / limit.value - 1.0
            })
        };
        self.list.iter().filter_map(of).fold(1.0, f64::min)
    }

    /// By how much a loop keeps every limit on its responses, relative and at most 1; `None` where one is infinite.
    pub(super) fn spare(&self, transients: &Transients<'_>) -> Option<f64> {
        let mut spare = 1.0_f64;
        // Far outside the area says enough; slow responses, which take longest to follow, are told by it.
        if let (Some(limit), Some(area)) = (self.of(Quantity::LoadIae), transients.load_area())
            && area > limit * (1.0 + FAR_OUTSIDE)
        {
            return Some(1.0 - area / limit);
        }
        for limit in &self.list {
            spare = spare.min(1.0 - limit.quantity.of_transients(transients)? / limit.value);
        }
        Some(spare)
    }
}
