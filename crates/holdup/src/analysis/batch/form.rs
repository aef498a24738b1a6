//! The normal form of an integrator with dead time, with or without lag, under P, PI, PD or PID control.
//!
//! With time counted in dead times, `k = K·Kc·d`, `a = d/Ti`, `b = Td/d`, `f = Tf/d`, `T` the lag and `x = ω²`,
//!
//! ```text
//! L(jω) = −k·e^(−jω)·(c + j·d)/E,    c = c₀ + c₁x + c₂x²,  d = ω(d₀ + d₁x),  E = x(1 + e₁x + e₂x²)
//! |L|² = k²·(n₀ + n₁x + n₂x²)/(x·E)
//! ```
//!
//! All of n₀, n₂, e₁, e₂ are at least 0. Where n₁ is too, |L| falls with ω from infinity on.

use super::lanes::{Lanes, WIDTH, flag, sin_cos};
use crate::model::{Controller, DerivativeFilter, Process};

/// Settings of loops in their own units; a time that is absent is 0, an absent integral time infinite.
pub(super) struct Settings {
    pub(super) process_gain: Lanes,
    pub(super) dead_time: Lanes,
    pub(super) lag: Lanes,
    pub(super) proportional_gain: Lanes,
    pub(super) integral_time: Lanes,
    pub(super) derivative_time: Lanes,
    pub(super) filter_time: Lanes,
}

/// The coefficients of so many loops.
pub(super) struct Forms {
    pub(super) gain: Lanes,
    pub(super) n: [Lanes; 3],
    pub(super) c: [Lanes; 3],
    pub(super) d: [Lanes; 2],
    pub(super) e: [Lanes; 2],
    /// 1 where the form applies: positive feedback gain, numbers of ordinary size, n₁ > 0.
    pub(super) applies: Lanes,
    /// Whether any of them has a lag.
    pub(super) lag: bool,
}

/// The coefficients of one loop.
#[derive(Clone, Copy)]
pub(super) struct Form {
    pub(super) k: f64,
    pub(super) n: [f64; 3],
    pub(super) c: [f64; 3],
    pub(super) d: [f64; 2],
    pub(super) e: [f64; 2],
}

/// (c + j·d)·e^(−jω) = V + j·W at one frequency, with two derivatives by ω. V > 0 and W = 0 where L is real and negative.
#[derive(Clone, Copy)]
pub(super) struct Turned {
    pub(super) v: [f64; 3],
    pub(super) w: [f64; 3],
}

/// R = 1 + q·A/B at one frequency: |1 + L|² with q = k, A = k·N − 2V, B = E, or |1 + 1/L|² with q = 1/k, A = E/k − 2V,
/// B = N, where N = n₀/x + n₁ + n₂x.
#[derive(Clone, Copy)]
pub(super) struct Distance {
    /// R.
    pub(super) squared: f64,
    /// q/B², by which Z is the slope of R.
    pub(super) scale: f64,
    /// Z = A'·B − A·B', of the sign of R'.
    pub(super) z: f64,
    /// Z'.
    pub(super) dz: f64,
}

impl Default for Settings {
    /// A loop of ordinary gain in every lane.
    fn default() -> Self {
        Self {
            process_gain: [1.0; WIDTH],
            dead_time: [1.0; WIDTH],
            lag: [0.0; WIDTH],
            proportional_gain: [0.4; WIDTH],
            integral_time: [f64::INFINITY; WIDTH],
            derivative_time: [0.0; WIDTH],
            filter_time: [0.0; WIDTH],
        }
    }
}

impl Settings {
    /// Puts a loop in a lane; false if it has not the normal form.
    pub(super) fn set(&mut self, lane: usize, process: &Process, controller: &Controller) -> bool {
        let other = controller.observer().is_some()
            || controller.compensator().is_some()
            || controller.output_filter().is_some();
        if other || process.integrators() != 1 {
            return false;
        }
        self.process_gain[lane] = process.process_gain();
        self.dead_time[lane] = process.dead_time();
        self.lag[lane] = process.lag().unwrap_or(0.0);
        self.proportional_gain[lane] = controller.proportional_gain();
        self.integral_time[lane] = controller.integral_time().unwrap_or(f64::INFINITY);
        self.derivative_time[lane] = controller.derivative_time().unwrap_or(0.0);
        self.filter_time[lane] = controller.derivative_filter().map_or(0.0, DerivativeFilter::time);
        true
    }
}

impl Forms {
    #[inline(always)]
    pub(super) fn new(settings: &Settings) -> Self {
        let mut forms = Self {
            gain: [0.0; WIDTH],
            n: [[0.0; WIDTH]; 3],
            c: [[0.0; WIDTH]; 3],
            d: [[0.0; WIDTH]; 2],
            e: [[0.0; WIDTH]; 2],
            applies: [0.0; WIDTH],
            lag: settings.lag.iter().any(|lag| *lag != 0.0),
        };
        for i in 0..WIDTH {
            let dead_time = settings.dead_time[i];
            let k = settings.process_gain[i] * settings.proportional_gain[i] * dead_time;
            let per_dead_time = 1.0 / dead_time;
            let a = dead_time / settings.integral_time[i];
            let b = settings.derivative_time[i] * per_dead_time;
            let f = settings.filter_time[i] * per_dead_time;
            let lag = settings.lag[i] * per_dead_time;
            let g = b + f;
            let skew = a * f * f - b;
            let n1 = 1.0 + a * a * f * f - 2.0 * a * b;
            let (f2, lag2) = (f * f, lag * lag);
            forms.gain[i] = k;
            forms.n[0][i] = a * a;
            forms.n[1][i] = n1;
            forms.n[2][i] = g * g;
            forms.c[0][i] = a;
            forms.c[1][i] = skew + lag;
            forms.c[2][i] = lag * f * g;
            forms.d[0][i] = 1.0 - lag * a;
            forms.d[1][i] = f * g - lag * skew;
            forms.e[0][i] = f2 + lag2;
            forms.e[1][i] = f2 * lag2;
            // Beyond that no loop is of use, squares of squares would overflow, and an integral action too slow to tell from
            // none is for the exact analysis to judge.
            let integrates = (a == 0.0) | (a > 1e-6);
            let ordinary = (k > 1e-6) & (k < 1e6) & (a < 1e6) & (b < 1e6) & (f < 1e6) & (lag < 1e6);
            let ordinary = ordinary & integrates;
            forms.applies[i] = flag(ordinary & (n1 > 1e-9 * (1.0 + a * a * f * f)));
        }
        forms
    }

    #[inline(always)]
    pub(super) fn one(&self, i: usize) -> Form {
        Form {
            k: self.gain[i],
            n: [self.n[0][i], self.n[1][i], self.n[2][i]],
            c: [self.c[0][i], self.c[1][i], self.c[2][i]],
            d: [self.d[0][i], self.d[1][i]],
            e: [self.e[0][i], self.e[1][i]],
        }
    }
}

impl Form {
    /// 1/|L|².
    #[inline(always)]
    pub(super) fn inverse_gain_squared(&self, x: f64) -> f64 {
        let [n0, n1, n2] = self.n;
        let [e1, e2] = self.e;
        x * x * (1.0 + x * (e1 + x * e2)) / (self.k * self.k * (n0 + x * (n1 + x * n2)))
    }

    /// V and W at a frequency in [0, π].
    #[inline(always)]
    pub(super) fn turned(&self, omega: f64) -> Turned {
        let ([c0, c1, c2], [d0, d1]) = (self.c, self.d);
        let x = omega * omega;
        let (sin, cos) = sin_cos(omega);
        let c = c0 + x * (c1 + x * c2);
        let dc = omega * (2.0 * c1 + 4.0 * c2 * x);
        let ddc = 2.0 * c1 + 12.0 * c2 * x;
        let d = omega * (d0 + x * d1);
        let dd = d0 + 3.0 * d1 * x;
        let ddd = 6.0 * d1 * omega;
        let (first, second) = (dc + d, dd - c);
        let (third, fourth) = (ddc + 2.0 * dd - c, ddd - 2.0 * dc - d);
        Turned {
            v: [c * cos + d * sin, first * cos + second * sin, third * cos + fourth * sin],
            w: [d * cos - c * sin, second * cos - first * sin, fourth * cos - third * sin],
        }
    }

    /// R and its slope: of the complementary sensitivity, or of the sensitivity.
    #[inline(always)]
    pub(super) fn distance<const COMPLEMENTARY: bool>(&self, omega: f64, v: &[f64; 3]) -> Distance {
        let ([n0, n1, n2], [e1, e2]) = (self.n, self.e);
        let x = omega * omega;
        let inverse = 1.0 / x;
        let e = x * (1.0 + x * (e1 + x * e2));
        let de = omega * (2.0 + x * (4.0 * e1 + 6.0 * x * e2));
        let dde = 2.0 + x * (12.0 * e1 + 30.0 * x * e2);
        let over = n0 * inverse;
        let n = over + (n1 + n2 * x);
        let dn = 2.0 * omega * (n2 - over * inverse);
        let ddn = 6.0 * over * inverse + 2.0 * n2;
        let ((q, a, da, dda), (b, db, ddb)) = if COMPLEMENTARY {
            let q = 1.0 / self.k;
            ((q, q * e, q * de, q * dde), (n, dn, ddn))
        } else {
            ((self.k, self.k * n, self.k * dn, self.k * ddn), (e, de, dde))
        };
        let (a, da, dda) = (a - 2.0 * v[0], da - 2.0 * v[1], dda - 2.0 * v[2]);
        Distance { squared: 1.0 + q * a / b, scale: q / (b * b), z: da * b - a * db, dz: dda * b - a * ddb }
    }
}
