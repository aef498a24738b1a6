//! Closed forms and printed numbers of the frequency analysis.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

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

fn pid(kc: f64, ti: f64, td: f64) -> Controller {
    let pi = Controller::proportional(kc).unwrap().with_integral_time(Seconds(ti)).unwrap();
    pi.with_derivative_time(Seconds(td)).unwrap()
}

#[test]
fn lower_gain_margins_are_those_of_the_architecture() {
    let observer = Observer::new(0.3).unwrap();
    let m = of(&plain(1.0, 1.0), &pid(0.3, 8.0, 0.0).with_observer(observer));
    assert_near(m.gain_margin_low.unwrap(), 0.241, 5e-4);
    assert_near(m.phase_crossovers[0], 0.168, 5e-4);
    let m = of(&plain(1.0, 1.0), &pid(0.3, 0.9, 1.2));
    assert_near(m.gain_margin_low.unwrap(), 0.420, 5e-4);
    // PI on the plain integrator has none.
    assert_eq!(of(&plain(1.0, 1.0), &pid(0.3, 8.0, 0.0)).gain_margin_low, None);
}

#[test]
fn pi_with_integral_time_up_to_the_dead_time_is_unstable_at_any_gain() {
    for ti in [0.3, 0.9, 1.0] {
        for kc in [0.01, 0.1, 0.5, 2.0] {
            let m = of(&plain(1.0, 1.0), &pid(kc, ti, 0.0));
            assert!(!m.stable && m.unstable_poles.unwrap() >= 2, "Ti {ti}, Kc {kc}");
        }
    }
    assert!(of(&plain(1.0, 1.0), &pid(0.001, 1.01, 0.0)).stable);
}

#[test]
fn neutral_loop_is_limited_by_infinite_frequency() {
    // |L| rises to its limit 0.95: no finite frequency attains the peaks.
    let m = of(&plain(1.0, 1.0), &pid(0.95 / 20.0, 30.0, 20.0));
    assert!(m.stable);
    let q = m.high_frequency_gain;
    assert_near(q, 0.95, ROUNDING);
    assert_eq!(m.gain_margin.unwrap(), 1.0 / q);
    assert_eq!(m.sensitivity_peak.unwrap(), 1.0 / (1.0 - q));
    assert_eq!(m.complementary_sensitivity_peak.unwrap(), q / (1.0 - q));
    assert_eq!((m.sensitivity_peak_frequency, m.complementary_sensitivity_peak_frequency), (None, None));
    assert!(m.warnings.iter().any(|w| w.contains("limit at infinite frequency")));
    // |L| falls to its limit: the first phase crossover is worse than the limit.
    let m = of(
        &plain(1.0, 1.0),
        &Controller::proportional(1.4).unwrap().with_derivative_time(Seconds(0.5)).unwrap(),
    );
    assert!(m.stable && m.gain_margin.unwrap() < 1.0 / 0.7 && m.sensitivity_peak.unwrap() > 1.0 / 0.3);
    assert!(m.sensitivity_peak_frequency.is_some());
    // At 1 and above there are infinitely many unstable poles.
    for kc in [0.5, 0.6] {
        let pd = Controller::proportional(kc).unwrap().with_derivative_time(Seconds(2.0)).unwrap();
        let m = of(&plain(1.0, 1.0), &pd);
        assert_eq!((m.stable, m.unstable_poles, m.gain_margin), (false, None, None));
        assert_eq!(m.phase_crossovers.len(), 32);
    }
}

#[test]
fn a_million_rad_per_second_of_bandwidth_changes_little_and_hides_nothing() {
    for q in [0.7, 0.95] {
        let ideal = Controller::proportional(q / 2.0).unwrap().with_derivative_time(Seconds(2.0)).unwrap();
        let filtered = ideal.with_filter_bandwidth(1e6).unwrap();
        let (a, b) = (of(&plain(1.0, 1.0), &ideal), of(&plain(1.0, 1.0), &filtered));
        // The filter delays by 1e-6 dead times; M_s amplifies that by up to M_s.
        assert_near(a.sensitivity_peak.unwrap() / b.sensitivity_peak.unwrap(), 1.0, 1e-4);
        assert_near(a.gain_margin.unwrap(), b.gain_margin.unwrap(), 1e-6);
        // Rising from below, |L| has its maximum far up the band, less than the limit of the unfiltered loop
        // by no more than the filter takes there: both N·Td and ω are large.
        let far = pid(q / 20.0, 30.0, 20.0).with_filter_bandwidth(1e6).unwrap();
        let m = of(&plain(1.0, 1.0), &far);
        assert_near(m.sensitivity_peak.unwrap() * (1.0 - q), 1.0, 1e-5);
        assert!(m.sensitivity_peak_frequency.unwrap() > 10.0 || q < 0.9);
    }
}

#[test]
fn wrong_sign_of_the_gain_is_one_unstable_pole() {
    let m = of(&plain(-1.0, 1.0), &Controller::proportional(0.3).unwrap());
    assert_eq!((m.stable, m.unstable_poles), (false, Some(1)));
    assert!(m.warnings[0].contains("1 closed-loop pole"));
    let both = of(&plain(-1.0, 1.0), &Controller::proportional(-0.3).unwrap());
    assert_eq!(both, of(&plain(1.0, 1.0), &Controller::proportional(0.3).unwrap()));
}

#[test]
fn a_pole_on_the_axis_is_not_stable() {
    let m = of(&plain(1.0, 1.0), &Controller::proportional(FRAC_PI_2).unwrap());
    assert_eq!((m.stable, m.unstable_poles, m.phase_margin), (false, None, None));
    assert_near(m.gain_crossovers[0], FRAC_PI_2, ROUNDING);
}

#[test]
fn numbers_out_of_reach_are_named_and_none_hangs_or_panics() {
    let extremes = [1e-300, 1e-100, 1e-30, 1e-9, 1.0, 1e9, 1e30, 1e100, 1e300];
    for k in extremes {
        for d in extremes {
            for (ti, td) in extremes.iter().zip(extremes.iter().rev()) {
                let answer = margins(&ClosedLoop::new(&plain(k, d), &pid(0.3, *ti, *td)));
                if let Err(error) = answer {
                    assert!(error.to_string().contains("1e-100"), "{error}");
                }
            }
        }
    }
}

#[test]
fn json_has_the_names_of_the_contract() {
    let m = of(&plain(1.0, 1.0), &Controller::proportional(0.5).unwrap());
    let json = serde_json::to_value(&m).unwrap();
    for name in [
        "stable",
        "gain_margin",
        "gain_margin_low",
        "phase_margin_deg",
        "delay_margin_s",
        "delay_margin_low_s",
        "gain_crossovers_rad_s",
        "phase_crossovers_rad_s",
        "sensitivity_peak",
        "sensitivity_peak_rad_s",
        "complementary_sensitivity_peak",
        "high_frequency_gain",
    ] {
        assert!(json.get(name).is_some(), "{name}");
    }
    assert_eq!(json["phase_margin_deg"].as_f64(), m.phase_margin.map(holdup::model::Radians::degrees));
    assert!(json.get("warnings").is_none());
}
