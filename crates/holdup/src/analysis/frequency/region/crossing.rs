//! The settings for which the characteristic equation has the root jω.

use num_complex::Complex;

use super::Plane;
use super::plane::Settings;
use crate::model::DerivativeFilter;

/// Process, controller and observer at one frequency.
pub(super) struct At<'a> {
    settings: &'a Settings<'a>,
    omega: f64,
    /// Process and observer's model of it.
    process: Complex<f64>,
    model: Complex<f64>,
    filter: Complex<f64>,
    /// jω/(1 + jω·Tf): derivative action for Td = 1.
    derivative: Complex<f64>,
}

impl<'a> At<'a> {
    pub(super) fn new(settings: &'a Settings<'a>, omega: f64) -> Self {
        let (process, controller) = (settings.process, settings.controller);
        let one = Complex::new(1.0, 0.0);
        let s = Complex::new(0.0, omega);
        let shape = s.powi(i32::from(process.integrators())) * (one + s * process.lag().unwrap_or(0.0));
        let with = |gain: f64, d: f64| Complex::from_polar(1.0, -omega * d) * gain / shape;
        let (gain, dead_time) = (process.process_gain(), process.dead_time());
        let observer = controller.observer();
        let model_gain = observer.and_then(|o| o.model_gain()).unwrap_or(gain);
        let model_dead_time = observer.and_then(|o| o.model_dead_time()).unwrap_or(dead_time);
        let filter = controller.output_filter().map_or(one, |f| one / (one + s * f.a1 + s * s * f.a2));
        let tf = controller.derivative_filter().map_or(0.0, DerivativeFilter::time);
        Self {
            settings,
            omega,
            process: with(gain, dead_time),
            model: with(model_gain, model_dead_time),
            filter,
            derivative: s / (one + s * tf),
        }
    }

    /// The points of the plane for which jω is a pole; none, one, or two for the observer gain.
    pub(super) fn points(&self) -> [Option<[f64; 2]>; 2] {
        let controller = self.settings.controller;
        let one = Complex::new(1.0, 0.0);
        let integral = Complex::new(0.0, -1.0 / self.omega);
        let ti = controller.integral_time();
        let td = controller.derivative_time().unwrap_or(0.0);
        let ko = controller.observer().map_or(0.0, |o| o.gain());
        // 1 + Ko·G + F·C·G·(1 + Ko·G_m) = 0 solved for the control law C.
        let law = -(one + self.process * ko) / (self.filter * self.process * (one + self.model * ko));
        match self.settings.plane {
            // C = Kc·(1 + Td·D) + (Kc/Ti)/s
            Plane::KcTi => {
                let [kc, ki] = solve(one + self.derivative * td, integral, law);
                [Some([kc, kc / ki]), None]
            }
            // C = Kc·(1 + 1/(Ti·s)) + (Kc·Td)·D
            Plane::KcTd => {
                let [kc, kd] = solve(one + integral * ti.map_or(0.0, |ti| 1.0 / ti), self.derivative, law);
                [Some([kc, kd / kc]), None]
            }
            // (1 + Kc·a) + Ko·(G + Kc·a·G_m) = 0, a = F·G·C/Kc: Ko real is a quadratic equation for Kc.
            Plane::KcKo => {
                let shape = one + self.derivative * td + integral * ti.map_or(0.0, |ti| 1.0 / ti);
                let a = self.filter * self.process * shape;
                let b = a * self.model;
                let (square, linear) = (a * b.conj(), b.conj() + a * self.process.conj());
                let constant = self.process.conj();
                quadratic(square.im, linear.im, constant.im).map(|kc| {
                    let kc = kc?;
                    let ko = -(one + a * kc) / (self.process + b * kc);
                    Some([kc, ko.re])
                })
            }
        }
    }
}

/// Real factors with p·a + q·b = c.
fn solve(a: Complex<f64>, b: Complex<f64>, c: Complex<f64>) -> [f64; 2] {
    let determinant = a.re * b.im - a.im * b.re;
    [(c.re * b.im - c.im * b.re) / determinant, (a.re * c.im - a.im * c.re) / determinant]
}

/// Real roots of a·x² + b·x + c.
fn quadratic(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 || discriminant.is_nan() {
        return [None, None];
    }
    let half = -0.5 * (b + discriminant.sqrt().copysign(b));
    // In the same order all along the curve.
    let (first, second) = if b < 0.0 { (c / half, half / a) } else { (half / a, c / half) };
    [Some(first), Some(second)]
}
