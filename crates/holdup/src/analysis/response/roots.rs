//! Sign changes of a cell's polynomial, all of them: no sampling, so close pairs are found too.
//!
//! Between two neighbouring extrema a polynomial is monotone and has at most one root. The extrema are the sign
//! changes of the derivative, found the same way. The recursion ends where the coefficients show that there is no root
//! or one: by Descartes' rule in the Bernstein basis, in which the derivative is a difference. Coefficients that
//! rounding could have given another sign show nothing.

use std::sync::LazyLock;

use super::legendre::{Poly, TERMS, add, derivative, ends, magnitude, significant, swing, value};

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

/// Every sign change of `p` between −1 and 1, up to changes of p by `floor`: last coefficients that sum up to less are
/// noise that would only make the recursion deep.
pub(super) fn sign_changes(p: &Poly, floor: f64) -> Roots {
    if p[0].abs() > swing(p) {
        return Roots::NONE;
    }
    let size = magnitude(p);
    let terms = significant(p, floor.max(1e-17 * size));
    let mut trimmed = *p;
    trimmed[terms..].fill(0.0);
    let mut bernstein = [0.0; TERMS];
    let mut noise = 0.0;
    for (c, (row, largest)) in trimmed[..terms].iter().zip(BERNSTEIN.iter()) {
        add(&mut bernstein, *c, row);
        noise += c.abs() * largest;
    }
    recurse(&trimmed, terms, &bernstein, 4.0 * f64::EPSILON * noise)
}

/// Coefficients of each Legendre polynomial in the Bernstein basis of degree 23, and the largest of them.
static BERNSTEIN: LazyLock<[(Poly, f64); TERMS]> = LazyLock::new(|| {
    let mut binomial = [[0.0; TERMS]; TERMS];
    for n in 0..TERMS {
        binomial[n][0] = 1.0;
        for k in 1..=n {
            binomial[n][k] = binomial[n - 1][k - 1] + if k < n { binomial[n - 1][k] } else { 0.0 };
        }
    }
    let n = TERMS - 1;
    std::array::from_fn(|k| {
        let row: Poly = std::array::from_fn(|j| {
            let from = (j + k).saturating_sub(n);
            let sum: f64 = (from..=j.min(k))
                .map(|i| {
                    let sign = if (k + i) % 2 == 0 { 1.0 } else { -1.0 };
                    sign * binomial[k][i] * binomial[k][i] * binomial[n - k][j - i]
                })
                .sum();
            sum / binomial[n][j]
        });
        let largest = row.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        (row, largest)
    })
});

/// Number of sign changes in a list of coefficients, or 2 where rounding may hide some.
fn variations(coefficients: &[f64], noise: f64) -> usize {
    let mut smallest = f64::INFINITY;
    let mut count = 0;
    for c in coefficients {
        smallest = smallest.min(c.abs());
    }
    for pair in coefficients.windows(2) {
        count += usize::from((pair[0] < 0.0) != (pair[1] < 0.0));
    }
    if smallest > noise { count } else { count.max(2) }
}

/// `bernstein` holds the Bernstein coefficients of `p`, up to a factor, with errors of at most `noise`.
fn recurse(p: &Poly, terms: usize, bernstein: &[f64], noise: f64) -> Roots {
    let mut roots = Roots::NONE;
    let changes = variations(bernstein, noise);
    if terms <= 1 || changes == 0 {
        return roots;
    }
    let slope = derivative(p);
    let (first, last) = ends(p);
    let mut extrema = Roots::NONE;
    if changes > 1 && terms > 2 && slope[0].abs() <= swing(&slope) {
        let mut next = [0.0; TERMS];
        for (d, pair) in next.iter_mut().zip(bernstein.windows(2)) {
            *d = pair[1] - pair[0];
        }
        extrema = recurse(&slope, terms - 1, &next[..bernstein.len() - 1], 2.0 * noise);
    }
    let (p, slope) = (&p[..terms], &slope[..terms - 1]);
    let (mut left, mut left_value) = (-1.0, first);
    for &right in extrema.as_slice().iter().chain(&[1.0]) {
        let right_value = if right == 1.0 { last } else { value(p, right) };
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
        // Newton's error is squared by the step: after one below 1e-9 the next is rounding.
        if (next - s).abs() < 1e-9 && next > low && next < high {
            return next;
        }
        s = next;
    }
    s
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let found = sign_changes(&with_roots(&wanted), 0.0);
        assert_eq!(found.as_slice().len(), 4);
        for (f, w) in found.as_slice().iter().zip(wanted) {
            // Depth 1e-12 over slope 1e-6 leaves rounding of 1e-16 an effect of 1e-10.
            assert!((f - w).abs() < 1e-9, "{f} {w}");
        }
    }

    #[test]
    fn twenty_roots_are_found_and_outside_ones_are_not() {
        let mut wanted: Vec<f64> = (0..20).map(|i| -0.95 + 0.1 * f64::from(i)).collect();
        assert_eq!(sign_changes(&with_roots(&wanted), 0.0).as_slice().len(), 20);
        wanted.extend([1.3, -2.0]);
        assert_eq!(sign_changes(&with_roots(&wanted), 0.0).as_slice().len(), 20);
    }

    #[test]
    fn a_polynomial_that_only_touches_zero_has_no_sign_change_or_a_pair_of_rounding_size() {
        let found = sign_changes(&with_roots(&[0.25, 0.25]), 0.0);
        let roots = found.as_slice();
        // Rounding of 1e-16 under a square: at most sqrt(1e-16) apart.
        assert!(roots.is_empty() || roots.len() == 2 && roots[1] - roots[0] < 1e-7);
    }
}
