//! The margins of many loops are those of the exact analysis of each.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use holdup::analysis::batch::{
    ManyMargins, Robustness, margins_of, margins_of_controllers, margins_of_processes,
    robustness_of_controllers, robustness_of_processes,
};
use holdup::analysis::frequency::margins;
use holdup::model::{ClosedLoop, Controller, Process, Seconds};
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

/// Both ways are exact to a few roundings; margins of a loop near its stability limit are small differences.
const AGREEMENT: f64 = 1e-9;

/// Settings in dead times of the process, gains as K·Kc·d.
#[derive(Debug, Clone, Copy)]
struct Settings {
    gain: f64,
    integral: Option<f64>,
    derivative: Option<f64>,
    filter: Option<f64>,
}

impl Settings {
    fn controller(self, process: &Process) -> Controller {
        let d = process.dead_time();
        let controller = Controller::proportional(self.gain / (process.process_gain() * d)).unwrap();
        let controller =
            self.integral.map_or(controller, |ti| controller.with_integral_time(Seconds(ti * d)).unwrap());
        let controller = self
            .derivative
            .map_or(controller, |td| controller.with_derivative_time(Seconds(td * d)).unwrap());
        self.filter.map_or(controller, |tf| controller.with_filter_time(Seconds(tf * d)).unwrap())
    }
}

fn spread(random: &mut impl Rng, from: f64, to: f64) -> f64 {
    from * (to / from).powf(random.random::<f64>())
}

fn close(a: Option<f64>, b: Option<f64>) -> bool {
    match (a, b) {
        (None, None) => true,
        (Some(a), Some(b)) => (a - b).abs() <= AGREEMENT * b.abs(),
        _ => false,
    }
}

fn agree(fast: &Robustness, exact: &Robustness) -> bool {
    fast.stable == exact.stable
        && close(fast.gain_margin, exact.gain_margin)
        && close(fast.gain_margin_low, exact.gain_margin_low)
        && close(fast.phase_margin.map(|m| m.0), exact.phase_margin.map(|m| m.0))
        && close(fast.delay_margin.map(|m| m.0), exact.delay_margin.map(|m| m.0))
        && close(fast.sensitivity_peak, exact.sensitivity_peak)
}

/// Compares all; returns the shares analysed one by one, without and with the complementary sensitivity.
fn check(process: &Process, settings: &[Settings]) -> [f64; 2] {
    let controllers: Vec<Controller> = settings.iter().map(|s| s.controller(process)).collect();
    let found = margins_of_controllers(process, &controllers);
    let both = robustness_of_controllers(process, &controllers);
    let differs =
        |(((settings, controller), fast), both): (((&Settings, &Controller), &_), &_)| -> Option<String> {
            let exact = margins(&ClosedLoop::new(process, controller)).map(|exact| Robustness::from(&exact));
            let same = match (fast, both, &exact) {
                (Ok(fast), Ok(both), Ok(exact)) => {
                    let peaks = [both, exact].map(|found| found.complementary_sensitivity_peak);
                    agree(fast, exact) && agree(both, exact) && close(peaks[0], peaks[1])
                }
                (fast, both, exact) => fast == exact && both == exact,
            };
            (!same).then(|| format!("{settings:?}\n  {fast:?}\n  {both:?}\n  {exact:?}\n"))
        };
    let loops = settings.par_iter().zip(&controllers).zip(&found.loops).zip(&both.loops);
    let different: Vec<String> = loops.filter_map(differs).collect();
    assert!(different.is_empty(), "{}", different.concat());
    #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
    let share = [found, both].map(|found| found.one_by_one as f64 / settings.len() as f64);
    share
}

fn process() -> Process {
    Process::integrating(0.0506, Seconds(6.0)).unwrap()
}

#[test]
fn random_loops_of_every_structure_have_the_margins_of_the_exact_analysis() {
    let mut random = ChaCha8Rng::seed_from_u64(6);
    for structure in ["P", "PI", "PD", "PID", "PID unfiltered"] {
        let settings: Vec<Settings> = (0..4400)
            .map(|_| {
                let r = &mut random;
                let derivative = structure.contains('D').then(|| spread(r, 0.01, 1.5));
                let filtered = derivative.filter(|_| structure != "PID unfiltered");
                Settings {
                    gain: spread(r, 0.02, 2.0),
                    integral: structure.contains('I').then(|| spread(r, 0.7, 300.0)),
                    derivative,
                    filter: filtered.map(|td| td * spread(r, 0.003, 1.0)),
                }
            })
            .collect();
        let share = check(&process(), &settings);
        println!("{structure}: {:.2} % one by one, with M_t {:.2} %", 100.0 * share[0], 100.0 * share[1]);
        // Those next to instability, with 2·Td > Ti, with a lower gain margin, or neutral with K·Kc·Td about 1.
        assert!(share[0] < 0.1, "{structure}: {share:?}");
        // Without integral action M_t may be 1, at rest.
        assert!(share[1] < 0.15 || !structure.contains('I'), "{structure}: {share:?}");
    }
}

#[test]
fn random_loops_with_a_lag_have_the_margins_of_the_exact_analysis() {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    for _ in 0..40 {
        let lag = spread(&mut random, 0.001, 30.0) * 6.0;
        let process = process().with_lag(Seconds(lag)).unwrap();
        let settings: Vec<Settings> = (0..60)
            .map(|_| Settings {
                gain: spread(&mut random, 0.005, 2.0),
                integral: random.random::<bool>().then(|| spread(&mut random, 1.0, 500.0)),
                derivative: random.random::<bool>().then(|| spread(&mut random, 0.01, 30.0)),
                filter: random.random::<bool>().then(|| spread(&mut random, 0.001, 3.0)),
            })
            .collect();
        check(&process, &settings);
    }
}

#[test]
fn loops_at_the_edges_of_the_fast_way_have_the_margins_of_the_exact_analysis() {
    let of = |gain, integral, derivative, filter| Settings { gain, integral, derivative, filter };
    let mut settings = vec![
        // Two peaks of nearly the same height, far apart.
        of(0.512_316, Some(1.0 / 0.268_47), Some(0.396_881), Some(0.003_968_8)),
        of(0.426_85, Some(1.0 / 0.218_187), Some(0.378_309), Some(0.003_783)),
        // Lower gain margin.
        of(0.3, Some(0.9), Some(1.2), None),
        of(0.3, Some(0.9), Some(1.2), Some(0.001)),
        // 2·Td and Ti the same, a little more, a little less.
        of(0.4, Some(1.0), Some(0.5), None),
        of(0.4, Some(4.0), Some(2.0 + 1e-9), Some(0.02)),
        of(0.4, Some(4.0), Some(2.0 - 1e-9), Some(0.02)),
        // Positive feedback.
        of(-0.4, Some(10.0), None, None),
        of(-1e-3, None, None, None),
        // Ti equal to the dead time, and to dead time and lag.
        of(0.1, Some(1.0), None, None),
        of(0.1, Some(1.0 + 1e-12), Some(0.2), Some(0.1)),
        // Very slow, very fast.
        of(1e-4, Some(1e5), None, None),
        of(1e-9, None, None, None),
        of(1e5, Some(3.0), Some(0.4), Some(0.1)),
        of(1e9, None, None, None),
        // A filter that filters nothing (beyond 1e5 per dead time the exact analysis loses digits), and one that leaves
        // nothing of the derivative.
        of(0.5, Some(10.0), Some(0.4), Some(1e-5)),
        of(0.5, Some(10.0), Some(0.4), Some(1e6)),
        of(0.5, Some(10.0), Some(1e-4), Some(1e-5)),
        of(0.5, Some(1e300), None, None),
    ];
    // Up to and over the stability limit, and K·Kc·Td up to and over 1.
    for power in 0..14 {
        let away = 10.0_f64.powi(-power);
        for sign in [-1.0, 1.0] {
            let limit = std::f64::consts::FRAC_PI_2 * (1.0 + 0.5 * sign * away);
            settings.push(of(limit, None, None, None));
            settings.push(of(0.5, Some(100.0), Some(2.0 * (1.0 + 0.5 * sign * away)), None));
            settings.push(of(0.5, Some(100.0), Some(2.0 * (1.0 + 0.5 * sign * away)), Some(1e-3)));
        }
    }
    check(&process(), &settings);
    check(&process().with_lag(Seconds(9.0)).unwrap(), &settings);
    // A level held by its outlet valve.
    check(&Process::integrating(-3.0, Seconds(0.02)).unwrap(), &settings);
    check(&Process::double_integrating(0.1, Seconds(1.0)).unwrap(), &settings);
}

#[test]
fn margins_of_processes_are_those_of_each_in_any_order_and_number_of_threads() {
    let mut random = ChaCha8Rng::seed_from_u64(8);
    let settings = Settings { gain: 0.6, integral: Some(4.0), derivative: Some(0.45), filter: Some(0.01) };
    let controller = settings.controller(&process());
    let mut factor = || 0.5 + random.random::<f64>();
    let processes: Vec<Process> =
        (0..2000).map(|_| process().perturbed(factor(), factor()).unwrap()).collect();
    let found = margins_of_processes(&processes, &controller);
    let both = robustness_of_processes(&processes, &controller);
    for (process, found) in processes.iter().zip(&found.loops) {
        assert_eq!(&margins_of(process, &controller), found);
    }
    for (found, both) in found.loops.iter().zip(&both.loops) {
        let (found, both) = (found.unwrap(), both.unwrap());
        assert!(found.complementary_sensitivity_peak.is_none() && agree(&found, &both));
        assert_eq!(both.complementary_sensitivity_peak.is_some(), both.stable);
    }
    for (process, fast) in processes.iter().zip(&found.loops) {
        let exact = margins(&ClosedLoop::new(process, &controller)).unwrap();
        assert!(agree(fast.as_ref().unwrap(), &Robustness::from(&exact)), "{process:?}");
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
    assert_eq!(pool.install(|| margins_of_processes(&processes, &controller)), found);
    let reversed: Vec<Process> = processes.iter().rev().copied().collect();
    let mut back = margins_of_processes(&reversed, &controller);
    back.loops.reverse();
    assert_eq!(back, found);
    assert_eq!(margins_of_processes(&[], &controller).loops, []);
    assert_eq!(margins_of_processes(&processes[7..8], &controller).loops, found.loops[7..8]);
}

#[test]
fn margins_follow_a_change_of_the_units_of_time_and_gain() {
    let scaled = |time: f64, gain: f64| -> ManyMargins {
        let mut random = ChaCha8Rng::seed_from_u64(9);
        let process = Process::integrating(0.3 * gain / time, Seconds(2.0 * time)).unwrap();
        let controllers: Vec<Controller> = (0..500)
            .map(|_| {
                let [kc, ti, td] = [random.random::<f64>(), random.random::<f64>(), random.random::<f64>()];
                let controller = Controller::proportional((0.2 + 1.5 * kc) / gain).unwrap();
                let controller = controller.with_integral_time(Seconds(time * (4.0 + 30.0 * ti))).unwrap();
                let td = Seconds(time * (0.1 + td));
                let controller = controller.with_derivative_time(td).unwrap();
                controller.with_filter_time(Seconds(0.1 * td.0)).unwrap()
            })
            .collect();
        margins_of_controllers(&process, &controllers)
    };
    let (one, other) = (scaled(1.0, 1.0), scaled(60.0, -0.01));
    assert_eq!(one.one_by_one, other.one_by_one);
    for (a, b) in one.loops.iter().flatten().zip(other.loops.iter().flatten()) {
        // The settings differ by a few roundings; the minutes are converted to seconds.
        let delay = a.delay_margin.map(|margin| Seconds(60.0 * margin.0));
        let mut converted = *a;
        converted.delay_margin = delay;
        assert!(agree(&converted, b), "{a:?}\n{b:?}");
    }
}
