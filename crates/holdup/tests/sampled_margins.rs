//! The margins of the sampled loop against closed forms, the law's own code, brute force and the continuous loop.
#![expect(clippy::unwrap_used, reason = "helpers of tests may unwrap")]

use std::f64::consts::PI;

use holdup::analysis::frequency::sampled::{
    LargestPeriod, SampledMargins, largest_sample_period, sampled_margins,
};
use holdup::analysis::frequency::{Margins, margins};
use holdup::analysis::response::Scenario;
use holdup::analysis::response::sampled::{Equipment, EquipmentSettings, SampledLoop};
use holdup::model::notation::{read_controller, read_process};
use holdup::model::{
    ClosedLoop, Compensator, CompensatorLaw, Controller, Lead, Process, Seconds, sampled_law,
};

fn smith(lead: Option<Lead>) -> Controller {
    let law = CompensatorLaw::ModifiedSmith { main_gain: 0.8, disturbance_gain: 0.35, lead };
    Controller::from(Compensator::new(law, 1.0, Seconds(1.0)).unwrap())
}

/// Every kind of law on every kind of process that it runs on.
fn loops() -> Vec<(Process, Controller)> {
    let mut loops: Vec<(Process, Controller)> = [
        ("K=1,d=1", "Kc=0.4"),
        ("K=1,d=1", "Kc=0.4,Ti=8"),
        ("K=-1,d=1", "Kc=-0.4,Td=0.4,Tf=0.2"),
        ("K=1,d=1", "Kc=0.4,Td=0.4"),
        ("K=1,d=1", "Kc=0.4,Ti=8,Td=0.4,Tf=0.05"),
        ("K=1,d=1", "Kc=0.4,Td=0.4,Tf=0.2,Ko=0.3"),
        ("K=1,d=1", "Kc=0.3,Ti=12,Ko=0.2,Km=0.8,dm=1.3"),
        ("K=1,d=1,T=0.7", "Kc=0.3,Ti=10,Td=0.8,Tf=0.2"),
        ("K=0.2,d=1,integrators=2", "Kc=0.15,Td=6,Tf=0.5"),
        ("K=0.2,d=1,T=0.1,integrators=2", "Kc=0.02,Ti=40,Td=15,Tf=0.5"),
    ]
    .map(|(process, controller)| (read_process(process).unwrap(), read_controller(controller).unwrap()))
    .to_vec();
    let process = read_process("K=1,d=1").unwrap();
    loops.push((process, smith(None)));
    loops.push((process, smith(Some(Lead { derivative_time: 0.4, filter_time: 0.2 }))));
    loops
}

fn of(process: &Process, controller: &Controller, h: f64) -> SampledMargins {
    let law = sampled_law(process, controller, Seconds(h)).unwrap();
    sampled_margins(&law, process, Seconds(h), Seconds(0.0)).unwrap()
}

#[test]
fn p_control_with_whole_samples_of_dead_time_has_the_margins_of_the_textbook() {
    // L = κ/((z − 1)·z^l): arg L = −π at θ = π/(2l + 1), where |z − 1| = 2·sin(θ/2), so κ_max is that.
    for l in [1u32, 2, 5, 40] {
        let (process, p) =
            (Process::integrating(0.5, Seconds(f64::from(l))).unwrap(), read_controller("Kc=0.02").unwrap());
        let found = of(&process, &p, 1.0).margins;
        let theta = PI / f64::from(2 * l + 1);
        let expected = 2.0 * (0.5 * theta).sin() / 0.01;
        assert!((found.gain_margin.unwrap() / expected - 1.0).abs() < 1e-13, "{l} {found:?}");
        assert!((found.phase_crossovers[0] / theta - 1.0).abs() < 1e-13);
        // |L| = 1 at 2·sin(θ/2) = 0.01, with phase −π/2 − θ/2 − l·θ.
        let crossing = 2.0 * 0.005f64.asin();
        assert!((found.gain_crossovers[0] / crossing - 1.0).abs() < 1e-13);
        let phase = PI / 2.0 - crossing * (0.5 + f64::from(l));
        assert!((found.phase_margin.unwrap().0 - phase).abs() < 1e-13);
        // At θ = π L is real: (−1)^(l+1)·κ/2.
        assert!((found.high_frequency_gain - 0.005).abs() < 1e-16);
    }
}

#[test]
fn half_a_sample_of_dead_time_has_the_margin_of_the_root_condition() {
    // h = 1, d = 1.5: (z − 1)·z² + κ·(z + 1)/2 loses a pair at cos θ = 1/2 … : by the Jury conditions for
    // z³ − z² + κ/2·z + κ/2: 1 − κ²/4 > |κ/2 + κ/2|, so κ < 2·(√2 − 1).
    let process = Process::integrating(1.0, Seconds(1.5)).unwrap();
    let found = of(&process, &read_controller("Kc=0.1").unwrap(), 1.0).margins;
    let expected = 2.0 * (2f64.sqrt() - 1.0) / 0.1;
    assert!((found.gain_margin.unwrap() / expected - 1.0).abs() < 1e-13, "{found:?}");
}

#[test]
fn the_delay_margin_is_the_dead_time_at_which_the_jury_conditions_fail() {
    // κ = 0.7 at h = 1: stable at d = 1.5 (κ < 0.828), unstable at d = 2 (κ < 0.618). Between, with part f of a
    // sample, z³ − z² + κ·(1 − f)·z + κ·f: the condition |a0² − 1| > |a0·a2 − a1| is 1 − κ²f² = κ·(1 − f) + κf.
    let process = Process::integrating(1.0, Seconds(1.5)).unwrap();
    let found = of(&process, &read_controller("Kc=0.7").unwrap(), 1.0).margins;
    // 1 − κ²f² = |κ·f·(−1) − κ·(1 − f)| = κ: f = √(1 − κ)/κ.
    let limit = 1.0 + (1.0 - 0.7f64).sqrt() / 0.7;
    assert!((1.5 + found.delay_margin.unwrap().0 - limit).abs() < 1e-12, "{found:?}");
    assert_eq!(found.delay_margin_low, None);
}

/// Growth of the error from the middle of a long run to its end.
fn growth(process: &Process, controller: &Controller, h: f64, factor: f64) -> f64 {
    let equipment = Equipment::new(EquipmentSettings { sample_period: h, ..Default::default() }).unwrap();
    let actual = {
        let (gain, dead_time) = (process.process_gain() * factor, Seconds(process.dead_time()));
        let base = match process.integrators() {
            1 => Process::integrating(gain, dead_time).unwrap(),
            _ => Process::double_integrating(gain, dead_time).unwrap(),
        };
        process.lag().map_or(base, |lag| base.with_lag(Seconds(lag)).unwrap())
    };
    let horizon = 20_000.0;
    let sampled = SampledLoop::new(process, controller, &equipment).unwrap().on(&actual);
    let window = |from: f64| (0..4000).map(move |k| from + 0.05 * f64::from(k));
    let times: Vec<f64> = window(10_000.0).chain(window(19_790.0)).collect();
    let step = Scenario::unit_setpoint_step(Seconds(horizon)).unwrap();
    let (_, signals) = sampled.simulate(&step, &[], &times).unwrap();
    let y = signals.signals.controlled_variable;
    if y.len() < times.len() {
        return f64::INFINITY; // it left the range of numbers
    }
    let size = |part: &[f64]| part.iter().fold(0.0f64, |most, y| most.max((y - 1.0).abs()));
    size(&y[4000..]) / size(&y[..4000])
}

#[test]
fn just_below_the_gain_margin_the_simulated_loop_settles_and_just_above_it_does_not() {
    for (index, (process, controller)) in loops().into_iter().enumerate() {
        let h = [0.37, 0.25][index % 2];
        let margin = of(&process, &controller, h).margins.gain_margin.unwrap();
        let (below, above) = (
            growth(&process, &controller, h, 0.999 * margin),
            growth(&process, &controller, h, 1.001 * margin),
        );
        assert!(below < 0.8, "{controller:?} {margin} {below}");
        assert!(above > 1.25, "{controller:?} {margin} {above}");
    }
}

#[test]
fn margins_of_fast_samples_are_those_of_the_continuous_loop_in_first_order() {
    for (process, controller) in loops() {
        let exact = margins(&ClosedLoop::new(&process, &controller)).unwrap();
        let figures: [fn(&Margins) -> f64; 6] = [
            |m| m.gain_margin.unwrap(),
            |m| m.phase_margin.unwrap().0,
            |m| m.delay_margin.unwrap().0,
            |m| m.sensitivity_peak.unwrap(),
            |m| m.complementary_sensitivity_peak.unwrap(),
            |m| m.gain_crossovers[0],
        ];
        let found = [0.02, 0.01, 0.005].map(|h| of(&process, &controller, h).margins);
        for figure in figures {
            let errors = found.each_ref().map(|m| (figure(m) - figure(&exact)).abs());
            // Half the sample period, half the error, but where the first order happens to be small.
            for pair in errors.windows(2) {
                let order = pair[0] / pair[1];
                let small = pair[0] < 2e-4 * figure(&exact).abs();
                assert!((1.7..2.4).contains(&order) || small, "{controller:?} {errors:?} {}", figure(&exact));
            }
        }
    }
}

#[test]
fn margins_scale_with_time_and_gain_and_do_not_know_the_sign_of_the_process() {
    let read = |process, controller| (read_process(process).unwrap(), read_controller(controller).unwrap());
    let (process, controller) = read("K=0.5,d=2", "Kc=0.5,Ti=12,Td=1,Tf=0.3,Ko=0.2");
    let a = of(&process, &controller, 0.3).margins;
    let (process, controller) = read("K=-1.25e-3,d=20", "Kc=-20,Ti=120,Td=10,Tf=3,Ko=-8");
    let b = of(&process, &controller, 3.0).margins;
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-11, "{a} {b}"); // roundings of two ways to one number
    near(a.gain_margin.unwrap(), b.gain_margin.unwrap());
    near(a.phase_margin.unwrap().0, b.phase_margin.unwrap().0);
    near(10.0 * a.delay_margin.unwrap().0, b.delay_margin.unwrap().0);
    near(a.sensitivity_peak.unwrap(), b.sensitivity_peak.unwrap());
    near(0.1 * a.gain_crossovers[0], b.gain_crossovers[0]);
}

#[test]
fn at_the_gain_margin_a_phase_crossover_is_a_gain_crossover() {
    let (process, controller) =
        (read_process("K=1,d=1.13").unwrap(), read_controller("Kc=0.35,Td=0.5,Ko=0.25").unwrap());
    let h = Seconds(0.4);
    let law = sampled_law(&process, &controller, h).unwrap();
    let with_gain = |gain: f64| {
        let actual = Process::integrating(gain, Seconds(1.13)).unwrap();
        sampled_margins(&law, &actual, h, Seconds(0.0)).unwrap().margins
    };
    let margin = with_gain(1.0).gain_margin.unwrap();
    assert!(with_gain(margin * (1.0 - 1e-9)).stable);
    let edge = with_gain(margin * (1.0 + 1e-9));
    assert!(!edge.stable);
    let distance =
        |omega: f64| edge.gain_crossovers.iter().map(|w| (w - omega).abs()).fold(f64::MAX, f64::min);
    // The gain is off by 1e-9 there, and with it the frequency.
    assert!(edge.phase_crossovers.iter().map(|&omega| distance(omega)).fold(f64::MAX, f64::min) < 1e-8);
}

#[test]
fn a_loop_is_stable_up_to_the_largest_sample_period_and_not_just_beyond() {
    // P control of K·Kc·d = 0.45: the continuous loop has a gain margin of (π/2)/0.45 = 3.49.
    let (process, p) = (read_process("K=1,d=1").unwrap(), read_controller("Kc=0.45").unwrap());
    let demand = |m: &Margins| m.gain_margin.map_or(f64::INFINITY, |margin| margin - 2.5);
    let LargestPeriod::UpTo(Seconds(h)) = largest_sample_period(&process, &p, Seconds(0.0), demand).unwrap()
    else {
        panic!("a period")
    };
    assert!(demand(&of(&process, &p, h).margins) >= 0.0);
    assert!(demand(&of(&process, &p, h * (1.0 + 1e-9)).margins) < 0.0);
    // Every smaller one holds: 500 of them, none of which the search asked for.
    for k in 1..500 {
        let smaller = h * f64::from(k) / 500.37;
        assert!(demand(&of(&process, &p, smaller).margins) >= 0.0, "{smaller} {h}");
    }
    let none = |m: &Margins| m.gain_margin.map_or(f64::INFINITY, |margin| margin - 9.0);
    assert_eq!(largest_sample_period(&process, &p, Seconds(0.0), none).unwrap(), LargestPeriod::None);
    let always = largest_sample_period(&process, &p, Seconds(0.0), |_| 1.0).unwrap();
    assert_eq!(always, LargestPeriod::DeadTime(Seconds(1.0)));
}
