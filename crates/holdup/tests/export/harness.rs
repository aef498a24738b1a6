//! Tells exported controllers what standard input says, and writes what they answer: numbers as bits.

use exports::*;
use holdup_control::{Input, Mode};

/// The words of a line as bits.
struct Words<'l>(std::str::SplitWhitespace<'l>);

impl Words<'_> {
    fn bits(&mut self) -> u64 {
        u64::from_str_radix(self.0.next().unwrap(), 16).unwrap()
    }

    fn number(&mut self) -> f64 {
        f64::from_bits(self.bits())
    }

    fn input(&mut self) -> Input<f64> {
        let (sample_period, setpoint) = (self.number(), self.number());
        let controlled_variable = (self.bits() != 0, self.number());
        let feed_forward = self.number();
        let applied = (self.bits() != 0, self.number());
        let (mode, manual) = (self.bits(), self.number());
        Input {
            sample_period,
            setpoint,
            controlled_variable: controlled_variable.0.then_some(controlled_variable.1),
            feed_forward,
            applied: applied.0.then_some(applied.1),
            mode: [Mode::Automatic, Mode::Manual(manual), Mode::Hold][mode as usize],
        }
    }
}

/// Runs one of the controllers to the end of its part of the trace.
macro_rules! run {
    ($module:ident, $lines:ident) => {{
        let mut controller = None;
        while let Some(line) = $lines.next_if(|line| !line.starts_with('d')) {
            let mut words = Words(line[1..].split_whitespace());
            if line.starts_with('u') {
                let controller: &mut $module::Controller = controller.as_mut().unwrap();
                let output = controller.step(&words.input());
                let estimate = output.load_estimate.unwrap_or(0.0);
                println!(
                    "{:WIDTHx} {:WIDTHx} {} {:WIDTHx} {}",
                    output.manipulated_variable.to_bits(),
                    output.wanted.to_bits(),
                    output.limited as u8,
                    estimate.to_bits(),
                    output.status as u8
                );
            } else {
                let made = if line.starts_with('o') {
                    $module::Controller::switched_on(words.number())
                } else {
                    $module::Controller::at_rest(words.number(), words.number(), words.number())
                };
                println!("{}", u8::from(made.is_ok()));
                controller = made.ok();
            }
        }
    }};
}

fn main() {
    let told = std::io::read_to_string(std::io::stdin()).unwrap();
    let mut lines = told.lines().peekable();
    while let Some(line) = lines.next() {
        match line[2..].parse::<u8>().unwrap() {
        // the loops
            _ => panic!("no such loop: {line}"),
        }
    }
}
