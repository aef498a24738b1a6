//! The PD loops of one stated margin: two curves with closed forms.
//!
//! In units of the dead time the loop is `L = a·(1 + τ1·s)/(1 + τ2·s)·e^(−s)/s` with `a = |K·Kc|·d`, `τ1 = Td/d + τ2`
//! and `τ2 = 1/(N·d)`, 0 without a filter. |L| falls strictly with frequency; below the frequency π/2 the phase is
//! above −180° and beyond it falls strictly, so there is one gain crossover and one first phase crossover p, and p
//! lies in [π/2, π). The loop is stable exactly if |L(jp)| < 1, and without a filter a·τ1 < 1 follows from that.
//!
//! - Constant gain margin: p = π − q is the parameter. The phase condition gives τ1 by tangents, the margin then
//!   gives a: without a filter τ1·p = cot q and a = p·sin q/Am.
//! - Constant phase margin φ: the gain crossover g is the parameter, `atan(τ1·g) = φ − π/2 + g + atan(τ2·g)`.

use std::f64::consts::{FRAC_PI_2, PI};

/// A PD loop in units of the dead time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pd {
    /// Loop gain a = |K·Kc|·d.
    pub(super) gain: f64,
    /// Derivative time over dead time.
    pub(super) derivative: f64,
}

/// The PD loops that have one stated margin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Curve {
    pub(super) margin: Margin,
    /// Filter time over dead time, τ2; 0 without a filter.
    pub(super) filter: f64,
}

/// The margin that is kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Margin {
    /// Gain margin, > 1.
    Gain(f64),
    /// Phase margin [rad], in (0, π).
    Phase(f64),
}

impl Curve {
    /// Both ends of the parameter: Td = 0 at the first (where P control can have the margin), Td → ∞ at the second,
    /// which does not belong to the curve.
    pub(super) fn ends(&self) -> (f64, f64) {
        match self.margin {
            Margin::Gain(_) => {
                // The lead cannot give the phase any more where sin q = τ2·p·cos q.
                let (mut low, mut high) = (0.0, FRAC_PI_2);
                if self.filter > 0.0 {
                    (low, high) =
                        super::root::bracket(low, high, 0.0, |q| q.sin() - self.filter * (PI - q) * q.cos());
                }
                (FRAC_PI_2, if self.filter > 0.0 { low.max(high) } else { 0.0 })
            }
            Margin::Phase(phase) => {
                let first = (FRAC_PI_2 - phase).max(0.0);
                let span = |g: f64| phase - PI + g + (self.filter * g).atan();
                let (low, high) = super::root::bracket(first, PI - phase, 0.0, span);
                (first, low.min(high))
            }
        }
    }

    /// The loop at this parameter, strictly between the ends or at the first.
    pub(super) fn at(&self, parameter: f64) -> Pd {
        let lag = self.filter;
        let gain =
            |x: f64, lead: f64| x * (1.0 + (lag * x).powi(2)).sqrt() / (1.0 + (lead * x).powi(2)).sqrt();
        match self.margin {
            Margin::Gain(margin) => {
                let (p, (sin, cos)) = (PI - parameter, parameter.sin_cos());
                if parameter == FRAC_PI_2 {
                    return Pd { gain: p / margin, derivative: 0.0 };
                }
                let lead = (cos + lag * p * sin) / (p * (sin - lag * p * cos));
                Pd { gain: gain(p, lead) / margin, derivative: lead - lag }
            }
            Margin::Phase(phase) => {
                let g = parameter;
                if g == FRAC_PI_2 - phase {
                    return Pd { gain: g, derivative: 0.0 };
                }
                let lead = (phase - FRAC_PI_2 + g + (lag * g).atan()).tan() / g;
                Pd { gain: gain(g, lead), derivative: lead - lag }
            }
        }
    }

    /// Phase margin [rad] of a loop with this filter.
    pub(super) fn phase_margin(&self, pd: Pd) -> f64 {
        let (lag, lead) = (self.filter, pd.derivative + self.filter);
        let b = 1.0 - (pd.gain * lead).powi(2);
        let square = pd.gain * pd.gain;
        let root = (b * b + 4.0 * lag * lag * square).sqrt();
        // The positive root of lag²·X² + b·X − a² = 0, X = g², without cancellation.
        let x = if b >= 0.0 { 2.0 * square / (b + root) } else { (root - b) / (2.0 * lag * lag) };
        let g = x.sqrt();
        FRAC_PI_2 - g + (lead * g).atan() - (lag * g).atan()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn response(pd: Pd, filter: f64, x: f64) -> (f64, f64) {
        let lead = pd.derivative + filter;
        let magnitude = pd.gain * ((1.0 + (lead * x).powi(2)) / (1.0 + (filter * x).powi(2))).sqrt() / x;
        (magnitude, -FRAC_PI_2 - x + (lead * x).atan() - (filter * x).atan())
    }

    #[test]
    fn loops_of_the_gain_curve_have_their_gain_margin_at_their_phase_crossover() {
        for filter in [0.0, 0.01, 0.3] {
            let curve = Curve { margin: Margin::Gain(2.5), filter };
            let (first, last) = curve.ends();
            for i in 0..50 {
                let q = first + (last - first) * f64::from(i) / 50.0;
                let (magnitude, phase) = response(curve.at(q), filter, PI - q);
                assert!((magnitude - 0.4).abs() < 1e-13 && (phase + PI).abs() < 1e-12, "{filter} {q}");
                assert!(curve.at(q).derivative >= 0.0);
            }
        }
    }

    #[test]
    fn loops_of_the_phase_curve_have_their_phase_margin_at_their_gain_crossover() {
        for filter in [0.0, 0.01, 0.3] {
            for phase in [0.3, 1.0, 1.7] {
                let curve = Curve { margin: Margin::Phase(phase), filter };
                let (first, last) = curve.ends();
                for i in 1..50 {
                    let g = first + (last - first) * f64::from(i) / 50.0;
                    let (magnitude, angle) = response(curve.at(g), filter, g);
                    assert!((magnitude - 1.0).abs() < 1e-13 && (angle + PI - phase).abs() < 1e-12);
                    assert!((curve.phase_margin(curve.at(g)) - phase).abs() < 1e-12);
                }
            }
        }
    }
}
