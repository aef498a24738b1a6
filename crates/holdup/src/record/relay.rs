//! Gain and dead time from a relay test.
//!
//! A relay gives `high` to an integrating process with dead time until its output has passed the setpoint by the
//! hysteresis ε, then `low` until it has passed it by ε the other way. Between switchings the output is straight lines of
//! slopes a = K·(high + D) and −b = K·(low + D), D the load; it goes on in the old direction for the dead time d after each
//! switching, so that its swing from trough to peak is A = 2ε + (a + b)·d, and it rises for A/a and falls for A/b, which are
//! also the times for which the relay gives `high` and `low`. With these two times t₁ and t₂, exactly and for any bias:
//!
//! K = A·(1/t₁ + 1/t₂)/(high − low), d = (1 − 2ε/A)·t₁·t₂/(t₁ + t₂), D = A/(K·t₁) − high.
//!
//! No describing function is involved: K. J. Åström and T. Hägglund, Automatica 20 (1984) 645, take the first harmonic instead,
//! which for this process is wrong by 8/π² in the amplitude.

use serde::Serialize;
use thiserror::Error;

use super::Record;
use crate::model::{ModelError, Process, Seconds};

/// Why cycle numbers give no process.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum RelayError {
    /// A number out of its range.
    #[error("{name} is {value}: must be {allowed}")]
    Value {
        /// Which number.
        name: &'static str,
        /// The number.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A record that holds no relay test.
    #[error("the record is no relay test: {reason}")]
    NoCycle {
        /// What is missing.
        reason: &'static str,
    },
    /// The process is out of range.
    #[error(transparent)]
    Model(#[from] ModelError),
}

/// What is measured of a steady cycle under a relay.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RelayCycle {
    /// Upper value of the relay [input unit].
    pub high: f64,
    /// Lower value of the relay [input unit].
    pub low: f64,
    /// Time for which the relay gives the upper value in one period [s].
    #[serde(rename = "high_time_s")]
    pub high_time: f64,
    /// Time for which it gives the lower value [s].
    #[serde(rename = "low_time_s")]
    pub low_time: f64,
    /// Swing of the controlled variable from trough to peak [output unit].
    pub swing: f64,
    /// How far the controlled variable passes the setpoint before the relay switches [output unit]; 0 without hysteresis.
    pub hysteresis: f64,
}

/// What the cycle tells.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RelayResult {
    /// Process gain [output unit/(input unit·s)]; negative where the output falls while the relay gives the upper value.
    pub process_gain: f64,
    /// Dead time [s].
    #[serde(rename = "dead_time_s")]
    pub dead_time: f64,
    /// Load at the process input [input unit].
    pub load: f64,
}

impl RelayResult {
    /// The process.
    ///
    /// # Errors
    /// Where gain or dead time are out of range.
    pub fn process(&self) -> Result<Process, ModelError> {
        Process::integrating(self.process_gain, Seconds(self.dead_time))
    }
}

impl RelayCycle {
    /// Gain, dead time and load by the closed form; the gain is positive.
    ///
    /// # Errors
    /// [`RelayError::Value`] where a time or the swing is not above 0, the relay's values are the same, or the hysteresis leaves
    /// no room for a dead time.
    ///
    /// ```
    /// use holdup::record::relay::RelayCycle;
    ///
    /// // K = 0.05, d = 6: up at 0.05·(1 + 0.2), down at 0.05·(1 − 0.2), swing (0.06 + 0.04)·6 = 0.6.
    /// let cycle = RelayCycle { high: 1.0, low: -1.0, high_time: 10.0, low_time: 15.0, swing: 0.6, hysteresis: 0.0 };
    /// let found = cycle.result()?;
    /// assert!((found.process_gain - 0.05).abs() < 1e-15 && (found.dead_time - 6.0).abs() < 1e-14);
    /// assert!((found.load - 0.2).abs() < 1e-14);
    /// # Ok::<(), holdup::record::relay::RelayError>(())
    /// ```
    pub fn result(&self) -> Result<RelayResult, RelayError> {
        let value = |name, value, allowed| Err(RelayError::Value { name, value, allowed });
        for (name, number) in
            [("high time", self.high_time), ("low time", self.low_time), ("swing", self.swing)]
        {
            if !(number > 0.0 && number.is_finite()) {
                return value(name, number, "above 0 and finite");
            }
        }
        let height = self.high - self.low;
        if !(height > 0.0 && height.is_finite()) {
            return value("height of the relay", height, "above 0 and finite");
        }
        if !(self.hysteresis >= 0.0 && 2.0 * self.hysteresis < self.swing) {
            return value("hysteresis", self.hysteresis, "at least 0 and less than half the swing");
        }
        let rates = 1.0 / self.high_time + 1.0 / self.low_time;
        let process_gain = self.swing * rates / height;
        Ok(RelayResult {
            process_gain,
            dead_time: (1.0 - 2.0 * self.hysteresis / self.swing) / rates,
            load: self.swing / (process_gain * self.high_time) - self.high,
        })
    }

    /// The mean cycle of a record in which the manipulated variable goes between two values. The first and the last stretch are
    /// left out, as the cycle is not steady or not whole there.
    ///
    /// # Errors
    /// [`RelayError::NoCycle`] where the manipulated variable has not two values, or switches too seldom.
    pub fn of(record: &Record, hysteresis: f64) -> Result<Self, RelayError> {
        let input = record.manipulated_variable();
        let [low, high] = input.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| {
            [low.min(value), high.max(value)]
        });
        let middle = f64::midpoint(low, high);
        let near = |value: f64| (value - low).min(high - value) < 0.1 * (high - low);
        if high <= low || !input.iter().all(|value| near(*value)) {
            return Err(RelayError::NoCycle {
                reason: "the manipulated variable must go between two values",
            });
        }
        let is_high = |k: usize| input[k] > middle;
        let switches: Vec<usize> = (1..input.len()).filter(|&k| is_high(k) != is_high(k - 1)).collect();
        if switches.len() < 5 {
            return Err(RelayError::NoCycle { reason: "it must switch at least five times" });
        }
        let (time, output) = (record.time(), record.controlled_variable());
        // From the second switching on, whole periods.
        let steady = &switches[1..];
        let mut times = [Vec::new(), Vec::new()];
        for pair in steady.windows(2) {
            times[usize::from(is_high(pair[0]))].push(time[pair[1]] - time[pair[0]]);
        }
        let mut ends = [Vec::new(), Vec::new()];
        for three in steady.windows(3) {
            let period = &output[three[0]..three[2]];
            ends[0].push(period.iter().copied().fold(f64::INFINITY, f64::min));
            ends[1].push(period.iter().copied().fold(f64::NEG_INFINITY, f64::max));
        }
        let mean = |values: &[f64]| {
            #[expect(clippy::cast_precision_loss, reason = "a number of periods")]
            let count = values.len() as f64;
            values.iter().sum::<f64>() / count
        };
        Ok(Self {
            high,
            low,
            high_time: mean(&times[1]),
            low_time: mean(&times[0]),
            swing: mean(&ends[1]) - mean(&ends[0]),
            hysteresis,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::identify::point_fit;

    /// An integrator with dead time under a relay, from switching to switching, which is exact: straight lines.
    fn cycle(
        gain: f64,
        dead_time: f64,
        load: f64,
        relay: [f64; 2],
        hysteresis: f64,
    ) -> (RelayCycle, Vec<(f64, f64)>) {
        let slope = |input: f64| gain * (input + load);
        let (mut time, mut level, mut input, mut acting) = (0.0, 0.0, relay[1], relay[1]);
        let (mut switchings, mut corners) = (Vec::new(), vec![]);
        while switchings.len() < 40 {
            // The line now goes on until the relay's threshold; what acts changes a dead time after the last switching.
            let threshold = if input == relay[1] { hysteresis } else { -hysteresis };
            let changes: f64 = switchings.last().map_or(0.0, |(at, _)| at + dead_time);
            if acting != input {
                level += slope(acting) * (changes - time);
                time = changes;
                acting = input;
                corners.push((time, level));
            }
            time += (threshold - level) / slope(acting);
            level = threshold;
            input = if input == relay[1] { relay[0] } else { relay[1] };
            switchings.push((time, input));
        }
        let n = switchings.len();
        let last = &switchings[n - 3..];
        let [first, second] = [last[1].0 - last[0].0, last[2].0 - last[1].0];
        let (high_time, low_time) = if last[0].1 == relay[1] { (first, second) } else { (second, first) };
        let corner = &corners[corners.len() - 2..];
        let swing = (corner[1].1 - corner[0].1).abs();
        (RelayCycle { high: relay[1], low: relay[0], high_time, low_time, swing, hysteresis }, switchings)
    }

    /// 1e-12: some 80 additions of numbers of order 1e3, over differences of order 10.
    #[test]
    fn bias_and_hysteresis_are_exact() {
        for (gain, dead_time) in [(0.0506, 6.0), (3e-4, 120.0)] {
            for load in [0.0, 0.4, -0.7] {
                for hysteresis in [0.0, 0.3 * gain * dead_time] {
                    let (cycle, _) = cycle(gain, dead_time, load, [-1.0, 1.5], hysteresis);
                    let found = cycle.result().unwrap();
                    assert!((found.process_gain / gain - 1.0).abs() < 1e-12, "{found:?}");
                    assert!((found.dead_time / dead_time - 1.0).abs() < 1e-12, "{found:?}");
                    assert!((found.load - load).abs() < 1e-11);
                }
            }
        }
    }

    /// A record at every second gives the cycle to the rounding of its rows; the point fit uses every row of it and, the
    /// switchings falling on rows, is exact to 1e-9.
    #[test]
    fn a_record_of_a_relay_test_gives_the_process() {
        let (gain, dead_time) = (0.01, 12.4);
        let time: Vec<f64> = (0..600).map(f64::from).collect();
        let (mut input, mut level, mut valve) = (Vec::new(), Vec::new(), 1.0);
        for k in 0..600 {
            let integral: f64 = (0..k)
                .map(|j| {
                    let (from, to) = (time[j] + dead_time, time[j] + 1.0 + dead_time);
                    input[j] * (time[k].min(to) - from).clamp(0.0, 1.0)
                })
                .sum();
            level.push(gain * integral);
            if level[k] > 0.05 {
                valve = -0.5;
            } else if level[k] < -0.05 {
                valve = 1.0;
            }
            // At rest first: what the input was before a record nobody knows.
            input.push(if k < 5 { 0.0 } else { valve });
        }
        let record = Record::new(time, level, input).unwrap();
        let fit = point_fit(&record, Seconds(50.0)).unwrap();
        assert!(
            (fit.process_gain - gain).abs() < 1e-11 && (fit.dead_time - dead_time).abs() < 1e-9,
            "{fit:?}"
        );
        let relay = RelayCycle::of(&record.rows(6, 600).unwrap(), 0.05).unwrap().result().unwrap();
        // A row in a period of some 60 s is 2 %, at both switchings; the hysteresis is passed by up to a row as well.
        assert!((relay.process_gain / gain - 1.0).abs() < 0.05, "{relay:?}");
        assert!((relay.dead_time - dead_time).abs() < 1.5, "{relay:?}");
    }

    #[test]
    fn numbers_that_are_no_cycle_are_refused() {
        let cycle =
            RelayCycle { high: 1.0, low: -1.0, high_time: 10.0, low_time: 10.0, swing: 1.0, hysteresis: 0.5 };
        assert!(cycle.result().unwrap_err().to_string().contains("hysteresis is 0.5"));
        assert!(RelayCycle { high: -1.0, ..cycle }.result().is_err());
        assert!(RelayCycle { high_time: 0.0, ..cycle }.result().is_err());
        let record = Record::new(vec![0.0, 1.0, 2.0], vec![0.0; 3], vec![0.0, 1.0, 0.0]).unwrap();
        assert!(RelayCycle::of(&record, 0.0).is_err());
    }
}
