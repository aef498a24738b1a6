//! The update of a controller: one sequence of arithmetic for all laws.

use crate::{Input, Limited, Mode, Output, Scalar, Segment, Settings, State, Status, Sum};

impl<T: Scalar, S: AsRef<[Segment<T>]> + AsMut<[Segment<T>]>> State<T, S> {
    /// One update: takes the measurement, returns the manipulated variable.
    ///
    /// In this order: the observer's model runs on to now; the measurement is judged; the terms move; the wanted
    /// output is their sum; the output is what the limits leave of it. The integral and the model learn what was
    /// applied at the next update.
    pub fn update(&mut self, settings: &Settings<T>, input: &Input<T>) -> Output<T> {
        let h = input.sample_period;
        if !(h.is_finite() && h > T::ZERO) {
            self.manipulated_variable = settings.limits().within(self.manipulated_variable);
            return self.output(Limited::No, Status::SamplePeriodRejected);
        }

        // The time since the last update, with what was applied in it: while nothing limited, the model is driven by
        // u_pd, otherwise by u_applied + D̂, which leaves out what feed-forward and bias balance.
        let applied =
            input.applied.filter(|applied| applied.is_finite()).unwrap_or(self.manipulated_variable);
        let shortfall = applied - self.wanted;
        if let Some(observer) = self.law.observer {
            let mut drive = self.unassisted;
            if shortfall != T::ZERO {
                drive = applied + (self.observer.load_estimate - self.assistance());
            }
            if !drive.is_finite() {
                drive = applied;
            }
            self.observer.advance(&observer, &mut self.line, drive, h);
        }
        let mut status = self.take(input);

        // The measurement.
        let age = self.age;
        self.age.add(h);
        if !self.age.value().is_finite() {
            self.age = age;
        }
        let elapsed = self.age.value();
        let late = settings.watch().is_stale(elapsed) || settings.watch().is_stale(h);
        let new = input.controlled_variable.filter(|measured| settings.watch().accepts(*measured));
        let judged = match (input.controlled_variable, new) {
            (Some(_), None) => Err(Status::MeasurementRejected),
            (None, _) if late || !self.follows => Err(Status::MeasurementStale),
            _ => Ok(()),
        };
        if let Err(judgement) = judged {
            return self.without_measurement(settings, input, judgement);
        }
        let start = !self.follows || (late && new.is_some());
        let by_law = input.mode == Mode::Automatic && self.automatic && !start;
        let before = (self.pid, self.observer, self.controlled_variable, self.unassisted, self.wanted);

        // The terms.
        if let Some(controlled_variable) = new {
            self.controlled_variable = controlled_variable;
            if let Some(observer) = self.law.observer {
                if start {
                    self.observer.start(&observer, controlled_variable, self.observer.load_estimate);
                } else {
                    self.observer.measure(&observer, controlled_variable, elapsed);
                }
            }
            if !by_law {
                self.pid.forget_setpoint(self.setpoint);
            }
            self.pid.measure(&self.law.pid, self.seen(), elapsed);
        }
        self.pid.integrate(&self.law.pid, self.setpoint, shortfall, h);
        self.pid.bleed(h);

        // The wanted output; by whom it is computed decides what gives way.
        let (bumpless, limited) = settings.limits().apply(self.operator(input), self.manipulated_variable, h);
        if by_law {
            self.unassisted =
                self.pid.proportional_derivative(&self.law.pid, self.setpoint) + self.pid.integral.value();
            self.wanted = self.unassisted + (self.assistance() - self.observer.load_estimate);
        }
        let target = if by_law { self.wanted } else { bumpless };
        let mut gives_way = !by_law;
        if self.law != *settings.law() {
            if self.fits(settings).is_ok() {
                self.adopt(settings.law());
                gives_way = true;
            } else {
                status = Status::SettingsRejected;
            }
        }
        if gives_way {
            self.seat(target);
        }
        if !(self.wanted.is_finite() && self.unassisted.is_finite()) {
            (self.pid, self.observer, self.controlled_variable, self.unassisted, self.wanted) = before;
            return self.without_measurement(settings, input, Status::MeasurementRejected);
        }

        // The output.
        let (output, limited) = if by_law {
            settings.limits().apply(self.wanted, self.manipulated_variable, h)
        } else {
            (bumpless, limited)
        };
        self.manipulated_variable = output;
        if new.is_some() {
            self.age = Sum::new(T::ZERO);
        }
        self.follows = true;
        self.automatic = input.mode == Mode::Automatic;
        self.output(limited, status)
    }

    /// Takes setpoint and feed-forward where they are good, and says whether all inputs but the measurement are.
    fn take(&mut self, input: &Input<T>) -> Status {
        let mut good = true;
        if input.setpoint.is_finite() {
            self.setpoint = input.setpoint;
        } else {
            good = false;
        }
        if input.feed_forward.is_finite() {
            self.feed_forward = input.feed_forward;
        } else {
            good = false;
        }
        if let Some(applied) = input.applied {
            good = good && applied.is_finite();
        }
        if let Mode::Manual(output) = input.mode {
            good = good && output.is_finite();
        }
        if good { Status::Good } else { Status::InputRejected }
    }

    /// The output that the operator asks for: the last one where none is asked for.
    fn operator(&self, input: &Input<T>) -> T {
        match input.mode {
            Mode::Manual(output) if output.is_finite() => output,
            _ => self.manipulated_variable,
        }
    }

    /// The update without a measurement to go by: the law stands still, and starts again without bump.
    fn without_measurement(
        &mut self,
        settings: &Settings<T>,
        input: &Input<T>,
        judgement: Status,
    ) -> Output<T> {
        self.follows = false;
        let mut target = self.operator(input);
        let mut status = judgement;
        if let Some(safe_output) = settings.watch().failed(self.age.value()) {
            status = Status::MeasurementFailed;
            if input.mode == Mode::Automatic {
                target = safe_output;
            }
        }
        let (output, limited) =
            settings.limits().apply(target, self.manipulated_variable, input.sample_period);
        self.manipulated_variable = output;
        self.output(limited, status)
    }

    fn output(&self, limited: Limited, status: Status) -> Output<T> {
        Output {
            manipulated_variable: self.manipulated_variable,
            wanted: self.wanted,
            limited,
            load_estimate: self.law.observer.map(|_| self.observer.load_estimate),
            status,
        }
    }
}
