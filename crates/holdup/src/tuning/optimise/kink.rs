//! The way down from a point on a kink: gradient sampling (J. V. Burke, A. S. Lewis and M. L. Overton, SIAM J. Optim. 15,
//! 2005, 751–779).
//!
//! On a kink every gradient points across it. The shortest vector in the convex hull of the gradients about the point lies
//! along it: the parts across cancel. Where that is 0 there is no way down.

use super::simplex::Value;

/// Radii within which gradients are taken, and the difference that makes one, as a part of the radius.
const RADII: [f64; 3] = [1e-2, 1e-3, 1e-5];
const DIFFERENCE: f64 = 1e-2;
/// A gain below this part of what the gradient promises is none.
const PROMISED: f64 = 1e-2;
/// Relative gain that is worth the name.
const GAIN: f64 = 1e-11;

/// Goes down as far as the straight lines along the kink lead.
pub(super) fn descend(from: (Vec<f64>, f64), finest: f64, value: &mut Value) -> (Vec<f64>, f64) {
    let mut best = from;
    for radius in RADII.into_iter().filter(|radius| *radius > finest) {
        for _ in 0..4 {
            let gradients = gradients(&best, radius, value);
            let Some(way) = direction(&gradients, &best.0) else { break };
            let Some(next) = follow(&best, &way, radius, value) else { break };
            best = next;
        }
    }
    best
}

/// Gradients at points within the radius; not at the point itself, where on a kink a difference is no gradient.
fn gradients(at: &(Vec<f64>, f64), radius: f64, value: &mut Value) -> Vec<Vec<f64>> {
    let count = at.0.len();
    let step = DIFFERENCE * radius;
    let mut list = Vec::new();
    for sample in 0..=count {
        // Corners of a simplex about the point, turned so that no face of it is parallel to an axis.
        let point: Vec<f64> = (0..count)
            .map(|axis| {
                let side = if axis == sample { 1.0 } else { -0.37 };
                let side = if sample == count { -0.61 + 0.2 * f64::from(axis % 2 == 0) } else { side };
                let moved = at.0[axis] + radius * side;
                if (0.0..=1.0).contains(&moved) { moved } else { at.0[axis] - radius * side }
            })
            .collect();
        let here = value(&point);
        let gradient: Vec<f64> = (0..count)
            .map(|axis| {
                let side = if point[axis] + step > 1.0 { -step } else { step };
                let mut moved = point.clone();
                moved[axis] += side;
                (value(&moved) - here) / side
            })
            .collect();
        if gradient.iter().all(|part| part.is_finite()) {
            list.push(gradient);
        }
    }
    list
}

/// The direction against the shortest vector of the convex hull, of length 1; none that leads out of the cube.
fn direction(gradients: &[Vec<f64>], at: &[f64]) -> Option<Vec<f64>> {
    let shortest = shortest(gradients)?;
    let inward = |(part, x): (&f64, &f64)| {
        let outward = (*part > 0.0 && *x <= 0.0) || (*part < 0.0 && *x >= 1.0);
        if outward { 0.0 } else { -part }
    };
    let way: Vec<f64> = shortest.iter().zip(at).map(inward).collect();
    let length = way.iter().map(|part| part * part).sum::<f64>().sqrt();
    (length > 0.0 && length.is_finite()).then(|| way.iter().map(|part| part / length).collect())
}

/// The shortest vector of the convex hull: from a corner, again and again the shortest on the way to the corner that lies
/// most against it, with the weight taken from the one that lies least so (B. F. Mitchell, V. F. Dem'yanov and
/// V. N. Malozemov, SIAM J. Control 12, 1974, 19–26).
fn shortest(corners: &[Vec<f64>]) -> Option<Vec<f64>> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let mut point = corners.first()?.clone();
    let mut weights = vec![0.0; corners.len()];
    weights[0] = 1.0;
    let scale = corners.iter().map(|corner| dot(corner, corner)).fold(0.0, f64::max);
    for _ in 0..400 {
        let products: Vec<f64> = corners.iter().map(|corner| dot(corner, &point)).collect();
        let to = (0..corners.len()).min_by(|&a, &b| products[a].total_cmp(&products[b]))?;
        let held = (0..corners.len()).filter(|&index| weights[index] > 0.0);
        let from = held.max_by(|&a, &b| products[a].total_cmp(&products[b]))?;
        if products[from] - products[to] <= 1e-14 * scale {
            break;
        }
        let along: Vec<f64> = corners[to].iter().zip(&corners[from]).map(|(a, b)| a - b).collect();
        let share = ((products[from] - products[to]) / dot(&along, &along)).min(weights[from]);
        weights[from] = if share >= weights[from] { 0.0 } else { weights[from] - share };
        weights[to] += share;
        for (part, step) in point.iter_mut().zip(&along) {
            *part += share * step;
        }
    }
    Some(point)
}

/// The best of a line: steps that grow while they gain; none where even a short one does not.
fn follow(from: &(Vec<f64>, f64), way: &[f64], radius: f64, value: &mut Value) -> Option<(Vec<f64>, f64)> {
    let mut at = |length: f64| {
        let point: Vec<f64> =
            from.0.iter().zip(way).map(|(x, part)| (x + length * part).clamp(0.0, 1.0)).collect();
        let here = value(&point);
        (point, here)
    };
    let mut length = radius;
    let mut best = at(length);
    while best.1 >= from.1 {
        length *= 0.25;
        if length < PROMISED * radius {
            return None;
        }
        best = at(length);
    }
    while length < 1.0 {
        length *= 2.0;
        let next = at(length);
        if next.1 >= best.1 {
            break;
        }
        best = next;
    }
    (from.1 - best.1 > GAIN * from.1.abs()).then_some(best)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn across_a_kink_gradients_cancel() {
        let found = shortest(&[vec![3.0, 3.2], vec![-3.0, -2.8], vec![3.0, 3.2]]).unwrap();
        // The line from one to the other passes 0 at the distance |det|/length.
        let expected = (3.0_f64 * -2.8 + 3.0 * 3.2).abs() / 72.0_f64.sqrt();
        assert!((found[0].hypot(found[1]) - expected).abs() < 1e-12, "{found:?}");
        let inside = shortest(&[vec![1.0, 0.0], vec![-1.0, 1.0], vec![-1.0, -1.0]]).unwrap();
        assert!(inside[0].hypot(inside[1]) < 1e-6, "{inside:?}");
    }

    #[test]
    fn nothing_leads_down_from_a_minimum() {
        let mut value = |x: &[f64]| (x[0] - 0.5).abs() + 2.0 * (x[1] - 0.25).abs();
        let end = descend((vec![0.5, 0.25], 0.0), 1e-9, &mut value);
        assert_eq!(end, (vec![0.5, 0.25], 0.0));
    }
}
