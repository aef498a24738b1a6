//! The sensitivity peak of loops in the normal form, with proof that it is the highest.
//!
//! |1 + L|² ≥ r² is G ≥ 0 with `G = U − V`, `U = (1 − r²)·E/(2k) + k·(n₀/x + n₁ + n₂x)/2`, V = Re (c + j·d)e^(−jω).
//! Below the frequency where |L| = 1 + r and above the phase crossover it holds because |L| falls. Between them lie the
//! cells of a fixed mesh of x. G and its second derivative by x are linear in the loop's coefficients, with tabulated
//! functions of x; on a cell the second derivative is within a tabulated bound of the straight line between its ends.
//!
//! A cell is settled where G at both ends exceeds what a chord can sag; or where G is proven convex, without a break up
//! to the minimum that Newton's method found: there G has the value 0 and the slope 0.

use super::crossovers::Crossovers;
use super::form::{Form, Forms};
use super::lanes::{Lanes, WIDTH, flag, greater, lesser};
use super::mesh::{FUNCTIONS, Mesh, Node, WEIGHTS};

/// The least |1 + L|² beyond which the peak is searched for: nearer to −1 the difference loses digits.
const LEAST: f64 = 1e-4;

/// Least |1 + L|² of so many loops.
pub(super) struct Peaks {
    /// The least |1 + L|².
    pub(super) squared: Lanes,
    /// Where it is, in radians per dead time.
    pub(super) omega: Lanes,
    /// Whether it is the least, proven.
    pub(super) proven: Lanes,
}

/// G of one loop: what its functions are multiplied by.
struct Excess {
    /// Of 1, x, x² and x³.
    powers: [Lanes; 4],
    /// Of the functions of the mesh, 1/x first.
    functions: [Lanes; FUNCTIONS],
    /// Weighted sum of the moduli of those after the first.
    weight: Lanes,
    /// Where the search begins and ends.
    from: Lanes,
    to: Lanes,
    /// What G must exceed to be positive beyond doubt.
    grain: Lanes,
}

impl Peaks {
    /// `passes` steps of Newton's method; from the best place of the mesh if `thorough`.
    #[inline(always)]
    pub(super) fn new(forms: &Forms, at: &Crossovers, mesh: &Mesh, passes: usize, thorough: bool) -> Self {
        let mut omega = start(forms, at, mesh, if thorough { 1 } else { 2 });
        for _ in 1..passes {
            for i in 0..WIDTH {
                let form = forms.one(i);
                let distance = form.distance(omega[i], &form.turned(omega[i]).v);
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
            let distance = form.distance(omega[i], &form.turned(omega[i]).v);
            let step = distance.z / distance.dz;
            // The parabola's minimum lies lower by `less`; the cubic term that it neglects is `less` times the relative step.
            let less = 0.5 * form.k * step * distance.z / (distance.e * distance.e);
            squared[i] = distance.squared - less;
            let settled = (distance.dz > 0.0) & (less * step.abs() <= 1e-11 * omega[i] * squared[i]);
            let near = step.abs() <= 1e-3 * omega[i];
            omega[i] -= step;
            let below = 1.0 - at.gain_there[i];
            let ordinary = (squared[i] > LEAST) & (squared[i] < below * below);
            proven[i] =
                flag(settled & near & ordinary) * at.proven[i] * at.decided[i] * flag(at.phase[i] > 0.0);
        }
        let mut peaks = Self { squared, omega, proven };
        if forms.lag {
            peaks.prove::<true>(forms, at, mesh);
        } else {
            peaks.prove::<false>(forms, at, mesh);
        }
        peaks
    }

    #[inline(always)]
    fn prove<const LAG: bool>(&mut self, forms: &Forms, at: &Crossovers, mesh: &Mesh) {
        let excess = Excess::new(forms, at, self);
        let (mut least, mut most) = (f64::INFINITY, 0.0);
        for i in 0..WIDTH {
            least = lesser(excess.from[i], least);
            most = greater(excess.to[i], most);
        }
        let nodes = &mesh.nodes;
        let first = nodes.partition_point(|node| node.x <= least);
        let last = nodes.partition_point(|node| node.x < most);
        if first == 0 || last >= nodes.len() || first > last {
            // Nothing to prove, or beyond the mesh.
            self.proven = [0.0; WIDTH];
            return;
        }
        // G and its curvature at the lower end of the cell.
        let (mut height, mut curvature) = ([0.0; WIDTH], [0.0; WIDTH]);
        // Whether cells are convex without a break from the minimum on; whether such cells wait for the minimum; whether
        // a cell stayed open.
        let (mut linked, mut waiting, mut open) = ([0.0; WIDTH], [0.0; WIDTH], [0.0; WIDTH]);
        excess.at::<LAG>(&nodes[first - 1], &mut height, &mut curvature);
        for j in first..=last {
            let (node, next) = (&nodes[j - 1], &nodes[j]);
            for i in 0..WIDTH {
                let (value, bend) = excess.one::<LAG>(next, i);
                let beside = excess.beside(node, i);
                let (low, high) = (height[i], curvature[i]);
                let convex = lesser(bend, high) >= beside;
                let sag = greater(greater(bend, high) + beside, 0.0) * node.sag;
                let outside = (next.x <= excess.from[i]) | (node.x >= excess.to[i]);
                let above = outside | (lesser(value, low) > sag + excess.grain[i]);
                let square = self.omega[i] * self.omega[i];
                let minimum = (node.x <= square) & (square <= next.x);
                let link = convex & (minimum | (linked[i] > 0.0));
                let was = waiting[i] > 0.0;
                let wait = convex & !link & (was | !above);
                open[i] += flag(!convex & (was | !above));
                (linked[i], waiting[i]) = (flag(link), flag(wait));
                (height[i], curvature[i]) = (value, bend);
            }
        }
        for i in 0..WIDTH {
            self.proven[i] *= flag((open[i] + waiting[i] == 0.0) & (excess.from[i] >= nodes[0].x));
        }
    }
}

/// The place of the mesh, of every `stride`-th, where |1 + L| is least, refined by the parabola through its neighbours.
#[inline(always)]
fn start(forms: &Forms, at: &Crossovers, mesh: &Mesh, stride: usize) -> Lanes {
    let (mut least, mut most) = (f64::INFINITY, 0.0);
    for i in 0..WIDTH {
        let live = at.proven[i] > 0.0;
        least = lesser(if live { at.gain[i] } else { f64::INFINITY }, least);
        most = greater(if live { at.turned[i] } else { 0.0 }, most);
    }
    let first = mesh.nodes.partition_point(|node| node.omega < 0.5 * least);
    let last = mesh.nodes.partition_point(|node| node.omega < most);
    let (mut omega, mut best) = ([0.0; WIDTH], [f64::INFINITY; WIDTH]);
    for node in mesh.nodes[first.min(last)..last].iter().step_by(stride) {
        for i in 0..WIDTH {
            let Form { k, n: [n0, n1, n2], c: [c0, c1, c2], d: [d0, d1], e: [e1, e2] } = forms.one(i);
            let (x, values) = (node.x, &node.values);
            let v = c0 * values[1] + c1 * values[2] + c2 * values[3] + d0 * values[4] + d1 * values[5];
            let y = k * (n0 * values[0] + n1 + n2 * x) - 2.0 * v;
            let value = y / (x * (1.0 + x * (e1 + x * e2)));
            let better = (value < best[i]) & (node.omega < at.turned[i]);
            omega[i] = if better { node.omega } else { omega[i] };
            best[i] = if better { value } else { best[i] };
        }
    }
    omega
}

impl Excess {
    #[inline(always)]
    fn new(forms: &Forms, at: &Crossovers, peaks: &Peaks) -> Self {
        let none = [0.0; WIDTH];
        let mut excess = Self {
            powers: [none; 4],
            functions: [none; FUNCTIONS],
            weight: none,
            from: none,
            to: none,
            grain: none,
        };
        for i in 0..WIDTH {
            let Form { k, n: [n0, n1, n2], c: [c0, c1, c2], d: [d0, d1], e: [e1, e2] } = forms.one(i);
            let share = 0.5 * (1.0 - peaks.squared[i]) / k;
            let half = 0.5 * k;
            let powers = [half * n1, share + half * n2, share * e1, share * e2];
            let over = half * n0;
            for (lanes, value) in excess.powers.iter_mut().zip(powers) {
                lanes[i] = value;
            }
            let mut weight = 1e-13 * (powers[2] + 60.0 * powers[3]);
            for (function, value) in [over, -c0, -c1, -c2, -d0, -d1].into_iter().enumerate() {
                excess.functions[function][i] = value;
                weight += WEIGHTS[function] * value.abs();
            }
            excess.weight[i] = weight;
            // |L| ≥ 1 + r at least where it is so with the E/x of the gain crossover, which is greater than that below.
            let crossover = at.gain[i] * at.gain[i];
            let factor = 1.0 + crossover * (e1 + crossover * e2);
            let far = 1.0 + peaks.squared[i].sqrt();
            let rest = far * far * factor / (k * k) - n2;
            let from = (n1 + (n1 * n1 + 4.0 * n0 * rest).sqrt()) / (2.0 * rest) * (1.0 - 1e-9);
            let to = at.turned[i] * at.turned[i] * (1.0 + 1e-9);
            let size = powers[0] + 10.0 * (powers[1] + 10.0 * (powers[2] + 10.0 * powers[3]));
            let turned = c0 + 10.0 * (c1.abs() + 10.0 * c2.abs() + d0.abs() + 10.0 * d1.abs());
            excess.grain[i] = 1e-12 * (size + turned + over / from);
            let live = peaks.proven[i] > 0.0;
            excess.from[i] = if live { from } else { f64::INFINITY };
            excess.to[i] = if live { to } else { 0.0 };
        }
        excess
    }

    /// G and its second derivative by x at a place.
    #[inline(always)]
    fn one<const LAG: bool>(&self, node: &Node, i: usize) -> (f64, f64) {
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

    #[inline(always)]
    fn at<const LAG: bool>(&self, node: &Node, value: &mut Lanes, curvature: &mut Lanes) {
        for i in 0..WIDTH {
            (value[i], curvature[i]) = self.one::<LAG>(node, i);
        }
    }

    /// How far the second derivative may be from the straight line between the ends of the cell that begins here.
    #[inline(always)]
    fn beside(&self, node: &Node, i: usize) -> f64 {
        self.functions[0][i] * node.beside[0] + self.weight[i] * node.beside[1]
    }
}
