//! Roots in a proven bracket.

/// The point of `low..high` where `f` changes sign, to the last bit that the sign can tell.
///
/// The sign at `low` must differ from the one at `high`; a value that is not a number counts as the sign of
/// `high`. Returns the two neighbouring points of different sign: they are a root where `f` is continuous there,
/// and the two sides of a jump where it is not.
pub(super) fn bracket(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> (f64, f64) {
    let (mut at_low, mut at_high) = (f(low), f(high));
    let rising = at_low < 0.0;
    // Secant steps for speed, every third step a bisection, so that a flat function cannot stall it.
    for step in 0..200 {
        let middle = low + 0.5 * (high - low);
        if middle <= low.min(high) || middle >= low.max(high) {
            break;
        }
        let secant = low - at_low * (high - low) / (at_high - at_low);
        let inside = secant > low.min(high) && secant < low.max(high);
        let point = if step % 3 == 2 || !inside { middle } else { secant };
        let value = f(point);
        if value == 0.0 {
            return (point, point);
        }
        if (value < 0.0) == rising {
            (low, at_low) = (point, value);
        } else {
            (high, at_high) = (point, value);
        }
        if !at_high.is_finite() {
            at_high = -at_low;
        }
    }
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::bracket;

    #[test]
    fn a_root_is_found_to_the_last_bits() {
        let (low, high) = bracket(0.0, 2.0, |x| x * x - 2.0);
        assert!((low - 2.0_f64.sqrt()).abs() < 1e-15 && (high - low).abs() < 1e-15);
    }

    #[test]
    fn a_jump_is_enclosed_by_its_two_sides() {
        let (low, high) = bracket(0.0, 1.0, |x| if x < 0.3 { -1.0 } else { 5.0 });
        assert!(low < 0.3 && high >= 0.3 && high - low < 1e-15);
    }

    #[test]
    fn a_flat_root_and_a_falling_one_do_not_stall() {
        let (low, high) = bracket(-1.0, 2.0, |x| -x.powi(9));
        assert!(low.abs() < 1e-9 && high.abs() < 1e-9);
    }
}
