//! The fast way against the Legendre cells.

use super::super::measure::Measure;
use super::super::solver::Solver;
use super::super::{Response, measure_of, response};
use super::*;
use crate::analysis::metrics::METRICS;
use crate::model::{ClosedLoop, Controller, Observer, Process, Seconds};

fn level() -> Process {
    Process::integrating(0.0506, Seconds(6.0)).unwrap()
}

fn pid(kc: f64, ti: f64, td: f64, n: f64) -> Controller {
    let pid = Controller::proportional(kc).unwrap().with_integral_time(Seconds(ti)).unwrap();
    pid.with_derivative_time(Seconds(td)).unwrap().with_filter_bandwidth(n).unwrap()
}

fn servo_and_load(horizon: f64, load_at: f64) -> Scenario {
    Scenario::new(vec![(0.0, 1.0)], vec![(load_at, 1.0)], Seconds(horizon), 0.0).unwrap()
}

/// Both answers; `None` where the fast way declines.
fn both(closed: &ClosedLoop, scenario: &Scenario) -> (Option<Response>, Response) {
    let system = System::new(closed);
    let (mut fast, mut general): (Measure, Measure) = (measure_of(scenario), measure_of(scenario));
    let outcome = run(&system, scenario, &mut fast);
    let fast = outcome.map(|outcome| response(scenario, &fast, outcome.unwrap()));
    let outcome = Solver::new(&system).run(scenario, &mut general).unwrap();
    (fast, response(scenario, &general, outcome))
}

#[track_caller]
fn agree(fast: &Response, general: &Response, tolerance: f64) {
    for metric in METRICS {
        let (ours, theirs) = ((metric.value)(&fast.metrics), (metric.value)(&general.metrics));
        assert_eq!(ours.is_some(), theirs.is_some(), "{}: {ours:?} {theirs:?}", metric.name);
        let (Some(ours), Some(theirs)) = (ours, theirs) else { continue };
        assert!(
            (ours - theirs).abs() <= tolerance * theirs.abs().max(1e-3),
            "{}: {ours} {theirs}, {:e}",
            metric.name,
            ours / theirs - 1.0
        );
    }
}

#[test]
fn the_paper_s_loops_take_the_fast_way_and_agree_to_1e_11() {
    let pd = Controller::proportional(1.2).unwrap().with_derivative_time(Seconds(1.0)).unwrap();
    let pd = pd.with_filter_bandwidth(100.0).unwrap();
    let loops = [
        pid(2.95, 15.0, 3.0, 100.0),
        pid(2.95, 15.0, 3.0, 100.0).with_setpoint_weights(0.5, 0.0).unwrap(),
        Controller::proportional(1.6).unwrap().with_integral_time(Seconds(48.0)).unwrap(),
        Controller::proportional(1.6).unwrap(),
        pd,
        pd.with_observer(Observer::new(0.8).unwrap()),
    ];
    for controller in loops {
        let closed = ClosedLoop::new(&level(), &controller);
        for scenario in [servo_and_load(200.0, 100.0), Scenario::unit_setpoint_step(Seconds(301.7)).unwrap()] {
            let (fast, general) = both(&closed, &scenario);
            // 1e-11: tolerance of a cell (2e-14) times some hundred cells.
            agree(&fast.expect("one layer"), &general, 1e-11);
        }
    }
}
