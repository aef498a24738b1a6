//! A plant of any kind under a controller, written without the library: exact between rows for a held valve.

use holdup::record::identify::Kind;
use holdup::record::{Operation, Record};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The controller: ideal form, once a row, in velocity form.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Law {
    pub(crate) gain: f64,
    pub(crate) integral_time: Option<f64>,
    pub(crate) derivative_time: f64,
}

/// How the valve follows the controller's output.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Valve {
    Ideal,
    /// Stands until the output is so far off, then jumps to it.
    Sticking(f64),
    /// Goes in steps of this size.
    Steps(f64),
}

/// One record to be made; rows are a second apart.
#[derive(Debug, Clone)]
pub(crate) struct Plant {
    pub(crate) kind: Kind,
    /// Slope that a unit input starts.
    pub(crate) gain: f64,
    pub(crate) dead_time: f64,
    pub(crate) lag: f64,
    pub(crate) law: Option<Law>,
    pub(crate) valve: Valve,
    /// Standard deviation of the measurement noise.
    pub(crate) noise: f64,
    pub(crate) rows: usize,
    pub(crate) limits: [f64; 2],
    pub(crate) seed: u64,
}

/// What happens to it, row by row.
#[derive(Clone, Copy)]
pub(crate) struct Events<'e> {
    pub(crate) setpoint: &'e dyn Fn(usize) -> f64,
    pub(crate) load: &'e dyn Fn(usize) -> f64,
    /// Output by hand.
    pub(crate) hand: &'e dyn Fn(usize) -> Option<f64>,
}

pub(crate) const START: f64 = 40.0;

impl Plant {
    /// An integrating plant under ideal equipment.
    pub(crate) fn integrating(gain: f64, dead_time: f64, seed: u64) -> Self {
        Self {
            kind: Kind::Integrating,
            gain,
            dead_time,
            lag: 1.0,
            law: None,
            valve: Valve::Ideal,
            noise: 0.02,
            rows: 400,
            limits: [-1e9, 1e9],
            seed,
        }
    }

    /// Quiet plant: nothing happens but what is named.
    pub(crate) fn record(&self, events: &Events<'_>) -> Record {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        let mut normal = || {
            let radius = (-2.0 * random.random_range(1e-12..1.0f64).ln()).sqrt();
            radius * (std::f64::consts::TAU * random.random_range(0.0..1.0f64)).cos()
        };
        let (mut first, mut second, mut lagged) = (0.0, 0.0, 0.0);
        let (mut output, mut position) = (0.0, 0.0);
        let mut positions: Vec<f64> = Vec::new();
        let mut columns: [Vec<f64>; 4] = Default::default();
        let mut operation = Vec::new();
        let mut seen: Vec<f64> = Vec::new();
        let mut before: Option<f64> = None;
        for k in 0..self.rows {
            let state = match self.kind {
                Kind::Integrating | Kind::IntegratingWithLag => first,
                Kind::DoubleIntegrating => second,
                Kind::FirstOrder => self.lag * lagged,
            };
            let level = self.gain * state + self.noise * normal();
            let wanted = (events.setpoint)(k);
            seen.push(level);
            if let Some(hand) = (events.hand)(k) {
                output = hand;
            } else if let (Some(law), Some(last)) = (self.law, before) {
                let at = |back: usize| seen[k.saturating_sub(back)];
                let rate = if k > 1 { at(0) - 2.0 * at(1) + at(2) } else { 0.0 };
                let integral = law.integral_time.map_or(0.0, |time| (wanted - level) / time);
                output +=
                    law.gain * ((wanted - last) - (at(0) - at(1)) + integral - law.derivative_time * rate);
            }
            before = Some(wanted);
            output = output.clamp(self.limits[0], self.limits[1]);
            position = match self.valve {
                Valve::Sticking(band) if (output - position).abs() < band => position,
                Valve::Ideal | Valve::Sticking(_) => output,
                Valve::Steps(step) => (output / step).round() * step,
            };
            positions.push(position);
            let time = f64::from(u32::try_from(k).unwrap());
            for (column, value) in
                columns.iter_mut().zip([time, START + level, 50.0 + output, START + wanted])
            {
                column.push(value);
            }
            operation.push(match (self.law, (events.hand)(k)) {
                (Some(_), None) => Operation::Automatic,
                _ => Operation::Manual,
            });
            // From this row to the next: an older position until the fraction of a row has passed, then the newer one.
            let whole = self.dead_time.floor();
            let fraction = self.dead_time - whole;
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few rows")]
            let whole = whole as usize;
            let position_at = |back: usize| if back > k { 0.0 } else { positions[k - back] };
            for (input, length) in [(position_at(whole + 1), fraction), (position_at(whole), 1.0 - fraction)]
            {
                let input = input + (events.load)(k);
                match self.kind {
                    Kind::Integrating => first += input * length,
                    Kind::DoubleIntegrating => {
                        second += length * (first + length * input / 2.0);
                        first += input * length;
                    }
                    Kind::IntegratingWithLag | Kind::FirstOrder => {
                        let next = input + (lagged - input) * (-length / self.lag).exp();
                        first += input * length - self.lag * (next - lagged);
                        lagged = next;
                    }
                }
            }
        }
        let [time, level, valve, setpoint] = columns;
        let record = Record::new(time, level, valve).unwrap().with_setpoint(setpoint).unwrap();
        record.with_operation(operation).unwrap()
    }
}

/// Nothing by hand.
pub(crate) fn no_hand(_: usize) -> Option<f64> {
    None
}

/// Pulses of a hand, up, back, down, back, each for `each` rows from row 40 on.
pub(crate) fn pulses(height: f64, each: usize) -> impl Fn(usize) -> Option<f64> {
    move |k| Some(if k < 40 { 0.0 } else { height * [1.0, 0.0, -1.0, 0.0][(k - 40) / each % 4] })
}

/// Setpoint steps up and back, each for `each` rows from row 40 on.
pub(crate) fn steps(height: f64, each: usize) -> impl Fn(usize) -> f64 {
    move |k| if k < 40 || (k - 40) / each % 2 == 1 { 0.0 } else { height }
}
