//! What is left of the exponential series: the building blocks of a lag's response.

/// `E_n(x) = Σ_{j≥n} (−1)^(j−n)·x^j/j!` for n = 1 to 4: 1 − e^(−x), x − 1 + e^(−x), and so on, without cancellation.
pub(super) fn rests(x: f64) -> [f64; 4] {
    let powers = [x, x * x / 2.0, x * x * x / 6.0];
    if x > 1.0 {
        let e1 = -(-x).exp_m1();
        let e2 = powers[0] - e1;
        let e3 = powers[1] - e2;
        return [e1, e2, e3, powers[2] - e3];
    }
    // E_4 by its series, the others by E_n = xⁿ/n! − E_(n+1).
    let mut term = powers[2] * x / 4.0;
    let (mut e4, mut j) = (0.0, 4.0);
    while term.abs() > 1e-18 * f64::abs(e4) {
        e4 += term;
        j += 1.0;
        term *= -x / j;
    }
    let e3 = powers[2] - e4;
    let e2 = powers[1] - e3;
    [x - e2, e2, e3, e4]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rests_of_the_exponential_meet_where_their_formulas_do() {
        let (below, above) = (rests(1.0), rests(1.0 + 1e-13));
        for (a, b) in below.iter().zip(above) {
            assert!((a - b).abs() < 2e-13, "{a} {b}"); // their slope is below 1
        }
        assert!((rests(1e-5)[3] / (1e-20 / 24.0) - 1.0).abs() < 1e-5); // the next term is x/5
        assert_eq!(rests(0.0), [0.0; 4]);
    }
}
