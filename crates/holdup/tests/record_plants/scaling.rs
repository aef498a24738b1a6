//! Time times a, level times b, valve times c: every result follows its unit.

use holdup::record::controller::{Estimate, recover};
use holdup::record::identify::Kind;
use holdup::record::relay::RelayCycle;
use holdup::record::{IdentifyOptions, Record, identify};

use super::plant::{Events, Law, Plant, no_hand, pulses, steps};

fn scaled(record: &Record, [a, b, c]: [f64; 3]) -> Record {
    let times = |values: &[f64], factor: f64| values.iter().map(|value| factor * value).collect::<Vec<f64>>();
    Record::new(
        times(record.time(), a),
        times(record.controlled_variable(), b),
        times(record.manipulated_variable(), c),
    )
    .unwrap()
    .with_setpoint(times(record.setpoint().unwrap(), b))
    .unwrap()
    .with_operation(record.operation().unwrap().to_vec())
    .unwrap()
}

/// 1e-6: the search for the noise's strengths stops at a fixed size, and rounding may stop it a step earlier.
fn near(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() <= 1e-6 * expected.abs(), "{what}: {found} is not {expected}");
}

const FACTORS: [[f64; 3]; 3] = [[4.0, 1.0, 1.0], [1.0, 16.0, 0.25], [0.0625, 0.5, 4.0]];

#[test]
fn process_and_intervals_follow_the_units_of_time_level_and_valve() {
    for (kind, closed) in
        [(Kind::Integrating, false), (Kind::Integrating, true), (Kind::IntegratingWithLag, false)]
    {
        let mut plant = Plant::integrating(0.002, 5.3, 3);
        (plant.kind, plant.lag, plant.rows) = (kind, 12.0, 300);
        let moves = steps(1.0, 60);
        let record = if closed {
            plant.law = Some(Law { gain: 20.0, integral_time: Some(60.0), derivative_time: 0.0 });
            plant.record(&Events { setpoint: &moves, load: &|_| 0.0, hand: &no_hand })
        } else {
            plant.record(&Events { setpoint: &|_| 0.0, load: &|_| 0.0, hand: &pulses(10.0, 40) })
        };
        let options = |a: f64| IdentifyOptions {
            kind: Some(kind),
            greatest_dead_time: Some(40.0 * a),
            ..IdentifyOptions::default()
        };
        let plain = identify(&record, &options(1.0)).unwrap();
        let (process, confidence) = (plain.process.unwrap(), plain.confidence.unwrap());
        for factors in FACTORS {
            let [a, b, c] = factors;
            let other = identify(&scaled(&record, factors), &options(a)).unwrap();
            assert_eq!(other.verdict, plain.verdict);
            let (found, within) = (other.process.unwrap(), other.confidence.unwrap());
            near(found.process_gain, process.process_gain * b / (a * c), "gain");
            near(found.dead_time, process.dead_time * a, "dead time");
            for end in 0..2 {
                near(within.process_gain[end], confidence.process_gain[end] * b / (a * c), "gain's interval");
                near(within.dead_time[end], confidence.dead_time[end] * a, "dead time's interval");
            }
            if let (Some(lag), Some(plain)) = (found.lag, process.lag) {
                near(lag, plain * a, "lag");
            }
        }
    }
}

#[test]
fn the_recovered_controller_follows_the_units() {
    let mut plant = Plant::integrating(0.002, 5.3, 5);
    plant.law = Some(Law { gain: 20.0, integral_time: Some(60.0), derivative_time: 3.0 });
    let record = plant.record(&Events { setpoint: &steps(1.0, 90), load: &|_| 0.0, hand: &no_hand });
    let plain = recover(&record).unwrap();
    for factors in FACTORS {
        let [a, b, c] = factors;
        let other = recover(&scaled(&record, factors)).unwrap();
        assert_eq!(other.structure, plain.structure);
        near(other.proportional_gain.value, plain.proportional_gain.value * c / b, "Kc");
        let value = |estimate: Option<Estimate>| estimate.unwrap().value;
        near(value(other.integral_time), value(plain.integral_time) * a, "Ti");
        near(value(other.derivative_time), value(plain.derivative_time) * a, "Td");
    }
}

/// 1e-12: a handful of roundings.
#[test]
fn the_relay_test_follows_the_units() {
    let cycle =
        RelayCycle { high: 1.5, low: -1.0, high_time: 10.0, low_time: 17.0, swing: 0.6, hysteresis: 0.07 };
    let plain = cycle.result().unwrap();
    for [a, b, c] in [[3.7, 0.21, 11.0], [60.0, 1.0, 0.01]] {
        let scaled = RelayCycle {
            high: cycle.high * c,
            low: cycle.low * c,
            high_time: cycle.high_time * a,
            low_time: cycle.low_time * a,
            swing: cycle.swing * b,
            hysteresis: cycle.hysteresis * b,
        };
        let found = scaled.result().unwrap();
        assert!((found.process_gain / (plain.process_gain * b / (a * c)) - 1.0).abs() < 1e-12);
        assert!((found.dead_time / (plain.dead_time * a) - 1.0).abs() < 1e-12);
        assert!((found.load - plain.load * c).abs() < 1e-12 * c);
    }
}
