//! Laws of the frequency analysis and an independent evaluation of L, on many loops.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use std::f64::consts::PI;

use holdup::analysis::frequency::{Margins, margins};
use holdup::model::{ClosedLoop, Controller, Observer, OutputFilter, Process, Seconds};
use num_complex::Complex;
use proptest::prelude::*;

/// A process and a controller in plain numbers.
#[derive(Debug, Clone, Copy)]
struct Loop {
    k: f64,
    d: f64,
    lag: Option<f64>,
    double: bool,
    kc: f64,
    ti: Option<f64>,
    td: Option<f64>,
    n: Option<f64>,
    filter: Option<(f64, f64)>,
    observer: Option<(f64, f64, f64)>,
}

impl Loop {
    /// The loop with `gain` times the process gain and `extra` added to its dead time; the observer keeps its
    /// model.
    fn closed(&self, gain: f64, extra: f64) -> ClosedLoop {
        let (k, d) = (self.k * gain, Seconds(self.d + extra));
        let mut process = if self.double {
            Process::double_integrating(k, d).unwrap()
        } else {
            Process::integrating(k, d).unwrap()
        };
        if let Some(lag) = self.lag {
            process = process.with_lag(Seconds(lag)).unwrap();
        }
        let mut c = Controller::proportional(self.kc).unwrap();
        if let Some(ti) = self.ti {
            c = c.with_integral_time(Seconds(ti)).unwrap();
        }
        if let Some(td) = self.td {
            c = c.with_derivative_time(Seconds(td)).unwrap();
        }
        if let Some(n) = self.n {
            c = c.with_filter_bandwidth(n).unwrap();
        }
        if let Some((a1, a2)) = self.filter {
            c = c.with_output_filter(a1, a2).unwrap();
            assert_eq!(c.output_filter(), Some(OutputFilter { a1, a2 }));
        }
        if let Some((ko, km, dm)) = self.observer {
            let o = Observer::new(ko).unwrap().with_model_gain(self.k * km).unwrap();
            c = c.with_observer(o.with_model_dead_time(Seconds(self.d * dm)).unwrap());
        }
        ClosedLoop::new(&process, &c)
    }

    fn margins(&self) -> Margins {
        margins(&self.closed(1.0, 0.0)).unwrap()
    }

    /// L(jω) written down from the block diagram, by complex arithmetic.
    fn at(&self, omega: f64) -> Complex<f64> {
        let s = Complex::new(0.0, omega);
        let integrators = if self.double { s * s } else { s };
        let structure = integrators * (self.lag.unwrap_or(0.0) * s + 1.0);
        let g = self.k * (-s * self.d).exp() / structure;
        let derivative = self.td.map_or(Complex::new(0.0, 0.0), |td| {
            td * s / self.n.map_or(Complex::new(1.0, 0.0), |n| s / n + 1.0)
        });
        let integral = self.ti.map_or(Complex::new(0.0, 0.0), |ti| 1.0 / (ti * s));
        let (a1, a2) = self.filter.unwrap_or((0.0, 0.0));
        let c = self.kc * (1.0 + integral + derivative) / (a2 * s * s + a1 * s + 1.0);
        match self.observer {
            None => g * c,
            Some((ko, km, dm)) => {
                let model = self.k * km * (-s * self.d * dm).exp() / structure;
                g * (c + ko + ko * model * c)
            }
        }
    }
}

fn some<T: std::fmt::Debug + Clone + 'static>(
    s: impl Strategy<Value = T> + 'static,
) -> impl Strategy<Value = Option<T>> {
    proptest::option::of(s)
}

/// Log-uniform on [low, high].
fn log(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low.ln()..high.ln()).prop_map(f64::exp)
}

prop_compose! {
    fn any_loop()(
        k in log(1e-3, 1e2), d in log(0.1, 50.0), lag in some(log(0.01, 10.0)), double in prop::bool::weighted(0.2),
        gain in log(0.02, 2.0), ti in some(log(0.5, 100.0)), td in some(log(0.02, 5.0)),
        n in some(log(0.5, 300.0)), filter in some((log(0.01, 1.0), log(0.001, 0.5))),
        observer in some((log(0.02, 1.0), log(0.7, 1.4), prop_oneof![Just(1.0), log(0.6, 1.6)])),
        sign in prop::bool::ANY, wrong in prop::bool::weighted(0.05),
    ) -> Loop {
        // Times in dead times, gains in units of 1/(K·d).
        let k = if sign { k } else { -k };
        let unit = 1.0 / (k * if double { d * d } else { d });
        let observer = observer.map(|(ko, km, dm)| (ko * unit, km, dm));
        let kc = gain * unit * if wrong { -1.0 } else { 1.0 };
        Loop {
            k, d, lag: lag.map(|t| t * d), double, kc, ti: ti.map(|t| t * d), td: td.map(|t| t * d),
            n: if td.is_some() { n.map(|n| n / d) } else { None },
            filter: filter.map(|(a1, a2)| (a1 * d, a2 * d * d)), observer,
        }
    }
}

/// The dense grid that the answers are held against.
fn grid(d: f64) -> impl Iterator<Item = f64> {
    let slow = (0..4000).map(|i| 10f64.powf(-4.0 + f64::from(i) / 1000.0));
    slow.chain((0..20_000).map(|i| 1.0 + 0.005 * f64::from(i))).map(move |w| w / d)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn no_point_of_a_dense_grid_beats_the_answers(l in any_loop()) {
        let m = l.margins();
        let points: Vec<(f64, Complex<f64>)> = grid(l.d).map(|w| (w, l.at(w))).collect();
        let (mut gains, mut phases) = (0, 0);
        let last = *m.phase_crossovers.last().unwrap();
        for pair in points.windows(2) {
            let [(_, a), (w, b)] = [pair[0], pair[1]];
            gains += usize::from((a.norm() >= 1.0) != (b.norm() >= 1.0));
            let cuts = (a.im >= 0.0) != (b.im >= 0.0) && a.re + b.re < 0.0;
            phases += usize::from(cuts && w <= last);
            if m.stable {
                // A grid never finds more than the supremum; 1e-9 covers the rounding of this evaluation.
                let s = 1.0 / (1.0 + b).norm();
                prop_assert!(s <= m.sensitivity_peak.unwrap() * (1.0 + 1e-9), "S {s} at {w}");
                let t = s * b.norm();
                prop_assert!(t <= m.complementary_sensitivity_peak.unwrap() * (1.0 + 1e-9), "T {t} at {w}");
            }
        }
        // The grid may miss a pair of crossings between two points, never find one that is not there.
        let (top, low) = (points.last().unwrap().0, points[0].0);
        let listed = |list: &[f64]| list.iter().filter(|w| (low..=top).contains(w)).count();
        prop_assert!(listed(&m.gain_crossovers) >= gains, "{gains} gain crossovers, {:?}", m.gain_crossovers);
        prop_assert!(listed(&m.phase_crossovers) + 1 >= phases, "{phases} phase crossovers, {:?}", m.phase_crossovers);
        for &w in &m.gain_crossovers {
            // Near ω → 0 the rounding of this evaluation is amplified by the slope of |L|, at most 3.
            prop_assert!((l.at(w).norm() - 1.0).abs() < 1e-9, "|L| = {} at {w}", l.at(w).norm());
        }
        for &w in &m.phase_crossovers {
            let at = l.at(w);
            prop_assert!(at.re < 0.0 && (at.im / at.re).abs() < 1e-9, "L = {at} at {w}");
        }
        if let Some(w) = m.sensitivity_peak_frequency {
            let s = 1.0 / (1.0 + l.at(w)).norm();
            prop_assert!((s / m.sensitivity_peak.unwrap() - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn stability_is_lost_between_0_999_and_1_001_of_every_margin(l in any_loop()) {
        let m = l.margins();
        if m.stable {
            let stable = |gain: f64, extra: f64| margins(&l.closed(gain, extra)).unwrap().stable;
            if let Some(g) = m.gain_margin {
                let inside = 1.0 + (g - 1.0) * 0.999;
                prop_assert!(stable(inside, 0.0), "inside the gain margin {g}");
                prop_assert!(!stable(1.0 + (g - 1.0) * 1.001, 0.0), "beyond the gain margin {g}");
            }
            if let Some(g) = m.gain_margin_low {
                prop_assert!(stable(1.0 - (1.0 - g) * 0.999, 0.0), "inside the lower gain margin {g}");
                prop_assert!(!stable(1.0 - (1.0 - g) * 1.001, 0.0), "beyond the lower gain margin {g}");
            }
            let dm = m.delay_margin.unwrap().0;
            prop_assert!(stable(1.0, dm * 0.999), "inside the delay margin {dm}");
            prop_assert!(!stable(1.0, dm * 1.001), "beyond the delay margin {dm}");
            if let Some(cut) = m.delay_margin_low.map(|t| t.0).filter(|t| t * 1.001 < l.d) {
                prop_assert!(stable(1.0, -cut * 0.999), "inside the lower delay margin {cut}");
                prop_assert!(!stable(1.0, -cut * 1.001), "beyond the lower delay margin {cut}");
            } else if m.delay_margin_low.is_none() {
                prop_assert!(stable(1.0, -0.9 * l.d), "no lower delay margin");
            }
            let s = m.sensitivity_peak.unwrap();
            // M_s guarantees gain margin M_s/(M_s − 1) and phase margin 2·asin(1/(2·M_s)).
            prop_assert!(m.gain_margin.unwrap() >= s / (s - 1.0) * (1.0 - 1e-12));
            prop_assert!(m.phase_margin.unwrap().0.abs() >= 2.0 * (0.5 / s).asin() * (1.0 - 1e-9));
        }
    }

    #[test]
    fn scaling_time_and_gain_scales_the_margins(l in any_loop(), a in log(0.01, 100.0), b in log(0.01, 100.0)) {
        let m = l.margins();
        let scaled = Loop {
            k: -l.k * b / if l.double { a * a } else { a }, d: l.d * a, kc: -l.kc / b,
            lag: l.lag.map(|t| t * a), ti: l.ti.map(|t| t * a), td: l.td.map(|t| t * a), n: l.n.map(|n| n / a),
            filter: l.filter.map(|(a1, a2)| (a1 * a, a2 * a * a)),
            observer: l.observer.map(|(ko, km, dm)| (-ko / b, km, dm)), ..l
        };
        let n = scaled.margins();
        prop_assert_eq!(m.stable, n.stable);
        prop_assert_eq!(m.unstable_poles, n.unstable_poles);
        // The scaled settings are rounded, and margins amplify that by their condition: 1e-9 is far above both.
        let near = |x: Option<f64>, y: Option<f64>, factor: f64| match (x, y) {
            (Some(x), Some(y)) => (x * factor / y - 1.0).abs() < 1e-9,
            (x, y) => x == y,
        };
        prop_assert!(near(m.gain_margin, n.gain_margin, 1.0));
        prop_assert!(near(m.gain_margin_low, n.gain_margin_low, 1.0));
        prop_assert!(near(m.delay_margin.map(|t| t.0), n.delay_margin.map(|t| t.0), a));
        prop_assert!(near(m.phase_margin.map(|p| p.0), n.phase_margin.map(|p| p.0), 1.0));
        prop_assert!(near(m.sensitivity_peak, n.sensitivity_peak, 1.0));
        prop_assert!(near(m.complementary_sensitivity_peak, n.complementary_sensitivity_peak, 1.0));
        prop_assert_eq!(m.phase_crossovers.len(), n.phase_crossovers.len());
        for (x, y) in m.gain_crossovers.iter().zip(&n.gain_crossovers) {
            prop_assert!((x / a / y - 1.0).abs() < 1e-9);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, ..ProptestConfig::default() })]

    #[test]
    fn unstable_poles_agree_with_the_encirclements_of_a_dense_nyquist_curve(l in any_loop()) {
        let m = l.margins();
        let Some(poles) = m.unstable_poles else { return Ok(()) };
        // 1 + L turns by `turned` from where L is its asymptote c/(jω)ᵏ to where |L| stays below 1.
        let integrators = if l.double { 2 } else { 1 };
        let models = if l.observer.is_some() { 2 } else { 1 };
        let k = f64::from(integrators * models + i32::from(l.ti.is_some()));
        let slow = (0..24_000).map(|i| 10f64.powf(-6.0 + f64::from(i) / 4000.0));
        let fast = (0..100_000).map(|i| 1.0 + 0.01 * f64::from(i));
        let mut turned = 0.0;
        let mut previous: Option<Complex<f64>> = None;
        for w in slow.chain(fast) {
            let next = 1.0 + l.at(w / l.d);
            // A step of the curve that passes −1 closer than it is long may go round it on either side.
            prop_assume!(next.norm() > 0.05);
            turned += previous.map_or(0.0, |p| (next * p.conj()).arg());
            previous = Some(next);
        }
        let end = previous.unwrap();
        prop_assume!((end - 1.0).norm() < 1.0);
        // Δ = sᵏ·D̃·(1 + L), all zeros of D̃ in the left half plane.
        let zeros = k / 2.0 + (end.arg() - turned) / PI;
        let counted = f64::from(u32::try_from(poles).unwrap());
        prop_assert!((zeros - counted).abs() < 0.01, "{zeros} by the curve, {poles}");
    }
}
