//! Sudden changes of the load are found where they are, and nowhere else.

use holdup::record::identify::Kind;
use holdup::record::{Identification, IdentifyOptions, LoadStep, Record, Verdict, identify};

use super::plant::{Events, Law, Plant, no_hand, pulses, steps};

fn answer(record: &Record, kind: Option<Kind>) -> Identification {
    let options = IdentifyOptions { kind, greatest_dead_time: Some(40.0), ..IdentifyOptions::default() };
    identify(record, &options).unwrap()
}

fn within([low, high]: [f64; 2], value: f64) -> bool {
    low <= value && value <= high
}

/// The noise is a fiftieth of what the pulses do; the law is slow enough to leave the step in the record.
fn plants() -> impl Iterator<Item = Plant> {
    (0..8_u32).map(|seed| {
        let gain = 0.001 * (1.0 + f64::from(seed * 5 % 8)) * if seed.is_multiple_of(2) { 1.0 } else { -1.0 };
        let mut plant = Plant::integrating(gain, 0.7 + 1.37 * f64::from(seed), u64::from(seed));
        plant.noise = 10.0 * gain.abs() * 40.0 / 50.0;
        plant
    })
}

fn law(plant: &Plant) -> Law {
    Law {
        gain: 0.35 / (plant.gain * (plant.dead_time + 2.0)),
        integral_time: Some(8.0 * (plant.dead_time + 2.0)),
        derivative_time: 0.0,
    }
}

/// Two steps: from row 130 on 8 units of the valve, from row 290 on 6 less.
fn two(k: usize) -> f64 {
    if k < 130 {
        0.0
    } else if k < 290 {
        8.0
    } else {
        2.0
    }
}

#[test]
fn steps_are_found_with_their_times_and_sizes_in_open_and_in_closed_loop() {
    for closed in [false, true] {
        let (mut asked, mut missed, mut gains_missed) = (0, 0, 0);
        for mut plant in plants() {
            let moves = steps(200.0 * plant.gain.abs(), 90);
            let by_hand = pulses(10.0, 40);
            let events = if closed {
                plant.law = Some(law(&plant));
                Events { setpoint: &moves, load: &two, hand: &no_hand }
            } else {
                Events { setpoint: &|_| 0.0, load: &two, hand: &by_hand }
            };
            let answer = answer(&plant.record(&events), Some(Kind::Integrating));
            assert_ne!(answer.verdict, Verdict::Refused, "{:?}", answer.reasons);
            let found: &[LoadStep] = &answer.load_steps;
            assert_eq!(found.len(), 2, "closed {closed} {plant:?}: {found:?}");
            for (step, (time, size)) in found.iter().zip([(130.0, 8.0), (290.0, -6.0)]) {
                // A tenth of the noise of the pulses bends a step of 6 by less than 6 rows.
                assert!((step.time - time).abs() < 6.0, "closed {closed} {plant:?}: {found:?}");
                assert!((step.size / size - 1.0).abs() < 0.3, "closed {closed} {plant:?}: {found:?}");
                asked += 2;
                missed += u32::from(!within(step.time_interval, time));
                missed += u32::from(!within(step.size_interval, size));
            }
            gains_missed += u32::from(!within(answer.confidence.unwrap().process_gain, plant.gain));
        }
        // Of 32 intervals of 95 % more than 6 miss with a probability of 0.3 %, of 8 more than 2 with 0.6 %.
        assert!(missed <= 6, "closed {closed}: {missed} of {asked}");
        assert!(gains_missed <= 2, "closed {closed}: {gains_missed}");
    }
}

/// What passed for a load that wanders is now known: the interval of the gain is narrower, and holds.
#[test]
fn a_step_that_is_found_tells_the_gain_better() {
    let mut narrower = 0;
    for plant in plants() {
        let record = plant.record(&Events { setpoint: &|_| 0.0, load: &two, hand: &pulses(10.0, 40) });
        let width = |load_steps: usize| {
            let options = IdentifyOptions {
                kind: Some(Kind::Integrating),
                greatest_dead_time: Some(40.0),
                load_steps: Some(load_steps),
                ..IdentifyOptions::default()
            };
            let [low, high] = identify(&record, &options).unwrap().confidence.unwrap().process_gain;
            high - low
        };
        narrower += u32::from(width(3) < 0.7 * width(0));
    }
    assert!(narrower >= 7, "{narrower} of 8");
}

/// A step is not put down to another kind of process, nor another kind of process to steps.
#[test]
fn kinds_and_steps_are_told_apart() {
    for kind in [Kind::Integrating, Kind::IntegratingWithLag, Kind::FirstOrder] {
        for mut plant in plants().step_by(3) {
            (plant.kind, plant.lag) = (kind, 20.0);
            let hand = pulses(10.0, 40);
            let stepping =
                Events { setpoint: &|_| 0.0, load: &|k| if k < 200 { 0.0 } else { 10.0 }, hand: &hand };
            let found = answer(&plant.record(&stepping), None);
            assert_eq!(found.model, Some(kind), "{plant:?} {} {:?}", found.choice, found.load_steps);
            assert_eq!(found.load_steps.len(), 1, "{plant:?} {:?}", found.load_steps);
            assert!((found.load_steps[0].time - 200.0).abs() < 6.0, "{plant:?} {:?}", found.load_steps);
            let quiet = Events { load: &|_| 0.0, ..stepping };
            let found = answer(&plant.record(&quiet), None);
            assert_eq!((found.model, found.load_steps.len()), (Some(kind), 0), "{plant:?} {}", found.choice);
        }
    }
}

/// The load follows the units of time, level and valve; 1e-3: the search for the noise stops a step earlier or later.
#[test]
fn times_and_sizes_follow_the_units() {
    let plant = plants().nth(3).unwrap();
    let record = plant.record(&Events { setpoint: &|_| 0.0, load: &two, hand: &pulses(10.0, 40) });
    let plain = answer(&record, Some(Kind::Integrating)).load_steps;
    let times = |values: &[f64], factor: f64| values.iter().map(|value| factor * value).collect::<Vec<f64>>();
    let scaled = Record::new(
        times(record.time(), 4.0),
        times(record.controlled_variable(), 0.5),
        times(record.manipulated_variable(), 8.0),
    )
    .unwrap()
    .with_operation(record.operation().unwrap().to_vec())
    .unwrap();
    let options = IdentifyOptions {
        kind: Some(Kind::Integrating),
        greatest_dead_time: Some(160.0),
        ..IdentifyOptions::default()
    };
    let other = identify(&scaled, &options).unwrap().load_steps;
    assert_eq!(plain.len(), other.len());
    for (plain, other) in plain.iter().zip(&other) {
        assert!((other.time / plain.time / 4.0 - 1.0).abs() < 1e-3, "{plain:?} {other:?}");
        assert!((other.size / plain.size / 8.0 - 1.0).abs() < 1e-3, "{plain:?} {other:?}");
    }
}
