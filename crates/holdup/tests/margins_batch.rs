//! The margins of many loops are those of the exact analysis of each.

use holdup::analysis::batch::{Robustness, margins_of_controllers};
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

/// Compares all; returns the share analysed one by one.
fn check(process: &Process, settings: &[Settings]) -> f64 {
    let controllers: Vec<Controller> = settings.iter().map(|s| s.controller(process)).collect();
    let found = margins_of_controllers(process, &controllers);
    settings.par_iter().zip(&controllers).zip(&found.loops).for_each(
        |((settings, controller), fast)| match (fast, margins(&ClosedLoop::new(process, controller))) {
            (Ok(fast), Ok(exact)) => {
                let exact = Robustness::from(&exact);
                assert!(agree(fast, &exact), "{settings:?}\n{fast:?}\n{exact:?}");
            }
            (fast, exact) => assert_eq!(fast.as_ref().err(), exact.as_ref().err(), "{settings:?}"),
        },
    );
    #[expect(clippy::cast_precision_loss, reason = "a few thousand")]
    let share = found.one_by_one as f64 / settings.len() as f64;
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
        println!("{structure}: {:.2} % one by one", 100.0 * share);
    }
}
