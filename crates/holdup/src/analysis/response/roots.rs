//! Sign changes of a cell's polynomial, all of them: no sampling, so close pairs are found too.
//!
//! Between two neighbouring extrema a polynomial is monotone and has at most one root. The extrema are the sign
//! changes of the derivative, found the same way; the recursion ends at the first derivative whose coefficients
//! show that it has one sign.

use super::legendre::{Poly, TERMS, derivative, magnitude, significant, swing, value};

/// Sign changes in increasing order, within −1…1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Roots {
    list: [f64; TERMS],
    count: usize,
}

impl Roots {
    const NONE: Self = Self { list: [0.0; TERMS], count: 0 };

    pub(super) fn as_slice(&self) -> &[f64] {
        &self.list[..self.count]
    }

    fn push(&mut self, root: f64) {
        if self.count < TERMS {
            self.list[self.count] = root;
            self.count += 1;
        }
    }
}

/// Every sign change of `p` between −1 and 1.
pub(super) fn sign_changes(p: &Poly) -> Roots {
    if p[0].abs() > swing(p) {
        return Roots::NONE;
    }
    // Coefficients that are rounding noise would only make the recursion deep.
    let terms = significant(p, 1e-17 * magnitude(p));
    let mut trimmed = *p;
    trimmed[terms..].fill(0.0);
    recurse(&trimmed, terms)
}

fn recurse(p: &Poly, terms: usize) -> Roots {
    if terms <= 1 || p[0].abs() > swing(p) {
        return Roots::NONE;
    }
    let slope = derivative(p);
    let extrema = recurse(&slope, terms - 1);
    let (p, slope) = (&p[..terms], &slope[..terms - 1]);
    let mut roots = Roots::NONE;
    let (mut left, mut left_value) = (-1.0, value(p, -1.0));
    for &right in extrema.as_slice().iter().chain(&[1.0]) {
        let right_value = value(p, right);
        if left_value < 0.0 && right_value > 0.0 || left_value > 0.0 && right_value < 0.0 {
            roots.push(bracketed(p, slope, (left, left_value), (right, right_value)));
        }
        if right_value != 0.0 {
            (left, left_value) = (right, right_value);
        }
    }
    roots
}

/// The root between two points of opposite sign: Newton, kept inside its bracket.
fn bracketed(p: &[f64], slope: &[f64], left: (f64, f64), right: (f64, f64)) -> f64 {
    let ((mut low, low_value), (mut high, high_value)) = (left, right);
    let rising = low_value < 0.0;
    let mut s = low - low_value * ((high - low) / (high_value - low_value));
    for _ in 0..100 {
        if !(s > low && s < high) {
            s = 0.5 * (low + high);
        }
        let here = value(p, s);
        if here == 0.0 {
            return s;
        }
        if (here < 0.0) == rising {
            low = s;
        } else {
            high = s;
        }
        let next = s - here / value(slope, s);
        if (next - s).abs() <= 2e-16 || high - low <= 2e-16 {
            return if next > low && next < high { next } else { s };
        }
        s = next;
    }
    s
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::response::legendre::add;

    /// Product of `(s − root)` over the roots, in the Legendre basis.
    fn with_roots(roots: &[f64]) -> Poly {
        let mut p = [0.0; TERMS];
        p[0] = 1.0;
        for root in roots {
            let mut next = [0.0; TERMS];
            let mut k = 0.0;
            for i in 0..TERMS - 1 {
                next[i + 1] += p[i] * (k + 1.0) / (2.0 * k + 1.0);
                if i > 0 {
                    next[i - 1] += p[i] * k / (2.0 * k + 1.0);
                }
                k += 1.0;
            }
            add(&mut next, -root, &p);
            p = next;
        }
        p
    }

    #[test]
    fn close_pairs_of_roots_are_found() {
        // A pair 2e-6 apart: the polynomial is only 1e-12 deep between them.
        let wanted = [-0.7, 0.123_455, 0.123_457, 0.9];
        let found = sign_changes(&with_roots(&wanted));
        assert_eq!(found.as_slice().len(), 4);
        for (f, w) in found.as_slice().iter().zip(wanted) {
            // Depth 1e-12 over slope 1e-6 leaves rounding of 1e-16 an effect of 1e-10.
            assert!((f - w).abs() < 1e-9, "{f} {w}");
        }
    }

    #[test]
    fn twenty_roots_are_found_and_outside_ones_are_not() {
        let mut wanted: Vec<f64> = (0..20).map(|i| -0.95 + 0.1 * f64::from(i)).collect();
        assert_eq!(sign_changes(&with_roots(&wanted)).as_slice().len(), 20);
        wanted.extend([1.3, -2.0]);
        assert_eq!(sign_changes(&with_roots(&wanted)).as_slice().len(), 20);
    }

    #[test]
    fn a_polynomial_that_only_touches_zero_has_no_sign_change_or_a_pair_of_rounding_size() {
        let found = sign_changes(&with_roots(&[0.25, 0.25]));
        let roots = found.as_slice();
        // Rounding of 1e-16 under a square: at most sqrt(1e-16) apart.
        assert!(roots.is_empty() || roots.len() == 2 && roots[1] - roots[0] < 1e-7);
    }
}
