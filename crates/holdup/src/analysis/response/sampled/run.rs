//! The loop itself: the law of `holdup-control`, the equipment, the process, event by event.

use holdup_control::{Input, Limited, Limits, Segment, Settings, State};

use super::equipment::{Equipment, LoadRamp};
use super::error::SampledError;
use super::load::{changes, load_at};
use super::plant::{Piece, Plant};
use super::sensor::Sensor;
use super::valve::Valve;
use crate::analysis::response::Scenario;
use crate::model::{Process, Seconds};

/// Beyond this the square of a signal is no number.
const LARGEST: f64 = 1e140;

/// What is seen of one piece of time, in deviations from rest.
pub(super) struct Moment<'a> {
    pub(super) piece: &'a Piece,
    pub(super) setpoint: f64,
    /// Output of the law at the valve.
    pub(super) manipulated: f64,
    pub(super) load_estimate: Option<f64>,
    /// Valve position at the start and its rate.
    pub(super) valve: (f64, f64),
    /// Load at the start and its rate.
    pub(super) load: (f64, f64),
}

/// How a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Count {
    pub(super) samples: u64,
    pub(super) lost: u64,
    pub(super) limited: u64,
    pub(super) travel: f64,
    pub(super) overflow_at: Option<f64>,
}

/// One run of a loop.
pub(super) struct Run<'a> {
    scenario: &'a Scenario,
    ramps: &'a [LoadRamp],
    settings: Settings<f64>,
    state: State<f64, Vec<Segment<f64>>>,
    plant: Plant,
    valve: Valve,
    sensor: Sensor,
    now: f64,
    setpoint: f64,
    /// Output of the law, and what it is from a time on.
    manipulated: f64,
    coming: Option<(f64, f64)>,
    load_estimate: Option<f64>,
    count: Count,
}

impl<'a> Run<'a> {
    pub(super) fn new(
        settings: &Settings<f64>,
        process: &Process,
        equipment: &Equipment,
        scenario: &'a Scenario,
        ramps: &'a [LoadRamp],
    ) -> Result<Self, SampledError> {
        let equipment = equipment.settings();
        let rest = equipment.initial_manipulated;
        let (low, high) = equipment.limits.map(|(low, high)| (low - rest, high - rest)).unzip();
        let mut limits = Limits::new(low, high)?;
        if let Some(rate) = equipment.rate_limit {
            limits = limits.with_rate(rate)?;
        }
        let settings = (*settings).with_limits(limits)?;
        // Late samples follow each other faster than the period says, by no more than the jitter.
        let line = match settings.law().observer {
            Some(observer) => {
                let shortest = equipment.sample_period - equipment.jitter;
                let segments = holdup_control::segments_needed(observer.dead_time(), shortest);
                vec![Segment::default(); segments.clamp(settings.segments_needed(), 1 << 22)]
            }
            None => Vec::new(),
        };
        Ok(Self {
            scenario,
            ramps,
            state: State::at_rest(&settings, line, 0.0, 0.0, 0.0)?,
            load_estimate: settings.law().observer.map(|_| 0.0),
            settings,
            plant: Plant::new(process),
            valve: Valve::new(equipment),
            sensor: Sensor::new(equipment),
            now: 0.0,
            setpoint: 0.0,
            manipulated: 0.0,
            coming: None,
            count: Count::default(),
        })
    }

    /// Runs to the horizon; the sample period is the nominal one, the delay that of the computation.
    pub(super) fn run(
        mut self,
        sample_period: Seconds,
        delay: Seconds,
        mut show: impl FnMut(&Moment<'_>),
    ) -> Count {
        let (Seconds(h), Seconds(delay)) = (sample_period, delay);
        let horizon = self.scenario.horizon();
        // An event that falls on a sample is seen by it, whatever the rounding of the two times.
        let together = 1e-9 * h;
        let changes = changes(self.scenario, self.ramps);
        let mut next_change = 0;
        let mut number = 0.0;
        let mut next_sample = self.sensor.time_of(number);
        let mut last_sample = next_sample - h;
        loop {
            while changes.get(next_change).is_some_and(|&time| time <= self.now + together) {
                next_change += 1;
            }
            self.setpoint = self.scenario.setpoint_at(self.now + together) - self.scenario.initial();
            // A delay of a whole sample ends where the next sample is taken: the older output first.
            self.deliver(together);
            if next_sample <= self.now + together {
                let output = self.sample(next_sample - last_sample);
                self.coming = Some((self.now + delay, output));
                last_sample = next_sample;
                number += 1.0;
                next_sample = self.sensor.time_of(number);
                self.deliver(together);
            }
            if self.now >= horizon {
                break;
            }
            let mut until = horizon.min(next_sample);
            if let Some(&time) = changes.get(next_change) {
                until = until.min(time);
            }
            if let Some((time, _)) = self.coming {
                until = until.min(time);
            }
            match self.valve.moving_for() {
                // So near that the clock would not move: it is there.
                Some(left) if left <= together => self.valve.advance(left),
                Some(left) => until = until.min(self.now + left),
                None => {}
            }
            if horizon - until <= together {
                until = horizon;
            }
            self.advance(until, together, &mut show);
            if self.plant.output().abs() >= LARGEST || self.manipulated.abs() >= LARGEST {
                self.count.overflow_at = Some(self.now);
                break;
            }
        }
        self.count.travel = self.valve.travel;
        self.count
    }

    /// Gives the valve the output that has come, if one has.
    fn deliver(&mut self, together: f64) {
        let Some((_, output)) = self.coming.take_if(|(time, _)| *time <= self.now + together) else { return };
        self.manipulated = output;
        self.valve.command(output);
        if let Some(estimate) = &mut self.load_estimate {
            *estimate = self.state.observer.load_estimate;
        }
    }

    /// One sample; returns the output that follows from it.
    fn sample(&mut self, elapsed: f64) -> f64 {
        let initial = self.scenario.initial();
        let measured = self.sensor.measure(self.plant.output() + initial);
        self.count.samples += 1;
        self.count.lost += u64::from(measured.is_none());
        let input = Input {
            controlled_variable: measured.map(|measured| measured - initial),
            ..Input::automatic(elapsed, self.setpoint, 0.0)
        };
        let output = self.state.update(&self.settings, &input);
        self.count.limited += u64::from(output.limited != Limited::No);
        output.manipulated_variable
    }

    /// Time goes on to `until` with nothing happening before.
    fn advance(&mut self, until: f64, together: f64, show: &mut impl FnMut(&Moment<'_>)) {
        let (position, speed) = self.valve.now();
        let (load, rate) = load_at(self.scenario, self.ramps, self.now + together);
        let load = load - rate * together;
        self.plant.feed(position + load, speed + rate);
        let (setpoint, manipulated, load_estimate) = (self.setpoint, self.manipulated, self.load_estimate);
        let start = self.now;
        self.plant.advance(until, |piece| {
            let gone = piece.start - start;
            show(&Moment {
                piece,
                setpoint,
                manipulated,
                load_estimate,
                valve: (position + speed * gone, speed),
                load: (load + rate * gone, rate),
            });
        });
        self.valve.advance(until - self.now);
        self.now = until;
    }
}
