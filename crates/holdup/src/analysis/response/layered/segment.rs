//! What happens on one segment, and the same cut into cells where a question needs plain polynomials.

use super::super::legendre::{Poly, TERMS, from_powers, interpolated, restricted, tail};
use super::signal::{Layer, Signal, decay, has_decayed, sum_of_magnitudes};
use super::tables::{EDGES, INVERSE, TABLES};
use crate::analysis::widest;

/// What happens from one breakpoint to the next.
pub(in super::super) struct Segment<'a> {
    /// Start [s].
    pub(in super::super) start: f64,
    /// Length [s].
    pub(in super::super) length: f64,
    /// Setpoint, relative to the initial level.
    pub(in super::super) setpoint: f64,
    /// Rate of the fast pole [1/s].
    pub(in super::super) rate: f64,
    /// Coefficients of the layers.
    pub(in super::super) terms: usize,
    /// Control error.
    pub(in super::super) error: &'a Signal,
    /// Controller output.
    pub(in super::super) manipulated: &'a Signal,
    /// Load estimate of the observer.
    pub(in super::super) load_estimate: Option<&'a Signal>,
}

/// A signal on a part of a segment, as a Legendre series.
#[derive(Debug, Clone)]
pub(in super::super) struct Part {
    /// Start [s].
    pub(in super::super) start: f64,
    /// Length [s].
    pub(in super::super) length: f64,
    pub(in super::super) poly: Poly,
}

/// A part of a layer is cut in half while its last coefficients exceed this part of the signal.
const RESOLVED: f64 = 1e-14;
/// What is left of a layer may be this part of the signal.
const NOTHING: f64 = 1e-17;

impl Segment<'_> {
    /// Length on the layer's axis.
    pub(super) fn theta(&self) -> f64 {
        self.rate * self.length
    }

    /// Value of a signal at `s`.
    pub(super) fn value(&self, signal: &Signal, s: f64) -> f64 {
        let smooth = signal.smooth.iter().rev().fold(0.0, |sum, c| sum * s + c);
        smooth + layer_at(signal, 0.5 * self.theta() * (1.0 + s), self.terms)
    }

    /// Values of a signal at both ends.
    pub(in super::super) fn ends(&self, signal: &Signal) -> (f64, f64) {
        let (start, end) = signal.smooth_ends();
        let layer = if self.terms > 0 { signal.layer[0] } else { 0.0 };
        (start + layer, end + layer_at(signal, self.theta(), self.terms))
    }

    /// If the derivative cannot vanish: its sign.
    pub(super) fn monotone(&self, signal: &Signal) -> bool {
        let mut others = 0.0;
        let mut index = 2.0;
        for c in &signal.smooth[2..] {
            others += index * c.abs();
            index += 1.0;
        }
        others *= 1.0 + 1e-14;
        if signal.smooth[1].abs() <= others {
            return false;
        }
        let mut layer = 0.0;
        for j in 0..self.terms {
            let next = signal.layer.get(j + 1).copied().unwrap_or(0.0);
            layer += (next - signal.layer[j]).abs();
        }
        signal.smooth[1].abs() > others + 0.5 * self.theta() * layer
    }

    /// The signal as Legendre series, part by part.
    pub(super) fn parts(&self, signal: &Signal) -> Vec<Part> {
        let mut parts = Vec::new();
        let (theta, over) = (self.theta(), self.layer_over(signal, NOTHING));
        let start = self.expansion(signal, over.min(theta));
        let mut from = 0.0;
        for (index, &edge) in EDGES[1..].iter().enumerate() {
            if from >= over.min(theta) {
                break;
            }
            // No slivers.
            let to = if edge * 1.2 > theta { theta } else { edge };
            if to == edge {
                let layer = (&signal.layer[..self.terms], &TABLES.layers[index][..]);
                let poly = combination((&start, &TABLES.powers[index]), layer);
                parts.push(self.part((from, to), poly));
            } else {
                self.cut(signal, (from, to), &mut parts);
            }
            from = to;
        }
        if from < theta || theta == 0.0 {
            let whole = from_powers(&signal.smooth);
            let s = if from > 0.0 { 2.0 * from / theta - 1.0 } else { -1.0 };
            let poly = if s > -1.0 { restricted(&whole, s, 1.0) } else { whole };
            let length = 0.5 * (1.0 - s) * self.length;
            parts.push(Part { start: self.start + (self.length - length), length, poly });
        }
        parts
    }

    /// The smooth part in terms of `θ^i/i!`, as far as its terms count up to `theta`.
    pub(super) fn expansion(&self, signal: &Signal, theta: f64) -> Poly {
        expansion(&signal.smooth, 2.0 / self.theta(), theta)
    }

    /// From here on, in units of the fast pole's time constant, the layer of a signal stays below this part of the signal.
    pub(in super::super) fn layer_over(&self, signal: &Signal, part: f64) -> f64 {
        if self.terms == 0 {
            return 0.0;
        }
        self.layer_below(signal, part * (sum_of_magnitudes(&signal.smooth) + signal.layer_size(self.terms)))
    }

    /// From here on, in units of the fast pole's time constant, the layer of a signal stays below `floor`.
    pub(super) fn layer_below(&self, signal: &Signal, floor: f64) -> f64 {
        let sizes = signal.layer.map(f64::abs);
        // From edge to edge no bound rises.
        let above = |bounds: &Layer| dot(&sizes[..self.terms], bounds) > floor;
        let first = TABLES.bounds.partition_point(above);
        EDGES.get(first).copied().unwrap_or_else(|| decay(self.terms))
    }

    fn cut(&self, signal: &Signal, (from, to): (f64, f64), parts: &mut Vec<Part>) {
        let scale = 2.0 / self.theta();
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let poly = interpolated(|x| self.value(signal, scale * (middle + half * x) - 1.0));
        let size = sum_of_magnitudes(&signal.smooth) + signal.layer_size(self.terms);
        if tail(&poly) > RESOLVED * size && half > 1e-3 {
            self.cut(signal, (from, middle), parts);
            self.cut(signal, (middle, to), parts);
            return;
        }
        parts.push(self.part((from, to), poly));
    }

    fn part(&self, (from, to): (f64, f64), poly: Poly) -> Part {
        Part { start: self.start + from / self.rate, length: (to - from) / self.rate, poly }
    }
}

fn expansion(smooth: &Poly, per_theta: f64, theta: f64) -> Poly {
    widest(
        #[inline(always)]
        || {
            let mut derivatives = [0.0; TERMS];
            let floor = NOTHING * sum_of_magnitudes(smooth);
            let (mut scale, mut power, mut small) = (1.0, 1.0, 0);
            for (i, row) in TABLES.at_start.iter().enumerate() {
                derivatives[i] = scale * dot(smooth, row);
                small = if derivatives[i].abs() * power <= floor { small + 1 } else { 0 };
                if small == 3 {
                    break;
                }
                scale *= per_theta;
                power *= theta * INVERSE[i + 1];
            }
            derivatives
        },
    )
}

/// Sum of the rows with these weights: those of the smooth part that are not 0, then those of the layer.
fn combination(smooth: (&[f64], &[Poly]), layer: (&[f64], &[Poly])) -> Poly {
    widest(
        #[inline(always)]
        || {
            let mut sum = [0.0; TERMS];
            let used = smooth.0.iter().rposition(|w| *w != 0.0).map_or(0, |last| last + 1);
            for (weight, row) in smooth.0[..used].iter().zip(smooth.1).chain(layer.0.iter().zip(layer.1)) {
                for k in 0..TERMS {
                    sum[k] += weight * row[k];
                }
            }
            sum
        },
    )
}

/// Sum of products, in lanes.
#[inline(always)]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut lanes = [0.0; 8];
    let (chunks, rest) = a.as_chunks::<8>();
    for (a, b) in chunks.iter().zip(b.as_chunks::<8>().0) {
        for k in 0..8 {
            lanes[k] += a[k] * b[k];
        }
    }
    let tail: f64 = rest.iter().zip(&b[chunks.len() * 8..]).map(|(a, b)| a * b).sum();
    lanes.iter().sum::<f64>() + tail
}

/// Value of a signal's layer at `theta`.
pub(super) fn layer_at(signal: &Signal, theta: f64, terms: usize) -> f64 {
    if has_decayed(theta, terms) {
        return 0.0;
    }
    let mut sum = 0.0;
    for j in (0..terms).rev() {
        sum = sum * theta * INVERSE[j + 1] + signal.layer[j];
    }
    sum * (-theta).exp()
}

const _: () = assert!(TERMS == 24, "the tables are made for 24 terms");
