//! Random controllers and what they are told: the same text for every language, and what `holdup_control` answers.

use std::collections::VecDeque;
use std::fmt::Write as _;

use holdup::deploy::export::Float;
use holdup_control::{
    Input, Limits, Mode, Observer, Output, Pid, Scalar, Segment, Settings, State, Status, Watch,
};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// A number that is written as its bits.
pub(crate) trait Real: Scalar {
    const FLOAT: Float;
    fn bits(self) -> String;
}

impl Real for f64 {
    const FLOAT: Float = Float::Double;
    fn bits(self) -> String {
        format!("{:016x}", self.to_bits())
    }
}

impl Real for f32 {
    const FLOAT: Float = Float::Single;
    fn bits(self) -> String {
        format!("{:08x}", self.to_bits())
    }
}

/// The numbers of the settings that are random, and whether the tracking time is one of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<T> {
    pub(crate) settings: Settings<T>,
    pub(crate) tracks: bool,
}

/// What a field of the exported settings holds.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Field<T> {
    Flag(bool),
    Number(Option<T>),
}

/// The fields of the exported settings, by their names in C and in Structured Text.
pub(crate) fn fields<T: Real>(given: &Given<T>) -> Vec<(&'static str, Field<T>)> {
    use Field::{Flag, Number};
    let (law, limits, watch) = (given.settings.law(), given.settings.limits(), given.settings.watch());
    let (pid, observer) = (law.pid, law.observer);
    let tracking_time = pid.tracking_time().filter(|_| given.tracks);
    let lead = observer.and_then(|observer| observer.lead());
    let range = watch.range();
    vec![
        ("law.pid.proportional_gain", Number(Some(pid.proportional_gain()))),
        ("law.pid.setpoint_weight", Number(Some(pid.setpoint_weight()))),
        ("law.pid.derivative_setpoint_weight", Number(Some(pid.derivative_setpoint_weight()))),
        ("law.pid.has_integral", Flag(pid.integral_time().is_some())),
        ("law.pid.integral_time", Number(pid.integral_time())),
        ("law.pid.has_tracking_time", Flag(tracking_time.is_some())),
        ("law.pid.tracking_time", Number(tracking_time)),
        ("law.pid.has_derivative", Flag(pid.derivative_time().is_some())),
        ("law.pid.derivative_time", Number(pid.derivative_time())),
        ("law.pid.has_derivative_filter", Flag(pid.filter_time().is_some())),
        ("law.pid.filter_time", Number(pid.filter_time())),
        ("law.pid.bias", Number(Some(pid.bias()))),
        ("law.pid.has_bleed_time", Flag(pid.bleed_time().is_some())),
        ("law.pid.bleed_time", Number(pid.bleed_time())),
        ("law.has_observer", Flag(observer.is_some())),
        ("law.observer.observer_gain", Number(observer.map(|o| o.observer_gain()))),
        ("law.observer.model_gain", Number(observer.map(|o| o.model_gain()))),
        ("law.observer.dead_time", Number(observer.map(|o| o.dead_time()))),
        ("law.observer.sample_period", Number(observer.map(|o| o.sample_period()))),
        ("law.observer.predicts", Flag(observer.is_some_and(|o| o.predicts()))),
        ("law.observer.has_lead", Flag(lead.is_some())),
        ("law.observer.lead_time", Number(lead.map(|lead| lead.0))),
        ("law.observer.lead_filter_time", Number(lead.map(|lead| lead.1))),
        ("limits.has_low", Flag(limits.low().is_some())),
        ("limits.low", Number(limits.low())),
        ("limits.has_high", Flag(limits.high().is_some())),
        ("limits.high", Number(limits.high())),
        ("limits.has_rate", Flag(limits.rate().is_some())),
        ("limits.rate", Number(limits.rate())),
        ("watch.has_range", Flag(range.is_some())),
        ("watch.range_low", Number(range.map(|range| range.0))),
        ("watch.range_high", Number(range.map(|range| range.1))),
        ("watch.has_stale_time", Flag(watch.stale_time().is_some())),
        ("watch.stale_time", Number(watch.stale_time())),
        ("watch.has_failure", Flag(watch.failure_time().is_some())),
        ("watch.failure_time", Number(watch.failure_time())),
        ("watch.safe_output", Number(watch.safe_output())),
    ]
}

/// A process with the units of a plant: normalised to K = 1, d = 1 by these.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    /// Process gain [input unit/(output unit·s)].
    pub(crate) gain: f64,
    /// Dead time [s].
    pub(crate) time: f64,
}

impl Scale {
    pub(crate) fn random(rng: &mut ChaCha8Rng) -> Self {
        let sign = if rng.random_bool(0.3) { -1.0 } else { 1.0 };
        let ten_to = |exponent: f64| 10f64.powf(exponent);
        Self { gain: sign * ten_to(rng.random_range(-2.0..2.0)), time: ten_to(rng.random_range(-1.0..2.5)) }
    }
}

/// Random settings for this process; an absent term is absent in about half of them.
pub(crate) fn random_settings<T: Real>(rng: &mut ChaCha8Rng, scale: Scale) -> Given<T> {
    let Scale { gain, time } = scale;
    let per_gain = 1.0 / (gain * time);
    let t = T::from_f64;
    let mut pid = Pid::proportional(t(rng.random_range(0.1..0.6) * per_gain)).unwrap();
    if rng.random_bool(0.4) {
        let weights = (t(rng.random_range(0.0..1.2)), t(rng.random_range(0.0..1.0)));
        pid = pid.with_setpoint_weights(weights.0, weights.1).unwrap();
    }
    if rng.random_bool(0.5) {
        pid = pid.with_integral(t(rng.random_range(2.0..20.0) * time)).unwrap();
    }
    if rng.random_bool(0.5) {
        let filter = rng.random_bool(0.7).then(|| t(rng.random_range(0.02..0.5) * time));
        pid = pid.with_derivative(t(rng.random_range(0.0..0.6) * time), filter).unwrap();
    }
    let tracks = rng.random_bool(0.4);
    if tracks {
        let tracking_time = if rng.random_bool(0.2) { 0.0 } else { rng.random_range(0.1..5.0) * time };
        pid = pid.with_tracking_time(t(tracking_time)).unwrap();
    }
    let bleed = rng.random_bool(0.6).then(|| t(rng.random_range(0.5..10.0) * time));
    pid = pid.with_bias(t(rng.random_range(-1.0..1.0)), bleed).unwrap();
    let mut limits = Limits::none();
    if rng.random_bool(0.7) {
        let low = rng.random_bool(0.9).then(|| t(rng.random_range(-4.0..-0.5)));
        let high = rng.random_bool(0.9).then(|| t(rng.random_range(0.5..4.0)));
        limits = Limits::new(low, high).unwrap();
    }
    if rng.random_bool(0.4) {
        limits = limits.with_rate(t(rng.random_range(0.1..3.0) / time)).unwrap();
    }
    let mut watch = Watch::none();
    if rng.random_bool(0.3) {
        let reach = gain.abs() * time * rng.random_range(2.0..20.0);
        watch = watch.with_range(t(-reach), t(reach)).unwrap();
    }
    if rng.random_bool(0.5) {
        watch = watch.with_stale_time(t(rng.random_range(0.3..0.8) * time)).unwrap();
    }
    if rng.random_bool(0.5) {
        let safe_output = t(rng.random_range(-0.4..0.4));
        watch = watch.with_failure(t(rng.random_range(0.9..2.0) * time), safe_output).unwrap();
    }
    let settings = Settings::new(pid).with_limits(limits).unwrap().with_watch(watch).unwrap();
    if rng.random_bool(0.4) {
        return Given { settings, tracks };
    }
    let observer_gain = t(rng.random_range(0.1..0.5) * per_gain);
    let model_gain = t(rng.random_range(0.7..1.4) * gain);
    let (dead_time, period) = (rng.random_range(0.6..1.6) * time, rng.random_range(0.02..0.5) * time);
    let mut observer = Observer::new(observer_gain, model_gain, t(dead_time), t(period)).unwrap();
    if rng.random_bool(0.3) {
        let lead = (t(rng.random_range(0.0..0.6) * time), t(rng.random_range(0.05..0.3) * time));
        observer = observer.with_lead(lead.0, lead.1).unwrap();
    }
    if rng.random_bool(0.3) {
        observer = observer.predicting();
    }
    Given { settings: settings.with_observer(observer).unwrap(), tracks }
}

/// The text that a program is told, line by line, and what it must answer.
#[derive(Clone, Debug, Default)]
pub(crate) struct Trace {
    /// Never begin at rest, which a function block cannot.
    pub(crate) switched_on_only: bool,
    pub(crate) told: String,
    pub(crate) expected: String,
    /// Loops that ran: some random ones are refused because the delay line is too short for them, which is an answer.
    pub(crate) loops: usize,
    /// Updates in them.
    pub(crate) updates: usize,
    /// How often each status was answered.
    pub(crate) statuses: [usize; 7],
}

impl Trace {
    /// Tells settings: what follows runs on them. Without this the design's are in use.
    pub(crate) fn tell_settings<T: Real>(&mut self, given: &Given<T>) {
        self.told.push('s');
        for (_, field) in fields(given) {
            match field {
                Field::Flag(flag) => self.told.push_str(if flag { " 1" } else { " 0" }),
                Field::Number(number) => {
                    let _ = write!(self.told, " {}", number.unwrap_or(T::ZERO).bits());
                }
            }
        }
        self.told.push('\n');
    }

    /// A loop on its process: switched on or at rest, then `updates` updates with all that happens in a plant.
    /// `others` are settings that are given while it runs.
    pub(crate) fn run<T: Real>(
        &mut self,
        rng: &mut ChaCha8Rng,
        scale: Scale,
        first: Given<T>,
        others: &[Given<T>],
        segments: usize,
        updates: usize,
    ) {
        let mut given = first;
        let storage = vec![Segment::default(); segments];
        let start = T::from_f64(rng.random_range(-1.0..1.0));
        let (mut state, told) = if self.switched_on_only || rng.random_bool(0.5) {
            let state = State::switched_on(&given.settings, storage, start);
            (state, format!("o {}\n", start.bits()))
        } else {
            let rest = T::from_f64(rng.random_range(-1.0..1.0) * scale.gain * scale.time);
            let state = State::at_rest(&given.settings, storage, rest, rest, start);
            (state, format!("r {0} {0} {1}\n", rest.bits(), start.bits()))
        };
        self.told += &told;
        self.expected += if state.is_ok() { "1\n" } else { "0\n" };
        let Ok(state) = &mut state else { return };
        self.loops += 1;
        let mut plant = Plant::new(scale);
        for update in 0..updates {
            if !others.is_empty() && update % 150 == 149 {
                given = others[rng.random_range(0..others.len())];
                self.tell_settings(&given);
            }
            let input = plant.input::<T>(rng, &given);
            let _ = writeln!(self.told, "u {}", words(&input));
            let output = state.update(&given.settings, &input);
            plant.run_on(output.manipulated_variable.to_f64());
            self.answer(&output);
        }
    }

    fn answer<T: Real>(&mut self, output: &Output<T>) {
        let estimate = output.load_estimate.unwrap_or(T::ZERO);
        let status = output.status as usize;
        let _ = writeln!(
            self.expected,
            "{} {} {} {} {status}",
            output.manipulated_variable.bits(),
            output.wanted.bits(),
            output.limited as usize,
            estimate.bits(),
        );
        self.updates += 1;
        self.statuses[status] += 1;
    }
}

/// The order in which the exported languages count the states.
const _: () = assert!(Status::Good as usize == 0 && Status::MeasurementFailed as usize == 6);

/// An input as words: sample period, setpoint, measured, controlled variable, feed-forward, applied known, applied,
/// mode, manual output.
fn words<T: Real>(input: &Input<T>) -> String {
    let (mode, manual) = match input.mode {
        Mode::Automatic => (0, T::ZERO),
        Mode::Manual(output) => (1, output),
        Mode::Hold => (2, T::ZERO),
    };
    let zero = T::ZERO;
    format!(
        "{} {} {} {} {} {} {} {mode} {}",
        input.sample_period.bits(),
        input.setpoint.bits(),
        u8::from(input.controlled_variable.is_some()),
        input.controlled_variable.unwrap_or(zero).bits(),
        input.feed_forward.bits(),
        u8::from(input.applied.is_some()),
        input.applied.unwrap_or(zero).bits(),
        manual.bits(),
    )
}

/// The process, crudely simulated: it need only make the controller work.
struct Plant {
    scale: Scale,
    level: f64,
    under_way: VecDeque<(f64, f64)>,
    waiting: f64,
    setpoint: f64,
    load: f64,
    feed_forward: f64,
    mode: u32,
    manual: f64,
    failed: bool,
    fast: bool,
    applied: f64,
    step: f64,
}

impl Plant {
    fn new(scale: Scale) -> Self {
        Self {
            scale,
            level: 0.0,
            under_way: VecDeque::new(),
            waiting: 0.0,
            setpoint: 0.0,
            load: 0.0,
            feed_forward: 0.0,
            mode: 0,
            manual: 0.0,
            failed: false,
            fast: false,
            applied: 0.0,
            step: 0.0,
        }
    }

    /// What the controller is told next: steps, noise, jitter, and what should not happen.
    fn input<T: Real>(&mut self, rng: &mut ChaCha8Rng, given: &Given<T>) -> Input<T> {
        let t = T::from_f64;
        let unit = self.scale.gain * self.scale.time;
        let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e36];
        let bad = bad[rng.random_range(0..bad.len())];
        let nominal =
            given.settings.law().observer.map_or(0.2 * self.scale.time, |o| o.sample_period().to_f64());
        if rng.random_bool(0.02) {
            self.setpoint = unit * rng.random_range(-2.0..2.0);
        }
        if rng.random_bool(0.02) {
            self.load = rng.random_range(-0.6..0.6);
        }
        if rng.random_bool(0.02) {
            self.feed_forward = rng.random_range(-0.5..0.5);
        }
        if rng.random_bool(0.03) {
            self.mode = if rng.random_bool(0.6) { 0 } else { rng.random_range(1..3) };
            self.manual = rng.random_range(-2.0..2.0);
        }
        if rng.random_bool(if self.failed { 0.1 } else { 0.01 }) {
            self.failed = !self.failed;
        }
        if rng.random_bool(if self.fast { 0.05 } else { 0.005 }) {
            self.fast = !self.fast;
        }
        // Jitter; samples that come so fast that they fill the line; a gap; a clock that stands or jumps.
        let jitter = if self.fast { rng.random_range(0.01..0.1) } else { rng.random_range(0.5..1.5) };
        self.step = nominal * if rng.random_bool(0.005) { rng.random_range(3.0..40.0) } else { jitter };
        let period = match rng.random_range(0..400) {
            0 => bad,
            1 => 0.0,
            2 => -self.step,
            _ => self.step,
        };
        let noise = unit * 0.02 * rng.random_range(-1.0..1.0);
        let measured = self.level + noise;
        let kind = rng.random_range(0..200);
        let controlled_variable = match kind {
            _ if self.failed && kind < 120 => None,
            _ if self.failed => Some(t(f64::NAN)),
            0..20 => None,
            20 => Some(t(bad)),
            21 => Some(t(unit * 30.0)),
            _ => Some(t(measured)),
        };
        let mode = match self.mode {
            0 => Mode::Automatic,
            1 if rng.random_bool(0.05) => Mode::Manual(t(f64::NAN)),
            1 => Mode::Manual(t(self.manual)),
            _ => Mode::Hold,
        };
        Input {
            sample_period: t(period),
            setpoint: t(if rng.random_bool(0.005) { f64::NAN } else { self.setpoint }),
            controlled_variable,
            feed_forward: t(if rng.random_bool(0.005) { f64::INFINITY } else { self.feed_forward }),
            applied: match rng.random_range(0..20) {
                0 => Some(t(f64::NAN)),
                1..6 => Some(t(self.applied)),
                _ => None,
            },
            mode,
        }
    }

    /// The output acts, a dead time later, through an actuator that sticks a little.
    fn run_on(&mut self, output: f64) {
        if (output - self.applied).abs() > 0.05 {
            self.applied = output.clamp(-5.0, 5.0);
        }
        self.under_way.push_back((self.applied + self.load, self.step));
        self.waiting += self.step;
        while self.waiting > self.scale.time
            && let Some((value, duration)) = self.under_way.pop_front()
        {
            self.waiting -= duration;
            self.level += self.scale.gain * value * duration;
        }
        let reach = 50.0 * (self.scale.gain * self.scale.time).abs();
        self.level = self.level.clamp(-reach, reach);
    }
}
