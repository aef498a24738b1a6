//! The squared error with an exponentially growing weight, by Parseval's theorem.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::laplace::{Input, error};
use crate::model::ClosedLoop;

/// Highest frequency of the quadrature, and its widest panel, in units of one over the shortest delay.
const HIGHEST: f64 = 80.0;
const WIDEST: f64 = 0.5;

/// Relative tolerance of a panel, and how often it is halved.
const TOLERANCE: f64 = 1e-2;
const HALVINGS: u32 = 14;

/// An upper bound on ∫ e^(2σt)·e² dt over all time [output unit² · s]: quadrature to a percent, doubled.
///
/// `heights` are the imaginary parts of the poles next to the line. `None` where the transform is not a number.
pub(super) fn squared_error(
    closed_loop: &ClosedLoop,
    input: Input,
    sigma: f64,
    heights: &[f64],
) -> Option<f64> {
    let square = |omega: f64| -> f64 {
        error(closed_loop, input, Complex64::new(-sigma, omega)).map_or(f64::NAN, |value| value.norm_sqr())
    };
    let delay = closed_loop.channels().iter().map(|channel| channel.delay).fold(f64::INFINITY, f64::min);
    let highest = (HIGHEST / delay).max(4.0 * heights.iter().copied().fold(sigma, f64::max));
    let (mut integral, mut envelope) = (0.0, 0.0_f64);
    let edges = edges(sigma, delay, highest, heights);
    for pair in edges.windows(2) {
        let [low, high] = [pair[0], pair[1]];
        let middle = 0.5 * (low + high);
        let values = [square(low), square(middle), square(high)];
        integral += simpson(&square, low, high, values, integral, HALVINGS);
        if low > 0.5 * highest {
            for (omega, value) in [low, middle, high].into_iter().zip(values) {
                envelope = envelope.max(value * omega * omega);
            }
        }
    }
    // |E| falls at least as 1/ω: the error has a jump at most.
    let bound = 2.0 * (integral + envelope / highest) / PI;
    bound.is_finite().then_some(bound)
}

/// Octaves from far below σ, cut into panels no wider than the ripple of the delay, with the poles as edges.
fn edges(sigma: f64, delay: f64, highest: f64, heights: &[f64]) -> Vec<f64> {
    let mut edges = vec![0.0];
    let mut next = 0.1 * sigma;
    while next < highest {
        edges.push(next);
        next += next.min(WIDEST / delay);
    }
    edges.push(highest);
    edges.extend(heights.iter().flat_map(|height| [height - sigma, *height, height + sigma]));
    edges.retain(|edge| (0.0..=highest).contains(edge));
    edges.sort_by(f64::total_cmp);
    edges
}

/// Simpson's rule, halved where the halves disagree.
fn simpson(
    function: &dyn Fn(f64) -> f64,
    low: f64,
    high: f64,
    [left, middle, right]: [f64; 3],
    so_far: f64,
    halvings: u32,
) -> f64 {
    let (centre, width) = (0.5 * (low + high), high - low);
    let (first, second) = (function(low + 0.25 * width), function(low + 0.75 * width));
    let coarse = width / 6.0 * (left + 4.0 * middle + right);
    let fine = width / 12.0 * (left + 4.0 * first + 2.0 * middle + 4.0 * second + right);
    let agreed = (fine - coarse).abs() <= TOLERANCE * fine.max(1e-2 * so_far);
    if agreed || halvings == 0 || !fine.is_finite() {
        return fine;
    }
    let lower = simpson(function, low, centre, [left, first, middle], so_far, halvings - 1);
    lower + simpson(function, centre, high, [middle, second, right], so_far + lower, halvings - 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::response::{Scenario, simulate};
    use crate::model::{Controller, Process, Seconds};

    #[test]
    fn on_the_imaginary_axis_it_is_twice_the_integral_of_the_squared_error() {
        let process = Process::integrating(0.5, Seconds(2.0)).unwrap();
        let pi = Controller::proportional(0.6).unwrap().with_integral_time(Seconds(12.0)).unwrap();
        let closed_loop = ClosedLoop::new(&process, &pi);
        for (input, scenario) in [
            (Input::Setpoint, Scenario::unit_setpoint_step(Seconds(400.0)).unwrap()),
            (Input::Load, Scenario::unit_load_step(Seconds(400.0)).unwrap()),
        ] {
            let ise = simulate(&closed_loop, &scenario).unwrap().metrics.ise.unwrap();
            // σ next to 0 stands for the axis itself, where E would be 0/0 at ω = 0.
            let bound = squared_error(&closed_loop, input, 1e-9, &[]).unwrap();
            // A percent of quadrature, and the bound beyond the highest frequency.
            assert!((0.5 * bound / ise - 1.0).abs() < 0.03, "{input:?}: {bound} for {ise}");
        }
    }
}
