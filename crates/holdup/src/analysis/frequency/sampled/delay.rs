//! How much longer or shorter the dead time may be before the sampled loop, computed anew for it, loses its stability.
//!
//! With a hold a longer dead time does not only turn L: between whole numbers of samples it changes |L|, too. So the
//! classical phase margin by frequency is where the search begins, and the verdict of the argument principle
//! decides: from a dead time at which the loop is stable to one at which it is not, halved to rounding.

/// The least change of the dead time [s] of which `loses` says that the loop loses its stability, by halving from `first`
/// [s] on; at most `most`.
pub(super) fn limit(first: f64, h: f64, most: f64, loses: impl Fn(f64) -> bool) -> f64 {
    // The guess is wrong by a part of a sample: the interval about it that holds the change of verdict.
    let mut reach = 0.25 * h;
    let (mut stable, mut unstable) = ((first - reach).max(0.0), (first + reach).min(most));
    while stable > 0.0 && loses(stable) {
        unstable = stable;
        reach *= 2.0;
        stable = (stable - reach).max(0.0);
    }
    reach = 0.25 * h;
    while !loses(unstable) {
        if unstable >= most || reach > 1e6 * (first + h) {
            return f64::INFINITY;
        }
        stable = unstable;
        reach *= 2.0;
        unstable = (unstable + reach).min(most);
    }
    while unstable - stable > 4.0 * f64::EPSILON * (unstable + h) {
        let middle = f64::midpoint(stable, unstable);
        if middle <= stable || middle >= unstable {
            break;
        }
        if loses(middle) {
            unstable = middle;
        } else {
            stable = middle;
        }
    }
    unstable
}

/// The least cut of the dead time [s] at which the loop loses its stability; none where it stays stable down to no
/// dead time at all.
pub(super) fn cut(first: Option<f64>, h: f64, most: f64, loses: impl Fn(f64) -> bool) -> Option<f64> {
    let first = first.filter(|&first| first <= most + h)?;
    let found = limit(first.min(most), h, most, loses);
    found.is_finite().then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_is_found_from_a_guess_on_either_side() {
        for guess in [0.1, 1.9, 2.0, 2.1, 9.0] {
            let found = limit(guess, 0.5, f64::INFINITY, |change| change >= 2.0);
            assert!((found - 2.0).abs() < 1e-14, "{guess} {found}"); // rounding of 2
        }
        assert_eq!(limit(1.0, 0.5, f64::INFINITY, |_| false), f64::INFINITY);
        assert_eq!(cut(Some(1.0), 0.5, 3.0, |_| false), None);
        assert_eq!(cut(Some(9.0), 0.5, 3.0, |_| true), None);
    }
}
