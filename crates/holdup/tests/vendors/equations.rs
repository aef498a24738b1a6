//! The printed equation with the typed numbers, against the controller that is said to run; and what manuals print.

use holdup::deploy::conversion::{Given, Sheet, Value, convert, read, vendor};
use holdup::model::DerivativeFilter;
use holdup::model::notation::read_controller;
use num_complex::Complex64;

use crate::{scaling, sheets};

/// What an equation is made of: the typed settings, the frequency and the signals.
struct At<'a> {
    sheet: &'a Sheet,
    s: Complex64,
    sp: Complex64,
    pv: Complex64,
    /// Span of the output and of the measurement.
    op_span: f64,
    pv_span: f64,
}

impl At<'_> {
    fn value(&self, name: &str) -> Option<Value> {
        self.sheet.parameters.iter().find(|parameter| parameter.name == name).map(|parameter| parameter.value)
    }

    /// A typed number; 0 where there is none.
    fn n(&self, name: &str) -> f64 {
        match self.value(name) {
            Some(Value::Number(number)) => number,
            _ => 0.0,
        }
    }

    /// A typed word.
    fn w(&self, name: &str) -> &'static str {
        match self.value(name) {
            Some(Value::Word(word)) => word,
            _ => "",
        }
    }

    /// 1/(time·s), nothing for a time of 0.
    fn divided(&self, time: f64) -> Complex64 {
        if time == 0.0 { Complex64::ZERO } else { (self.s * time).inv() }
    }

    fn percent(&self) -> f64 {
        self.op_span / self.pv_span
    }
}

fn direct(yes: bool) -> f64 {
    if yes { -1.0 } else { 1.0 }
}

/// The output of a block by its printed equation, written out again here, apart from its description.
fn printed(id: &str, at: &At<'_>) -> Complex64 {
    let (s, sp, pv, op_span) = (at.s, at.sp, at.pv, at.op_span);
    let (n, w) = (|name: &str| at.n(name), |name: &str| at.w(name));
    let divided = |time: f64| at.divided(time);
    let (e, percent) = (sp - pv, at.percent());
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
        _ => printed_further(id, at),
    }
}

/// The rest of them.
fn printed_further(id: &str, at: &At<'_>) -> Complex64 {
    let (s, sp, pv, op_span) = (at.s, at.sp, at.pv, at.op_span);
    let (n, w) = (|name: &str| at.n(name), |name: &str| at.w(name));
    let divided = |time: f64| at.divided(time);
    let (e, percent) = (sp - pv, at.percent());
    match id {
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
        "ge-pid-isa" => {
            let counts = |name: &str, steps: f64| n(name) / steps;
            let d = if w("Config Word bit 2") == "0" { e } else { -pv };
            let sum = e + e / s * counts("Ki", 1000.0) + s * counts("Kd", 100.0) * d;
            sum * counts("Kp", 100.0) * percent * direct(w("Config Word bit 0") == "1")
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
            let tf = run.derivative_filter().map_or(0.0, DerivativeFilter::time);
            let derivative = run.derivative_time().map_or(Complex64::ZERO, |td| s * td / (s * tf + 1.0));
            let (b, c) = (run.setpoint_weight(), run.derivative_setpoint_weight());
            let ideal =
                (sp * b - pv + integral * (sp - pv) + derivative * (sp * c - pv)) * run.proportional_gain();
            let block = printed(
                vendor.id,
                &At { sheet: &sheet, s, sp, pv, op_span: scaling.op.width(), pv_span: scaling.pv.width() },
            );
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
    // GFK-2950C, 7.2.2: Kp entered as 450 is 4.50; GFK-1503E, word 8: Ki entered as 1400 is 1.400 repeats a second.
    let ge = vendor("ge-pid-isa").unwrap();
    let pi = read(ge, &Given::read(ge, &["Kp=450,Ki=1400"]).unwrap(), &scaling(100.0, 100.0)).unwrap();
    assert_eq!((pi.proportional_gain(), pi.integral_time()), (4.5, Some(1.0 / 1.4)));
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
