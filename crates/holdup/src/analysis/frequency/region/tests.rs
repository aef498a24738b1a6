//! Tests of the region: closed forms, and the quantity at every vertex.

use std::f64::consts::{FRAC_PI_2, PI};

use super::super::margins::margins;
use super::*;
use crate::model::{ClosedLoop, Observer, Seconds};

fn plain() -> Process {
    Process::integrating(1.0, Seconds(1.0)).unwrap()
}

fn of(controller: &Controller, plane: Plane, window: [f64; 2], levels: &[Constant]) -> Region {
    let window = Window { proportional_gain: window[0], other: window[1] };
    region(&plain(), controller, plane, window, levels).unwrap()
}

fn p() -> Controller {
    Controller::proportional(1.0).unwrap()
}

#[test]
fn pi_boundary_is_its_closed_form() {
    let region = of(&p(), Plane::KcTi, [2.0, 50.0], &[]);
    assert_eq!(region.boundary.len(), 1);
    let vertices = &region.boundary[0].vertices;
    for v in vertices {
        // −ω²·e^(jω) + Kc·(jω + 1/Ti) = 0: Kc = ω·sin ω and Kc/Ti = ω²·cos ω.
        let omega = v.frequency.unwrap();
        assert!((v.x - omega * omega.sin()).abs() < 1e-12 && (v.y - omega.tan() / omega).abs() < 1e-9 * v.y);
        // No integral time up to the dead time has a stable gain, and none a gain above that of P control.
        assert!(v.y > 1.0 && v.x < FRAC_PI_2);
    }
    let (first, last) = (vertices[0], vertices[vertices.len() - 1]);
    assert!(first.x < 1e-6 && (first.y - 1.0).abs() < 1e-6);
    // Cut by the window, on the way to π/2.
    assert!((last.y - 50.0).abs() < 1e-9 && (FRAC_PI_2 - last.x).abs() < 0.03);
}

#[test]
fn pd_boundary_is_its_closed_form_and_below_the_neutral_limit() {
    let region = of(&p(), Plane::KcTd, [2.0, 20.0], &[]);
    let crossing: Vec<_> = region.boundary.iter().flat_map(|c| &c.vertices).collect();
    let most = crossing.iter().map(|v| v.x).fold(0.0, f64::max);
    for v in &crossing {
        let omega = v.frequency.unwrap();
        assert!((FRAC_PI_2..PI).contains(&omega) && v.x * v.y < 1.0);
        assert!((v.x - omega * omega.sin()).abs() < 1e-12 && (v.x * v.y + omega.cos()).abs() < 1e-12);
    }
    // The maximum of ω·sin ω, at tan ω = −ω; the vertices are 0.02 apart.
    assert!(most <= 1.819_706 && most > 1.8195);
}

#[test]
fn perfect_observer_has_the_product_of_two_intervals() {
    let pd = p().with_derivative_time(Seconds(0.3)).unwrap();
    let region = of(&pd, Plane::KcKo, [3.0, 3.0], &[]);
    let alone = margins(&ClosedLoop::new(&plain(), &pd)).unwrap();
    let most = alone.gain_margin.unwrap();
    assert_eq!(region.boundary.len(), 2);
    for v in region.boundary.iter().flat_map(|c| &c.vertices) {
        let on_right = (v.x - most).abs() < 1e-12 && v.y <= FRAC_PI_2;
        let on_top = (v.y - FRAC_PI_2).abs() < 1e-12 && v.x <= most;
        assert!(on_right || on_top, "{v:?}");
    }
}

#[test]
fn wrong_observer_model_moves_the_boundary_but_little() {
    let observer = |gain| p().with_observer(Observer::new(1.0).unwrap().with_model_gain(gain).unwrap());
    let region = of(&observer(1.0 + 1e-6), Plane::KcKo, [3.0, 3.0], &[]);
    assert!(!region.boundary.is_empty());
    for v in region.boundary.iter().flat_map(|c| &c.vertices) {
        // The corner is rounded off by the root of the difference.
        assert!((v.x.max(v.y) - FRAC_PI_2).abs() < 2e-3, "{v:?}");
    }
}

#[test]
fn sensitivity_level_passes_through_simc() {
    let level = 1.703_521_690_410_479_7;
    let region = of(&p(), Plane::KcTi, [1.0, 16.0], &[Constant::SensitivityPeak(level)]);
    let curves = &region.levels[0].curves;
    assert_eq!(curves.len(), 1);
    for v in &curves[0] {
        let pi = Controller::proportional(v.x).unwrap().with_integral_time(Seconds(v.y)).unwrap();
        let peak = margins(&ClosedLoop::new(&plain(), &pi)).unwrap().sensitivity_peak.unwrap();
        assert!((peak - level).abs() < 1e-9);
    }
    // SIMC PI: Kc = 0.5, Ti = 8. The chord next to it leaves the curve by the square of a step.
    let at = curves[0].windows(2).find(|w| (w[0].y - 8.0) * (w[1].y - 8.0) <= 0.0).unwrap();
    let share = (8.0 - at[0].y) / (at[1].y - at[0].y);
    assert!((at[0].x + share * (at[1].x - at[0].x) - 0.5).abs() < 1e-3);
}

#[test]
fn gain_and_phase_margins_are_met_at_every_vertex() {
    let levels = [Constant::GainMargin(3.0), Constant::PhaseMargin(PI / 4.0)];
    let region = of(&p(), Plane::KcTd, [2.0, 4.0], &levels);
    for level in &region.levels {
        assert!(level.curves.iter().any(|curve| curve.len() > 10), "{:?}", level.constant);
        for v in level.curves.iter().flatten() {
            let pd = Controller::proportional(v.x).unwrap().with_derivative_time(Seconds(v.y)).unwrap();
            let m = margins(&ClosedLoop::new(&plain(), &pd)).unwrap();
            match level.constant {
                Constant::GainMargin(value) => assert!((m.gain_margin.unwrap() - value).abs() < 1e-9),
                Constant::PhaseMargin(value) => {
                    assert!((m.phase_margin.unwrap().0.abs() - value).abs() < 1e-9);
                }
                Constant::SensitivityPeak(_) => unreachable!("not asked for"),
            }
        }
    }
}

#[test]
fn negative_process_gain_mirrors_the_region() {
    let process = Process::integrating(-1.0, Seconds(1.0)).unwrap();
    let window = Window { proportional_gain: 2.0, other: 9.0 };
    let mirrored = region(&process, &p(), Plane::KcTi, window, &[]).unwrap();
    let same = of(&p(), Plane::KcTi, [2.0, 9.0], &[]);
    for (a, b) in mirrored.boundary[0].vertices.iter().zip(&same.boundary[0].vertices) {
        assert!((a.x + b.x).abs() < 1e-12 && (a.y - b.y).abs() < 1e-9);
    }
}

#[test]
fn settings_out_of_range_are_named() {
    let window = Window { proportional_gain: 0.0, other: 9.0 };
    let error = region(&plain(), &p(), Plane::KcTi, window, &[]).unwrap_err();
    assert!(error.to_string().starts_with("the window's proportional gain is 0"));
    let window = Window { proportional_gain: 1.0, ..window };
    let error = region(&plain(), &p(), Plane::KcTi, window, &[Constant::GainMargin(0.5)]).unwrap_err();
    assert!(error.to_string().contains("above 1"));
}

/// Every change of the verdict between neighbours of a grid has a boundary vertex within a cell.
fn assert_complete(process: &Process, controller: &Controller, plane: Plane, window: [f64; 2]) {
    let window = Window { proportional_gain: window[0], other: window[1] };
    let settings = Settings::new(process, controller, plane, window);
    let found = region(process, controller, plane, window, &[]).unwrap();
    let all: Vec<[f64; 2]> =
        found.boundary.iter().flat_map(|c| &c.vertices).map(|v| settings.square([v.x, v.y])).collect();
    let cell = 1.0 / 37.0;
    let at = |i: i32, l: i32| [(f64::from(i) + 0.4) * cell, (f64::from(l) + 0.6) * cell];
    let stable = |p: [f64; 2]| settings.stable(settings.point(p));
    let mut changes = 0;
    for i in 0..36 {
        for l in 0..36 {
            for other in [at(i + 1, l), at(i, l + 1)] {
                let here = at(i, l);
                if stable(here) != stable(other) {
                    changes += 1;
                    let near = all.iter().any(|p| (p[0] - here[0]).hypot(p[1] - here[1]) < 1.2 * cell);
                    assert!(near, "{plane:?}: no boundary next to {:?}", settings.point(here));
                }
            }
        }
    }
    assert!(changes > 10, "{plane:?}: {changes}");
}

#[test]
fn nothing_of_the_boundary_is_missing() {
    let (plain, lag) = (plain(), plain().with_lag(Seconds(0.7)).unwrap());
    let double = Process::double_integrating(0.5, Seconds(1.0)).unwrap();
    let td = |td: f64| p().with_derivative_time(Seconds(td)).unwrap();
    let ti = |c: Controller, ti: f64| c.with_integral_time(Seconds(ti)).unwrap();
    let model = |km: f64, dm: f64| {
        let observer = Observer::new(0.3).unwrap().with_model_gain(km).unwrap();
        observer.with_model_dead_time(Seconds(dm)).unwrap()
    };
    assert_complete(&plain, &td(1.2), Plane::KcTi, [1.5, 8.0]);
    assert_complete(&plain, &p().with_observer(model(1.3, 0.8)), Plane::KcTi, [1.5, 20.0]);
    assert_complete(&plain, &ti(p(), 0.9), Plane::KcTd, [2.0, 4.0]);
    assert_complete(&plain, &td(0.5).with_filter_bandwidth(8.0).unwrap(), Plane::KcTd, [2.0, 4.0]);
    assert_complete(&lag, &ti(td(0.5), 6.0), Plane::KcTd, [4.0, 6.0]);
    assert_complete(&double, &td(4.0), Plane::KcTi, [0.5, 40.0]);
    assert_complete(&plain, &td(0.3).with_observer(model(1.2, 1.0)), Plane::KcKo, [2.5, 2.5]);
    assert_complete(&plain, &td(0.3).with_observer(model(0.9, 1.3)), Plane::KcKo, [2.5, 2.5]);
    assert_complete(&plain, &ti(p(), 8.0).with_observer(model(1.0, 1.01)), Plane::KcKo, [2.5, 2.5]);
}

#[test]
fn gain_rising_to_its_limit_bounds_the_region_at_infinite_frequency() {
    let pd = p().with_derivative_time(Seconds(20.0)).unwrap();
    let region = of(&pd, Plane::KcTi, [0.1, 400.0], &[]);
    let limit = region.boundary.iter().find(|c| c.crossing == Crossing::InfiniteFrequency).unwrap();
    // K·Kc·Td = 1 while |L|² = 1 + (1 − 2·Td/Ti)·Kc²/ω² + … rises to its limit; above Ti = 2·Td it falls to it.
    assert!(limit.vertices.iter().all(|v| (v.x - 0.05).abs() < 1e-15 && v.frequency.is_none()));
    let highest = limit.vertices.iter().map(|v| v.y).fold(0.0, f64::max);
    assert!(highest < 40.1 && highest > 36.0, "{highest}");
    let top = region.boundary.iter().flat_map(|c| &c.vertices).map(|v| v.y).fold(0.0, f64::max);
    assert!(top > 399.0 && top <= 400.0, "{top}");
    let json = serde_json::to_value(&region).unwrap();
    assert_eq!((&json["plane"], &json["y"]), (&"kc-ti".into(), &"integral_time_s".into()));
    assert_eq!(json["boundary"].as_array().unwrap().len(), region.boundary.len());
}
