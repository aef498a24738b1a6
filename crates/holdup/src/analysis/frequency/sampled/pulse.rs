//! The sampled loop as polynomials in w = z − 1 and whole delays z^(−l): process with hold and fractional dead time, and
//! the law as `holdup-control` computes it.
//!
//! In w what is small at low frequencies is small by itself: nothing cancels when samples follow each other fast.

use holdup_control::{Law, Observer, Pid};

use crate::analysis::exponential::rests;
use crate::model::{Process, Seconds};

/// A polynomial in w, lowest power first.
pub(super) type Powers = Vec<f64>;

/// `Σ pₖ(w)·z^(−lₖ)`, the terms as (lₖ, pₖ).
pub(super) type Terms = Vec<(f64, Powers)>;

/// L = N/D of the loop broken at the process input, `D = wᵏ·Π(a + b·w)·Q`.
#[derive(Debug, Clone)]
pub(super) struct Pulse {
    pub(super) numerator: Terms,
    /// k: how many poles L has at z = 1.
    pub(super) integrators: usize,
    /// a and b of every other real factor, 0 < a ≤ b.
    pub(super) factors: Vec<(f64, f64)>,
    /// Q of a law that predicts: 1 + C·P, with the powers of the prediction spelled out.
    pub(super) prediction: Option<Terms>,
}

impl Pulse {
    /// The loop of this law and this process, sampled every `h` [s], its output delayed by `delay` [s].
    pub(super) fn new(law: &Law<f64>, process: &Process, h: f64, delay: Seconds) -> Self {
        let mut factors = Vec::new();
        let (whole, part) = parts(process.dead_time() + delay.0, h);
        let held = held(process, h, part);
        let mut integrators = usize::from(process.integrators());
        if let Some(lag) = process.lag() {
            factors.push((rests(h / lag)[0], 1.0));
        }
        let arrival = whole + 1.0;
        let (cn, cd, filter) = terms(&law.pid, h);
        let integral = law.pid.integral_time().is_some();
        let Some(observer) = &law.observer else {
            integrators += usize::from(integral);
            factors.extend(filter);
            let numerator = vec![(arrival, product(&held, &cn))];
            return Self { numerator, integrators, factors, prediction: None };
        };
        let (ln, ld) = lead(observer, h);
        let (ko, km) = (observer.observer_gain(), observer.model_gain());
        let (model_whole, model_part) = parts(observer.dead_time(), h);
        let shifted = |p: &Powers| product(p, &[0.0, 1.0]); // w·p
        let estimate = |p: &Powers| product(&product(&ln, p), &[ko]);
        let main = sum(&shifted(&product(&cn, &ld)), &estimate(&shifted(&cd)));
        integrators += 1;
        factors.extend(observer.lead().map(|_| (ld[0], ld[1])));
        if !observer.predicts() {
            // u = −[C + Ko·lead·(1 + G_m·C)]·y
            integrators += usize::from(integral);
            factors.extend(filter);
            let model = [km * h, km * h * (1.0 - model_part)];
            let echo = estimate(&product(&cn, &model));
            let numerator =
                vec![(arrival, product(&held, &main)), (arrival + model_whole + 1.0, product(&held, &echo))];
            return Self { numerator, integrators, factors, prediction: None };
        }
        // u = −[C_p + Ko·lead·(1 + G_m·C_p)]·y, C_p = C/(1 + C·P), with w·(1 + C·P) + C·G_m·w = w + C·Km·h.
        let main = sum(&main, &estimate(&product(&cn, &[km * h])));
        let mut prediction = vec![(0.0, cd)];
        let mut age = 1.0;
        while age <= model_whole {
            prediction.push((age, product(&cn, &[km * h])));
            age += 1.0;
        }
        if model_part > 0.0 {
            prediction.push((age, product(&cn, &[km * h * model_part])));
        }
        let numerator = vec![(arrival, product(&held, &main))];
        Self { numerator, integrators, factors, prediction: Some(prediction) }
    }
}

/// A dead time in samples: whole ones and the rest, which is 0 where only rounding is left.
fn parts(dead_time: f64, h: f64) -> (f64, f64) {
    let samples = dead_time / h;
    let nearest = samples.round();
    if (samples - nearest).abs() <= 4.0 * f64::EPSILON * samples {
        return (nearest, 0.0);
    }
    (samples.floor(), samples - samples.floor())
}

/// z·(numerator in w) of the process with hold, `part` of a sample of dead time beside the whole ones: its denominator is
/// wⁿ·(w + 1 − e^(−h/T)).
///
/// In each sample the older output acts for the first `part` of it, the newer one for the rest.
fn held(process: &Process, h: f64, part: f64) -> Powers {
    let gain = process.process_gain();
    let (old, new) = (part * h, (1.0 - part) * h);
    // (1 + w)·newer + older: the newer output comes one sample earlier.
    let both = |newer: f64, older: f64| vec![gain * (newer + older), gain * newer];
    let Some(lag) = process.lag() else {
        let first = both(new, old);
        if process.integrators() == 1 {
            return first;
        }
        let second = both(0.5 * new * new, old * (0.5 * old + new));
        return sum(&product(&second, &[0.0, 1.0]), &product(&first, &[h]));
    };
    let ([n1, n2, n3, _], [o1, o2, o3, _]) = (rests(new / lag), rests(old / lag));
    let [a, e2, ..] = rests(h / lag);
    // Lag, its integral and the second integral after one sample, from rest; what the older output left at the change
    // goes on by itself.
    let zero = both(n1, o1 * (1.0 - n1));
    let first = both(lag * n2, lag * (o2 + n1 * o1));
    let pole = [a, 1.0];
    if process.integrators() == 1 {
        return sum(&product(&first, &pole), &product(&zero, &[lag * a]));
    }
    let square = lag * lag;
    let second = both(square * n3, square * (o3 + n2 * o1) + new * lag * o2);
    let of_second = product(&product(&second, &pole), &[0.0, 1.0]);
    let of_first = product(&product(&first, &pole), &[h]);
    let of_zero = product(&zero, &[h * lag * a, square * e2]);
    sum(&sum(&of_second, &of_first), &of_zero)
}

/// Numerator and denominator of the PID terms, and the factor of the derivative's filter in the denominator.
fn terms(pid: &Pid<f64>, h: f64) -> (Powers, Powers, Option<(f64, f64)>) {
    let td = pid.derivative_time().unwrap_or(0.0);
    let filter = (td > 0.0).then(|| (h, pid.filter_time().unwrap_or(0.0) + h));
    let slope = filter.map_or(vec![1.0], |(a, b)| vec![a, b]);
    let mut cn = slope.clone();
    let mut cd = slope.clone();
    let mut derivative = vec![0.0, td];
    if let Some(ti) = pid.integral_time() {
        // The integral is h·z/(z − 1): a common factor w in the other two.
        cd = product(&cd, &[0.0, 1.0]);
        derivative.insert(0, 0.0);
        cn = sum(&cd, &product(&slope, &[h / ti, h / ti]));
    }
    cn = product(&sum(&cn, &derivative), &[pid.proportional_gain()]);
    (cn, cd, filter)
}

/// Numerator and denominator of the lead in the estimate.
fn lead(observer: &Observer<f64>, h: f64) -> (Powers, Powers) {
    observer.lead().map_or((vec![1.0], vec![1.0]), |(td, tf)| (vec![h, td + h], vec![h, tf + h]))
}

/// `p·q`.
pub(super) fn product(p: &[f64], q: &[f64]) -> Powers {
    let mut product = vec![0.0; p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// `p + q`.
pub(super) fn sum(p: &[f64], q: &[f64]) -> Powers {
    let at = |p: &[f64], i: usize| p.get(i).copied().unwrap_or(0.0);
    (0..p.len().max(q.len())).map(|i| at(p, i) + at(q, i)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Response of `held/denominator` to one sample of 1, from its recurrence in z.
    fn pulse_response(process: &Process, h: f64, part: f64) -> Vec<f64> {
        let numerator = held(process, h, part);
        let mut denominator = vec![1.0];
        for _ in 0..process.integrators() {
            denominator = product(&denominator, &[0.0, 1.0]);
        }
        if let Some(lag) = process.lag() {
            denominator = product(&denominator, &[rests(h / lag)[0], 1.0]);
        }
        // p(z − 1) by Horner, lowest power of z first.
        let in_z =
            |p: &Powers| p.iter().rev().fold(vec![0.0], |sum_, &c| sum(&product(&sum_, &[-1.0, 1.0]), &[c]));
        let (n, d) = (in_z(&numerator), in_z(&denominator));
        let order = denominator.len() - 1;
        let mut y: Vec<f64> = Vec::new();
        for k in 0..12 {
            // z·n: the numerator is one sample ahead.
            let input = order.checked_sub(k).and_then(|power| n.get(power)).copied().unwrap_or(0.0);
            let past: f64 = (1..=order.min(k)).map(|i| d[order - i] * y[k - i]).sum();
            y.push(input - past);
        }
        y
    }

    #[test]
    fn a_held_pulse_comes_out_as_the_difference_of_two_steps() {
        let h = 0.7;
        for process in [
            Process::integrating(1.5, Seconds(1.0)).unwrap(),
            Process::double_integrating(1.5, Seconds(1.0)).unwrap(),
            Process::integrating(1.5, Seconds(1.0)).unwrap().with_lag(Seconds(0.6)).unwrap(),
            Process::double_integrating(1.5, Seconds(1.0)).unwrap().with_lag(Seconds(0.6)).unwrap(),
        ] {
            for part in [0.0, 0.3, 0.9] {
                let step = |t: f64| {
                    let Some(t) = Some(t).filter(|&t| t > 0.0) else { return 0.0 };
                    let both = process.integrators() == 2;
                    1.5 * match (process.lag(), both) {
                        (None, false) => t,
                        (None, true) => 0.5 * t * t,
                        (Some(lag), false) => lag * rests(t / lag)[1],
                        (Some(lag), true) => lag * lag * rests(t / lag)[2],
                    }
                };
                let found = pulse_response(&process, h, part);
                for (k, y) in (0..12u32).map(f64::from).zip(found) {
                    let t = (k + 1.0 - part) * h;
                    let expected = step(t) - step(t - h);
                    // Twelve steps of a recurrence whose terms are up to 20.
                    assert!((y - expected).abs() < 1e-12, "{process:?} {part} {k}: {y} {expected}");
                }
            }
        }
    }
}
