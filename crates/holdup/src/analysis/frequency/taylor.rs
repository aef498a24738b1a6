//! Proofs on an interval from the Taylor polynomial at its middle and a bound of the third derivative.

/// `f + df·t + ddf·t²/2`: a real function about the middle of an interval, up to its third-order rest.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quadratic {
    pub(super) f: f64,
    pub(super) df: f64,
    pub(super) ddf: f64,
}

impl Quadratic {
    /// Value at distance t from the middle.
    pub(super) fn at(self, t: f64) -> f64 {
        self.f + t * (self.df + 0.5 * t * self.ddf)
    }

    /// Least and greatest value on |t| ≤ radius.
    pub(super) fn range(self, radius: f64) -> (f64, f64) {
        let (a, b) = (self.at(-radius), self.at(radius));
        let (mut low, mut high) = (a.min(b), a.max(b));
        let vertex = -self.df / self.ddf;
        if vertex.abs() < radius {
            let value = self.at(vertex);
            low = low.min(value);
            high = high.max(value);
        }
        (low, high)
    }
}

/// What is proven about the zeros of a real function on an interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Zeros {
    /// There is none.
    None,
    /// The function is monotone: one zero if its signs at the ends differ, else none.
    Monotone,
    /// The function does not rise above rounding anywhere on the interval: it touches zero.
    Touching,
    /// Nothing yet.
    Unknown,
}

/// What the Taylor polynomial, the bound `third` of the third derivative and the rounding error `rounding` of
/// the value prove on |t| ≤ radius.
pub(super) fn zeros(q: Quadratic, third: f64, rounding: f64, radius: f64) -> Zeros {
    let rest = third * radius * radius * radius / 6.0 + rounding;
    let (low, high) = q.range(radius);
    if low > rest || high < -rest {
        return Zeros::None;
    }
    if q.df.abs() > q.ddf.abs() * radius + 0.5 * third * radius * radius {
        return Zeros::Monotone;
    }
    if low.abs().max(high.abs()) + rest <= 4.0 * rounding { Zeros::Touching } else { Zeros::Unknown }
}

/// The one zero of a function on [a, b), where there is one.
pub(super) fn root(zeros: Zeros, a: f64, b: f64, at: impl Fn(f64) -> Quadratic) -> Option<f64> {
    match zeros {
        Zeros::None | Zeros::Unknown => None,
        Zeros::Touching => Some(f64::midpoint(a, b)),
        Zeros::Monotone => {
            // At ω = 0 a function may vanish without crossing: nothing to list there.
            let (start, end) = (at(a).f, at(b).f);
            if (a == 0.0 && start == 0.0) || (start >= 0.0) == (end >= 0.0) {
                return None;
            }
            let mut bracket = if start < 0.0 { (a, b) } else { (b, a) };
            let mut omega = a + (b - a) * (start / (start - end)).clamp(0.0, 1.0);
            for _ in 0..100 {
                let q = at(omega);
                if q.f < 0.0 {
                    bracket.0 = omega;
                } else {
                    bracket.1 = omega;
                }
                let newton = omega - q.f / q.df;
                let (low, high) = (bracket.0.min(bracket.1), bracket.0.max(bracket.1));
                let next = if newton >= low && newton <= high { newton } else { f64::midpoint(low, high) };
                let step = (next - omega).abs();
                omega = next;
                if step <= 1e-9 * omega && newton == next {
                    // Newton's next step is below rounding; take it without asking.
                    let q = at(omega);
                    let last = omega - q.f / q.df;
                    return Some(if last >= low && last <= high { last } else { omega });
                }
                if high - low <= 2.0 * f64::EPSILON * high {
                    break;
                }
            }
            Some(omega)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// cos about 1.5, where its third derivative is at most 1 in modulus.
    fn cosine(omega: f64) -> Quadratic {
        Quadratic { f: omega.cos(), df: -omega.sin(), ddf: -omega.cos() }
    }

    #[test]
    fn a_band_is_settled_when_its_taylor_polynomial_allows_it() {
        assert_eq!(zeros(cosine(1.0), 1.0, 0.0, 0.4), Zeros::None);
        assert_eq!(zeros(cosine(1.5), 1.0, 0.0, 0.9), Zeros::Monotone);
        assert_eq!(zeros(cosine(3.0), 1.0, 0.0, 2.0), Zeros::Unknown);
        let flat = Quadratic { f: 1e-17, df: 0.0, ddf: 0.0 };
        assert_eq!(zeros(flat, 0.0, 1e-16, 0.1), Zeros::Touching);
    }

    #[test]
    fn the_one_zero_of_a_monotone_function_is_polished_to_rounding() {
        let zero = root(Zeros::Monotone, 0.6, 2.4, cosine).unwrap();
        assert!((zero - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        assert_eq!(root(Zeros::Monotone, 0.6, 1.4, cosine), None);
    }
}
