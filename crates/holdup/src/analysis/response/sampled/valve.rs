//! The valve: what becomes of the controller's output on its way into the process.

use super::equipment::EquipmentSettings;

/// A valve that receives the output in steps of its quantum, sticks, and moves at a limited rate.
///
/// Stiction is the data-driven model of Kano, Maruta, Kugemoto and Shimizu, "Practical model and detection algorithm for
/// valve stiction", 7th IFAC Symposium on Dynamics and Control of Process Systems (2004), 859–864: S is the width of stickband and
/// deadband together, J the slip jump. The valve stops when the output stops or turns. It starts again in its old
/// direction when the output has gone on by more than J, in the other one when it has come back by more than S; it
/// then stands at the output less (S − J)/2 in its direction. J = 0 is a pure deadband (backlash) of width S. At the
/// start it rests in the middle of its band.
///
/// All values are deviations from the manipulated variable at rest.
#[derive(Debug, Clone)]
pub(super) struct Valve {
    limits: Option<(f64, f64)>,
    rate: Option<f64>,
    quantum: Option<f64>,
    rest: f64,
    friction: Option<Friction>,
    position: f64,
    target: f64,
    /// Distance moved so far [input unit].
    pub(super) travel: f64,
}

/// State of the stiction model, in the names of its source.
#[derive(Debug, Clone)]
struct Friction {
    s: f64,
    j: f64,
    /// Output when the valve came to rest.
    us: f64,
    /// Direction of the frictional force.
    d: f64,
    resting: bool,
    last: f64,
    last_change: f64,
}

impl Friction {
    fn new(s: f64, j: f64) -> Self {
        Self { s, j, us: 0.5 * (s - j), d: 1.0, resting: true, last: 0.0, last_change: 0.0 }
    }

    /// The position that follows from this output; none where the valve stays.
    fn follow(&mut self, u: f64) -> Option<f64> {
        let change = u - self.last;
        if !self.resting && change * self.last_change <= 0.0 {
            self.us = self.last;
            self.resting = true;
        }
        (self.last, self.last_change) = (u, change);
        if self.resting {
            let beyond = self.d * (u - self.us);
            if -beyond > self.s {
                self.d = -self.d;
            } else if beyond <= self.j {
                return None;
            }
            self.resting = false;
        }
        Some(u - self.d * 0.5 * (self.s - self.j))
    }
}

impl Valve {
    pub(super) fn new(equipment: &EquipmentSettings) -> Self {
        let rest = equipment.initial_manipulated;
        Self {
            limits: equipment.limits.map(|(low, high)| (low - rest, high - rest)),
            rate: equipment.rate_limit,
            quantum: equipment.output_quantum,
            rest,
            friction: equipment.stiction.map(|(s, j)| Friction::new(s, j)),
            position: 0.0,
            target: 0.0,
            travel: 0.0,
        }
    }

    /// The output that comes out of the converter for this one.
    fn converted(&self, output: f64) -> f64 {
        let stepped = self.quantum.map_or(output, |q| quantised(output + self.rest, q) - self.rest);
        self.limits.map_or(stepped, |(low, high)| stepped.clamp(low, high))
    }

    /// The controller's output is this from now on.
    pub(super) fn command(&mut self, output: f64) {
        let output = self.converted(output);
        let target = match &mut self.friction {
            None => output,
            Some(friction) => friction.follow(output).unwrap_or(self.target),
        };
        self.target = self.limits.map_or(target, |(low, high)| target.clamp(low, high));
        if self.rate.is_none() {
            self.travel += (self.target - self.position).abs();
            self.position = self.target;
        }
    }

    /// Position now, and the rate at which it moves [input unit/s].
    pub(super) fn now(&self) -> (f64, f64) {
        let to_go = self.target - self.position;
        let rate = self.rate.filter(|_| to_go != 0.0).map_or(0.0, |rate| rate.copysign(to_go));
        (self.position, rate)
    }

    /// Time until it stands [s], where it moves.
    pub(super) fn moving_for(&self) -> Option<f64> {
        let rate = self.now().1;
        (rate != 0.0).then(|| (self.target - self.position) / rate)
    }

    /// Time goes on by so much [s].
    pub(super) fn advance(&mut self, duration: f64) {
        let Some(left) = self.moving_for() else { return };
        let before = self.position;
        // The last move ends where it was meant to, whatever the rounding of the times.
        let arrived = duration >= left * (1.0 - 1e-9);
        self.position = if arrived { self.target } else { before + self.now().1 * duration };
        self.travel += (self.position - before).abs();
    }
}

/// The multiple of the quantum that is nearest.
pub(super) fn quantised(value: f64, quantum: f64) -> f64 {
    (value / quantum).round() * quantum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn positions(settings: &EquipmentSettings, outputs: &[f64]) -> Vec<f64> {
        let mut valve = Valve::new(settings);
        let positions = outputs.iter().map(|&output| {
            valve.command(output);
            valve.now().0
        });
        positions.collect()
    }

    #[test]
    fn without_slip_jump_stiction_is_backlash() {
        let settings = EquipmentSettings { stiction: Some((2.0, 0.0)), ..EquipmentSettings::default() };
        // Play of ±1 about the rest: position follows one behind the output, in the direction of the move.
        let outputs = [0.5, 1.0, 1.5, 3.0, 2.0, 1.0, 0.5, -2.0, -1.0, 1.0];
        assert_eq!(positions(&settings, &outputs), [0.0, 0.0, 0.5, 2.0, 2.0, 2.0, 1.5, -1.0, -1.0, 0.0]);
    }

    #[test]
    fn a_sticking_valve_jumps_by_the_slip_jump() {
        let settings = EquipmentSettings { stiction: Some((3.0, 1.0)), ..EquipmentSettings::default() };
        // It starts beyond (S + J)/2 = 2, then stands (S − J)/2 = 1 behind; moving, it follows without sticking.
        // It stops when the output stops; in the same direction it starts after J, back after S.
        let outputs = [1.9, 2.1, 2.5, 2.5, 3.4, 3.6, 3.0, 0.7, 0.5];
        let expected = [0.0, 1.1, 1.5, 1.5, 1.5, 2.6, 2.6, 2.6, 1.5];
        for (position, expected) in positions(&settings, &outputs).iter().zip(expected) {
            assert!((position - expected).abs() < 1e-15, "{position} {expected}"); // two roundings
        }
    }

    #[test]
    fn quanta_are_those_of_the_output_scale_and_limits_hold_after_them() {
        let settings = EquipmentSettings {
            output_quantum: Some(0.4),
            limits: Some((0.0, 1.1)),
            initial_manipulated: 0.5,
            ..EquipmentSettings::default()
        };
        // 0.5 + 0.2 → 0.8 − 0.5; 0.5 + 2 → 2.4, limited to 1.1.
        let found = positions(&settings, &[0.2, 2.0, -3.0]);
        for (position, expected) in found.iter().zip([0.3, 0.6, -0.5]) {
            assert!((position - expected).abs() < 1e-15, "{position} {expected}"); // two roundings
        }
    }

    #[test]
    fn a_valve_with_a_rate_limit_moves_in_a_straight_line_and_travels_what_it_moved() {
        let settings = EquipmentSettings { rate_limit: Some(2.0), ..EquipmentSettings::default() };
        let mut valve = Valve::new(&settings);
        valve.command(3.0);
        assert_eq!((valve.now(), valve.moving_for()), ((0.0, 2.0), Some(1.5)));
        valve.advance(1.0);
        valve.command(1.0);
        assert_eq!(valve.now(), (2.0, -2.0));
        valve.advance(0.5);
        assert_eq!((valve.now(), valve.moving_for()), ((1.0, 0.0), None));
        assert_eq!(valve.travel, 3.0);
    }
}
