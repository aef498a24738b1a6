//! What does not identify the process is refused.

use holdup::model::Seconds;
use holdup::record::identify::point_fit;
use holdup::record::{IdentifyOptions, Record, Verdict, identify};
use num_complex::Complex;

use super::plant::{Events, Law, Plant, no_hand};

/// In automatic at a constant setpoint, with a linear controller of any structure: noise and load alone move the loop.
#[test]
fn a_constant_setpoint_under_a_linear_controller_is_refused_with_a_test() {
    for seed in 0..6_u32 {
        let dead_time = 1.3 + 1.9 * f64::from(seed);
        let gain = 0.002;
        let mut plant = Plant::integrating(gain, dead_time, u64::from(seed));
        plant.noise = 0.05;
        plant.law = Some(Law {
            gain: 0.3 / (gain * (dead_time + 1.0)),
            integral_time: (seed % 3 > 0).then_some(8.0 * (dead_time + 1.0)),
            derivative_time: if seed % 3 == 2 { 0.4 * dead_time } else { 0.0 },
        });
        let load = |k: usize| if k < 200 { 0.0 } else { 3.0 };
        let record = plant.record(&Events { setpoint: &|_| 0.0, load: &load, hand: &no_hand });
        let answer = identify(&record, &IdentifyOptions::default()).unwrap();
        assert_eq!(answer.verdict, Verdict::Refused, "{plant:?} {:?}", answer.reasons);
        assert!(answer.process.is_none() && answer.confidence.is_none());
        assert!(answer.reasons[0].contains("controller"), "{:?}", answer.reasons);
        assert!(answer.test.is_some_and(|test| test.pulse > 0.0));
    }
}

/// A forced steady oscillation: the fit of the integrator is perfect and returns the controller, whatever the process.
/// K = ω/|C(jω)| and ω·d = π/2 + arg C(jω). The rows hold the controller's output for a second, which the sampled law's own
/// C(e^(jω)) has; half of that row is the dead time's.
#[test]
fn of_a_forced_steady_oscillation_the_fit_is_perfect_returns_the_controller_and_is_refused() {
    for (period, proportional, integral_time) in [(120.0, 3.0, 80.0), (90.0, -1.7, 300.0), (150.0, 0.6, 45.0)]
    {
        let frequency = std::f64::consts::TAU / period;
        let time: Vec<f64> = (0..1200).map(f64::from).collect();
        let level: Vec<f64> = time.iter().map(|t| (frequency * t).sin()).collect();
        // C(e^(jω)) of the sampled PI law, on −y.
        let shift = Complex::from_polar(1.0, frequency);
        let law = proportional * (1.0 + (1.0 / integral_time) * shift / (shift - 1.0));
        let valve: Vec<f64> =
            time.iter().map(|t| -(law * Complex::from_polar(1.0, frequency * t)).im).collect();
        let record = Record::new(
            time.clone(),
            level.iter().map(|value| 50.0 + value).collect(),
            valve.iter().map(|value| 30.0 + value).collect(),
        )
        .unwrap()
        .with_setpoint(vec![50.0; time.len()])
        .unwrap();
        let answer = identify(&record, &IdentifyOptions::default()).unwrap();
        assert_eq!(answer.verdict, Verdict::Refused, "{:?}", answer.reasons);
        assert!(answer.reasons[0].contains("returns the controller"), "{:?}", answer.reasons);

        // That is what would have been returned. Over whole rows: what the input was before the record nobody knows, so that the
        // fit is that of a long record; 3 % for its two ends.
        let fit = point_fit(&record, Seconds(period)).unwrap();
        let [size, angle] = [law.norm(), law.arg()];
        // A held sine is smaller by sin(ω/2)/(ω/2) and half a row late.
        let gain = frequency / size / ((frequency / 2.0).sin() / (frequency / 2.0));
        let quarter = std::f64::consts::FRAC_PI_2;
        let turned = if proportional > 0.0 { angle } else { angle - angle.signum() * std::f64::consts::PI };
        let dead_time = (quarter + turned) / frequency - 0.5;
        assert!((fit.process_gain.abs() / gain - 1.0).abs() < 0.03, "{fit:?} {gain}");
        assert!((fit.dead_time - dead_time).abs() < 0.03 * period, "{fit:?} {dead_time}");
    }
}
