//! The running controller comes back with intervals that hold it.

use holdup::record::controller::{Estimate, recover};

use super::plant::{Events, Law, Plant, no_hand, steps};

fn holds(estimate: Estimate, value: f64) -> bool {
    // An exact law leaves an interval of rounding: 1e-9 of the value.
    let slack = 1e-9 * value.abs();
    estimate.interval[0] - slack <= value && value <= estimate.interval[1] + slack
}

/// P, PI and PID laws on plants with noise, under setpoint steps, with what the record shows of the output rounded or not.
#[test]
fn proportional_integral_and_derivative_action_are_recovered() {
    let (mut asked, mut missed) = (0, 0);
    for seed in 0..12_u32 {
        let dead_time = 1.3 + 0.7 * f64::from(seed);
        let gain = 0.002 * if seed.is_multiple_of(2) { 1.0 } else { -1.0 };
        let proportional = 0.3 / (gain * (dead_time + 1.0));
        for (structure, integral_time, derivative_time) in [
            ("P", None, 0.0),
            ("PI", Some(8.0 * (dead_time + 1.0)), 0.0),
            ("PID", Some(8.0 * (dead_time + 1.0)), 0.5 * (dead_time + 1.0)),
        ] {
            let mut plant = Plant::integrating(gain, dead_time, u64::from(seed));
            plant.law = Some(Law { gain: proportional, integral_time, derivative_time });
            plant.noise = 0.02;
            let record = plant.record(&Events { setpoint: &steps(1.0, 90), load: &|_| 0.0, hand: &no_hand });
            let found = recover(&record).unwrap();
            assert_eq!(found.structure, structure, "{plant:?}\n{found:?}");
            let near = |estimate: Estimate, value: f64| {
                assert!((estimate.value / value - 1.0).abs() < 0.02, "{plant:?}\n{found:?}");
                (1, u32::from(!holds(estimate, value)))
            };
            let mut count = |(one, miss): (u32, u32)| (asked, missed) = (asked + one, missed + miss);
            count(near(found.proportional_gain, proportional));
            assert_eq!(found.integral_time.is_some(), integral_time.is_some());
            if let (Some(estimate), Some(value)) = (found.integral_time, integral_time) {
                count(near(estimate, value));
            }
            if let Some(estimate) = found.derivative_time {
                count(near(estimate, derivative_time));
            }
        }
    }
    // Of 72 intervals of 95 % more than 10 miss with a probability of 0.1 %.
    assert!(missed <= 10, "{missed} of {asked}");
}

/// What the historian rounds and what it stamps a little off is not the controller's own value: the interval allows for it.
#[test]
fn a_rounded_record_gives_the_controller_within_its_interval() {
    let (mut asked, mut missed) = (0, 0);
    for seed in 0..12_u32 {
        let dead_time = 2.3 + 0.5 * f64::from(seed);
        let law = Law {
            gain: 150.0 / (dead_time + 1.0),
            integral_time: Some(10.0 * (dead_time + 1.0)),
            derivative_time: 0.0,
        };
        let mut plant = Plant::integrating(0.002, dead_time, u64::from(seed));
        (plant.law, plant.noise) = (Some(law), 0.02);
        let record = plant.record(&Events { setpoint: &steps(1.0, 90), load: &|_| 0.0, hand: &no_hand });
        // The controller saw the level to the last digit; the historian keeps hundredths of it and tenths of the output.
        let rounded = |values: &[f64], unit: f64| -> Vec<f64> {
            values.iter().map(|value| (value / unit).round() * unit).collect()
        };
        let kept = holdup::record::Record::new(
            record.time().to_vec(),
            rounded(record.controlled_variable(), 0.01),
            rounded(record.manipulated_variable(), 0.1),
        )
        .unwrap()
        .with_setpoint(record.setpoint().unwrap().to_vec())
        .unwrap();
        let found = recover(&kept).unwrap();
        assert_eq!(found.structure, "PI", "{found:?}");
        for (estimate, value) in
            [(found.proportional_gain, law.gain), (found.integral_time.unwrap(), law.integral_time.unwrap())]
        {
            assert!((estimate.value / value - 1.0).abs() < 0.08, "{value} {found:?}");
            asked += 1;
            missed += u32::from(!holds(estimate, value));
        }
    }
    // Of 24 intervals of 95 % more than 5 miss with a probability of 0.1 %.
    assert!(missed <= 5, "{missed} of {asked}");
}
