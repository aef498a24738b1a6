//! Gain and phase crossover of loops in the normal form, with proof that they are the ones that count.
//!
//! **Gain.** The equation |L|² = 1 is a polynomial in x whose coefficients change sign once (n₁ > 0): one positive root,
//! proven by the signs of the polynomial to both sides of what Newton's method finds. |L| > 1 below and < 1 above.
//!
//! **Verdict.** arg(1 + L) goes with arg L below the crossover and stays within π/2 of a whole turn above. So the loop is
//! stable if and only if φ = π + arg L, followed from ω = 0 on, is in (0, 2π) at the crossover. φ = arg(c + j·d) − ω, the
//! principal value: arg(c + j·d) is in (−π, π), because it is what a polynomial with positive coefficients turns
//! (0 … π) less what two lags turn (0 … π/2 each).
//!
//! **Phase.** φ'·|c + j·d|² is a polynomial in x of degree 4. Where its coefficients are positive first and negative
//! after, φ rises first and falls after. With φ > 0 at the gain crossover it then has one zero, and that is above; |L|
//! is greatest there among all phase crossovers above, and there is none below.

use super::form::{Forms, Turned};
use super::kernel::Effort;
use super::lanes::{Lanes, WIDTH, angle, flag, greater, lesser};
use super::mesh::single;

/// A right angle.
const QUARTER: f64 = std::f64::consts::FRAC_PI_2;
/// Half width of the interval that is proven to hold x at the gain crossover, relative.
const WITHIN: f64 = 1e-11;

/// Crossovers of so many loops.
pub(super) struct Crossovers {
    /// Gain crossover, in radians per dead time.
    pub(super) gain: Lanes,
    /// φ at the gain crossover: the phase margin where it is positive.
    pub(super) phase: Lanes,
    /// Whether gain crossover and verdict are proven.
    pub(super) decided: Lanes,
    /// Phase crossover, in radians per dead time.
    pub(super) turned: Lanes,
    /// Gain margin: 1/|L| at the phase crossover.
    pub(super) margin: Lanes,
    /// Whether the phase crossover is proven.
    pub(super) proven: Lanes,
}

impl Crossovers {
    #[inline(always)]
    pub(super) fn new(forms: &Forms, effort: &Effort) -> Self {
        let (gain, known) = gain_crossovers(forms, effort.gain);
        let mut phase = [0.0; WIDTH];
        let mut decided = [0.0; WIDTH];
        for i in 0..WIDTH {
            let ([c0, c1, c2], [d0, d1]) = (forms.one(i).c, forms.one(i).d);
            let x = gain[i] * gain[i];
            let imaginary = gain[i] * (d0 + d1 * x);
            phase[i] = angle(c0 + x * (c1 + x * c2), imaginary) - gain[i];
            // Nearer to the boundary the exact analysis decides.
            decided[i] = known[i] * flag((imaginary > 0.0) & (phase[i].abs() > 1e-6));
        }
        let mut found =
            Self { gain, phase, decided, turned: [0.0; WIDTH], margin: [0.0; WIDTH], proven: [0.0; WIDTH] };
        found.phase_crossovers(forms, effort.phase);
        found
    }

    /// Phase crossovers, what is known there, and where they are proven.
    #[inline(always)]
    fn phase_crossovers(&mut self, forms: &Forms, passes: usize) {
        let (mut omega, mut settled) = ([0.0; WIDTH], [0.0; WIDTH]);
        for i in 0..WIDTH {
            // Single precision is enough for a start.
            const QUARTER: f32 = std::f32::consts::FRAC_PI_2;
            let ([c0, c1, c2], [d0, d1]) = (forms.one(i).c.map(single), forms.one(i).d.map(single));
            let parts = |omega: f32| {
                let x = omega * omega;
                (c0 + x * (c1 + x * c2), omega * (d0 + x * d1))
            };
            // φ', but no flatter than −0.2.
            let slope = |omega: f32| {
                let (x, (c, d)) = (omega * omega, parts(omega));
                let (dc, dd) = (omega * (2.0 * c1 + 4.0 * c2 * x), d0 + 3.0 * d1 * x);
                let slope = (c * dd - d * dc) / (c * c + d * d) - 1.0;
                if slope < -0.2 { slope } else { -0.2 }
            };
            let within = |omega: f32| {
                let omega = if omega > 0.3 * QUARTER { omega } else { 0.3 * QUARTER };
                if omega < 1.9 * QUARTER { omega } else { 1.9 * QUARTER }
            };
            // From π/2, where φ = −arctan(c/d), with the mean of the slopes there and where that slope leads to;
            // t/(1 + 0.28·t²) is near enough to the arc tangent.
            let (c, d) = parts(QUARTER);
            let lead = c * d / (d * d + 0.28 * c * c);
            let first = slope(QUARTER);
            let second = slope(within(QUARTER + lead / first));
            omega[i] = f64::from(within(QUARTER + 2.0 * lead / (first + second)));
        }
        for _ in 0..passes {
            for i in 0..WIDTH {
                // Halley's method, in steps of at most half the frequency.
                let Turned { v, w } = forms.one(i).turned(omega[i]);
                let most = 0.5 * omega[i];
                let full = 2.0 * w[0] * w[1] / (2.0 * w[1] * w[1] - w[0] * w[2]);
                let step = lesser(greater(full, -most), most);
                // What a step leaves is it times (step·w″/w′)²/4 and (step/ω)², less than 1e-10 of ω. That φ is near 0 here,
                // of all multiples of π in (−2π, π), is seen from V > 0.
                let short = (step.abs() < 3e-4 * omega[i]) & ((step * w[2]).abs() < 5e-4 * w[1].abs());
                settled[i] = flag(short & (w[1] < -1e-2 * v[0]));
                omega[i] = lesser(omega[i] - step, 1.99 * QUARTER);
            }
        }
        for i in 0..WIDTH {
            let form = forms.one(i);
            let ([n0, n1, n2], [c0, c1, c2]) = (form.n, form.c);
            let ([d0, d1], [e1, e2]) = (form.d, form.e);
            // φ'·|c + j·d|², its coefficients and bounds of their roundings.
            let rate = [
                (c0 * d0 - n0, c0 * d0.abs() + n0),
                (
                    3.0 * c0 * d1 - c1 * d0 - n1 - n0 * e1,
                    3.0 * c0 * d1.abs() + (c1 * d0).abs() + n1 + n0 * e1,
                ),
                (
                    c1 * d1 - 3.0 * c2 * d0 - n2 - n1 * e1 - n0 * e2,
                    (c1 * d1).abs() + 3.0 * c2 * d0.abs() + n2 + n1 * e1 + n0 * e2,
                ),
                (-c2 * d1 - n2 * e1 - n1 * e2, c2 * d1.abs() + n2 * e1 + n1 * e2),
            ];
            let may_fall = |(sum, size): (f64, f64)| sum < 1e-13 * size;
            let may_rise = |(sum, size): (f64, f64)| sum > -1e-13 * size;
            let one_change = !(may_fall(rate[0])
                | (may_fall(rate[1]) & (may_rise(rate[2]) | may_rise(rate[3])))
                | (may_fall(rate[2]) & may_rise(rate[3])));
            self.margin[i] = form.inverse_gain_squared(omega[i] * omega[i]).sqrt();
            let inside = (omega[i] > self.gain[i]) & (omega[i] < 1.98 * QUARTER);
            self.proven[i] = flag(one_change & inside) * settled[i];
        }
        self.turned = omega;
    }
}

/// Gain crossovers, and where they are proven.
#[inline(always)]
fn gain_crossovers(forms: &Forms, passes: usize) -> (Lanes, Lanes) {
    let (mut x, mut proven) = ([0.0; WIDTH], [0.0; WIDTH]);
    for i in 0..WIDTH {
        let form = forms.one(i);
        let square = form.k * form.k;
        let [n0, n1, n2] = form.n.map(|n| square * n);
        // Without filter and lag the equation is quadratic.
        let factor = 1.0 - n2;
        x[i] = (n1 + (n1 * n1 + 4.0 * factor * n0).sqrt()) / (2.0 * factor);
        proven[i] = forms.applies[i] * flag(n2 < 0.999_999);
    }
    if forms.lag {
        for i in 0..WIDTH {
            // Their factor at that place, taken as constant.
            let form = forms.one(i);
            let square = form.k * form.k;
            let [n0, n1, n2] = form.n.map(|n| square * n);
            let factor = 1.0 + x[i] * (form.e[0] + x[i] * form.e[1]) - n2;
            x[i] = (n1 + (n1 * n1 + 4.0 * factor * n0).sqrt()) / (2.0 * factor);
        }
    }
    for _ in 0..passes {
        for i in 0..WIDTH {
            let form = forms.one(i);
            let square = form.k * form.k;
            let ([n0, n1, n2], [e1, e2], x_) = (form.n.map(|n| square * n), form.e, x[i]);
            let value = x_ * (x_ * (1.0 - n2 + x_ * (e1 + x_ * e2)) - n1) - n0;
            let slope = x_ * (2.0 * (1.0 - n2) + x_ * (3.0 * e1 + 4.0 * x_ * e2)) - n1;
            x[i] = x_ - value / slope;
        }
    }
    for i in 0..WIDTH {
        let form = forms.one(i);
        let square = form.k * form.k;
        let ([n0, n1, n2], [e1, e2]) = (form.n.map(|n| square * n), form.e);
        let value = |x: f64| x * x * (1.0 - n2 + x * (e1 + x * e2)) - (n1 * x + n0);
        // Fifty roundings of the greatest term.
        let noise = 1e-14 * (n0 + x[i] * (n1 + x[i] * n2));
        let between = (value(x[i] * (1.0 - WITHIN)) < -noise) & (value(x[i] * (1.0 + WITHIN)) > noise);
        proven[i] *= flag(between);
        x[i] = x[i].sqrt();
    }
    (x, proven)
}
