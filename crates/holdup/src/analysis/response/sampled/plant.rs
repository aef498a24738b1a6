//! The process between samples, in closed form.
//!
//! Its input is a straight line from knot to knot: held outputs, valves on their way, loads on a ramp. Behind the dead
//! time, which is exact, the integrators make polynomials of it and a lag makes one exponential: nothing is
//! approximated, at samples and between them.

use std::collections::VecDeque;
use std::sync::LazyLock;

use super::super::legendre::{Poly, TERMS};
use crate::analysis::exponential::rests;
use crate::model::Process;

/// From this time on the input is `value + slope·(t − time)`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knot {
    pub(super) time: f64,
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// Lag output z, its integral where there are two integrators, and the controlled variable y, from rest at 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct States {
    z: f64,
    rate: f64,
    y: f64,
}

/// The process and where it stands.
#[derive(Debug, Clone)]
pub(super) struct Plant {
    gain: f64,
    lag: Option<f64>,
    double: bool,
    dead_time: f64,
    /// The first is the one that drives the process now, one dead time ago.
    knots: VecDeque<Knot>,
    now: f64,
    states: States,
}

/// A stretch of time on which the delayed input is one straight line.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    pub(super) start: f64,
    pub(super) length: f64,
    gain: f64,
    lag: Option<f64>,
    double: bool,
    states: States,
    /// Delayed input at the start, and its slope.
    input: (f64, f64),
}

impl Plant {
    pub(super) fn new(process: &Process) -> Self {
        Self {
            gain: process.process_gain(),
            lag: process.lag(),
            double: process.integrators() == 2,
            dead_time: process.dead_time(),
            knots: VecDeque::from([Knot { time: f64::NEG_INFINITY, value: 0.0, slope: 0.0 }]),
            now: 0.0,
            states: States::default(),
        }
    }

    /// Controlled variable now [output unit].
    pub(super) fn output(&self) -> f64 {
        self.states.y
    }

    /// The input is this from now on.
    pub(super) fn feed(&mut self, value: f64, slope: f64) {
        let knot = Knot { time: self.now, value, slope };
        match self.knots.back_mut() {
            Some(last) if last.time == self.now => *last = knot,
            Some(last) if last.slope == 0.0 && slope == 0.0 && last.value == value => {}
            _ => self.knots.push_back(knot),
        }
    }

    /// Lets time go on to `until` [s] and shows each piece of it.
    pub(super) fn advance(&mut self, until: f64, mut show: impl FnMut(&Piece)) {
        while self.now < until {
            // Times carry a rounding each: what is nearer than that is one time.
            let tiny = 4.0 * f64::EPSILON * (until + self.dead_time);
            let mut end = until;
            while let Some(next) = self.knots.get(1) {
                let arrival = next.time + self.dead_time;
                if arrival > self.now + tiny {
                    if arrival < until - tiny {
                        end = arrival;
                    }
                    break;
                }
                self.knots.pop_front();
            }
            let Knot { time, value, slope } = self.knots[0];
            let elapsed = if slope == 0.0 { 0.0 } else { (self.now - self.dead_time - time).max(0.0) };
            let piece = Piece {
                start: self.now,
                length: end - self.now,
                gain: self.gain,
                lag: self.lag,
                double: self.double,
                states: self.states,
                input: (value + slope * elapsed, slope),
            };
            show(&piece);
            self.states = piece.at(piece.length);
            self.now = end;
        }
    }
}

impl Piece {
    /// The states at this time from the start [s].
    fn at(&self, t: f64) -> States {
        let k = self.gain;
        let (p0, p1) = self.input;
        let States { z, rate, y } = self.states;
        let Some(lag) = self.lag else {
            let (once, twice) = (k * t * (p0 + 0.5 * p1 * t), 0.5 * k * t * t * (p0 + p1 * t / 3.0));
            let y = if self.double { y + rate * t + twice } else { y + once };
            return States { z, rate: if self.double { rate + once } else { rate }, y };
        };
        let [e1, e2, e3, e4] = rests(t / lag);
        let once = lag * (z * e1 + k * (p0 * e2 + p1 * lag * e3));
        let z_end = z * (-t / lag).exp() + k * (p0 * e1 + p1 * lag * e2);
        if !self.double {
            return States { z: z_end, rate, y: y + once };
        }
        let twice = lag * lag * (z * e2 + k * (p0 * e3 + p1 * lag * e4));
        States { z: z_end, rate: rate + once, y: y + rate * t + twice }
    }

    /// Controlled variable at this time from the start [s].
    pub(super) fn output(&self, t: f64) -> f64 {
        self.at(t).y
    }

    /// The controlled variable as polynomials, stretch by stretch: start from the piece's start [s], length [s],
    /// polynomial. Where there is a lag a stretch is so short that its Taylor series is the function, to rounding.
    pub(super) fn polynomials(&self, mut show: impl FnMut(f64, f64, &Poly)) {
        let Some(lag) = self.lag else {
            show(0.0, self.length, &self.taylor(&self.states, self.input.0, self.length));
            return;
        };
        let mut from = 0.0;
        while from < self.length {
            let left = self.length - from;
            // One time constant, then more as the exponential dies; after 40 it is below rounding.
            let reach = match from / lag {
                gone if gone > 40.0 => f64::INFINITY,
                gone if gone > 8.0 => 2.5,
                gone if gone > 0.5 => 2.0,
                _ => 1.0,
            };
            // No slivers.
            let length = if left < 1.25 * reach * lag { left } else { reach * lag };
            let states = if from == 0.0 { self.states } else { self.at(from) };
            show(from, length, &self.taylor(&states, self.input.0 + self.input.1 * from, length));
            from = if length == left { self.length } else { from + length };
        }
    }

    /// The Taylor series from these states on, in the Legendre basis of a cell of this length.
    fn taylor(&self, states: &States, p0: f64, length: f64) -> Poly {
        let (k, p1) = (self.gain, self.input.1);
        // Coefficients in t/length.
        let mut c = [0.0; TERMS];
        if let Some(lag) = self.lag {
            let x = length / lag;
            c[0] = states.z;
            c[1] = (k * p0 - states.z) * x;
            c[2] = (k * p1 * length - c[1]) * x / 2.0;
            for j in 3..TERMS {
                #[expect(clippy::cast_precision_loss, reason = "at most 23")]
                let order = j as f64;
                c[j] = -c[j - 1] * x / order;
            }
            if length > 4.0 * lag {
                // The exponential is gone: what is left of it is rounding, which a long cell must not enlarge.
                c[1] = k * p1 * length;
                c[2..].fill(0.0);
            }
        } else {
            (c[0], c[1]) = (k * p0, k * p1 * length);
        }
        let mut c = integral(&c, length, if self.double { states.rate } else { states.y });
        if self.double {
            c = integral(&c, length, states.y);
        }
        let mut legendre = [0.0; TERMS];
        for (value, row) in c.iter().zip(POWERS.iter()).filter(|(value, _)| **value != 0.0) {
            for (sum, weight) in legendre.iter_mut().zip(row) {
                *sum += value * weight;
            }
        }
        legendre
    }
}

/// Coefficients of the integral over a cell of this length, from `start` on.
fn integral(c: &Poly, length: f64, start: f64) -> Poly {
    let mut integral = [0.0; TERMS];
    integral[0] = start;
    for j in 1..TERMS {
        #[expect(clippy::cast_precision_loss, reason = "at most 23")]
        let order = j as f64;
        integral[j] = c[j - 1] * length / order;
    }
    integral
}

/// `xⁿ` for x from 0 to 1 in the Legendre polynomials of `2x − 1`: `(2k+1)·(n!)²/((n−k)!·(n+k+1)!)`, all positive.
static POWERS: LazyLock<[Poly; TERMS]> = LazyLock::new(|| {
    let mut table = [[0.0; TERMS]; TERMS];
    let mut n = 0.0;
    for row in &mut table {
        row[0] = 1.0 / (n + 1.0);
        let mut k = 0.0;
        for j in 1..TERMS {
            let before = row[j - 1];
            row[j] = before * (2.0 * k + 3.0) / (2.0 * k + 1.0) * (n - k) / (n + k + 2.0);
            k += 1.0;
        }
        n += 1.0;
    }
    table
});

#[cfg(test)]
mod tests {
    use super::super::super::legendre::value;
    use super::*;
    use crate::model::Seconds;

    fn outputs(process: &Process, feed: &[(f64, f64, f64)], until: f64) -> (f64, Vec<Piece>) {
        let mut plant = Plant::new(process);
        let mut pieces = Vec::new();
        for &(time, value, slope) in feed {
            plant.advance(time, |piece| pieces.push(piece.clone()));
            plant.feed(value, slope);
        }
        plant.advance(until, |piece| pieces.push(piece.clone()));
        (plant.output(), pieces)
    }

    #[test]
    fn a_pulse_through_an_integrator_arrives_one_dead_time_later_at_its_area() {
        let process = Process::integrating(0.5, Seconds(2.3)).unwrap();
        let (y, _) = outputs(&process, &[(0.0, 4.0, 0.0), (1.0, 0.0, 0.0)], 2.8);
        assert!((y - 1.0).abs() < 1e-15); // half of the pulse has arrived: 0.5·4·0.5
        let (y, _) = outputs(&process, &[(0.0, 4.0, 0.0), (1.0, 0.0, 0.0)], 9.0);
        assert!((y - 2.0).abs() < 1e-15);
    }

    #[test]
    fn a_ramp_through_two_integrators_is_a_cubic() {
        let process = Process::double_integrating(2.0, Seconds(1.0)).unwrap();
        let (y, _) = outputs(&process, &[(0.0, 0.0, 3.0)], 5.0);
        assert!((y - 2.0 * 3.0 * 64.0 / 6.0).abs() < 1e-13); // K·rate·t³/6 after 4 s, a dozen roundings
    }

    #[test]
    fn a_lag_delays_a_ramp_by_its_time_in_the_end_and_does_not_act_at_first() {
        let process = Process::integrating(2.0, Seconds(1.0)).unwrap().with_lag(Seconds(0.1)).unwrap();
        // A step: y = K·(t − T·(1 − e^(−t/T))), after 5 s.
        let (y, _) = outputs(&process, &[(0.0, 1.0, 0.0)], 6.0);
        assert!((y - 2.0 * (5.0 - 0.1)).abs() < 1e-14);
        let slow = Process::integrating(2.0, Seconds(1.0)).unwrap().with_lag(Seconds(1e9)).unwrap();
        // A lag of 1e9 s is one more integrator: y = K/T·t²/2, to t/T.
        let (y, _) = outputs(&slow, &[(0.0, 1.0, 0.0)], 6.0);
        assert!((y / (2e-9 * 12.5) - 1.0).abs() < 1e-8);
    }

    #[test]
    fn the_polynomials_of_a_piece_are_its_closed_form_whatever_the_lag() {
        for lag in [1e-3, 0.2, 1.0, 3.0, 1e3] {
            for process in [
                Process::integrating(0.7, Seconds(1.0)).unwrap().with_lag(Seconds(lag)).unwrap(),
                Process::double_integrating(0.7, Seconds(1.0)).unwrap().with_lag(Seconds(lag)).unwrap(),
            ] {
                let feed = [(0.0, 1.0, 0.0), (1.5, -0.5, 0.3), (2.5, 2.0, -1.0)];
                let (_, pieces) = outputs(&process, &feed, 8.0);
                let mut covered = 0.0;
                for piece in &pieces {
                    piece.polynomials(|from, length, poly| {
                        covered += length;
                        for s in [-1.0, -0.4, 0.3, 1.0] {
                            let t = from + 0.5 * length * (1.0 + s);
                            let (found, exact) = (value(poly, s), piece.output(t));
                            // Rounding of values up to 5, enlarged by the alternating series of e^(−3).
                            assert!(
                                (found - exact).abs() < 5e-14 * (1.0 + exact.abs()),
                                "{lag} {found} {exact}"
                            );
                        }
                    });
                }
                assert!((covered - 8.0).abs() < 1e-12); // the sum of a few thousand lengths
            }
        }
    }
}
