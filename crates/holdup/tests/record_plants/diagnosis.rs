//! A cycle is put down to what makes it: the tuning, the valve, or something outside.

use holdup::record::{IdentifyOptions, Record, identify};

use super::plant::{Events, Law, Plant, Valve, no_hand, steps};

fn findings(record: &Record) -> String {
    let answer = identify(record, &IdentifyOptions::default()).unwrap();
    let [low, high] = answer.controller.as_ref().map_or([0.0; 2], |found| found.proportional_gain.interval);
    format!("{:?} Kc {low:.3}..{high:.3} {:?}", answer.verdict, answer.diagnosis.findings)
}

/// A good PI tuning on plants over a decade of dead times.
fn plant(seed: u32) -> Plant {
    let dead_time = 3.3 + 2.1 * f64::from(seed);
    let mut plant = Plant::integrating(0.002, dead_time, u64::from(seed));
    plant.law = Some(Law {
        gain: 0.35 / (0.002 * (dead_time + 1.0)),
        integral_time: Some(10.0 * (dead_time + 1.0)),
        derivative_time: 0.0,
    });
    (plant.noise, plant.rows) = (0.005, 1600);
    plant
}

#[test]
fn a_valve_that_sticks_or_moves_in_steps_is_named() {
    for seed in 0..5 {
        for valve in [Valve::Sticking(2.0), Valve::Steps(3.0)] {
            for moves in [0.0, 1.0] {
                let mut plant = plant(seed);
                plant.valve = valve;
                let record =
                    plant.record(&Events { setpoint: &steps(moves, 600), load: &|_| 1.3, hand: &no_hand });
                let findings = findings(&record);
                // At a constant setpoint the process is not known, and only straight flanks can tell.
                let named = findings.contains("check the valve");
                assert!(named || moves == 0.0, "{valve:?} {moves} {plant:?}\n{findings}");
                assert!(!findings.contains("outside; look") && !findings.contains(": tuning"), "{findings}");
            }
        }
    }
}

#[test]
fn a_loop_near_its_limit_is_put_down_to_its_tuning() {
    for seed in 0..5 {
        let mut plant = plant(seed);
        // 93 % of the gain at which it would cycle for ever, π/2 less what the integral and the sampling cost.
        let dead_time = plant.dead_time + 1.5;
        plant.law = Some(Law { gain: 1.36 / (0.002 * dead_time), ..plant.law.unwrap() });
        let record = plant.record(&Events { setpoint: &steps(1.0, 500), load: &|_| 0.0, hand: &no_hand });
        let findings = findings(&record);
        assert!(
            findings.contains("gain is too high") || findings.contains(": tuning"),
            "{plant:?}\n{findings}"
        );
        assert!(!findings.contains("check the valve") && !findings.contains("outside;"), "{findings}");
    }
}

#[test]
fn a_reset_that_is_too_fast_is_put_down_to_it() {
    for seed in 0..5 {
        let mut plant = plant(seed);
        let law = plant.law.unwrap();
        // ½√(K·Kc·Ti) = 0.2.
        let (gain, slow) = (0.1 * law.gain, 0.16 / (0.002 * 0.1 * law.gain));
        plant.law = Some(Law { gain, integral_time: Some(slow), ..law });
        (plant.rows, plant.noise) = (2500, 0.01);
        let record = plant.record(&Events { setpoint: &steps(1.0, 1200), load: &|_| 0.0, hand: &no_hand });
        let findings = findings(&record);
        assert!(findings.contains("reset too fast") && findings.contains("lowering the gain"), "{findings}");
    }
}

#[test]
fn a_cycle_from_outside_is_told_from_the_loop_and_its_valve() {
    for seed in 0..5 {
        let plant = plant(seed);
        let period = 9.0 * (plant.dead_time + 1.0);
        #[expect(clippy::cast_precision_loss, reason = "a row")]
        let swinging = |k: usize| 3.0 * (std::f64::consts::TAU * k as f64 / period).sin();
        let record = plant.record(&Events { setpoint: &steps(1.0, 600), load: &swinging, hand: &no_hand });
        let findings = findings(&record);
        assert!(findings.contains("comes from outside; look for another loop"), "{plant:?}\n{findings}");
        assert!(!findings.contains("check the valve") && !findings.contains(": tuning"), "{findings}");
    }
}
