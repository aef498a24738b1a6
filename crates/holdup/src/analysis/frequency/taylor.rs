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
