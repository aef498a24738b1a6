//! What is typed reads back; what differs from the design is said; units and signs change what they should.

use holdup::deploy::conversion::{Action, Filter, Given, Kind, Sheet, Value, Vendor, convert, read, vendors};
use holdup::model::notation::read_controller;
use holdup::model::{Controller, DerivativeFilter, Seconds};

use proptest::prelude::*;

use crate::{scaling, sheets};

fn given(vendor: &Vendor, sheet: &Sheet) -> Given {
    let texts: Vec<String> = sheet.parameters.iter().map(|p| format!("{}={}", p.name, p.value)).collect();
    Given::read(vendor, &texts).unwrap()
}

fn settings(controller: &Controller) -> [f64; 6] {
    let filter = controller.derivative_filter().map_or(f64::NAN, DerivativeFilter::time);
    [
        controller.proportional_gain(),
        controller.integral_time().unwrap_or(f64::NAN),
        controller.derivative_time().unwrap_or(f64::NAN),
        filter,
        1.0 + controller.setpoint_weight(),
        1.0 + controller.derivative_setpoint_weight(),
    ]
}

#[track_caller]
fn assert_same(left: &[f64], right: &[f64], what: &str) {
    for (l, r) in left.iter().zip(right) {
        // A conversion is a dozen roundings, and a root that loses a digit or two.
        assert!(
            (l.is_nan() && r.is_nan()) || (l - r).abs() <= 1e-12 * r.abs(),
            "{what}: {left:?} is not {right:?}"
        );
    }
}

#[test]
fn what_is_typed_reads_back_as_the_controller_that_runs() {
    for (vendor, design, scaling, sheet) in sheets() {
        let back = read(vendor, &given(vendor, &sheet), &scaling).unwrap();
        assert_eq!(back, sheet.run, "{}", vendor.id);
        // And once more round: what the block runs is typed the same.
        let again = convert(vendor, &back, &scaling).sheet.unwrap();
        assert_same(&settings(&again.run), &settings(&back), vendor.id);
        let typed = |sheet: &Sheet| -> Vec<(&str, Value)> {
            sheet.parameters.iter().map(|parameter| (parameter.name, parameter.value)).collect()
        };
        for ((name, first), (same, second)) in typed(&sheet).into_iter().zip(typed(&again)) {
            assert_eq!(name, same, "{}", vendor.id);
            match (first, second) {
                (Value::Number(l), Value::Number(r)) => assert_same(&[l + 1.0], &[r + 1.0], vendor.id),
                (first, second) => assert_eq!(first, second, "{} {name} of {design:?}", vendor.id),
            }
        }
        assert!(again.cannot.is_empty(), "{}: {:?}", vendor.id, again.cannot);
    }
}

#[test]
fn gain_and_times_are_met_and_every_other_difference_is_said() {
    for (vendor, design, _, sheet) in sheets() {
        let (wanted, runs) = (settings(&design), settings(&sheet.run));
        let rounded = sheet.cannot.iter().any(|sentence| sentence.contains("whole steps"));
        if !rounded {
            // To 1e-9, from where on a rounding to steps is said.
            for (l, r) in wanted[..3].iter().zip(&runs) {
                assert!(
                    (l.is_nan() && r.is_nan()) || (l - r).abs() <= 1e-9 * r.abs(),
                    "{}: {design:?}",
                    vendor.id
                );
            }
        }
        let same = |l: f64, r: f64| (l.is_nan() && r.is_nan()) || (l - r).abs() <= 1e-9 * r.abs();
        for (index, word) in [(3, "derivative"), (4, "weight b"), (5, "weight c")] {
            let said = sheet.cannot.iter().any(|s| s.contains(word) || (index == 3 && s.contains("Tf")));
            let counts = index != 5 || design.derivative_time().is_some();
            assert!(!counts || said || same(wanted[index], runs[index]), "{}: {:?}", vendor.id, sheet.cannot);
        }
        assert_eq!(design.observer().is_some(), sheet.cannot.iter().any(|s| s.contains("observer")));
    }
}

#[test]
fn units_of_the_plant_do_not_change_what_is_typed_in_percent() {
    for &vendor in vendors().iter().filter(|vendor| vendor.uses_spans()) {
        let typed = |factor: f64, design: &str, pv: f64| {
            let controller = read_controller(design).unwrap();
            let scaled = Controller::proportional(controller.proportional_gain() / factor).unwrap();
            let scaled = scaled.with_integral_time(Seconds(controller.integral_time().unwrap())).unwrap();
            convert(vendor, &scaled, &scaling(pv, 80.0)).sheet.unwrap().parameters[0].value
        };
        let per_unit = vendor.input == holdup::deploy::conversion::Scale::Engineering;
        // The measurement in millimetres instead of metres: gain and span change, the percentage does not.
        let (Value::Number(metres), Value::Number(millimetres)) =
            (typed(1.0, "Kc=20,Ti=300", 5.0), typed(1000.0, "Kc=20,Ti=300", 5000.0))
        else {
            panic!("{}: a gain is a number", vendor.id)
        };
        let factor = if per_unit { 1000.0 } else { 1.0 };
        // Omron's band has four digits.
        assert!(
            (metres / (millimetres * factor) - 1.0).abs() < 1e-3,
            "{}: {metres} {millimetres}",
            vendor.id
        );
    }
}

#[test]
fn the_sign_of_the_gain_changes_the_action_alone() {
    for &vendor in vendors() {
        let of = |text: &str| convert(vendor, &read_controller(text).unwrap(), &scaling(5.0, 80.0)).sheet;
        let (Ok(positive), negative) = (of("Kc=2,Ti=40,Td=3,c=0"), of("Kc=-2,Ti=40,Td=3,c=0")) else {
            panic!("{} takes a PID", vendor.id)
        };
        match vendor.action {
            Action::ReverseOnly => assert!(negative.unwrap_err().reason.contains("positive")),
            Action::Sign => assert!(negative.unwrap().run.proportional_gain() < 0.0),
            Action::Words { name, .. } => {
                let negative = negative.unwrap();
                for (left, right) in positive.parameters.iter().zip(&negative.parameters) {
                    assert_eq!(left == right, left.name != name, "{}: {left:?} {right:?}", vendor.id);
                }
            }
        }
    }
}

#[test]
fn a_block_without_a_filter_of_its_own_says_so() {
    let absent = vendors().iter().filter(|vendor| vendor.filter == Filter::Absent);
    let design = read_controller("Kc=2,Ti=40,Td=3,Tf=0.3").unwrap();
    for &vendor in absent {
        let sheet = convert(vendor, &design, &scaling(5.0, 80.0)).sheet.unwrap();
        assert!(
            sheet.cannot.iter().any(|sentence| sentence.contains("Tf = 0.3 s is left out")),
            "{}",
            vendor.id
        );
    }
}

#[test]
fn compensators_and_complex_zeros_are_refused_with_the_reason() {
    let short = read_controller("Kc=2,Ti=8,Td=3").unwrap();
    for &vendor in vendors().iter().filter(|vendor| vendor.interacting) {
        let refusal = convert(vendor, &short, &scaling(5.0, 80.0)).sheet.unwrap_err();
        assert!(refusal.reason.contains("4 derivative times"), "{}", vendor.id);
    }
    let plain = vendors().iter().filter(|vendor| matches!(vendor.integral.kind, Kind::Gain(_)));
    assert_eq!(plain.count(), 4);
}

proptest! {
    #[test]
    fn whatever_the_numbers_every_block_answers_with_finite_ones_or_refuses(
        gain in any::<f64>(), ti in any::<f64>(), td in any::<f64>(), tf in any::<f64>(),
        b in any::<f64>(), c in any::<f64>(), terms in 0..8_u8, pv in 1e-300..1e300_f64,
    ) {
        let build = || -> Result<Controller, holdup::model::ModelError> {
            let mut controller = Controller::proportional(gain)?;
            if terms & 1 != 0 {
                controller = controller.with_integral_time(Seconds(ti.abs()))?;
            }
            if terms & 2 != 0 {
                controller = controller.with_derivative_time(Seconds(td.abs()))?;
            }
            if terms & 4 != 0 {
                controller = controller.with_filter_time(Seconds(tf.abs()))?;
            }
            controller.with_setpoint_weights(b, c)
        };
        let Ok(controller) = build() else { return Ok(()) };
        for &vendor in vendors() {
            match convert(vendor, &controller, &scaling(pv + 1.0, 80.0)).sheet {
                Ok(sheet) => {
                    let finite = |value| !matches!(value, Value::Number(number) if !f64::is_finite(number));
                    prop_assert!(sheet.parameters.iter().all(|p| finite(p.value)), "{}: {:?}", vendor.id, sheet);
                }
                Err(refusal) => prop_assert!(!refusal.reason.contains('\n')),
            }
        }
    }
}
