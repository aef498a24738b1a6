//! The fit gives back the process that made a record.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::input::Input;
use super::search::search;
use super::*;
use crate::record::Record;

/// A plant and how it is seen.
pub(crate) struct Plant {
    pub(crate) kind: Kind,
    pub(crate) gain: f64,
    pub(crate) dead_time: f64,
    pub(crate) lag: f64,
    /// What the columns of initial state and load are multiplied by.
    pub(crate) own: f64,
    pub(crate) load: Load,
    pub(crate) hold: Hold,
}

impl Plant {
    pub(crate) fn record(&self, time: Vec<f64>, input: Vec<f64>) -> Record {
        let of = Input::new(&time, &input, self.hold);
        let scale = if self.kind == Kind::FirstOrder { self.gain * self.lag } else { self.gain };
        let column = of.column(self.kind.shape(self.lag), self.dead_time, &time);
        let own = self.kind.own_columns(self.load, &time, self.lag);
        let level: Vec<f64> = (0..time.len())
            .map(|k| scale * column[k] + self.own * own.iter().map(|column| column[k]).sum::<f64>())
            .collect();
        Record::new(time, level, input).unwrap()
    }
}

fn noiseless(plant: &Plant, time: Vec<f64>, input: Vec<f64>) -> Fit {
    let record = plant.record(time, input);
    let problem = Problem::new(&record, 0, 1, plant.hold, plant.load);
    let white = Whitener::new(&Noise::WHITE, &problem.times);
    search(&Whitened::new(&problem, &white, plant.kind), problem.step(), problem.span() / 4.0).unwrap()
}

/// Steps and random moves, on even and uneven grids, all kinds, both holds. The dead time is no multiple of anything.
/// 1e-9: the condition of the problem, some 1e4, on rounding of 1e-15, with room.
#[test]
fn without_noise_gain_dead_time_and_lag_come_back() {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    for kind in Kind::ALL {
        for hold in [Hold::Constant, Hold::Linear] {
            for even in [true, false] {
                let mut time = vec![0.0];
                while time.len() < 300 {
                    let step = if even { 1.0 } else { random.random_range(0.4..1.6) };
                    time.push(time[time.len() - 1] + step);
                }
                let mut value = 20.0;
                let input: Vec<f64> = (0..300)
                    .map(|k| {
                        if k > 5 && random.random_range(0.0..1.0) < 0.1 {
                            value = random.random_range(0.0..100.0);
                        }
                        value
                    })
                    .collect();
                let plant = Plant {
                    kind,
                    gain: -0.013 * random.random_range(0.5..2.0),
                    dead_time: random.random_range(0.1..12.0),
                    lag: if kind.has_lag() { random.random_range(2.0..20.0) } else { 0.0 },
                    own: 0.7,
                    load: if even { Load::Constant } else { Load::Drifting },
                    hold,
                };
                let fit = noiseless(&plant, time, input);
                let near = |found: f64, true_: f64| (found / true_ - 1.0).abs();
                assert!(
                    near(fit.process_gain(), plant.gain) < 1e-9
                        && near(fit.dead_time, plant.dead_time) < 1e-9
                        && (fit.lag - plant.lag.max(1.0)).abs() * f64::from(u8::from(kind.has_lag())) < 1e-8,
                    "{kind:?} {hold:?} even {even}: K {} {}, d {} {}, T {} {}",
                    fit.process_gain(),
                    plant.gain,
                    fit.dead_time,
                    plant.dead_time,
                    fit.lag,
                    plant.lag
                );
            }
        }
    }
}
