//! The terms of N and D as functions of x = 1/ω and of the phase θ.

use num_complex::Complex;

use super::super::polynomial::Polynomial;

/// One polynomial in x times e^(−j·turns·θ).
#[derive(Debug, Clone)]
pub(super) struct Term {
    turns: f64,
    coefficients: Vec<Complex<f64>>,
    moduli: Polynomial,
}

impl Term {
    pub(super) fn new(p: &Polynomial, order: usize, turns: f64) -> Self {
        let mut coefficients = vec![Complex::new(0.0, 0.0); order + 1];
        let mut moduli = Polynomial::ZERO;
        for (power, &c) in p.coefficients().iter().enumerate() {
            // s^power/sⁿ = (x/j)^(n − power)
            let rest = order - power;
            coefficients[rest] = match rest % 4 {
                0 => Complex::new(c, 0.0),
                1 => Complex::new(0.0, -c),
                2 => Complex::new(-c, 0.0),
                _ => Complex::new(0.0, c),
            };
            moduli.add_to(rest, c.abs());
        }
        Self { turns, coefficients, moduli }
    }
}

/// Taylor coefficients in x and θ of a sum of terms, and bounds of their moduli on |x| ≤ `most`.
pub(super) fn sum(terms: &[Term], x: f64, most: f64, theta: f64) -> ([Complex<f64>; 6], [f64; 10]) {
    let zero = Complex::new(0.0, 0.0);
    let (mut all, mut bound) = ([zero; 6], [0.0; 10]);
    for Term { turns, coefficients, moduli } in terms {
        let [p, dp, ddp] = coefficients
            .iter()
            .rev()
            .fold([zero; 3], |[p, dp, ddp], c| [p * x + c, dp * x + p, ddp * x + dp]);
        let (sin, cos) = (turns * theta).sin_cos();
        let e = [Complex::new(cos, -sin), Complex::new(-sin, -cos) * turns];
        let e = [e[0], e[1], e[0] * (-0.5 * turns * turns)];
        let own = [p * e[0], dp * e[0], p * e[1], ddp * e[0], dp * e[1], p * e[2]];
        all = std::array::from_fn(|i| all[i] + own[i]);
        let [b0, b1, b2, b3] = moduli.magnitudes(most);
        let (b2, b3) = (0.5 * b2, b3 / 6.0);
        let (t2, t3) = (0.5 * turns * turns, turns * turns * turns / 6.0);
        let own = [b0, b1, b0 * turns, b2, b1 * turns, b0 * t2, b3, b2 * turns, b1 * t2, b0 * t3];
        bound = std::array::from_fn(|i| bound[i] + own[i]);
    }
    (all, bound)
}
