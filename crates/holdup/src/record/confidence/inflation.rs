//! How much wider an interval must be because the noise itself is estimated, and because the rows are rounded.
//!
//! The variance of gain and dead time depends on the strengths of the noise. Along each of them the restricted likelihood,
//! with odds of two to one for the part being absent and else a uniform prior on its standard deviation (A. Gelman, Bayesian
//! Analysis 1 (2006) 515), weighs the variances and the estimates that go with them. The mean of the variances plus the variance
//! of the estimates takes the place of the variance at the best strengths. An estimate whose variance is itself uncertain is a mixture
//! of normal distributions; with the variance as the inverse of a χ² it is Student's t (A. Gelman and others, Bayesian Data
//! Analysis, 3rd ed. (2013), section 3.2), whose degrees of freedom follow from the spread of the variances, and whose scale
//! from their mean: ν/(ν − 2) times the square of the scale is that mean.

use crate::record::identify::{Basis, Fit, Joint, Noise, Problem, Shape, Whitener, dot};

/// Points along each strength.
const POINTS: u32 = 9;

/// The restricted log-likelihood falls by so much at the end of what is weighed.
const FALL: f64 = 4.5;

/// What takes the place of the residual variance and of the rows' degrees of freedom for one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Inflation {
    /// Factor on the variance.
    pub(crate) factor: f64,
    /// Degrees of freedom.
    pub(crate) freedom: f64,
    /// Greatest effect of rounding, in standard deviations.
    pub(crate) bias: f64,
}

/// The noise with one of its parts at another strength.
type Vary = fn(&Noise, f64) -> Noise;

/// The inflation of gain and of dead time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Inflations {
    pub(crate) gain: Inflation,
    pub(crate) dead_time: Inflation,
}

/// Likelihood, estimates and variances of gain and dead time under one noise, linear about a fit.
#[derive(Debug, Clone, Copy)]
struct Linear {
    likelihood: f64,
    estimate: [f64; 2],
    variance: [f64; 2],
    /// Σ of the moduli of the weights by which a row enters the estimates.
    weight: [f64; 2],
}

/// The columns of the linearised fit: those of initial state and load, the input's, and its change with the dead time.
struct Linearised<'p, 'r> {
    problem: &'p Problem<'r>,
    fit: Fit,
    own: Vec<Vec<f64>>,
    column: Vec<f64>,
    slope: Vec<f64>,
}

impl<'p, 'r> Linearised<'p, 'r> {
    fn new(problem: &'p Problem<'r>, joint: &Joint) -> Self {
        let fit = &joint.fit;
        let shape = fit.kind.shape(fit.lag);
        let mut own = problem.own_columns(fit.kind, fit.lag);
        if fit.kind.has_lag() {
            let of = |lag: f64| problem.column(fit.kind.shape(lag), fit.dead_time);
            let (more, less) = (of(1.0001 * fit.lag), of(0.9999 * fit.lag));
            own.push(more.iter().zip(&less).map(|(a, b)| a - b).collect());
        }
        let rate = |shape: Shape| problem.column(shape, fit.dead_time);
        let slope = rate(shape.rate()).into_iter().map(|value| -fit.gain * value).collect();
        Self { problem, fit: *fit, own, column: problem.column(shape, fit.dead_time), slope }
    }

    /// Where the noise leaves single rows to tell the dead time, finding it is finding a change point: the best of many
    /// separate places, whose 95 % threshold is 7.35 instead of 3.84 (B. E. Hansen, Econometrica 68 (2000) 575, theorem
    /// 3). How separate, the correlation of what one row more or less of dead time changes tells; it matters where the
    /// uncertainty reaches beyond one row.
    fn change_points(&self, noise: &Noise, deviation: f64) -> f64 {
        const RATIO: f64 = 7.35 / 3.84;
        let fit = &self.fit;
        let whitener = Whitener::new(noise, &self.problem.times);
        let basis = Basis::of(self.own.iter().map(|column| whitener.whiten(column.clone())));
        let step = self.problem.step();
        let change = |delay: f64| {
            basis.projected(whitener.whiten(self.problem.column(fit.kind.shape(fit.lag).rate(), delay)))
        };
        let (here, beyond) = (change(fit.dead_time), change(fit.dead_time + step));
        let alike = dot(&here, &beyond) / (dot(&here, &here) * dot(&beyond, &beyond)).sqrt();
        let separate = 1.0 - alike.clamp(0.0, 1.0);
        let reach = (2.0 * deviation / step).min(1.0);
        let factor = 1.0 + (RATIO - 1.0) * separate * reach;
        if factor.is_finite() { factor } else { RATIO }
    }

    fn under(&self, noise: &Noise) -> Linear {
        let whitener = Whitener::new(noise, &self.problem.times);
        let whiten = |column: &Vec<f64>| whitener.whiten(column.clone());
        let mut basis = Basis::of(self.own.iter().map(whiten));
        let column = basis.projected(whiten(&self.column));
        let slope = basis.projected(whiten(&self.slope));
        let response = basis.projected(whiten(&self.problem.response));
        let [vv, vs, ss] = [dot(&column, &column), dot(&column, &slope), dot(&slope, &slope)];
        let [vy, sy] = [dot(&column, &response), dot(&slope, &response)];
        let determinant = vv * ss - vs * vs;
        let estimate = [(vy * ss - sy * vs) / determinant, (sy * vv - vy * vs) / determinant];
        let rest = dot(&response, &response) - estimate[0] * vy - estimate[1] * sy;
        basis.add(column.clone());
        basis.add(slope.clone());
        #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
        let freedom = (self.problem.len().saturating_sub(basis.rank())).max(1) as f64;
        let scale = rest.max(f64::MIN_POSITIVE) / freedom;
        let likelihood = -0.5 * (freedom * scale.ln() + whitener.log_determinant() + basis.log_determinant());
        // A rounding error of a row moves the whitened rows after it; their weights bound its effect from above only
        // where the whitener does not amplify, so the weights are taken back through the whitener.
        let back = |own: f64, other: f64| -> f64 {
            let weights =
                column.iter().zip(&slope).map(|(v, s)| (own * v + other * s) / determinant).collect();
            whitener.transposed(weights).iter().map(|weight| weight.abs()).sum()
        };
        Linear {
            likelihood,
            estimate,
            variance: [scale * ss / determinant, scale * vv / determinant],
            weight: [back(ss, -vs), {
                let weights =
                    column.iter().zip(&slope).map(|(v, s)| (vv * s - vs * v) / determinant).collect();
                whitener.transposed(weights).iter().map(|weight: &f64| weight.abs()).sum()
            }],
        }
    }
}

/// The inflation for a fit whose rows are known to within `resolution` (0 where rounding is below the noise).
pub(crate) fn inflations(problem: &Problem<'_>, joint: &Joint, resolution: f64) -> Inflations {
    let linearised = Linearised::new(problem, joint);
    let at_best = linearised.under(&joint.noise);
    let noise = joint.noise;
    let step = problem.step();
    let total = noise.white.hypot(noise.coloured).max(noise.walk * step.sqrt());
    let longest = problem.span() / 6.0;
    // Each part with the unit in which it begins to matter.
    let parts: [(Vary, f64, f64); 4] = [
        (|n, s| Noise { coloured: s, ..*n }, noise.coloured, 0.05 * total),
        (|n, s| Noise { walk: s, ..*n }, noise.walk, 0.002 * total / step.sqrt()),
        (|n, s| Noise { wander: s, ..*n }, noise.wander, 2e-5 * total / (step * step.sqrt())),
        (|n, s| Noise { correlation_time: s, ..*n }, noise.correlation_time, 0.3 * noise.correlation_time),
    ];
    let mut mean_excess = [0.0_f64; 2];
    let mut spread = [0.0_f64; 2];
    for (index, (vary, best, unit)) in parts.into_iter().enumerate() {
        if index == 3 && noise.coloured == 0.0 {
            continue;
        }
        let limit = if index == 3 { longest } else { f64::INFINITY };
        let mut top = best + unit;
        for _ in 0..40 {
            if top >= limit || linearised.under(&vary(&noise, top)).likelihood < at_best.likelihood - FALL {
                break;
            }
            top = best + 2.0 * (top - best);
        }
        let top = top.min(limit);
        let (mut weights, mut sums) = (0.0, [[0.0; 3]; 2]);
        for k in 0..POINTS {
            let strength = top * (f64::from(k) + if index == 3 { 0.5 } else { 0.0 }) / f64::from(POINTS - 1);
            let linear = linearised.under(&vary(&noise, strength));
            let odds = if k == 0 && index < 3 { 2.0 * f64::from(POINTS) } else { 1.0 };
            let weight = odds * (linear.likelihood - at_best.likelihood).exp();
            if !weight.is_finite() {
                continue;
            }
            weights += weight;
            for of in 0..2 {
                let moved = linear.estimate[of] - at_best.estimate[of];
                let variance = linear.variance[of] / at_best.variance[of];
                let shift = moved * moved / at_best.variance[of];
                sums[of][0] += weight * variance;
                sums[of][1] += weight * variance * variance;
                sums[of][2] += weight * shift;
            }
        }
        for of in 0..2 {
            let [variance, square, shift] = sums[of].map(|sum| sum / weights);
            if variance.is_finite() && shift.is_finite() {
                // Walk and wander are rival explanations of one slow movement: the worse counts, not both.
                mean_excess[of] = mean_excess[of].max(variance + shift - 1.0);
                spread[of] = spread[of].max(square - variance * variance);
            }
        }
    }
    let of = |index: usize| {
        let mean = (1.0 + mean_excess[index]).clamp(1.0, 9.0);
        let relative = spread[index] / (mean * mean);
        // A variance of this mean and spread that is distributed as the inverse of a χ²: mean ν/(ν − 2), spread 2/(ν − 4) of
        // its square.
        let own = 4.0 + 2.0 / relative;
        let freedom = 1.0 / (1.0 / joint.freedom + 1.0 / own);
        let factor = (mean * (freedom - 2.0) / freedom).max(1.0);
        // An error of interpolation grows from 0 to the resolution and back: half of it on average.
        let bias = 0.5 * resolution * at_best.weight[index] / at_best.variance[index].sqrt();
        Inflation { factor, freedom, bias: if bias.is_finite() { bias } else { 0.0 } }
    };
    let mut dead_time = of(1);
    dead_time.factor *= linearised.change_points(&joint.noise, at_best.variance[1].sqrt());
    Inflations { gain: of(0), dead_time }
}
