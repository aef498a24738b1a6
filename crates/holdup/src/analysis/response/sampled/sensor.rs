//! What the law is told of the process, and when.

use std::f64::consts::TAU;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::equipment::EquipmentSettings;
use super::valve::quantised;

/// Sensor and clock: noise, quanta, lost measurements, late samples. Each has a stream of random numbers of its own, so
/// that one of them does not change the draws of another.
#[derive(Debug, Clone)]
pub(super) struct Sensor {
    noise: f64,
    quantum: Option<f64>,
    drop: f64,
    period: f64,
    jitter: f64,
    noises: ChaCha8Rng,
    drops: ChaCha8Rng,
    delays: ChaCha8Rng,
    /// The second of the two normal numbers that are drawn together.
    spare: Option<f64>,
}

impl Sensor {
    pub(super) fn new(equipment: &EquipmentSettings) -> Self {
        let stream = |number| {
            let mut stream = ChaCha8Rng::seed_from_u64(equipment.seed);
            stream.set_stream(number);
            stream
        };
        Self {
            noise: equipment.noise,
            quantum: equipment.measurement_quantum,
            drop: equipment.drop,
            period: equipment.sample_period,
            jitter: equipment.jitter,
            noises: stream(0),
            drops: stream(1),
            delays: stream(2),
            spare: None,
        }
    }

    /// Time of the sample of this number [s].
    pub(super) fn time_of(&mut self, number: f64) -> f64 {
        let late = if self.jitter > 0.0 { self.jitter * self.delays.random::<f64>() } else { 0.0 };
        number * self.period + late
    }

    /// The measurement of this value [output unit]; none where it is lost.
    pub(super) fn measure(&mut self, value: f64) -> Option<f64> {
        let noise = if self.noise > 0.0 { self.noise * self.normal() } else { 0.0 };
        let measured = self.quantum.map_or(value + noise, |quantum| quantised(value + noise, quantum));
        let lost = self.drop > 0.0 && self.drops.random::<f64>() < self.drop;
        (!lost).then_some(measured)
    }

    /// A normal number of mean 0 and variance 1 (Box and Muller 1958).
    fn normal(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        // 1 − u is in (0, 1]: its logarithm is finite.
        let radius = (-2.0 * (1.0 - self.noises.random::<f64>()).ln()).sqrt();
        let (sine, cosine) = (TAU * self.noises.random::<f64>()).sin_cos();
        self.spare = Some(radius * sine);
        radius * cosine
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sensor(change: impl Fn(&mut EquipmentSettings)) -> Sensor {
        let mut settings = EquipmentSettings { sample_period: 0.5, ..EquipmentSettings::default() };
        change(&mut settings);
        Sensor::new(&settings)
    }

    #[test]
    fn noise_has_its_mean_and_its_deviation() {
        let mut sensor = sensor(|s| s.noise = 2.0);
        let values: Vec<f64> = (0..100_000).filter_map(|_| sensor.measure(7.0)).collect();
        let n = 100_000.0;
        let mean = values.iter().sum::<f64>() / n;
        let variance = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / n;
        // Deviations of the two estimates: 2/√n and 4·√(2/n); five of them.
        assert!((mean - 7.0).abs() < 5.0 * 2.0 / n.sqrt());
        assert!((variance - 4.0).abs() < 5.0 * 4.0 * (2.0 / n).sqrt());
        // A normal number lies within one deviation in 68.27 % of the cases.
        let within = values.iter().filter(|v| (*v - 7.0).abs() < 2.0).count();
        assert!((67_500..69_000).contains(&within), "{within}");
    }

    #[test]
    fn one_imperfection_does_not_change_the_draws_of_another() {
        let mut alone = sensor(|s| s.noise = 1.0);
        let mut with_drops = sensor(|s| (s.noise, s.drop, s.jitter) = (1.0, 0.3, 0.1));
        let (mut kept, mut lost) = (0, 0);
        for number in 0..1000 {
            with_drops.time_of(f64::from(number));
            let expected = alone.measure(0.0);
            match with_drops.measure(0.0) {
                None => lost += 1,
                some => {
                    assert_eq!(some, expected);
                    kept += 1;
                }
            }
        }
        // 300 expected, deviation 14.5; five of them.
        assert!((228..372).contains(&lost) && kept + lost == 1000, "{lost}");
    }

    #[test]
    fn samples_are_late_within_the_jitter_and_never_early() {
        let mut sensor = sensor(|s| s.jitter = 0.2);
        for number in 0..1000 {
            let late = sensor.time_of(f64::from(number)) - 0.5 * f64::from(number);
            assert!((0.0..0.2 + 1e-12).contains(&late)); // rounding of a time below 500
        }
    }

    #[test]
    fn a_quantised_measurement_is_a_multiple_of_its_quantum() {
        let mut sensor = sensor(|s| (s.noise, s.measurement_quantum) = (1.0, Some(0.25)));
        for _ in 0..100 {
            assert_eq!((4.0 * sensor.measure(0.1).unwrap()).fract(), 0.0);
        }
    }
}
