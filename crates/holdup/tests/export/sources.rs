//! Exports to run, and running foreign programs on traces.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::trace::{Given, Real, Scale};
use holdup::deploy::export::{Export, Float, Installation};
use holdup::model::notation::{read_controller, read_process};
use holdup::model::{Compensator, Controller, Seconds};

/// Loops of the README and of the plant, one of each structure: process, controller.
pub(crate) const LOOPS: [(&str, &str); 8] = [
    ("K=0.0506,d=6", "Kc=1.5321,Td=1.0343,Ko=1.5321"),
    ("K=0.0506,d=6", "Kc=2.95,Ti=15,Td=3,N=100,Ko=0.7,Km=0.045,dm=7"),
    ("K=0.0506,d=6", "Kc=2.95,Ti=15,Td=3,N=1,b=0.7,c=0"),
    ("K=0.0506,d=6", "Kc=1.647,Ti=48"),
    ("K=-2/h,d=4min", "Kc=-3.1,Td=1min,Tf=6s"),
    ("K=-2/h,d=4min", "Kc=-3.1"),
    ("K=1e-3,d=20,T=8", "Kc=20,Ti=200,Td=8,N=2"),
    ("K=1,d=5", "smith"),
];

/// The export of one of the loops.
pub(crate) fn export(name: &str, (process, controller): (&str, &str), float: Float) -> (Export, Scale) {
    let process = read_process(process).unwrap();
    let controller = if controller == "smith" {
        let settings = [
            ("main_gain", 0.2),
            ("disturbance_gain", 0.1),
            ("lead_time_s", 2.0),
            ("filter_time_s", 0.2),
            ("model_gain", 1.05),
            ("model_dead_time_s", 5.3),
        ];
        Controller::from(Compensator::from_parameters("SP+DOB", &settings).unwrap())
    } else {
        read_controller(controller).unwrap()
    };
    let d = process.dead_time();
    let installation = Installation {
        float,
        output_low: Some(-1.5),
        output_high: Some(2.5),
        rate_limit: Some(3.0 / d),
        tracking_time: Some(Seconds(0.8 * d)),
        bias: 0.1,
        bleed_time: Some(Seconds(3.0 * d)),
        measurement_range: Some((-1e4, 1e4)),
        stale_time: Some(Seconds(0.6 * d)),
        failure: Some((Seconds(1.7 * d), 0.3)),
        ..Installation::sampled(Seconds(d / 13.0))
    };
    let scale = Scale { gain: process.process_gain(), time: d };
    (Export::new(name, &process, &controller, &installation).unwrap(), scale)
}

/// The settings of such an export in its own precision.
pub(crate) fn given<T: Real>(export: &Export) -> Given<T> {
    Given { settings: export.settings().unwrap(), tracks: true }
}

/// A fresh folder for sources and programs.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("export").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Runs a compiler, which must have nothing to say.
pub(crate) fn compile(command: &mut Command) {
    let output = command.output().unwrap();
    let said = [output.stdout, output.stderr].concat();
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&said));
    assert!(said.is_empty(), "{command:?}: {}", String::from_utf8_lossy(&said));
}

/// What a program answers to a trace.
pub(crate) fn answer(command: &mut Command, told: &str) -> String {
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let told = told.to_owned();
    let writer = std::thread::spawn(move || stdin.write_all(told.as_bytes()));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    assert!(output.status.success(), "{command:?} failed");
    String::from_utf8(output.stdout).unwrap()
}

/// Fails at the first line that differs, with what was told.
pub(crate) fn must_agree(what: &str, told: &str, expected: &str, answered: &str) {
    let mut answers = answered.lines();
    let mut settings = "";
    let mut expected = expected.lines();
    for (number, line) in told.lines().enumerate() {
        if line.starts_with('s') || line.starts_with('d') {
            settings = line;
            continue;
        }
        let (right, answer) = (expected.next(), answers.next());
        assert_eq!(right, answer, "{what}, line {}: {line}\nsettings {settings}", number + 1);
    }
    assert_eq!((expected.next(), answers.next()), (None, None), "{what}: lines are left over");
}
