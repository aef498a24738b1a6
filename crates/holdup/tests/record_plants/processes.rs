//! The process comes back with intervals that hold it.

use holdup::record::identify::{Kind, Load};
use holdup::record::{Identification, IdentifyOptions, Record, Verdict, identify};

use super::plant::{Events, Law, Plant, no_hand, pulses, steps};

fn at_rest(_: usize) -> f64 {
    0.0
}

fn answer(record: &Record, kind: Option<Kind>, load: Load) -> Identification {
    let options =
        IdentifyOptions { kind, load, greatest_dead_time: Some(40.0), ..IdentifyOptions::default() };
    identify(record, &options).unwrap()
}

/// How many of the intervals hold the truth. Of 16 intervals of 95 % more than 4 miss with a probability of 0.1 %.
fn missed(answer: &Identification, plant: &Plant) -> u32 {
    let confidence = answer.confidence.unwrap();
    let misses = |[low, high]: [f64; 2], value: f64| u32::from(!(low <= value && value <= high));
    misses(confidence.process_gain, plant.gain) + misses(confidence.dead_time, plant.dead_time)
}

/// Plants over a range of gains and dead times, the noise a fiftieth of what the pulses do.
fn plants(kind: Kind) -> impl Iterator<Item = Plant> {
    (0..8).map(move |seed: u32| {
        let gain = 0.001 * (1.0 + f64::from(seed * 5 % 8)) * if seed.is_multiple_of(2) { 1.0 } else { -1.0 };
        let dead_time = 0.7 + 1.37 * f64::from(seed);
        let lag = 6.0 + 2.0 * f64::from(seed);
        let mut plant = Plant::integrating(gain, dead_time, u64::from(seed));
        (plant.kind, plant.lag) = (kind, lag);
        let swing = 10.0 * gain.abs() * 40.0;
        plant.noise = swing / 50.0;
        plant
    })
}

#[test]
fn every_kind_is_told_from_the_others_and_its_intervals_hold() {
    for kind in Kind::ALL {
        let mut misses = 0;
        // Every other plant: each of their searches over all kinds is long.
        for mut plant in plants(kind).step_by(2) {
            if kind == Kind::DoubleIntegrating {
                (plant.gain, plant.noise) = (plant.gain / 50.0, plant.noise / 10.0);
            }
            let record =
                plant.record(&Events { setpoint: &at_rest, load: &at_rest, hand: &pulses(10.0, 40) });
            let answer = answer(&record, None, Load::Constant);
            assert_eq!(answer.model, Some(kind), "{plant:?}\n{}\n{:?}", answer.choice, answer.candidates);
            misses += missed(&answer, &plant);
            if let Some([low, high]) = answer.confidence.unwrap().lag {
                misses += u32::from(!(low <= plant.lag && plant.lag <= high));
            }
        }
        // Of 8 or 12 intervals.
        assert!(misses <= 3, "{kind:?}: {misses}");
    }
}

/// Constant, drifting and stepping loads, in open and in closed loop.
#[test]
fn a_load_that_steps_or_drifts_does_not_pass_for_the_process() {
    let stepping = |k: usize| {
        if k < 130 {
            0.0
        } else if k < 290 {
            4.0
        } else {
            -2.0
        }
    };
    #[expect(clippy::cast_precision_loss, reason = "a row")]
    let drifting = |k: usize| 0.02 * k as f64;
    let law = |plant: &Plant| Law {
        gain: 0.35 / (plant.gain * (plant.dead_time + 2.0)),
        integral_time: Some(8.0 * (plant.dead_time + 2.0)),
        derivative_time: 0.0,
    };
    for (name, load, known) in [
        ("stepping", &stepping as &dyn Fn(usize) -> f64, Load::Constant),
        ("drifting", &drifting, Load::Drifting),
    ] {
        for closed in [false, true] {
            let mut misses = 0;
            for mut plant in plants(Kind::Integrating) {
                let moves = steps(200.0 * plant.gain.abs(), 90);
                let events = if closed {
                    plant.law = Some(law(&plant));
                    Events { setpoint: &moves, load, hand: &no_hand }
                } else {
                    Events { setpoint: &at_rest, load, hand: &pulses(10.0, 40) }
                };
                let answer = answer(&plant.record(&events), Some(Kind::Integrating), known);
                assert_ne!(answer.verdict, Verdict::Refused, "{name} {closed} {:?}", answer.reasons);
                let gain = answer.process.unwrap().process_gain / plant.gain;
                assert!((0.6..1.6).contains(&gain), "{name} {closed} {plant:?}: {gain}");
                misses += missed(&answer, &plant);
            }
            assert!(misses <= 4, "{name}, closed {closed}: {misses}");
        }
    }
}

/// A hand in the middle of a record in automatic, and a valve at its limit, are movement from outside.
#[test]
fn mode_changes_and_limits_identify_where_the_setpoint_does_not_move() {
    let by_hand = |k: usize| (150..190).contains(&k).then(|| if k < 170 { 9.0 } else { -9.0 });
    let upset = |k: usize| if (100..160).contains(&k) { 14.0 } else { 0.0 };
    for (name, hand, load, limits) in [
        ("mode", &by_hand as &dyn Fn(usize) -> Option<f64>, &at_rest as &dyn Fn(usize) -> f64, [-1e9, 1e9]),
        ("limit", &no_hand, &upset, [-10.0, 1e9]),
    ] {
        let mut misses = 0;
        for mut plant in plants(Kind::Integrating) {
            plant.noise /= 5.0;
            plant.law = Some(Law {
                gain: 0.35 / (plant.gain * (plant.dead_time + 2.0)),
                integral_time: Some(8.0 * (plant.dead_time + 2.0)),
                derivative_time: 0.0,
            });
            plant.limits = limits;
            let record = plant.record(&Events { setpoint: &at_rest, load, hand });
            let answer = answer(&record, Some(Kind::Integrating), Load::Constant);
            let excitation = answer.excitation;
            assert!(excitation.closed_loop && excitation.any(), "{name}: {excitation:?}");
            if answer.verdict != Verdict::Refused {
                misses += missed(&answer, &plant);
            }
        }
        assert!(misses <= 4, "{name}: {misses}");
    }
}
