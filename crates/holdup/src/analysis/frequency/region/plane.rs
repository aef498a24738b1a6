//! A point of the plane as a closed loop.

use super::super::characteristic::Characteristic;
use super::super::envelope::Envelope;
use super::super::margins::{Margins, margins};
use super::super::winding;
use super::{Plane, Window};
use crate::model::{ClosedLoop, Controller, Observer, Process, Seconds};

/// Bands of an octave through which Δ is followed; where more are needed the point counts as not stable.
const WORK: usize = 20_000;

/// The fixed settings, the plane and its window.
pub(super) struct Settings<'a> {
    pub(super) process: &'a Process,
    pub(super) controller: &'a Controller,
    pub(super) plane: Plane,
    pub(super) window: Window,
    /// Sign of the process gain, and so of Kc and Ko.
    pub(super) sign: f64,
}

impl<'a> Settings<'a> {
    pub(super) fn new(
        process: &'a Process,
        controller: &'a Controller,
        plane: Plane,
        window: Window,
    ) -> Self {
        Self { process, controller, plane, window, sign: process.process_gain().signum() }
    }

    /// The controller of gain `kc` [input unit / output unit] with the fixed settings; those of the plane as given.
    pub(super) fn with_gain(&self, kc: f64) -> Option<Controller> {
        let old = self.controller;
        let mut new = Controller::proportional(kc).ok()?;
        if let Some(ti) = old.integral_time() {
            new = new.with_integral_time(Seconds(ti)).ok()?;
        }
        new = self.with_derivative(new, old.derivative_time().unwrap_or(0.0))?;
        if let Some(filter) = old.output_filter() {
            new = new.with_output_filter(filter.a1, filter.a2).ok()?;
        }
        Some(old.observer().map_or(new, |observer| new.with_observer(observer)))
    }

    fn with_derivative(&self, controller: Controller, td: f64) -> Option<Controller> {
        let new = controller.with_derivative_time(Seconds(td)).ok()?;
        match self.controller.derivative_filter() {
            Some(filter) => new.with_filter_time(Seconds(filter.time())).ok(),
            None => Some(new),
        }
    }

    /// The observer of gain `ko` with the model of the fixed one; none of gain 0.
    fn observer(&self, ko: f64) -> Option<Observer> {
        let mut new = Observer::new(ko).ok()?;
        if let Some(old) = self.controller.observer() {
            if let Some(gain) = old.model_gain() {
                new = new.with_model_gain(gain).ok()?;
            }
            if let Some(dead_time) = old.model_dead_time() {
                new = new.with_model_dead_time(Seconds(dead_time)).ok()?;
            }
        }
        Some(new)
    }

    /// The loop at a point; gains with their sign. `None` where a setting is out of its range.
    pub(super) fn closed(&self, [x, y]: [f64; 2]) -> Option<ClosedLoop> {
        let controller = self.with_gain(x)?;
        let controller = match self.plane {
            Plane::KcTi => controller.with_integral_time(Seconds(y)).ok()?,
            Plane::KcTd => self.with_derivative(controller, y)?,
            Plane::KcKo if y == 0.0 => controller.without_observer(),
            Plane::KcKo => controller.with_observer(self.observer(y)?),
        };
        Some(ClosedLoop::new(self.process, &controller))
    }

    /// Whether the loop at a point is stable, by the argument principle.
    pub(super) fn stable(&self, point: [f64; 2]) -> bool {
        let characteristic = self.closed(point).and_then(|l| Characteristic::new(&l).ok());
        characteristic.is_some_and(|c| winding::unstable_poles(&c, &Envelope::new(&c), WORK) == Ok(0))
    }

    /// The margins at a point where the loop is stable.
    pub(super) fn margins(&self, point: [f64; 2]) -> Option<Margins> {
        self.closed(point).and_then(|l| margins(&l).ok()).filter(|m| m.stable)
    }

    /// A point of the unit square as one of the plane.
    pub(super) fn point(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let y = if self.plane == Plane::KcKo { self.sign * v } else { v };
        [self.sign * u * self.window.proportional_gain, y * self.window.other]
    }

    /// A point of the plane in the unit square of the window.
    pub(super) fn square(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let y = if self.plane == Plane::KcKo { self.sign * y } else { y };
        [self.sign * x / self.window.proportional_gain, y / self.window.other]
    }
}
