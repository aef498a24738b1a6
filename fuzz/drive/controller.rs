//! What the fuzz target `controller` does with bytes, and the replay of its corpus too: settings of any law, inputs of
//! any kind, changes of settings, modes and time in between. After each update the output must be finite, within the
//! limits in force, and no further from the last one than the rate allows.

use holdup_control::{
    Action, Input, Limits, Mode, Observer, Pid, Scalar, Segment, Settings, State, Status, Watch,
};

/// Segments of the delay line; a law that needs more is refused.
const SEGMENTS: usize = 24;

/// Runs the bytes in both precisions and returns how many updates were checked.
///
/// # Panics
/// Where an output breaks its contract: that is what is sought.
pub(crate) fn drive(data: &[u8]) -> usize {
    run::<f64>(data) + run::<f32>(data)
}

fn run<T: Scalar>(data: &[u8]) -> usize {
    let mut bytes = Bytes(data);
    let Some(mut settings) = settings::<T>(&mut bytes) else { return 0 };
    let line = [Segment::default(); SEGMENTS];
    let (setpoint, measured, output) = (bytes.scalar(), bytes.scalar(), bytes.scalar());
    let started = if bytes.byte() & 1 == 0 {
        State::at_rest(&settings, line, setpoint, measured, output)
    } else {
        State::switched_on(&settings, line, output)
    };
    let Ok(mut state) = started else { return 0 };
    let mut saved = state;
    let mut updates = 0;
    while !bytes.0.is_empty() && updates < 4096 {
        match bytes.byte() % 16 {
            0 => {
                if let Some(other) = self::settings(&mut bytes) {
                    settings = other;
                }
            }
            1 => saved = state,
            2 => state = saved,
            _ => {}
        }
        let input = input(&mut bytes);
        // The same input may come again, as when a plant stands still.
        for _ in 0..=(bytes.byte() % 4) {
            let last = state.manipulated_variable;
            let answer = state.update(&settings, &input);
            let u = answer.manipulated_variable;
            assert!(u.is_finite(), "{u:?} after {input:?} with {settings:?}");
            assert_eq!(settings.limits().within(u), u, "beyond {:?}", settings.limits());
            assert_eq!(u, state.manipulated_variable, "the state forgot what it returned");
            assert!(answer.wanted.is_finite(), "{answer:?}");
            let h = input.sample_period;
            if let (Some(rate), true) = (settings.limits().rate(), h.is_finite() && h > T::ZERO) {
                // Where the last output is beyond a new limit, the limit wins over the rate.
                let (from, step) = (settings.limits().within(last), rate * h);
                let within = from == last && (u > last + step || u < last - step);
                assert!(!within, "{last:?} to {u:?} in {h:?} s at {rate:?} a second");
            }
            if !(h.is_finite() && h > T::ZERO) {
                assert_eq!(answer.status, Status::SamplePeriodRejected);
            }
            updates += 1;
        }
    }
    updates
}

/// Settings of any law, limits and watch; `None` where the numbers are refused.
fn settings<T: Scalar>(bytes: &mut Bytes<'_>) -> Option<Settings<T>> {
    let (terms, more) = (bytes.byte(), bytes.byte());
    let has = |flags: u8, bit: u8| flags & (1 << bit) != 0;
    let gain = bytes.number();
    let mut pid = Pid::proportional(T::from_f64(gain)).ok()?;
    if has(terms, 0) {
        pid = pid.with_integral(bytes.positive()).ok()?;
    }
    if has(terms, 1) {
        let filter = has(terms, 2).then(|| bytes.positive());
        pid = pid.with_derivative(bytes.positive(), filter).ok()?;
    }
    if has(terms, 3) {
        pid = pid.with_setpoint_weights(bytes.scalar(), bytes.scalar()).ok()?;
    }
    if has(terms, 4) {
        pid = pid.with_tracking_time(bytes.positive()).ok()?;
    }
    if has(terms, 5) {
        let bleed = has(terms, 6).then(|| bytes.positive());
        pid = pid.with_bias(bytes.scalar(), bleed).ok()?;
    }
    let direct = has(terms, 7);
    let mut settings = Settings::new(if direct { pid.with_action(Action::Direct) } else { pid });
    if has(more, 0) {
        // The observer's gains have the sign of the law's, or there is none.
        let sign = if (gain > 0.0) == direct { -1.0 } else { 1.0 };
        let mut next = || T::from_f64(sign * bytes.positive::<f64>());
        let (observer_gain, model_gain) = (next(), next());
        let (dead_time, period) = (bytes.positive(), bytes.positive());
        let mut observer = Observer::new(observer_gain, model_gain, dead_time, period).ok()?;
        if has(more, 1) {
            observer = observer.with_lead(bytes.positive(), bytes.positive()).ok()?;
        }
        settings =
            settings.with_observer(if has(more, 2) { observer.predicting() } else { observer }).ok()?;
    }
    if more >> 3 != 0 {
        let low = has(more, 3).then(|| bytes.scalar());
        let high = has(more, 4).then(|| bytes.scalar());
        let mut limits = Limits::new(low, high).ok()?;
        if has(more, 5) {
            limits = limits.with_rate(bytes.positive()).ok()?;
        }
        settings = settings.with_limits(limits).ok()?;
    }
    if has(more, 6) {
        let mut watch = Watch::none().with_stale_time(bytes.positive()).ok()?;
        if has(more, 7) {
            watch = watch.with_failure(bytes.positive(), bytes.scalar()).ok()?;
        }
        settings = settings.with_watch(watch).ok()?;
    }
    Some(settings)
}

/// An input, good or bad.
fn input<T: Scalar>(bytes: &mut Bytes<'_>) -> Input<T> {
    let flags = bytes.byte();
    let sample_period = if flags & 1 == 0 { bytes.positive() } else { bytes.scalar() };
    let measured = (flags & 2 == 0).then(|| bytes.scalar());
    let mode = match flags >> 6 {
        0 => Mode::Manual(bytes.scalar()),
        1 => Mode::Hold,
        _ => Mode::Automatic,
    };
    let mut input = Input::automatic(sample_period, bytes.scalar(), T::ZERO);
    input.controlled_variable = measured;
    input.mode = mode;
    if flags & 4 != 0 {
        input.feed_forward = bytes.scalar();
    }
    if flags & 8 != 0 {
        input.applied = Some(bytes.scalar());
    }
    input
}

/// Numbers out of bytes; behind the end there are zeros.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    fn word(&mut self) -> i16 {
        i16::from_le_bytes([self.byte(), self.byte()])
    }

    /// Any number: mostly of the size of a plant's signals, at times at an edge of the format.
    fn number(&mut self) -> f64 {
        match self.byte() % 8 {
            0..=4 => f64::from(self.word()) / 1024.0,
            5 => 10f64.powi(i32::from(self.word() % 310)),
            6 => f64::from_bits(u64::from_le_bytes(std::array::from_fn(|_| self.byte()))),
            _ => {
                let edges = [
                    f64::NAN,
                    f64::INFINITY,
                    f64::NEG_INFINITY,
                    f64::MAX,
                    f64::MIN,
                    f64::MIN_POSITIVE,
                    f64::from(f32::MAX),
                    -0.0,
                ];
                edges[usize::from(self.byte() % 8)]
            }
        }
    }

    fn scalar<T: Scalar>(&mut self) -> T {
        T::from_f64(self.number())
    }

    /// A number that is positive where it is a number other than 0.
    fn positive<T: Scalar>(&mut self) -> T {
        T::from_f64(self.number().abs())
    }
}
