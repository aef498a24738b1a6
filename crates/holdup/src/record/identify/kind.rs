//! The models of a process that a record is compared with.

use std::fmt;

use serde::Serialize;

use super::input::Shape;

/// What kind of process.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// K·e^(−ds)/s.
    Integrating,
    /// K·e^(−ds)/(s(Ts + 1)).
    IntegratingWithLag,
    /// K·e^(−ds)/s².
    DoubleIntegrating,
    /// K·T·e^(−ds)/(Ts + 1): self-regulating; K is the slope at the start, K·T the gain at rest.
    FirstOrder,
}

impl Kind {
    /// All kinds, the simplest first.
    pub const ALL: [Self; 4] =
        [Self::Integrating, Self::IntegratingWithLag, Self::DoubleIntegrating, Self::FirstOrder];

    /// Whether the process has a lag to be found.
    #[must_use]
    pub fn has_lag(self) -> bool {
        matches!(self, Self::IntegratingWithLag | Self::FirstOrder)
    }

    /// The word that reports and JSON use.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Integrating => "integrating",
            Self::IntegratingWithLag => "integrating-with-lag",
            Self::DoubleIntegrating => "double-integrating",
            Self::FirstOrder => "first-order",
        }
    }

    pub(crate) fn shape(self, lag: f64) -> Shape {
        match self {
            Self::Integrating => Shape::Integral,
            Self::IntegratingWithLag => Shape::LaggedIntegral(lag),
            Self::DoubleIntegrating => Shape::DoubleIntegral,
            Self::FirstOrder => Shape::Lag(lag),
        }
    }

    /// The columns that belong to the initial state and to the load, over time from 0 to 1: the powers up to the number
    /// of integrators (one more for a drifting load), and the lag's own decay.
    pub(crate) fn own_columns(self, load: Load, times: &[f64], lag: f64) -> Vec<Vec<f64>> {
        let start = times[0];
        let span = times[times.len() - 1] - start;
        let integrators = match self {
            Self::FirstOrder => 0,
            Self::Integrating | Self::IntegratingWithLag => 1,
            Self::DoubleIntegrating => 2,
        };
        let powers = integrators + i32::from(load == Load::Drifting);
        let mut columns: Vec<Vec<f64>> = (0..=powers)
            .map(|power| times.iter().map(|time| ((time - start) / span).powi(power)).collect())
            .collect();
        if self.has_lag() {
            columns.push(times.iter().map(|time| (-(time - start) / lag).exp()).collect());
        }
        columns
    }
}

impl Kind {
    /// What a load that steps up by one makes of the controlled variable so long after, before the gain, and the rate of it.
    pub(crate) fn load_response(self, lag: f64, after: f64) -> [f64; 2] {
        if after <= 0.0 {
            return [0.0, 0.0];
        }
        let risen = -(-after / lag).exp_m1();
        match self {
            Self::Integrating => [after, 1.0],
            Self::IntegratingWithLag => [after - lag * risen, risen],
            Self::DoubleIntegrating => [after * after / 2.0, after],
            Self::FirstOrder => [risen, (1.0 - risen) / lag],
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Integrating => "integrating",
            Self::IntegratingWithLag => "integrating with lag",
            Self::DoubleIntegrating => "double integrating",
            Self::FirstOrder => "first order, self-regulating",
        })
    }
}

/// What the load is taken for beside its random part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Load {
    /// Constant and unknown.
    #[default]
    Constant,
    /// A straight line in time, unknown.
    Drifting,
}

/// How the manipulated variable goes from one sample to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Hold {
    /// It holds its value until the next sample, as that of a digital controller does.
    #[default]
    Constant,
    /// It goes straight to the next value, as a slow actuator, or a historian that draws lines, has it.
    Linear,
}
