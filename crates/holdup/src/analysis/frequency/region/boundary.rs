//! The pieces of the crossing curves with stable settings on one side only.

use super::super::characteristic::Characteristic;
use super::super::error::FrequencyError;
use super::super::margins::margins;
use super::super::transfer::LoopTransfer;
use super::crossing::At;
use super::plane::Settings;
use super::{Crossing, Curve, Plane, Vertex};
use crate::model::{ClosedLoop, Controller};

/// Crossings are followed up to this frequency [rad per dead time].
const FARTHEST: f64 = 50.0;

/// Distance from the curve at which stability is asked for, as a share of the window.
const BESIDE: f64 = 1e-8;

/// Distance of neighbouring vertices, as a share of the window.
const APART: f64 = 0.01;

/// A curve in the plane along a parameter.
struct Path<'a> {
    crossing: Crossing,
    at: Box<dyn Fn(f64) -> Option<Vertex> + 'a>,
    /// Values of the parameter between which the curve is followed.
    samples: Vec<f64>,
}

/// The boundary of the stable settings within the window.
pub(super) fn curves(settings: &Settings) -> Result<Vec<Curve>, FrequencyError> {
    let mut paths = Vec::new();
    if settings.plane == Plane::KcKo && perfect(settings) {
        paths.extend(factors(settings)?);
    } else {
        let mut dense = Vec::new();
        if settings.plane == Plane::KcKo {
            let [law, observer] = factor_loops(settings);
            for closed in law.iter().chain(&observer) {
                dense.extend(critical(closed)?.iter().map(|(omega, _)| *omega));
            }
        }
        paths.extend((0..2).map(|branch| along_frequency(settings, branch, &dense)));
    }
    paths.extend(neutral(settings)?);
    Ok(paths.iter().flat_map(|path| pieces(settings, path)).collect())
}

/// The curve on which jω is a pole. Where the observer's model is nearly the process it exists only next to the
/// frequencies `dense`.
fn along_frequency<'a>(settings: &'a Settings<'a>, branch: usize, dense: &[f64]) -> Path<'a> {
    let d = settings.process.dead_time();
    let at = move |omega: f64| {
        let [x, y] = At::new(settings, omega).points()[branch]?;
        Some(Vertex { x, y, frequency: Some(omega) })
    };
    // Evenly from 0.02 on, before that evenly in the logarithm.
    let near = (0..200).map(|i| 0.02 * 10.0_f64.powf(-0.03 * f64::from(200 - i)));
    let far = (0..2500).map(|i| 0.02 + (FARTHEST - 0.02) * f64::from(i) / 2499.0);
    let mut samples: Vec<f64> = near.chain(far).map(|omega| omega / d).collect();
    for &omega in dense.iter().filter(|&&omega| omega * d < FARTHEST) {
        let apart = (2..28).map(|i| 10.0_f64.powf(-0.5 * f64::from(i)));
        samples.extend(apart.flat_map(|share| [omega * (1.0 - share), omega * (1.0 + share)]));
    }
    samples.sort_by(f64::total_cmp);
    Path { crossing: Crossing::ImaginaryAxis, at: Box::new(at), samples }
}

/// Whether the observer's model is the process.
fn perfect(settings: &Settings) -> bool {
    let (process, observer) = (settings.process, settings.controller.observer());
    let same = |model: Option<f64>, value: f64| model.is_none_or(|model| model == value);
    same(observer.and_then(|o| o.model_gain()), process.process_gain())
        && same(observer.and_then(|o| o.model_dead_time()), process.dead_time())
}

/// The loop without the observer for a gain of modulus 1, and the loop of a perfect observer of gain 1.
fn factor_loops(settings: &Settings) -> [Option<ClosedLoop>; 2] {
    let law = settings.with_gain(settings.sign).map(Controller::without_observer);
    let observer = Controller::proportional(settings.sign).ok();
    [law, observer].map(|controller| controller.map(|c| ClosedLoop::new(settings.process, &c)))
}

/// Where 1 + L is a product of a factor with Kc and one with Ko: lines at the critical gains of each.
fn factors<'a>(settings: &'a Settings<'a>) -> Result<Vec<Path<'a>>, FrequencyError> {
    let [law, observer] = factor_loops(settings);
    let mut paths = Vec::new();
    for (omega, gain) in law.as_ref().map(critical).transpose()?.unwrap_or_default() {
        let x = settings.sign * gain;
        let at = move |v: f64| Some(Vertex { x, y: settings.point([0.0, v])[1], frequency: Some(omega) });
        paths.push(line(Crossing::ImaginaryAxis, at));
    }
    for (omega, gain) in observer.as_ref().map(critical).transpose()?.unwrap_or_default() {
        let y = settings.sign * gain;
        let at = move |u: f64| Some(Vertex { x: settings.point([u, 0.0])[0], y, frequency: Some(omega) });
        paths.push(line(Crossing::ImaginaryAxis, at));
    }
    Ok(paths)
}

/// Frequencies and factors on the loop gain at which jω is a pole.
fn critical(closed: &ClosedLoop) -> Result<Vec<(f64, f64)>, FrequencyError> {
    let transfer = LoopTransfer::new(closed)?;
    let crossovers = margins(closed)?.phase_crossovers;
    Ok(crossovers.into_iter().map(|omega| (omega, 1.0 / transfer.at(omega).norm())).collect())
}

/// The curve on which the gain at infinite frequency is 1; it does not depend on an integral or an observer.
fn neutral<'a>(settings: &'a Settings<'a>) -> Result<Option<Path<'a>>, FrequencyError> {
    let probe = settings.point([1.0, if settings.plane == Plane::KcKo { 0.0 } else { 1.0 }]);
    let Some(closed) = settings.closed(probe) else { return Ok(None) };
    let gain = Characteristic::new(&closed)?.high_frequency_gain;
    if gain == 0.0 {
        return Ok(None);
    }
    let [x, y] = probe;
    let at = move |t: f64| {
        let [_, v] = settings.point([0.0, t]);
        // Proportional to Kc, and to Td where that is in the plane.
        let x = if settings.plane == Plane::KcTd { x * y / (gain * v) } else { x / gain };
        (t > 0.0).then_some(Vertex { x, y: v, frequency: None })
    };
    Ok(Some(line(Crossing::InfiniteFrequency, at)))
}

fn line<'a>(crossing: Crossing, at: impl Fn(f64) -> Option<Vertex> + 'a) -> Path<'a> {
    let samples = (0..=200).map(|i| f64::from(i) / 200.0).collect();
    Path { crossing, at: Box::new(at), samples }
}

/// The pieces of a path that bound the stable settings, their ends found to about 1e-8 of the window.
fn pieces(settings: &Settings, path: &Path) -> Vec<Curve> {
    let bounds = |t: f64| bounding(settings, path, t);
    let mut curves = Vec::new();
    let mut open: Vec<Vertex> = Vec::new();
    let mut before: Option<f64> = None;
    for t in refined(settings, path) {
        let vertex = bounds(t);
        match (vertex, before) {
            (Some(vertex), Some(before)) => {
                if open.is_empty() {
                    open.extend(end(&bounds, t, before));
                }
                open.push(vertex);
            }
            (Some(vertex), None) => open.push(vertex),
            (None, Some(before)) if !open.is_empty() => {
                open.extend(end(&bounds, before, t));
                curves.push(Curve { crossing: path.crossing, vertices: std::mem::take(&mut open) });
            }
            (None, _) => {}
        }
        before = Some(t);
    }
    if !open.is_empty() {
        curves.push(Curve { crossing: path.crossing, vertices: open });
    }
    curves.retain(|curve| curve.vertices.len() > 1);
    curves
}

/// The samples of a path with others between, so that neighbours in the window are near each other and the
/// path is followed to where it leaves the window or ends.
fn refined(settings: &Settings, path: &Path) -> Vec<f64> {
    let within = |t: f64| {
        let point = (path.at)(t).map(|v| settings.square([v.x, v.y]))?;
        point.iter().all(|c| (0.0..=1.0).contains(c)).then_some(point)
    };
    let mut all = Vec::with_capacity(path.samples.len());
    all.extend(path.samples.first());
    for pair in path.samples.windows(2) {
        let mut stack = vec![(pair[0], pair[1], 0)];
        while let Some((a, b, depth)) = stack.pop() {
            let split = match (within(a), within(b)) {
                (Some(p), Some(q)) => (p[0] - q[0]).hypot(p[1] - q[1]) > APART,
                (None, None) => false,
                _ => true,
            };
            let middle = f64::midpoint(a, b);
            if split && depth < 45 && middle > a && middle < b {
                stack.extend([(middle, b, depth + 1), (a, middle, depth + 1)]);
            } else {
                all.push(b);
            }
        }
    }
    all
}

/// The last point between a parameter `inside` that bounds and one `outside` that does not.
fn end(bounds: &impl Fn(f64) -> Option<Vertex>, inside: f64, outside: f64) -> Option<Vertex> {
    let (mut inside, mut outside, mut last) = (inside, outside, None);
    for _ in 0..60 {
        let middle = f64::midpoint(inside, outside);
        if let Some(vertex) = bounds(middle) {
            (inside, last) = (middle, Some(vertex));
        } else {
            outside = middle;
        }
        if (outside - inside).abs() <= 4.0 * f64::EPSILON * inside.abs() {
            break;
        }
    }
    last
}

/// The point of the path, if it lies in the window with stable settings on one side only.
fn bounding(settings: &Settings, path: &Path, t: f64) -> Option<Vertex> {
    let vertex = (path.at)(t)?;
    let in_window = |[u, v]: [f64; 2]| (0.0..=1.0).contains(&u) && (0.0..=1.0).contains(&v);
    let [u, v] = settings.square([vertex.x, vertex.y]);
    if !in_window([u, v]) {
        return None;
    }
    // The direction of the path, from a short step along it.
    let step = if t > 0.0 { 1e-6 * t } else { 1e-6 };
    let next = (path.at)(t + step).or_else(|| (path.at)(t - step))?;
    let next = settings.square([next.x, next.y]);
    let (du, dv) = (next[0] - u, next[1] - v);
    let length = du.hypot(dv);
    if length.is_nan() || length == 0.0 {
        return None;
    }
    // Settings are positive: near an axis the points on either side are nearer to the curve.
    let beside = BESIDE.min(0.1 * u.max(1e-14)).min(if v > 0.0 { 0.1 * v } else { BESIDE });
    let side = |sign: f64| {
        let point = [u - sign * beside * dv / length, v + sign * beside * du / length];
        settings.stable(settings.point([point[0], point[1].max(0.0)]))
    };
    (side(1.0) != side(-1.0)).then_some(vertex)
}
