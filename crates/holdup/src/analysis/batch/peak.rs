//! The sensitivity peak of loops in the normal form, with proof that it is the highest.
//!
//! |1 + L|² ≥ r² is G ≥ 0 with `G = U − V`, `U = (1 − r²)·E/(2k) + k·(n₀/x + n₁ + n₂x)/2`, V = Re (c + j·d)e^(−jω).
//! Of the complementary sensitivity, |1 + 1/L|² ≥ r² is G ≥ 0 with `U = E/(2k) + (1 − r²)·k·(n₀/x + n₁ + n₂x)/2`.
//! Below the frequency where |L| = 1 + r (or |L| = 1/(1 − r)) and above the phase crossover it holds because |L| falls. Between them lie the
//! cells of a fixed mesh of x. G and its second derivative by x are linear in the loop's coefficients, with tabulated
//! functions of x; on a cell the second derivative is within a tabulated bound of the straight line between its ends.
//!
//! A cell is settled where G at both ends exceeds what a chord can sag; or where G is proven convex, without a break up
//! to the minimum that Newton's method found: there G has the value 0 and the slope 0.

use super::crossovers::Crossovers;
use super::form::{Form, Forms};
use super::kernel::Effort;
use super::lanes::{Lanes, WIDTH, flag, greater, lesser};
use super::mesh::{FUNCTIONS, Mesh, Node, ROUNDING, WEIGHTS, single};

/// The least |1 + L|² beyond which the peak is searched for: nearer to −1 the difference loses digits.
const LEAST: f64 = 1e-4;

/// Least |1 + L|², or |1 + 1/L|², of so many loops.
pub(super) struct Peaks {
    /// The least of it.
    pub(super) squared: Lanes,
    /// Where it is, in radians per dead time.
    pub(super) omega: Lanes,
    /// Whether it is the least, proven.
    pub(super) proven: Lanes,
}

/// Lanes in single precision.
type Singles = [f32; WIDTH];

/// G of one loop: what its functions are multiplied by.
struct Excess {
    /// Of 1, x, x² and x³.
    powers: [Singles; 4],
    /// Of the functions of the mesh, 1/x first.
    functions: [Singles; FUNCTIONS],
    /// Weighted sum of the moduli of those after the first, roundings included.
    weight: Singles,
    /// Where the search begins and ends, and x at the minimum.
    from: Singles,
    to: Singles,
    minimum: Singles,
    /// What G must exceed to be positive beyond doubt.
    grain: Singles,
}

impl Peaks {
    /// Newton's method from the best place of the mesh, then the proof.
    #[inline(always)]
    pub(super) fn new<const COMPLEMENTARY: bool>(
        forms: &Forms,
        at: &Crossovers,
        mesh: &Mesh,
        effort: &Effort,
    ) -> Self {
        let mut omega = start::<COMPLEMENTARY>(forms, at, mesh, effort.stride);
        for _ in 0..effort.peak {
            for i in 0..WIDTH {
                let form = forms.one(i);
                let distance = form.distance::<COMPLEMENTARY>(omega[i], &form.turned(omega[i]).v);
                let most = 0.3 * omega[i];
                // Uphill is left, downhill right: away from a maximum by the longest step.
                let step =
                    if distance.dz > 0.0 { distance.z / distance.dz } else { most.copysign(distance.z) };
                omega[i] = lesser(omega[i] - greater(lesser(step, most), -most), at.turned[i]);
            }
        }
        let (mut squared, mut proven) = ([0.0; WIDTH], [0.0; WIDTH]);
        for i in 0..WIDTH {
            let form = forms.one(i);
            let distance = form.distance::<COMPLEMENTARY>(omega[i], &form.turned(omega[i]).v);
            let step = distance.z / distance.dz;
            // The parabola's minimum lies lower by `less`; the cubic term that it neglects is `less` times the relative step.
            let less = 0.5 * distance.scale * step * distance.z;
            squared[i] = distance.squared - less;
            let settled = (distance.dz > 0.0) & (less * step.abs() <= 1e-11 * omega[i] * squared[i]);
            let near = step.abs() <= 1e-3 * omega[i];
            omega[i] -= step;
            // At the phase crossover |1 + L| is 1 − |L|, and |1 + 1/L| is 1/|L| − 1; above they are greater.
            let below = at.margin[i] - 1.0;
            let there = if COMPLEMENTARY { squared[i] } else { squared[i] * at.margin[i] * at.margin[i] };
            let ordinary = (squared[i] > LEAST) & (there < below * below);
            proven[i] =
                flag(settled & near & ordinary) * at.proven[i] * at.decided[i] * flag(at.phase[i] > 0.0);
        }
        let mut peaks = Self { squared, omega, proven };
        if forms.lag {
            peaks.prove::<true, COMPLEMENTARY>(forms, at, mesh);
        } else {
            peaks.prove::<false, COMPLEMENTARY>(forms, at, mesh);
        }
        peaks
    }

    #[inline(always)]
    fn prove<const LAG: bool, const COMPLEMENTARY: bool>(
        &mut self,
        forms: &Forms,
        at: &Crossovers,
        mesh: &Mesh,
    ) {
        let excess = Excess::new::<COMPLEMENTARY>(forms, at, self);
        let (mut least, mut most) = (f32::INFINITY, 0.0_f32);
        for i in 0..WIDTH {
            least = least.min(excess.from[i]);
            most = most.max(excess.to[i]);
        }
        let nodes = &mesh.nodes;
        let first = nodes.partition_point(|node| node.x <= least);
        let last = nodes.partition_point(|node| node.x < most);
        // A loop whose search begins below the mesh is not proven; the others are, whatever stands beside them.
        let (first, last) = (first.max(1), last.min(nodes.len() - 1));
        if first > last {
            self.proven = [0.0; WIDTH];
            return;
        }
        // G and its curvature at the lower end of the cell.
        let (mut height, mut curvature) = ([0.0; WIDTH], [0.0; WIDTH]);
        // Whether cells are convex without a break from the minimum on; whether such cells wait for the minimum; whether
        // a cell stayed open.
        let (mut linked, mut waiting, mut open) = ([0.0_f32; WIDTH], [0.0_f32; WIDTH], [0.0_f32; WIDTH]);
        for i in 0..WIDTH {
            (height[i], curvature[i]) = excess.one::<LAG>(&nodes[first - 1], i);
        }
        for j in first..=last {
            let (node, next) = (&nodes[j - 1], &nodes[j]);
            for i in 0..WIDTH {
                let (value, bend) = excess.one::<LAG>(next, i);
                let beside = excess.beside(node, i);
                let (low, high) = (height[i], curvature[i]);
                let (least, most) = if bend < high { (bend, high) } else { (high, bend) };
                let convex = least >= beside;
                let sag = (most + beside) * node.sag;
                let sag = if sag > 0.0 { sag } else { 0.0 };
                let outside = (next.x <= excess.from[i]) | (node.x >= excess.to[i]);
                let above = outside | ((if value < low { value } else { low }) > sag + excess.grain[i]);
                let minimum = (node.x <= excess.minimum[i]) & (excess.minimum[i] <= next.x);
                let link = convex & (minimum | (linked[i] > 0.0));
                let was = waiting[i] > 0.0;
                let wait = convex & !link & (was | !above);
                open[i] = if !convex & (was | !above) { 1.0 } else { open[i] };
                linked[i] = if link { 1.0 } else { 0.0 };
                waiting[i] = if wait { 1.0 } else { 0.0 };
                (height[i], curvature[i]) = (value, bend);
            }
        }
        for i in 0..WIDTH {
            let from = excess.from[i];
            let closed = (open[i] + waiting[i] == 0.0) & (from >= nodes[0].x) & (from < f32::INFINITY);
            self.proven[i] *= flag(closed);
        }
    }
}

/// The place of the mesh, of every `stride`-th, where |1 + L|, or |1 + 1/L|, is least, refined by the parabola through its neighbours.
#[inline(always)]
fn start<const COMPLEMENTARY: bool>(forms: &Forms, at: &Crossovers, mesh: &Mesh, stride: usize) -> Lanes {
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    let mut from = [0.0; WIDTH];
    for i in 0..WIDTH {
        let live = at.proven[i] > 0.0;
        // The complementary sensitivity of a slow integral action is highest far below the crossover.
        let half = if COMPLEMENTARY { 0.1 } else { 0.5 } * at.gain[i];
        from[i] = single(half * half);
        least = least.min(if live { half } else { f64::INFINITY });
        most = most.max(if live { at.turned[i] } else { 0.0 });
    }
    // The same places for a loop whatever stands beside it: multiples of the stride, and one below its own first.
    let (mesh, places) = (&mesh.nodes, |omega: f64| mesh.nodes.partition_point(|node| node.omega < omega));
    let first = (places(least) / stride).saturating_sub(1) * stride;
    let last = (places(most) + stride).min(mesh.len());
    let singles = |lanes: &Lanes| lanes.map(single);
    let (k, [n0, n1, n2]) = (singles(&forms.gain), forms.n.each_ref().map(singles));
    let ([c0, c1, c2], [d0, d1]) = (forms.c.each_ref().map(singles), forms.d.each_ref().map(singles));
    let [e1, e2] = forms.e.each_ref().map(singles);
    let to = singles(&at.turned).map(|omega| omega * omega);
    // Place and value: the last one seen, the best one, and those beside the best one.
    let (mut last_place, mut last_value) = (0.0_f32, [f32::INFINITY; WIDTH]);
    let (mut place, mut best) = ([0.0_f32; WIDTH], [f32::INFINITY; WIDTH]);
    let (mut place_before, mut before) = ([0.0_f32; WIDTH], [f32::INFINITY; WIDTH]);
    let (mut place_after, mut after) = ([0.0_f32; WIDTH], [f32::INFINITY; WIDTH]);
    for node in mesh[first.min(last)..last].iter().step_by(stride) {
        let (x, values) = (node.x, &node.values);
        for i in 0..WIDTH {
            let v = c0[i] * values[1]
                + c1[i] * values[2]
                + c2[i] * values[3]
                + d0[i] * values[4]
                + d1[i] * values[5];
            let n = n0[i] * values[0] + n1[i] + n2[i] * x;
            let e = x * (1.0 + x * (e1[i] + x * e2[i]));
            let value = if COMPLEMENTARY { (e / k[i] - 2.0 * v) / n } else { (k[i] * n - 2.0 * v) / e };
            let better = (value < best[i]) & (x >= from[i]) & (x < to[i]);
            let beside = place[i] == last_place;
            after[i] = if beside { value } else { after[i] };
            place_after[i] = if beside { x } else { place_after[i] };
            before[i] = if better { last_value[i] } else { before[i] };
            place_before[i] = if better { last_place } else { place_before[i] };
            place[i] = if better { x } else { place[i] };
            best[i] = if better { value } else { best[i] };
            last_value[i] = value;
        }
        last_place = x;
    }
    let mut omega = [0.0; WIDTH];
    for i in 0..WIDTH {
        // The parabola's minimum, counted in places from the best one, and what lies there.
        let share = 0.5 * (before[i] - after[i]) / (before[i] - 2.0 * best[i] + after[i]);
        let inside = (before[i] < f32::MAX) & (after[i] < f32::MAX) & (share.abs() <= 0.6);
        let share = if inside { share } else { 0.0 };
        let slope = 0.5 * (place_after[i] - place_before[i]);
        let bend = 0.5 * (place_after[i] + place_before[i]) - place[i];
        let there = place[i] + if inside { share * (slope + share * bend) } else { 0.0 };
        omega[i] = lesser(f64::from(there).sqrt(), at.turned[i]);
    }
    omega
}

impl Excess {
    #[inline(always)]
    fn new<const COMPLEMENTARY: bool>(forms: &Forms, at: &Crossovers, peaks: &Peaks) -> Self {
        let none = [0.0; WIDTH];
        let mut excess = Self {
            powers: [none; 4],
            functions: [none; FUNCTIONS],
            weight: none,
            from: none,
            to: none,
            minimum: none,
            grain: none,
        };
        for i in 0..WIDTH {
            let Form { k, n: [n0, n1, n2], c: [c0, c1, c2], d: [d0, d1], e: [e1, e2] } = forms.one(i);
            let below = 1.0 - peaks.squared[i];
            let (share, half) =
                if COMPLEMENTARY { (0.5 / k, 0.5 * below * k) } else { (0.5 * below / k, 0.5 * k) };
            let powers = [half * n1, share + half * n2, share * e1, share * e2];
            let over = half * n0;
            for (power, value) in powers.into_iter().enumerate() {
                excess.powers[power][i] = single(value);
            }
            let mut weight = ROUNDING * (powers[2] + 60.0 * powers[3]);
            for (function, value) in [over, -c0, -c1, -c2, -d0, -d1].into_iter().enumerate() {
                excess.functions[function][i] = single(value);
                weight += f64::from(WEIGHTS[function]) * value.abs();
            }
            excess.weight[i] = single(weight * (1.0 + ROUNDING));
            // |L| ≥ 1 + r, or 1/(1 − r), at least where it is so with the E/x of the gain crossover, which is greater than that below.
            let crossover = at.gain[i] * at.gain[i];
            let factor = 1.0 + crossover * (e1 + crossover * e2);
            let least = peaks.squared[i].sqrt();
            let far = if COMPLEMENTARY { 1.0 / (1.0 - least) } else { 1.0 + least };
            let square = k * k;
            let rest = single(far * far * factor - square * n2);
            let (linear, constant) = (single(square * n1), single(square * n0));
            let from =
                (linear + (linear * linear + 4.0 * constant * rest).sqrt()) / (2.0 * rest) * (1.0 - 1e-5);
            let to = at.turned[i] * at.turned[i] * (1.0 + ROUNDING);
            // At most the sum of the moduli of all terms, at x < 10.
            let size = powers[0] + 10.0 * (powers[1] + 10.0 * (powers[2] + 10.0 * powers[3]));
            let turned = c0 + 10.0 * (c1.abs() + 10.0 * c2.abs() + d0.abs() + 10.0 * d1.abs());
            excess.grain[i] = single(ROUNDING * (size + turned)) + single(ROUNDING * over) / from;
            let live = (peaks.proven[i] > 0.0) & (below > 0.0);
            excess.from[i] = if live { from } else { f32::INFINITY };
            excess.to[i] = if live { single(to) } else { 0.0 };
            excess.minimum[i] = single(peaks.omega[i] * peaks.omega[i]);
        }
        excess
    }

    /// G and its second derivative by x at a place.
    #[inline(always)]
    fn one<const LAG: bool>(&self, node: &Node, i: usize) -> (f32, f32) {
        let (p, f) = (&self.powers, &self.functions);
        let (values, curvatures, x) = (&node.values, &node.curvatures, node.x);
        let mut value = p[0][i] + x * (p[1][i] + x * p[2][i]);
        let mut curvature = 2.0 * p[2][i];
        for function in [0, 1, 2, 4, 5] {
            value += f[function][i] * values[function];
            curvature += f[function][i] * curvatures[function];
        }
        if LAG {
            value += x * x * x * p[3][i] + f[3][i] * values[3];
            curvature += 6.0 * x * p[3][i] + f[3][i] * curvatures[3];
        }
        (value, curvature)
    }

    /// How far the second derivative may be from the straight line between the ends of the cell that begins here.
    #[inline(always)]
    fn beside(&self, node: &Node, i: usize) -> f32 {
        self.functions[0][i] * node.beside[0] + self.weight[i] * node.beside[1]
    }
}
