//! The dead-time compensators against the closed formulas of their sources.

#![expect(clippy::unwrap_used, reason = "a test may")]

use std::f64::consts::PI;

use holdup::analysis::frequency::{LoopTransfer, Margins, margins};
use holdup::analysis::response::{Scenario, simulate, trajectory};
use holdup::model::{ClosedLoop, Compensator, CompensatorLaw, Controller, Lead, Process, Seconds};
use num_complex::Complex64;
use proptest::prelude::*;

fn plain(gain: f64, dead_time: f64) -> Process {
    Process::integrating(gain, Seconds(dead_time)).unwrap()
}

fn controller(law: CompensatorLaw, gain: f64, dead_time: f64) -> Controller {
    Compensator::new(law, gain, Seconds(dead_time)).unwrap().into()
}

fn modified_smith(gain: f64, dead_time: f64, tr: f64, k0: f64, lead: Option<Lead>) -> Controller {
    let law = CompensatorLaw::ModifiedSmith { main_gain: 1.0 / (gain * tr), disturbance_gain: k0, lead };
    controller(law, gain, dead_time)
}

fn two_degree(gain: f64, dead_time: f64, setpoint_time: f64, a1: f64, a2: f64) -> Controller {
    controller(CompensatorLaw::TwoDegree { setpoint_time, a1, a2 }, gain, dead_time)
}

fn huba(gain: f64, dead_time: f64, main_gain: f64, filter_time: f64) -> Controller {
    controller(CompensatorLaw::InverseModel { main_gain, filter_time }, gain, dead_time)
}

fn achieved(process: &Process, controller: &Controller) -> Margins {
    margins(&ClosedLoop::new(process, controller)).unwrap()
}

/// One of each law for gain K and dead time d.
fn one_of_each(gain: f64, dead_time: f64) -> [Controller; 5] {
    let (k, d) = (gain, dead_time);
    let lead = Some(Lead { derivative_time: 0.4 * d, filter_time: 0.04 * d });
    [
        modified_smith(k, d, d, 0.5 / (k * d), None),
        modified_smith(k, d, 0.8 * d, 0.6 / (k * d), lead),
        two_degree(k, d, d, 4.0 * d, 4.0 * d * d),
        two_degree(k, d, 2.0 * d, 3.0 * d, 2.0 * d * d),
        huba(k, d, (-1.0_f64).exp() / (k * d), d),
    ]
}

/// S from its formula: the loop transfer function goes through a determinant and a quotient of some dozen roundings,
/// which a pole near the axis may magnify.
const CLOSE: f64 = 1e-10;

fn assert_sensitivity(process: &Process, controller: &Controller, omega: f64, formula: Complex64) {
    let transfer = LoopTransfer::new(&ClosedLoop::new(process, controller)).unwrap();
    let (s, t) = (transfer.sensitivity(omega), transfer.complementary_sensitivity(omega));
    assert!((s - formula).norm() < CLOSE * (1.0 + formula.norm()), "{omega}: {s} is not {formula}");
    assert!((s + t - 1.0).norm() < CLOSE * (1.0 + s.norm()), "{omega}: {s} + {t} is not 1");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn sensitivity_of_the_modified_smith_predictor_is_the_product_of_its_source(
        k in 0.1..5.0_f64, d in 0.2..5.0_f64, tr in 0.2..5.0_f64, k0 in 0.05..1.2_f64,
        td in 0.0..0.5_f64, w in 0.01..30.0_f64, with_lead in any::<bool>(),
    ) {
        let (tr, k0, omega) = (tr * d, k0 / (k * d), w / d);
        let lead = with_lead.then_some(Lead { derivative_time: td * d, filter_time: 0.05 * d });
        let (s, e) = (Complex64::new(0.0, omega), Complex64::new(0.0, -omega * d).exp());
        let f = lead.map_or(Complex64::from(1.0), |l| (l.derivative_time * s + 1.0) / (l.filter_time * s + 1.0));
        let formula = (1.0 - e / (tr * s + 1.0)) * (s / (s + k * k0 * f * e));
        assert_sensitivity(&plain(k, d), &modified_smith(k, d, tr, k0, lead), omega, formula);
    }

    #[test]
    fn complementary_sensitivity_of_the_two_degree_compensator_is_its_filter_and_the_dead_time(
        k in 0.1..5.0_f64, d in 0.2..5.0_f64, t in 0.2..5.0_f64, a1 in 0.5..6.0_f64, a2 in 0.2..8.0_f64,
        w in 0.01..30.0_f64,
    ) {
        let (t, a1, a2, omega) = (t * d, a1 * d, a2 * d * d, w / d);
        let (s, e) = (Complex64::new(0.0, omega), Complex64::new(0.0, -omega * d).exp());
        let formula = 1.0 - ((a1 + d) * s + 1.0) * e / (a2 * s * s + a1 * s + 1.0);
        assert_sensitivity(&plain(-k, d), &two_degree(-k, d, t, a1, a2), omega, formula);
    }

    #[test]
    fn sensitivity_of_the_inverse_model_observer_is_that_of_p_control_times_that_of_the_observer(
        k in 0.1..5.0_f64, d in 0.2..5.0_f64, kc in 0.05..1.2_f64, tf in 0.1..5.0_f64, w in 0.01..30.0_f64,
    ) {
        let (kc, tf, omega) = (kc / (k * d), tf * d, w / d);
        let (s, e) = (Complex64::new(0.0, omega), Complex64::new(0.0, -omega * d).exp());
        let formula = s / (s + k * kc * e) * (1.0 - e / (tf * s + 1.0));
        assert_sensitivity(&plain(k, d), &huba(k, d, kc, tf), omega, formula);
    }

    #[test]
    fn a_model_that_differs_gives_the_general_loop(
        k in 0.5..2.0_f64, d in 0.5..2.0_f64, lag in 0.1..2.0_f64, w in 0.05..20.0_f64, law in 0..5_usize,
    ) {
        // Controllers for K = d = 1 on another process with a lag: L = C·G with each C written down on its own.
        let (s, e) = (Complex64::new(0.0, w), Complex64::new(0.0, -w).exp());
        let c = match law {
            0 | 1 => {
                let (kr, k0) = [(1.0, 0.5.into()), (1.25, 0.6 * (0.4 * s + 1.0) / (0.04 * s + 1.0))][law];
                // v = −Kr·(y + (1 − e)·v/s), u = v − K0·(y − e·v/s)
                let v = -kr / (1.0 + kr * (1.0 - e) / s);
                -(v - k0 * (1.0 - e * v / s))
            }
            2 | 3 => {
                let (a1, a2) = [(4.0, 4.0), (3.0, 2.0)][law - 2];
                let q = ((a1 + 1.0) * s + 1.0) / (a2 * s * s + a1 * s + 1.0);
                q * s / (1.0 - q * e)
            }
            _ => ((-1.0_f64).exp() + s / (s + 1.0)) / (1.0 - e / (s + 1.0)),
        };
        let l = c * k * Complex64::new(0.0, -w * d).exp() / (s * (lag * s + 1.0));
        let process = plain(k, d).with_lag(Seconds(lag)).unwrap();
        let transfer = LoopTransfer::new(&ClosedLoop::new(&process, &one_of_each(1.0, 1.0)[law])).unwrap();
        // At low frequency 1 − e/(…) is a difference: six digits of it go at ω = 0.05.
        prop_assert!((transfer.at(w) - l).norm() < CLOSE * l.norm(), "{law}: {} is not {l}", transfer.at(w));
    }
}

#[test]
fn active_disturbance_rejection_is_a_pi_controller_with_an_output_filter() {
    let (k, wc, wo) = (0.5, 0.3, 0.7);
    let law = CompensatorLaw::DisturbanceRejection { controller_bandwidth: wc, observer_bandwidth: wo };
    let sum = 2.0 * wo + wc;
    let pi = Controller::proportional((2.0 * wc * wo + wo * wo) / (k * sum)).unwrap();
    let pi = pi.with_integral_time(Seconds((2.0 * wc + wo) / (wc * wo))).unwrap();
    let pi = pi.with_output_filter(1.0 / sum, 0.0).unwrap();
    // On another process than its model, and whatever the dead time of the model.
    let process = plain(0.8, 1.0);
    let adrc = controller(law, k, 9.0);
    let [adrc, pi] =
        [adrc, pi].map(|controller| LoopTransfer::new(&ClosedLoop::new(&process, &controller)).unwrap());
    for omega in [0.01, 0.3, 2.0, 40.0] {
        assert!((adrc.at(omega) - pi.at(omega)).norm() < CLOSE * pi.at(omega).norm());
    }
}

#[test]
fn the_three_descriptions_of_the_two_degree_compensator_are_one_loop() {
    // Zhong with λ, the filtered predictor with T0 and Tf, Åström–Hang–Lim with k1, k2, k3: written from their own
    // formulas at the same poles −1/1.5 and −1/2.5, dead time 2.
    let (l1, l2, d) = (1.5, 2.5, 2.0);
    let (k3, k2) = (1.0 / (l1 * l2), (l1 + l2) / (l1 * l2));
    let k4 = k2 + k3 * d;
    let transfer =
        LoopTransfer::new(&ClosedLoop::new(&plain(1.0, d), &two_degree(1.0, d, 1.0, l1 + l2, l1 * l2)))
            .unwrap();
    for omega in [0.02, 0.4, 1.0, 7.0] {
        let (s, e) = (Complex64::new(0.0, omega), Complex64::new(0.0, -omega * d).exp());
        // Åström–Hang–Lim: the feedback M(s) of y − y_m at the plant input; 1 + M·G = 1/(1 − T).
        let m = (k4 + k3 / s) / (1.0 + k2 / s + k3 / (s * s) - (k4 / s + k3 / (s * s)) * e);
        let hang = m * e / s;
        // Filtered predictor: u = C·(r − ŷ), ŷ = (1 − Fr·e)·u/s + Fr·y.
        let filter = ((l1 + l2 + d) * s + 1.0) / (l2 * s + 1.0);
        let c = 1.0 / l1;
        let filtered = c * filter / (1.0 + c * (1.0 - filter * e) / s) * e / s;
        for other in [hang, filtered] {
            assert!((transfer.at(omega) - other).norm() < CLOSE * other.norm(), "{omega}: {other}");
        }
    }
}

/// Closed forms of a response and of what the simulator promises: 1e-9.
const SIMULATED: f64 = 1e-9;

fn setpoint_response(process: &Process, controller: &Controller, times: &[f64]) -> Vec<f64> {
    let step = Scenario::unit_setpoint_step(Seconds(60.0)).unwrap();
    trajectory(&ClosedLoop::new(process, controller), &step, times).unwrap().controlled_variable
}

#[test]
fn the_setpoint_response_is_a_first_order_lag_behind_the_dead_time() {
    let (k, d) = (-0.5, 2.0);
    let times: Vec<f64> = (0..200).map(|i| 0.17 * f64::from(i)).collect();
    let laws = one_of_each(k, d);
    for (controller, t) in laws[..4].iter().zip([d, 0.8 * d, d, 2.0 * d]) {
        let response = setpoint_response(&plain(k, d), controller, &times);
        for (time, y) in times.iter().zip(response) {
            let exact = if *time < d { 0.0 } else { -f64::exp_m1(-(time - d) / t) };
            assert!((y - exact).abs() < SIMULATED, "{} at {time}: {y}, {exact}", controller.structure());
        }
    }
}

#[test]
fn a_load_leaves_no_offset_and_the_filter_of_the_setpoint_is_left_away_where_it_cancels() {
    let (k, d) = (0.5, 2.0);
    for controller in one_of_each(k, d) {
        let closed = ClosedLoop::new(&plain(k, d), &controller);
        let response = simulate(&closed, &Scenario::unit_load_step(Seconds(400.0)).unwrap()).unwrap();
        assert!(response.final_controlled_variable.abs() < SIMULATED, "{}", controller.structure());
        assert!((response.final_manipulated_variable + 1.0).abs() < SIMULATED);
    }
    // A window keeps no drift that a long run would show.
    let long = Scenario::new(vec![(0.0, 1.0)], vec![(50.0, 1.0)], Seconds(10_000.0), 0.0).unwrap();
    for controller in one_of_each(k, d) {
        let response = simulate(&ClosedLoop::new(&plain(k, d), &controller), &long).unwrap();
        assert!((response.final_controlled_variable - 1.0).abs() < SIMULATED, "{}", controller.structure());
    }
    let states = one_of_each(k, d).map(|c| ClosedLoop::new(&plain(k, d), &c).rates().len());
    assert_eq!(states, [2, 3, 4, 3, 2]);
}

#[test]
fn the_integral_of_the_error_after_a_load_is_that_of_the_closed_form() {
    // S·G at s = 0 from the formulas: (Tr + d)/K0 for the modified predictor, K·d·(…) for the others by S''/2.
    let (k, d) = (0.5, 2.0);
    let (tr, k0) = (3.0, 0.3);
    let closed = ClosedLoop::new(&plain(k, d), &modified_smith(k, d, tr, k0, None));
    let response = simulate(&closed, &Scenario::unit_load_step(Seconds(400.0)).unwrap()).unwrap();
    // K·K0·d = 0.3 < 1/e: no overshoot, so the integral of the modulus is the integral.
    assert!((response.metrics.iae.unwrap() - (tr + d) / k0).abs() < SIMULATED * 20.0);
}

/// Stable up to the margin and not beyond, on both sides, in the process alone.
fn assert_delay_margins(k: f64, d: f64, controller: &Controller) {
    let nominal = achieved(&plain(k, d), controller);
    let name = controller.structure();
    assert!(nominal.stable && nominal.warnings.is_empty(), "{name}: {:?}", nominal.warnings);
    let (longer, shorter) = (nominal.delay_margin.unwrap().0, nominal.delay_margin_low.map(|cut| cut.0));
    // Where L comes from −∞ at ω = 0, nothing there is taken for a crossing.
    let transfer = LoopTransfer::new(&ClosedLoop::new(&plain(k, d), controller)).unwrap();
    for &omega in &nominal.phase_crossovers {
        let at = transfer.at(omega);
        assert!(omega * d > 0.05 && (-at).arg().abs() < 1e-9, "{name}: L = {at} at {omega}");
    }
    let stable = |dead_time: f64| achieved(&plain(k, dead_time), controller).stable;
    assert!(stable(d + 0.999 * longer) && !stable(d + 1.001 * longer), "{name}: + {longer}");
    if let Some(cut) = shorter {
        assert!(stable(d - 0.999 * cut) && !stable(d - 1.001 * cut), "{name}: − {cut}");
    }
}

#[test]
fn a_dead_time_as_much_longer_or_shorter_as_the_delay_margins_say_is_the_limit() {
    for controller in one_of_each(0.7, 1.3) {
        assert_delay_margins(0.7, 1.3, &controller);
    }
    // Fast ones fail for a shorter dead time too.
    for controller in [
        modified_smith(0.7, 1.3, 0.1, 0.6 / 0.91, None),
        two_degree(0.7, 1.3, 1.0, 1.0, 0.25),
        huba(0.7, 1.3, 0.6 / 0.91, 0.1),
    ] {
        assert!(
            achieved(&plain(0.7, 1.3), &controller).delay_margin_low.is_some(),
            "{}",
            controller.structure()
        );
        assert_delay_margins(0.7, 1.3, &controller);
    }
}

#[test]
fn the_sensitivity_peaks_of_zhongs_compensator_are_those_of_the_collection() {
    for (lambda, peak) in [(1.0, 2.20), (1.5, 1.87), (2.0, 1.69), (3.0, 1.49)] {
        let controller = two_degree(1.0, 1.0, 1.0, 2.0 * lambda, lambda * lambda);
        let margins = achieved(&plain(1.0, 1.0), &controller);
        // Half a unit of the last digit printed there.
        assert!((margins.sensitivity_peak.unwrap() - peak).abs() < 5e-3, "{lambda}: {margins:?}");
        assert_eq!(margins.high_frequency_gain, 0.0);
    }
}

#[test]
fn the_observer_gain_alone_decides_the_phase_margin_that_the_source_states() {
    // The loop K·K0·e^(−d·s)/s has the phase margin π/2 − K·K0·d = 61.35° at K0 = 1/(2·K·d).
    let proportional = Controller::proportional(0.5).unwrap();
    let margin = achieved(&plain(1.0, 1.0), &proportional).phase_margin.unwrap();
    assert!((margin.0 - (PI / 2.0 - 0.5)).abs() < 1e-12);
}
