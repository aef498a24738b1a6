//! Search along one variable: where a limit is reached, and the least value on an interval.

/// Steps until a search along one variable is given up; halving alone would need 53.
const STEPS: usize = 120;

/// A place and by how much it keeps a limit: negative where it does not.
pub(super) type Place = (f64, f64);

/// The place between one that keeps a limit and one that does not where the limit is reached, on the side that keeps it:
/// regula falsi with weights (N. Anderson and Å. Björck, BIT 13, 1973, 253–264), halving where it is slow or where nothing
/// is known of the far side but that it is outside.
///
/// It ends when the interval is `width` of the place, relative, or the limit is kept by `spare` at most.
pub(super) fn boundary(
    inside: Place,
    outside: Place,
    (width, spare): (f64, f64),
    slack: &mut dyn FnMut(f64) -> f64,
) -> f64 {
    let (mut a, mut b) = (inside, outside);
    // What the secant is drawn through: an end that stays counts less and less.
    let (mut of_a, mut of_b) = (a.1, b.1);
    let mut last = None;
    let mut slow = 0;
    for _ in 0..STEPS {
        let apart = (b.0 - a.0).abs();
        if apart <= width * a.0.abs() || a.1 <= spare {
            break;
        }
        let share = if of_b.is_finite() && slow < 3 { of_a / (of_a - of_b) } else { 0.5 };
        // Never next to an end: the other one would stay.
        let least = (0.25 * width * a.0.abs() / apart).min(0.1);
        let next = a.0 + (b.0 - a.0) * share.max(least).min(1.0 - least);
        if next == a.0 || next == b.0 {
            break;
        }
        let here = slack(next);
        let keeps = here >= 0.0;
        let weight = 1.0 - here / if keeps { a.1 } else { b.1 };
        let weight = if weight > 0.0 && weight < 1.0 { weight } else { 0.5 };
        let stays = last == Some(keeps);
        if keeps {
            (a, of_a) = ((next, here), here);
            of_b *= if stays { weight } else { 1.0 };
        } else {
            (b, of_b) = ((next, here), here);
            of_a *= if stays { weight } else { 1.0 };
        }
        last = Some(keeps);
        slow = if (b.0 - a.0).abs() > 0.5 * apart { slow + 1 } else { 0 };
    }
    a.0
}

/// The least value on an interval, taken as having one minimum, and where it is: golden section with parabolas (R. P.
/// Brent, Algorithms for Minimization without Derivatives, 1973, chapter 5). A kink is found as well, by the golden section.
pub(super) fn least(low: f64, high: f64, width: f64, value: &mut dyn FnMut(f64) -> f64) -> (f64, f64) {
    let golden = 0.5 * (3.0 - 5.0_f64.sqrt());
    let (mut a, mut b) = (low, high);
    let first = a + golden * (b - a);
    let at = value(first);
    // The best, the one before and the one before that.
    let (mut x, mut w, mut v) = ((first, at), (first, at), (first, at));
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    for _ in 0..STEPS {
        let middle = f64::midpoint(a, b);
        let finest = width * x.0.abs().max(0.1 * (high - low)) + f64::MIN_POSITIVE;
        if (x.0 - middle).abs() <= 2.0 * finest - 0.5 * (b - a) {
            break;
        }
        let (r, q) = ((x.0 - w.0) * (x.1 - v.1), (x.0 - v.0) * (x.1 - w.1));
        let mut numerator = (x.0 - v.0) * q - (x.0 - w.0) * r;
        let mut denominator = 2.0 * (q - r);
        if denominator > 0.0 {
            numerator = -numerator;
        }
        denominator = denominator.abs();
        let parabola = before.abs() > finest
            && numerator.is_finite()
            && denominator.is_finite()
            && numerator.abs() < (0.5 * denominator * before).abs()
            && numerator > denominator * (a - x.0)
            && numerator < denominator * (b - x.0);
        before = step;
        if parabola {
            step = numerator / denominator;
            let next = x.0 + step;
            if next - a < 2.0 * finest || b - next < 2.0 * finest {
                step = finest.copysign(middle - x.0);
            }
        } else {
            before = if x.0 < middle { b - x.0 } else { a - x.0 };
            step = golden * before;
        }
        let next = x.0 + if step.abs() >= finest { step } else { finest.copysign(step) };
        let here = (next, value(next));
        // Where both are beyond a wall, what is worth anything lies below.
        let beyond = here.1 == f64::INFINITY && x.1 == f64::INFINITY;
        if if beyond { next < x.0 } else { here.1 <= x.1 } {
            if next < x.0 {
                b = x.0;
            } else {
                a = x.0;
            }
            (v, w, x) = (w, x, here);
        } else {
            if next < x.0 {
                a = next;
            } else {
                b = next;
            }
            if here.1 <= w.1 || w.0 == x.0 {
                (v, w) = (w, here);
            } else if here.1 <= v.1 || v.0 == x.0 || v.0 == w.0 {
                v = here;
            }
        }
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_is_reached_from_the_side_that_keeps_it_in_a_few_steps() {
        let mut count = 0;
        let mut slack = |x: f64| {
            count += 1;
            2.0 - x * x
        };
        let found = boundary((1.0, 1.0), (2.0, -2.0), (1e-12, 0.0), &mut slack);
        assert!(found <= 2.0_f64.sqrt() && found > 2.0_f64.sqrt() * (1.0 - 2e-12), "{found}");
        assert!(count < 16, "{count}");
    }

    #[test]
    fn a_limit_beyond_which_nothing_is_known_is_reached_too() {
        let mut slack = |x: f64| if x > 0.7 { f64::NEG_INFINITY } else { 1.0 };
        let found = boundary((0.1, 1.0), (2.0, f64::NEG_INFINITY), (1e-9, 0.0), &mut slack);
        assert!(found <= 0.7 && found > 0.7 * (1.0 - 1e-8), "{found}");
    }

    #[test]
    fn smooth_and_kinked_minima_are_found() {
        let (at, least_value) = least(0.0, 2.0, 1e-8, &mut |x| (x - 0.7) * (x - 0.7) + 1.0);
        assert!((at - 0.7).abs() < 1e-6 && (least_value - 1.0).abs() < 1e-12);
        let (at, _) = least(0.0, 2.0, 1e-8, &mut |x| if x < 0.7 { 3.0 * (0.7 - x) } else { x - 0.7 });
        assert!((at - 0.7).abs() < 1e-7);
        // The least value lies at the end, or beyond a wall.
        let (at, _) = least(1.0, 2.0, 1e-8, &mut |x| x);
        assert!((at - 1.0).abs() < 1e-6);
        let (at, _) = least(1.0, 2.0, 1e-8, &mut |x| if x > 1.3 { f64::INFINITY } else { -x });
        assert!((at - 1.3).abs() < 1e-6);
    }
}
