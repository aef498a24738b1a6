//! Closed forms and printed numbers of the frequency analysis.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use holdup::analysis::frequency::{Margins, margins};
use holdup::model::{ClosedLoop, Controller, Observer, Process, Seconds};

fn plain(k: f64, d: f64) -> Process {
    Process::integrating(k, Seconds(d)).unwrap()
}

fn of(process: &Process, controller: &Controller) -> Margins {
    margins(&ClosedLoop::new(process, controller)).unwrap()
}

fn assert_near(got: f64, expected: f64, tolerance: f64) {
    assert!((got - expected).abs() <= tolerance, "got {got}, expected {expected} ± {tolerance}");
}

/// A few units of rounding: the closed forms below are met to that.
const ROUNDING: f64 = 1e-13;

#[test]
fn proportional_loop_with_a_quarter_of_pi_has_gain_margin_two_and_phase_margin_45_degrees() {
    let m = of(&plain(0.5, 3.0), &Controller::proportional(FRAC_PI_4 / 1.5).unwrap());
    assert!(m.stable);
    assert_near(m.gain_margin.unwrap(), 2.0, ROUNDING);
    assert_near(m.phase_margin.unwrap().degrees(), 45.0, 100.0 * ROUNDING);
    // Phase margin over crossover: (π/4)/(π/4) dead times.
    assert_near(m.delay_margin.unwrap().0, 3.0, 3.0 * ROUNDING);
    assert_near(m.gain_crossovers[0], FRAC_PI_4 / 3.0, ROUNDING);
    assert_near(m.phase_crossovers[0], FRAC_PI_2 / 3.0, ROUNDING);
    assert_eq!((m.gain_margin_low, m.delay_margin_low, m.unstable_poles), (None, None, Some(0)));
    // Phase crossovers at π/2 + 2πk.
    assert_eq!(m.phase_crossovers.len(), 32);
    assert_near(m.phase_crossovers[31], (FRAC_PI_2 + 62.0 * std::f64::consts::PI) / 3.0, 100.0 * ROUNDING);
}

#[test]
fn simc_pi_has_its_known_margins() {
    let (k, d) = (0.0506, 6.0);
    let simc = Controller::proportional(0.5 / (k * d)).unwrap().with_integral_time(Seconds(8.0 * d)).unwrap();
    let m = of(&plain(k, d), &simc);
    // Half a unit of the last digit known.
    assert_near(m.gain_margin.unwrap(), 2.96340, 5e-6);
    assert_near(m.phase_margin.unwrap().degrees(), 46.8643, 5e-5);
    assert_near(m.sensitivity_peak.unwrap(), 1.70352, 5e-6);
    assert_near(m.delay_margin.unwrap().0 / d, 1.58964, 5e-6);
}

#[test]
fn verdict_of_a_proportional_loop_flips_within_1e_9_of_half_pi() {
    for (factor, unstable) in [(1.0 - 1e-9, 0), (1.0 + 1e-9, 2)] {
        let m = of(&plain(1.0, 1.0), &Controller::proportional(FRAC_PI_2 * factor).unwrap());
        assert_eq!(m.stable, unstable == 0);
        assert_eq!(m.unstable_poles, Some(unstable));
    }
}

#[test]
fn paper_loops_have_the_margins_that_independent_programs_found() {
    let process = plain(0.0506, 6.0);
    let ideal = Controller::proportional(1.5321).unwrap().with_derivative_time(Seconds(1.0343)).unwrap();
    let m = of(&process, &ideal);
    assert_near(m.gain_margin.unwrap(), 3.854, 5e-4);
    assert_near(m.phase_margin.unwrap().degrees(), 67.86, 5e-3);
    assert_near(m.sensitivity_peak.unwrap(), 1.432, 5e-4);
    let m = of(&process, &ideal.with_observer(Observer::new(1.5321).unwrap()));
    assert_near(m.gain_margin.unwrap(), 2.12446, 5e-6);
    assert_near(m.phase_margin.unwrap().degrees(), 33.411, 5e-4);
    assert_near(m.sensitivity_peak.unwrap(), 2.17946, 5e-6);
    assert_near(m.delay_margin.unwrap().0, 4.494, 5e-4);
    // As simulated: parallel form (derivative gain 1.0343), filtered at 100 rad/s.
    let parallel = Controller::proportional(1.5321)
        .unwrap()
        .with_derivative_time(Seconds(1.0343 / 1.5321))
        .unwrap()
        .with_filter_bandwidth(100.0)
        .unwrap();
    let m = of(&process, &parallel);
    assert_near(m.gain_margin.unwrap(), 3.72, 5e-3);
    assert_near(m.phase_margin.unwrap().degrees(), 66.3, 5e-2);
    assert_near(m.sensitivity_peak.unwrap(), 1.46, 5e-3);
    let m = of(&process, &parallel.with_observer(Observer::new(1.5321).unwrap()));
    assert_near(m.gain_margin.unwrap(), 2.07, 5e-3);
    assert_near(m.phase_margin.unwrap().degrees(), 32.5, 5e-2);
    assert_near(m.sensitivity_peak.unwrap(), 2.24, 5e-3);
}
