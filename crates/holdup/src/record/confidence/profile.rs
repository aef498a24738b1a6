//! Which dead times and gains the record does not exclude: the likelihood profiled over all the rest.

use serde::Serialize;

use super::inflation::{Inflation, Inflations};
use super::quantile;
use crate::record::identify::{Fit, Joint, Problem, Whitened, polish};

/// Dead times at which the profile is first computed, evenly and at the best one.
const TRIED: u32 = 60;

/// Dead times inside an interval at which the gain is bounded.
const INSIDE: u32 = 24;

/// Intervals of 95 %.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Confidence {
    /// Process gain [output unit/(input unit·s)], from the lower to the upper end.
    pub process_gain: [f64; 2],
    /// Dead time [s].
    #[serde(rename = "dead_time_s")]
    pub dead_time: [f64; 2],
    /// Lag [s], where the model has one.
    #[serde(rename = "lag_s")]
    pub lag: Option<[f64; 2]>,
}

/// At one dead time, the gains that belong to the joint region of 95 %.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Slice {
    /// Dead time [s].
    #[serde(rename = "dead_time_s")]
    pub dead_time: f64,
    /// Lag [s] that goes with it best; absent where the model has none.
    #[serde(rename = "lag_s")]
    pub lag: Option<f64>,
    /// Least and greatest process gain.
    pub process_gain: [f64; 2],
}

/// The profile of one fit.
pub(crate) struct Profile<'w, 'p, 'r> {
    whitened: &'w Whitened<'p, 'r>,
    best: Fit,
    greatest: f64,
    inflations: Inflations,
    /// Fits at dead times in order.
    tried: Vec<Fit>,
}

impl<'w, 'p, 'r> Profile<'w, 'p, 'r> {
    /// The profile of `joint`, whose problem is `whitened` by its noise, wider by these inflations.
    pub(crate) fn new(
        whitened: &'w Whitened<'p, 'r>,
        joint: &Joint,
        greatest: f64,
        inflations: Inflations,
    ) -> Self {
        let mut profile =
            Self { whitened, best: joint.fit, greatest, inflations, tried: Vec::with_capacity(90) };
        let mut places: Vec<f64> = (0..=TRIED).map(|k| greatest * f64::from(k) / f64::from(TRIED)).collect();
        // Where the dead time is known well the even places are all outside: a few close to the best one.
        let width = profile.width();
        for factor in [0.3, 0.7, 1.0, 1.5, 2.2, 3.2, 5.0, 9.0] {
            places.extend([joint.fit.dead_time - factor * width, joint.fit.dead_time + factor * width]);
        }
        places.push(joint.fit.dead_time);
        places.retain(|place| (0.0..=greatest).contains(place));
        places.sort_by(f64::total_cmp);
        profile.tried = places.into_iter().map(|place| profile.at(place)).collect();
        profile
    }

    /// The best with this dead time, over the lag too.
    fn at(&self, dead_time: f64) -> Fit {
        let start = Fit { dead_time, ..self.best };
        if self.best.kind.has_lag() {
            polish(self.whitened, start, self.greatest, false)
        } else {
            self.whitened.at(dead_time, self.best.lag)
        }
    }

    /// Residual variance.
    fn variance(&self) -> f64 {
        self.best.squares / self.freedom_of_rows()
    }

    fn freedom_of_rows(&self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
        let rows = self.whitened.problem.len() as f64;
        (rows - 4.0).max(1.0)
    }

    /// Standard deviation of the dead time by the curvature at the best one.
    fn width(&self) -> f64 {
        let slope = self.whitened.column(self.best.kind.shape(self.best.lag).rate(), self.best.dead_time);
        let (mut basis, _) = self.whitened.rest(self.best.lag);
        basis.add(self.whitened.column(self.best.kind.shape(self.best.lag), self.best.dead_time));
        let slope = basis.projected(slope);
        let squares: f64 = slope.iter().map(|value| value * value).sum();
        let width = (self.variance() / squares).sqrt() / self.best.gain.abs();
        if width.is_finite() { width.min(self.greatest) } else { self.greatest / 10.0 }
    }

    /// The ends of the dead times whose squares stay below the threshold.
    fn ends(&self, limit: f64) -> [f64; 2] {
        let inside = |fit: &Fit| fit.squares <= limit;
        let first = self.tried.iter().position(inside).unwrap_or(0);
        let last = self.tried.iter().rposition(inside).unwrap_or(self.tried.len() - 1);
        let low = match first.checked_sub(1) {
            Some(before) => self.edge(self.tried[before].dead_time, self.tried[first].dead_time, limit),
            None => self.tried[first].dead_time,
        };
        let high = match self.tried.get(last + 1) {
            Some(after) => self.edge(after.dead_time, self.tried[last].dead_time, limit),
            None => self.tried[last].dead_time,
        };
        [low, high]
    }

    /// Where the squares pass the limit between a dead time outside and one inside.
    fn edge(&self, mut outside: f64, mut inside: f64, limit: f64) -> f64 {
        for _ in 0..24 {
            let middle = f64::midpoint(outside, inside);
            if self.at(middle).squares <= limit {
                inside = middle;
            } else {
                outside = middle;
            }
            if (outside - inside).abs() <= 1e-4 * inside.abs() {
                break;
            }
        }
        f64::midpoint(outside, inside)
    }

    /// Gains at one dead time whose squares stay below the limit.
    fn gains(fit: &Fit, limit: f64) -> Option<[f64; 2]> {
        let room = limit - fit.squares;
        if room < 0.0 || fit.column_squares <= 0.0 {
            return None;
        }
        let half = (room / fit.column_squares).sqrt();
        let unit = fit.process_gain() / fit.gain;
        let ends = [(fit.gain - half) * unit, (fit.gain + half) * unit];
        Some([ends[0].min(ends[1]), ends[0].max(ends[1])])
    }

    /// The squares up to which a parameter's value is not excluded.
    fn limit(&self, quantile: fn(f64) -> f64, of: &Inflation) -> f64 {
        let deviations = (quantile(of.freedom) * of.factor).sqrt() + of.bias;
        self.best.squares + deviations * deviations * self.variance()
    }

    /// The intervals of 95 % of each parameter.
    pub(crate) fn confidence(&self) -> Confidence {
        let dead_time = self.ends(self.limit(quantile::one, &self.inflations.dead_time));
        let limit = self.limit(quantile::one, &self.inflations.gain);
        let under = self.ends(limit);
        let (mut process_gain, mut lag) = ([f64::INFINITY, f64::NEG_INFINITY], [f64::INFINITY, 0.0]);
        for fit in self.across(under) {
            if let Some(gains) = Self::gains(&fit, limit) {
                process_gain = [process_gain[0].min(gains[0]), process_gain[1].max(gains[1])];
                lag = [f64::min(lag[0], fit.lag), f64::max(lag[1], fit.lag)];
            }
        }
        let lag = self.best.kind.has_lag().then_some(lag);
        Confidence { process_gain, dead_time, lag }
    }

    /// The joint region of 95 % of gain and dead time, slice by slice.
    pub(crate) fn region(&self) -> Vec<Slice> {
        let Inflations { gain, dead_time } = &self.inflations;
        let limit = self.limit(quantile::two, gain).max(self.limit(quantile::two, dead_time));
        let slice = |fit: Fit| {
            let process_gain = Self::gains(&fit, limit)?;
            let lag = self.best.kind.has_lag().then_some(fit.lag);
            Some(Slice { dead_time: fit.dead_time, lag, process_gain })
        };
        self.across(self.ends(limit)).filter_map(slice).collect()
    }

    /// Fits across an interval of dead times, the best one among them.
    fn across(&self, ends: [f64; 2]) -> impl Iterator<Item = Fit> {
        let even =
            (0..=INSIDE).map(move |k| ends[0] + (ends[1] - ends[0]) * f64::from(k) / f64::from(INSIDE));
        let mut places: Vec<f64> = even.collect();
        places.push(self.best.dead_time);
        places.sort_by(f64::total_cmp);
        places.into_iter().map(|place| self.at(place))
    }
}

/// Whether a problem's profile reaches the greatest dead time that was looked for.
pub(crate) fn open_ended(confidence: &Confidence, greatest: f64, problem: &Problem<'_>) -> bool {
    confidence.dead_time[1] >= greatest - 0.5 * problem.step()
}
