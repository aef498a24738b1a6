//! Roots in a proven bracket.

/// The point of `low..high` where `f` changes sign, to the last bit that the sign can tell, or to where |f| is at
/// most `enough`.
///
/// The sign at `low` must differ from the one at `high`; a value that is not a number counts as the sign of
/// `high`. Returns the two neighbouring points of different sign, the first with the sign of `low`: they are a root
/// where `f` is continuous there, and the two sides of a jump where it is not. A point that is good enough is
/// returned twice.
pub(super) fn bracket(mut low: f64, mut high: f64, enough: f64, f: impl Fn(f64) -> f64) -> (f64, f64) {
    let (mut at_low, mut at_high) = (f(low), f(high));
    let rising = at_low < 0.0;
    let mut before = f64::INFINITY;
    for _ in 0..300 {
        let width = high - low;
        let middle = low + 0.5 * width;
        if middle == low || middle == high {
            break;
        }
        // Regula falsi with halved weights; where two steps do not halve the bracket, and at infinities, the middle.
        let secant = low - at_low * width / (at_high - at_low);
        let inside = secant > low.min(high) && secant < low.max(high);
        let point = if width.abs() > 0.5 * before || !inside { middle } else { secant };
        let value = f(point);
        if value.abs() <= enough {
            return (point, point);
        }
        if (value < 0.0) == rising {
            if point != middle {
                at_high *= 0.5;
            }
            (low, at_low) = (point, value);
        } else {
            if point != middle {
                at_low *= 0.5;
            }
            (high, at_high) = (point, value);
        }
        before = if point == middle { f64::INFINITY } else { width };
    }
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::bracket;

    #[test]
    fn a_root_is_found_to_the_last_bits() {
        let (low, high) = bracket(0.0, 2.0, 0.0, |x| x * x - 2.0);
        assert!((low - 2.0_f64.sqrt()).abs() < 1e-15 && (high - low).abs() < 1e-15);
    }

    #[test]
    fn a_smooth_root_takes_a_dozen_steps() {
        let count = std::cell::Cell::new(0);
        let f = |x: f64| {
            count.set(count.get() + 1);
            x.exp() - 3.0
        };
        let (found, _) = bracket(-5.0, 8.0, 1e-12, f);
        assert!((found - 3.0_f64.ln()).abs() < 1e-12 && count.get() < 25, "{}", count.get());
    }

    #[test]
    fn a_jump_is_enclosed_by_its_two_sides() {
        let (low, high) = bracket(0.0, 1.0, 0.0, |x| if x < 0.3 { -1.0 } else { 5.0 });
        assert!(low < 0.3 && high >= 0.3 && high - low < 1e-15);
    }

    #[test]
    fn a_flat_root_and_a_falling_one_do_not_stall() {
        let (low, high) = bracket(-1.0, 2.0, 0.0, |x| -x.powi(9));
        assert!(low.abs() < 1e-9 && high.abs() < 1e-9);
    }
}
