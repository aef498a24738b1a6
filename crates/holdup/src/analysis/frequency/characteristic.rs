//! The characteristic equation of a closed loop, in closed form: L = N/D and 1 + L = Δ/D.
//!
//! With states x and channel inputs w the loop is `s·x = A·x + B·E(s)·w`, `w = C·x + F·E(s)·w` with the delays
//! on the diagonal of E. Δ is the determinant of that system; D is what remains of it when the delayed channel
//! 0 is cut, and N = Δ − D. Being linear in each delay, the determinant is a sum over the permutations of a
//! small sparse matrix.

use super::error::FrequencyError;
use super::polynomial::Polynomial;
use super::quasi_polynomial::QuasiPolynomial;
use crate::model::ClosedLoop;
use crate::model::closed_loop::Source;

const MAX_STATES: usize = 15;
const MAX_CHANNELS: usize = 4;

/// N, D and Δ of a loop broken at the process input, time counted in dead times of the process.
#[derive(Debug, Clone)]
pub(super) struct Characteristic {
    /// Dead time of the process [s]: the unit of time of everything else here.
    pub(super) dead_time: f64,
    /// Numerator N of L.
    pub(super) numerator: QuasiPolynomial,
    /// Denominator D of L.
    pub(super) denominator: QuasiPolynomial,
    /// Δ = N + D, whose zeros are the closed-loop poles.
    pub(super) closed: QuasiPolynomial,
    /// The degree of Δ: the number of states that are not windows.
    pub(super) order: usize,
    /// |L(j∞)|: the sum of the moduli of the leading coefficients of N.
    pub(super) high_frequency_gain: f64,
}

impl Characteristic {
    pub(super) fn new(closed_loop: &ClosedLoop) -> Result<Self, FrequencyError> {
        let (states, channels) = (closed_loop.rates().len(), closed_loop.channels().len());
        if states > MAX_STATES || channels > MAX_CHANNELS || channels == 0 {
            return Err(FrequencyError::TooLarge { states, channels });
        }
        let windows = closed_loop.windows().len();
        let dead_time = closed_loop.channels()[0].delay;
        let matrix = Matrix::new(closed_loop, dead_time);
        let mut expansion = [[0.0; MAX_STATES + 1]; 1 << MAX_CHANNELS];
        matrix.expand(0, 0, Monomial { value: 1.0, power: 0, delayed: 0 }, &mut expansion);

        let mut numerator = QuasiPolynomial::default();
        let mut denominator = QuasiPolynomial::default();
        let mut closed = QuasiPolynomial::default();
        for (delayed, coefficients) in expansion.iter().enumerate().take(1 << channels) {
            let delay = closed_loop
                .channels()
                .iter()
                .enumerate()
                .filter(|(channel, _)| delayed & (1 << channel) != 0)
                .fold(0.0, |sum, (_, c)| sum + c.delay / dead_time);
            let open = if delayed & 1 == 0 { &mut denominator } else { &mut numerator };
            // The factor s of every window is divided out. What stands below it is the rounding of a cancellation: the
            // input of a window drops out of the equations at s = 0.
            for (power, &value) in coefficients[windows..].iter().enumerate() {
                in_reach("a coefficient of the characteristic equation", value)?;
                open.add_to(delay, power, value);
                closed.add_to(delay, power, value);
            }
        }
        for sum in [&mut numerator, &mut denominator, &mut closed] {
            sum.sort();
        }
        let largest = |q: &QuasiPolynomial| q.magnitudes(1.0)[0];
        if largest(&numerator) < 1e-100 {
            let value = largest(&numerator);
            return Err(FrequencyError::OutOfReach { quantity: "the loop gain over one dead time", value });
        }
        in_reach("the longest delay", closed.longest_delay())?;
        let order = states - windows;
        let leading = |(_, p): &(f64, Polynomial)| p.coefficient(order).abs();
        let high_frequency_gain = numerator.terms().iter().map(leading).sum();
        Ok(Self { dead_time, numerator, denominator, closed, order, high_frequency_gain })
    }
}

fn in_reach(quantity: &'static str, value: f64) -> Result<(), FrequencyError> {
    // Squares of coefficients are formed, and sums of them.
    if value.abs() <= 1e100 { Ok(()) } else { Err(FrequencyError::OutOfReach { quantity, value }) }
}

/// One product of the expansion: `value·s^power·Π e^(−τ·s)` over the channels in `delayed`.
#[derive(Clone, Copy)]
struct Monomial {
    value: f64,
    power: usize,
    delayed: usize,
}

/// Rows of the system; every entry is a monomial in a column, and a column may occur twice in a row.
struct Matrix {
    rows: Vec<Vec<(usize, Monomial)>>,
}

impl Matrix {
    fn new(closed_loop: &ClosedLoop, dead_time: f64) -> Self {
        let states = closed_loop.rates().len();
        let entry = |source: Source, value: f64| match source {
            Source::State(column) => Some((column, Monomial { value, power: 0, delayed: 0 })),
            Source::Delayed(channel) => {
                Some((states + channel, Monomial { value, power: 0, delayed: 1 << channel }))
            }
            Source::Setpoint | Source::SetpointRate | Source::Load => None,
        };
        let row = |diagonal: (usize, Monomial), sum: &[(Source, f64)], scale: f64| {
            let mut row = vec![diagonal];
            row.extend(sum.iter().filter_map(|&(source, w)| entry(source, -w * scale)));
            row
        };
        let s = Monomial { value: 1.0, power: 1, delayed: 0 };
        let one = Monomial { power: 0, ..s };
        let rates = closed_loop.rates().iter().enumerate();
        let inputs = closed_loop.channels().iter().enumerate();
        let rows = rates
            .map(|(i, rate)| row((i, s), rate.terms(), dead_time))
            .chain(inputs.map(|(i, channel)| row((states + i, one), channel.input.terms(), 1.0)))
            .collect();
        Self { rows }
    }

    /// Adds every permutation that agrees with the choices made in the rows before `row`.
    fn expand(&self, row: usize, used: u32, so_far: Monomial, sum: &mut [[f64; MAX_STATES + 1]]) {
        let Some(entries) = self.rows.get(row) else {
            sum[so_far.delayed][so_far.power] += so_far.value;
            return;
        };
        for &(column, entry) in entries {
            if used & (1 << column) != 0 {
                continue;
            }
            // The permutation's sign: one inversion for every larger column used in an earlier row.
            let inversions = (used >> (column + 1)).count_ones();
            let sign = if inversions.is_multiple_of(2) { 1.0 } else { -1.0 };
            let product = Monomial {
                value: sign * so_far.value * entry.value,
                power: so_far.power + entry.power,
                delayed: so_far.delayed | entry.delayed,
            };
            self.expand(row + 1, used | (1 << column), product, sum);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Controller, Observer, Process, Seconds};

    #[test]
    fn pi_loop_has_the_numerator_and_denominator_of_the_textbook() {
        let process = Process::integrating(0.5, Seconds(2.0)).unwrap();
        let pi = Controller::proportional(0.6).unwrap().with_integral_time(Seconds(8.0)).unwrap();
        let loop_ = Characteristic::new(&ClosedLoop::new(&process, &pi)).unwrap();
        // In dead times: K·Kc·d·(s + d/Ti)/s².
        assert_eq!(loop_.denominator.terms(), &[(0.0, Polynomial::new(&[0.0, 0.0, 1.0]))]);
        let [(delay, p)] = loop_.numerator.terms() else { panic!("one delay") };
        assert_eq!(*delay, 1.0);
        // Products of three numbers: three roundings.
        assert!((p.coefficient(0) - 0.15).abs() < 1e-16 && (p.coefficient(1) - 0.6).abs() < 2e-16);
    }

    #[test]
    fn perfect_observer_factorises() {
        let process = Process::integrating(1.0, Seconds(1.0)).unwrap();
        let p = Controller::proportional(0.3).unwrap().with_observer(Observer::new(0.2).unwrap());
        let loop_ = Characteristic::new(&ClosedLoop::new(&process, &p)).unwrap();
        // (s + 0.3·e)(s + 0.2·e) = s² + 0.5·s·e + 0.06·e²
        let terms = loop_.closed.terms();
        assert_eq!(terms.iter().map(|t| t.0).collect::<Vec<_>>(), [0.0, 1.0, 2.0]);
        assert!((terms[1].1.coefficient(1) - 0.5).abs() < 1e-16);
        assert!((terms[2].1.coefficient(0) - 0.06).abs() < 1e-16);
    }

    #[test]
    fn unfiltered_derivative_shows_at_infinite_frequency() {
        let process = Process::integrating(2.0, Seconds(1.0)).unwrap();
        let pd = Controller::proportional(0.3).unwrap().with_derivative_time(Seconds(0.5)).unwrap();
        let loop_ = Characteristic::new(&ClosedLoop::new(&process, &pd)).unwrap();
        assert!((loop_.high_frequency_gain - 0.3).abs() < 1e-16);
    }
}
