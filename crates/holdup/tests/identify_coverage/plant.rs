//! A tank with noise, in open loop under pulses of its valve or in closed loop under setpoint steps.

use holdup::record::Record;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// One cell of the study; strengths are in units of the noise's standard deviation, 0.1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cell {
    pub(crate) closed: bool,
    /// Correlation of coloured noise from row to row; 0: none.
    pub(crate) rho: f64,
    /// White measurement noise.
    pub(crate) white: f64,
    /// Change of the load from row to row, in units of the input.
    pub(crate) wander: f64,
    /// Rounding.
    pub(crate) quantum: f64,
    /// A point is archived when it is so far from the last one; straight lines between.
    pub(crate) compression: f64,
}

impl Cell {
    pub(crate) const WHITE: Self =
        Self { closed: false, rho: 0.0, white: 1.0, wander: 0.0, quantum: 0.0, compression: 0.0 };
}

const ROWS: usize = 400;
const UNIT: f64 = 0.1;

/// A normal number by Box and Muller.
fn normal(random: &mut ChaCha8Rng) -> f64 {
    let radius = (-2.0 * random.random_range(1e-12..1.0f64).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.random_range(0.0..1.0f64)).cos()
}

/// The record, its process gain and its dead time.
pub(crate) fn plant(cell: &Cell, seed: u64) -> (Record, f64, f64) {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let gain = 0.002 * random.random_range(0.5..2.0f64);
    let dead_time = random.random_range(1.0..12.0f64);
    let (proportional, integral_time) = (0.35 / (gain * (dead_time + 2.0)), 8.0 * (dead_time + 2.0));
    let (mut time, mut level, mut valve, mut setpoint) = (vec![], vec![], vec![], vec![]);
    let mut moved = vec![0.0];
    let (mut coloured, mut load, mut loaded, mut errors) = (normal(&mut random), 0.0, 0.0, 0.0);
    let (mut wanted, mut pulse) = (40.0, 0.0);
    let mut now = 0.0f64;
    for k in 0..ROWS {
        let arrived = now - dead_time;
        let integral = if arrived <= 0.0 {
            0.0
        } else {
            // Rows are one second apart.
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "below the number of rows"
            )]
            let row = arrived.floor() as usize;
            moved[row] + arrived.fract() * valve[row]
        };
        coloured = cell.rho * coloured + (1.0 - cell.rho * cell.rho).sqrt() * normal(&mut random);
        let noise = if cell.rho > 0.0 { coloured } else { 0.0 } + cell.white * normal(&mut random);
        let mut value: f64 = 40.0 + gain * integral + loaded + UNIT * noise;
        if cell.quantum > 0.0 {
            value = (value / (cell.quantum * UNIT)).round() * cell.quantum * UNIT;
        }
        let input = if cell.closed {
            if k % (ROWS / 4) == ROWS / 10 {
                wanted += if (k / (ROWS / 4)).is_multiple_of(2) { 2.0 } else { -2.0 };
            }
            errors += wanted - value;
            proportional * (wanted - value + errors / integral_time)
        } else {
            if k >= ROWS / 10 && k % (ROWS / 8) == ROWS / 10 % (ROWS / 8) {
                pulse = [10.0, 0.0, -10.0, 0.0][(k / (ROWS / 8)) % 4];
            }
            pulse
        };
        moved.push(moved[k] + input);
        loaded += gain * load;
        load += cell.wander * normal(&mut random);
        time.push(now);
        level.push(value);
        valve.push(input);
        setpoint.push(wanted);
        now += 1.0;
    }
    if cell.compression > 0.0 {
        compress(&mut level, cell.compression * UNIT);
    }
    let record = Record::new(time, level, valve.iter().map(|value| 50.0 + value).collect()).unwrap();
    (record.with_setpoint(setpoint).unwrap(), gain, dead_time)
}

/// Keeps the points that are so far from the last kept one, and draws straight lines between them.
fn compress(values: &mut [f64], band: f64) {
    let mut last = 0;
    for k in 1..values.len() {
        if (values[k] - values[last]).abs() > band || k == values.len() - 1 {
            let (from, to) = (values[last], values[k]);
            let steps = f64::from(u32::try_from(k - last).unwrap());
            for between in last + 1..k {
                let share = f64::from(u32::try_from(between - last).unwrap()) / steps;
                values[between] = from + share * (to - from);
            }
            last = k;
        }
    }
}
