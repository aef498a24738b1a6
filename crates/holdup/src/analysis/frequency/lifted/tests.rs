//! Tests of the bounds over wide bands.

use super::super::envelope::{Envelope, Steady};
use super::super::functions::{Curve, Functions};
use super::super::scan::{Findings, Scan};
use super::*;
use crate::model::{ClosedLoop, Controller, Observer, Process, Seconds};

fn search(kc: f64, td: f64, bandwidth: Option<f64>, ko: f64, lift: bool) -> Findings {
    let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
    let pd = Controller::proportional(kc).unwrap().with_derivative_time(Seconds(td)).unwrap();
    let pd = bandwidth.map_or(pd, |n| pd.with_filter_bandwidth(n).unwrap());
    let loop_ = ClosedLoop::new(&process, &pd.with_observer(Observer::new(ko).unwrap()));
    let characteristic = Characteristic::new(&loop_).unwrap();
    let (functions, envelope) = (Functions::new(&characteristic), Envelope::new(&characteristic));
    let (steady, lifted) = (Steady::new(&characteristic), Lifted::new(&characteristic));
    let (lifted, limit) = (lifted.as_ref().filter(|_| lift), characteristic.high_frequency_gain);
    Scan::new(&functions, &envelope, &steady, lifted, limit, true).run()
}

#[test]
fn peaks_at_infinite_frequency_take_few_bands() {
    for (kc, td, ko) in [(0.0073, 68.4, 0.3), (0.019, 50.0, 0.3), (1e-6, 0.5e6, 0.3), (0.01, 90.0, 0.5)] {
        let found = search(kc, td, None, ko, true);
        // The supremum is the limit: nothing at a finite frequency is higher.
        let limit = 1.0 / (1.0 - kc * td);
        assert!((found.sensitivity.value / limit - 1.0).abs() < 1e-14 && found.sensitivity.omega.is_none());
        assert_eq!(found.below_one, kc * td);
        assert!(found.unfinished_from.is_none() && found.work < 5_000, "{}", found.work);
    }
    // A plateau up to a million radians per dead time, with its highest point far up.
    let found = search(0.0073, 68.4, Some(1e6), 0.3, true);
    assert!(found.sensitivity.omega.unwrap() > 100.0 && found.work < 40_000, "{}", found.work);
}

#[test]
fn both_ways_of_searching_find_the_same_peaks() {
    for (kc, td, ko) in [(0.019, 50.0, 0.1), (0.3, 2.0, 0.3), (0.05, 10.0, 0.2)] {
        // Unfiltered, the first would have to be searched along the axis up to 1e11 radians.
        for bandwidth in [None, Some(30.0), Some(300.0)].into_iter().skip(usize::from(kc * td > 0.9)) {
            let [a, b] = [true, false].map(|lift| search(kc, td, bandwidth, ko, lift));
            // The tolerance within which one peak is not told from another.
            assert!((a.sensitivity.value / b.sensitivity.value - 1.0).abs() < 2e-11);
            assert!((a.complementary.value / b.complementary.value - 1.0).abs() < 2e-11);
            assert!((a.below_one / b.below_one - 1.0).abs() < 2e-11);
        }
    }
}

#[test]
fn what_is_proven_holds_on_a_dense_grid_and_what_is_false_is_left_open() {
    let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
    let pd = Controller::proportional(0.02).unwrap().with_derivative_time(Seconds(30.0)).unwrap();
    let loop_ = ClosedLoop::new(&process, &pd.with_observer(Observer::new(0.4).unwrap()));
    let characteristic = Characteristic::new(&loop_).unwrap();
    let functions = Functions::new(&characteristic);
    let lifted = Lifted::new(&characteristic).unwrap();
    let (from, to) = (20.0, 80.0);
    let grid = || (0..60_000).map(|i| from + 0.001 * f64::from(i));
    let highest = grid().map(|omega| functions.at(omega).peak_value(Peak::Sensitivity)).fold(0.0, f64::max);
    for factor in [0.9, 0.999, 1.001, 1.1] {
        let question = Question::Below(Peak::Sensitivity, highest * factor);
        let pieces = lifted.open(question, from, to, |_| question).0.unwrap_or_else(|| vec![(from, to)]);
        assert_eq!(pieces.is_empty(), factor > 1.0, "{factor}");
        for omega in grid() {
            let open = pieces.iter().any(|(a, b)| (*a..=*b).contains(&omega));
            assert!(open || functions.at(omega).peak_value(Peak::Sensitivity) < highest * factor);
        }
    }
}
