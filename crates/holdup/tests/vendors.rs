//! Every registered vendor's block: in step with its folder, back as it went, and the law that its equation says.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use std::path::Path;

use holdup::deploy::conversion::{
    Action, Filter, Given, Kind, Scaling, Sheet, Span, Value, Vendor, Weight, Weights, convert, read, vendor,
    vendors,
};
use holdup::model::notation::read_controller;
use holdup::model::{Controller, Seconds};
use num_complex::Complex64;

fn scaling(pv: f64, op: f64) -> Scaling {
    Scaling::new(Span::new(-1.0, pv - 1.0).unwrap(), Span::new(10.0, op + 10.0).unwrap())
}

/// Controllers of every structure. Times are whole tenths, so that blocks with steps take them.
fn designs() -> Vec<Controller> {
    let texts = [
        "Kc=2.5",
        "Kc=2.5,Ti=40",
        "Kc=2.5,Td=3",
        "Kc=2.5,Ti=40,Td=3",
        "Kc=2.5,Ti=40,Td=3,Tf=0.3",
        "Kc=2.5,Ti=40,Td=3,Tf=0.3,b=0.4,c=0",
        "Kc=2.5,Ti=40,b=0,c=0",
        "Kc=2.5,Ti=8,Td=3,N=2,c=0",
        "Kc=-2.5,Ti=40,Td=3,Tf=0.3,c=0",
        "Kc=-0.02,Ti=400,Td=60,N=0.5,b=0.25,c=0.5,Ko=-1,a1=2",
    ];
    texts.iter().map(|text| read_controller(text).unwrap()).collect()
}

/// Every sheet of every vendor for every design that it takes.
fn sheets() -> Vec<(&'static Vendor, Controller, Scaling, Sheet)> {
    let scaling = scaling(5.0, 80.0);
    let mut sheets = Vec::new();
    for &vendor in vendors() {
        let before = sheets.len();
        for design in designs() {
            if let Ok(sheet) = convert(vendor, &design, &scaling).sheet {
                sheets.push((vendor, design, scaling.clone(), sheet));
            }
        }
        assert!(sheets.len() - before >= 5, "{} takes too few designs", vendor.id);
    }
    sheets
}

fn given(vendor: &Vendor, sheet: &Sheet) -> Given {
    let texts: Vec<String> = sheet.parameters.iter().map(|p| format!("{}={}", p.name, p.value)).collect();
    Given::read(vendor, &texts).unwrap()
}

fn settings(controller: &Controller) -> [f64; 6] {
    let filter = controller.derivative_filter().map_or(f64::NAN, |filter| filter.time());
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
fn registry_is_in_step_with_its_folder() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/deploy/vendors");
    let mut stems: Vec<String> = std::fs::read_dir(&folder)
        .unwrap()
        .filter_map(|entry| entry.unwrap().file_name().to_str()?.strip_suffix(".rs").map(str::to_owned))
        .filter(|stem| stem != "mod")
        .collect();
    stems.sort();
    let modules: String = stems.iter().fold(String::new(), |all, stem| all + "mod " + stem + ";\n");
    let list: String = stems.iter().fold(String::new(), |all, stem| all + "    &" + stem + "::ENTRY,\n");
    let right = format!(
        "//! The registered blocks, one file each.\n//!\n//! A test (`tests/vendors.rs`) keeps the lines below in step \
         with the folder: never edit them by hand.\n\nuse super::conversion::Vendor;\n\n{modules}\n/// Every block.\n\
         #[rustfmt::skip]\npub(super) static REGISTRY: &[&Vendor] = &[\n{list}];\n"
    );
    let file = folder.join("mod.rs");
    if std::fs::read_to_string(&file).unwrap() != right {
        std::fs::write(&file, right).unwrap();
        panic!(
            "{} was not in step with the folder and has been rewritten: run the tests again",
            file.display()
        );
    }
    let ids: Vec<String> = vendors().iter().map(|vendor| vendor.id.replace('-', "_")).collect();
    assert_eq!(ids, stems, "file name and id differ");
}

#[test]
fn every_block_says_where_its_equation_comes_from_and_uses_no_name_twice() {
    for &vendor in vendors() {
        assert!(!vendor.source.citation.is_empty() && !vendor.source.read.is_empty(), "{}", vendor.id);
        assert!(vendor.equation.contains('=') && !vendor.equation.contains('\n'), "{}", vendor.id);
        if vendor.interacting {
            let free = matches!(vendor.weights, Weights::Choice { free: None, .. })
                || matches!(vendor.weights, Weights::Each { b: Weight::Fixed(_), c: Weight::Fixed(_) });
            assert!(free, "{}: free weights of an interacting block have no ideal form", vendor.id);
        }
    }
    for (vendor, _, _, sheet) in sheets() {
        let mut names: Vec<&str> = sheet.parameters.iter().map(|parameter| parameter.name).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count, "{}: {names:?}", vendor.id);
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

/// The output of a block by its printed equation, written out again here, apart from its description.
fn printed(
    id: &str,
    sheet: &Sheet,
    s: Complex64,
    sp: Complex64,
    pv: Complex64,
    spans: (f64, f64),
) -> Complex64 {
    let value =
        |name: &str| sheet.parameters.iter().find(|parameter| parameter.name == name).map(|p| p.value);
    let n = |name: &str| match value(name) {
        Some(Value::Number(number)) => number,
        _ => 0.0,
    };
    let w = |name: &str| match value(name) {
        Some(Value::Word(word)) => word,
        _ => "",
    };
    let divided = |by: f64| if by == 0.0 { Complex64::ZERO } else { (s * by).inv() };
    let direct = |yes: bool| if yes { -1.0 } else { 1.0 };
    let e = sp - pv;
    let (pv_span, op_span) = spans;
    let percent = op_span / pv_span;
    match id {
        "siemens-pid-compact" => {
            let c = |name: &str| n(&format!("Retain.CtrlParams.{name}"));
            let (td, a) = (c("Td"), c("TdFiltRatio"));
            let sum = sp * c("PWeighting") - pv
                + e * divided(c("Ti"))
                + s * td / (s * a * td + 1.0) * (sp * c("DWeighting") - pv);
            sum * c("Gain") * direct(w("Config.InvertControl") == "TRUE") * op_span / 100.0
        }
        "rockwell-pide-independent" | "rockwell-pide-dependent" => {
            let (p, i, d) = (n("PGain"), n("IGain"), n("DGain"));
            let (ki, kd) = if id.ends_with("independent") {
                (s.inv() * i / 60.0, d * 60.0)
            } else {
                (divided(i * 60.0) * p, p * d * 60.0)
            };
            let of = |name: &str| if w(name) == "1" { -pv } else { e };
            let lag = if w("DSmoothing") == "1" { s * (kd / p / 16.0) + 1.0 } else { Complex64::ONE };
            let sum = of("PVEProportional") * p + e * ki + s * kd / lag * of("PVEDerivative");
            sum * percent * direct(w("ControlAction") == "1")
        }
        "emerson-deltav-standard" | "emerson-deltav-series" => {
            let (reset, rate) = (n("RESET"), n("RATE"));
            let action = direct(w("CONTROL_OPTS.Direct_Acting") == "TRUE") * n("GAIN") * percent;
            let (p, d) = match w("STRUCTURE") {
                "PID action on Error" | "PD action on Error" => (e, e),
                "PI action on Error, D action on PV" | "P action on Error, D action on PV" => (e, -pv),
                "I action on Error, PD action on PV" => (-pv, -pv),
                _ => (sp * n("BETA") - pv, sp * n("GAMMA") - pv),
            };
            let lag = s * n("ALPHA") * rate + 1.0;
            if id.ends_with("standard") {
                return (p + e * divided(reset) + s * rate / lag * d) * action;
            }
            interacting((p, d), e, sp, pv, s, (reset, rate), lag) * action
        }
        "honeywell-experion" | "honeywell-interactive" => {
            let (t1, t2) = (n("T1") * 60.0, n("T2") * 60.0);
            let action = direct(w("CTLACTN") == "DIRECT") * n("K") * percent;
            let (p, d) = match w("CTLEQN") {
                "EQA" => (e, e),
                "EQB" => (e, -pv),
                _ => (-pv, -pv),
            };
            if id.ends_with("experion") {
                return (p + e * divided(t1) + s * t2 / (s * t2 / 16.0 + 1.0) * d) * action;
            }
            interacting((p, d), e, sp, pv, s, (t1, t2), s * t2 * 0.1 + 1.0) * action
        }
        "yokogawa-centum" => {
            let (p, d) = match w("PID control algorithm") {
                "PID" => (e, e),
                "PI-D" => (e, -pv),
                _ => (-pv, -pv),
            };
            let td = n("D");
            let sum = p + e / (s * n("I")) + s * td / (s * td / 8.0 + 1.0) * d;
            sum * 100.0 / n("P") * percent * direct(w("Control action direction") == "Direct")
        }
        "abb-800xa-pidcc" => {
            let derivative = s * n("Td") / (s * n("TfDerivative") + 1.0) * pv;
            let sum = sp * n("Beta") - pv + e * divided(n("Ti")) - derivative;
            sum * n("Gain") * percent * direct(w("Direct") == "true")
        }
        "schneider-pidff" => {
            let td = n("td");
            let lag = if td > 0.0 { s * td / n("kd") + 1.0 } else { Complex64::ONE };
            let d = if w("pv_dev") == "1" { e } else { -pv };
            let sum = sp * (1.0 - n("ovs_att")) - pv + e * divided(n("ti")) + s * td / lag * d;
            sum * n("kp") * percent * direct(w("rev_dir") == "1")
        }
        "omron-pidat" => {
            let (p, ti, td) = (n("P") / 10.0, n("Tik") / 10.0, n("Tdk") / 10.0);
            let integral = if ti == 999.9 { Complex64::ZERO } else { e * divided(ti) };
            let sum = sp * (1.0 - n("alpha")) - pv + integral - s * td * pv;
            sum * 100.0 / p * percent * direct(w("forward") == "1")
        }
        "arduino-pid-v1" => {
            let p = if w("POn") == "P_ON_M" { -pv } else { e };
            let sum = p * n("Kp") + e / s * n("Ki") - s * pv * n("Kd");
            sum * direct(w("ControllerDirection") == "REVERSE")
        }
        "esphome-pid" => {
            let sum = e * n("kp") + e / s * n("ki") - s * pv * n("kd");
            sum * op_span * direct(w("output") == "cool_output")
        }
        "klipper-heater" => {
            let derivative = s * n("pid_Kd") / (s * n("smooth_time") + 1.0) * pv;
            (e * n("pid_Kp") + e / s * n("pid_Ki") - derivative) / 255.0 * op_span
        }
        "codesys-util-pid" => (e + e / (s * n("TN")) + s * n("TV") * e) * n("KP"),
        "beckhoff-ctrl-pid" => {
            let of = |name: &str| if w(name) == "TRUE" { -pv } else { e };
            let derivative = s * n("tTv") / (s * n("tTd") + 1.0) * of("bDInTheFeedbackPath");
            (of("bPInTheFeedbackPath") + e * divided(n("tTn")) + derivative) * n("fKp")
        }
        _ => panic!("{id}: write its printed equation here"),
    }
}

/// Lead and reset in series: of the error, or the lead of the measurement alone.
fn interacting(
    (p, d): (Complex64, Complex64),
    e: Complex64,
    sp: Complex64,
    pv: Complex64,
    s: Complex64,
    (reset, rate): (f64, f64),
    lag: Complex64,
) -> Complex64 {
    let lead = (s * rate + 1.0) / lag;
    let integral = if reset == 0.0 { Complex64::ZERO } else { (s * reset).inv() };
    if d == e {
        return (integral + 1.0) * lead * e;
    }
    let setpoint = if p == e { integral + 1.0 } else { integral };
    setpoint * sp - (integral + 1.0) * lead * pv
}

#[test]
fn the_printed_equation_with_the_typed_numbers_is_the_controller_that_runs() {
    for (vendor, design, scaling, sheet) in sheets() {
        let run = &sheet.run;
        for s in [Complex64::new(0.0, 0.02), Complex64::new(0.01, 0.3), Complex64::new(-0.05, 4.0)] {
            let (sp, pv) = (Complex64::new(1.3, 0.2), Complex64::new(-0.4, 0.7));
            let integral = run.integral_time().map_or(Complex64::ZERO, |ti| (s * ti).inv());
            let tf = run.derivative_filter().map_or(0.0, |filter| filter.time());
            let derivative = run.derivative_time().map_or(Complex64::ZERO, |td| s * td / (s * tf + 1.0));
            let (b, c) = (run.setpoint_weight(), run.derivative_setpoint_weight());
            let ideal =
                (sp * b - pv + integral * (sp - pv) + derivative * (sp * c - pv)) * run.proportional_gain();
            let block = printed(vendor.id, &sheet, s, sp, pv, (scaling.pv.width(), scaling.op.width()));
            // A dozen roundings; terms of the sum that cancel are at most a hundred times the sum.
            assert!(
                (block - ideal).norm() <= 1e-11 * ideal.norm(),
                "{}: {design:?}: {block} {ideal}",
                vendor.id
            );
        }
    }
}

#[test]
fn numbers_that_the_manuals_print() {
    // W474, PIDAT, example: proportional band 10.0 %, integral time 120.0 s, derivative time 40.0 s, sampling 0.5 s
    // are the words 0064, 04B0, 0190 and 0032 (hexadecimal), reverse operation.
    let omron = vendor("omron-pidat").unwrap();
    let mut percent = scaling(100.0, 100.0);
    percent.sample_period = Some(0.5);
    let sheet =
        convert(omron, &read_controller("Kc=10,Ti=120,Td=40,b=0.35,c=0").unwrap(), &percent).sheet.unwrap();
    let value = |name: &str| sheet.parameters.iter().find(|p| p.name == name).unwrap().value;
    for (name, word) in [("P", 0x64), ("Tik", 0x4B0), ("Tdk", 0x190), ("sampling period", 0x32)] {
        assert_eq!(value(name), Value::Number(f64::from(word)), "{name}");
    }
    assert_eq!((value("alpha"), value("forward")), (Value::Number(0.65), Value::Word("0")));
    // CENTUM: proportional band 100/Kc; 20 % is a gain of 5.
    let centum = vendor("yokogawa-centum").unwrap();
    let pi = read(centum, &Given::read(centum, &["P=20,I=60"]).unwrap(), &scaling(100.0, 100.0)).unwrap();
    assert_eq!(pi.proportional_gain(), 5.0);
    // 1756-RM006: KI = KC/TI and KD = KC·TD between the forms of PIDE, times in minutes.
    let of = |id: &str| {
        let design = read_controller("Kc=3,Ti=120,Td=30").unwrap();
        let sheet = convert(vendor(id).unwrap(), &design, &scaling(100.0, 100.0)).sheet.unwrap();
        [0, 1, 2].map(|index| match sheet.parameters[index].value {
            Value::Number(number) => number,
            Value::Word(word) => panic!("{word}"),
        })
    };
    assert_eq!(of("rockwell-pide-dependent"), [3.0, 2.0, 0.5]);
    assert_eq!(of("rockwell-pide-independent"), [3.0, 1.5, 1.5]);
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
