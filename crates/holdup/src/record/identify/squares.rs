//! Linear least squares by orthogonal columns, small and numerically plain.

/// A column after those before it have been taken out of it, twice, and what was taken.
#[derive(Debug, Clone, Default)]
pub(crate) struct Basis {
    columns: Vec<Vec<f64>>,
    /// ln |XᵀX| of the columns that were given.
    log_determinant: f64,
}

/// A column whose part outside the basis is smaller than this share of it is in the basis: 1e-11 leaves five digits
/// above rounding.
const DEPENDENT: f64 = 1e-11;

impl Basis {
    /// The basis of these columns; one that the others span adds nothing.
    pub(crate) fn of(columns: impl IntoIterator<Item = Vec<f64>>) -> Self {
        let mut basis = Self::default();
        for column in columns {
            basis.add(column);
        }
        basis
    }

    /// Adds a column; says whether it was independent of those before.
    pub(crate) fn add(&mut self, mut column: Vec<f64>) -> bool {
        let whole = norm(&column);
        self.project(&mut column);
        let left = norm(&column);
        if !(left > DEPENDENT * whole && left.is_normal()) {
            return false;
        }
        self.log_determinant += 2.0 * left.ln();
        for value in &mut column {
            *value /= left;
        }
        self.columns.push(column);
        true
    }

    /// Takes the basis out of a column, twice: once leaves rounding of the size of the column.
    pub(crate) fn project(&self, column: &mut [f64]) {
        for _ in 0..2 {
            for of in &self.columns {
                let part = dot(of, column);
                column.iter_mut().zip(of).for_each(|(value, q)| *value -= part * q);
            }
        }
    }

    /// The column less its part in the basis.
    pub(crate) fn projected(&self, mut column: Vec<f64>) -> Vec<f64> {
        self.project(&mut column);
        column
    }

    /// The column less its part in the basis, and the sum of squares of that: 0 where it is rounding.
    pub(crate) fn outside(&self, column: Vec<f64>) -> (Vec<f64>, f64) {
        let whole = dot(&column, &column);
        let left = self.projected(column);
        let squares = dot(&left, &left);
        (left, if squares > DEPENDENT * DEPENDENT * whole { squares } else { 0.0 })
    }

    /// Number of independent columns.
    pub(crate) fn rank(&self) -> usize {
        self.columns.len()
    }

    /// ln |XᵀX| of the independent columns.
    pub(crate) fn log_determinant(&self) -> f64 {
        self.log_determinant
    }
}

/// Σ a·b, in eight sums that the machine can do side by side.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (whole_a, rest_a) = a.as_chunks::<8>();
    let (whole_b, rest_b) = b.as_chunks::<8>();
    for (a, b) in whole_a.iter().zip(whole_b) {
        for lane in 0..8 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    rest + sums.iter().sum::<f64>()
}

/// Euclidean length.
pub(crate) fn norm(column: &[f64]) -> f64 {
    dot(column, column).sqrt()
}

/// Solves the symmetric positive definite system by Gaussian elimination with the largest diagonal first; `None` where it
/// is singular to rounding.
pub(crate) fn solve(mut matrix: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let n = right.len();
    for pivot in 0..n {
        let best = (pivot..n).max_by(|&a, &b| matrix[a][pivot].abs().total_cmp(&matrix[b][pivot].abs()))?;
        matrix.swap(pivot, best);
        right.swap(pivot, best);
        let lead = matrix[pivot][pivot];
        if lead.abs() < f64::MIN_POSITIVE || !lead.is_finite() {
            return None;
        }
        for row in pivot + 1..n {
            let factor = matrix[row][pivot] / lead;
            for column in pivot..n {
                matrix[row][column] -= factor * matrix[pivot][column];
            }
            right[row] -= factor * right[pivot];
        }
    }
    for pivot in (0..n).rev() {
        let known: f64 = (pivot + 1..n).map(|column| matrix[pivot][column] * right[column]).sum();
        right[pivot] = (right[pivot] - known) / matrix[pivot][pivot];
    }
    Some(right)
}

/// What the columns say of the response by whitened least squares, as a column.
pub(crate) fn generalised(
    whitener: &super::noise::Whitener,
    columns: &[Vec<f64>],
    response: &[f64],
) -> Vec<f64> {
    let white: Vec<Vec<f64>> = columns.iter().map(|column| whitener.whiten(column.clone())).collect();
    let right = whitener.whiten(response.to_vec());
    let normal = white.iter().map(|a| white.iter().map(|b| dot(a, b)).collect()).collect();
    let weights = solve(normal, white.iter().map(|a| dot(a, &right)).collect()).unwrap_or_default();
    let mut sum = vec![0.0; response.len()];
    for (weight, column) in weights.iter().zip(columns) {
        sum.iter_mut().zip(column).for_each(|(sum, value)| *sum += weight * value);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_basis_spans_is_taken_out() {
        let basis = Basis::of([vec![1.0; 4], vec![0.0, 1.0, 2.0, 3.0], vec![5.0, 6.0, 7.0, 8.0]]);
        assert_eq!(basis.rank(), 2);
        // |XᵀX| of the first two: 4·14 − 6².
        assert!((basis.log_determinant() - 20.0f64.ln()).abs() < 1e-14);
        assert!(norm(&basis.projected(vec![3.0, 1.0, -1.0, -3.0])) < 1e-14);
    }

    #[test]
    fn a_system_is_solved_and_a_singular_one_is_not() {
        let x = solve(vec![vec![4.0, 1.0], vec![1.0, 3.0]], vec![1.0, 2.0]).unwrap_or_default();
        assert!((x[0] - 1.0 / 11.0).abs() < 1e-15 && (x[1] - 7.0 / 11.0).abs() < 1e-15);
        assert_eq!(solve(vec![vec![0.0]], vec![1.0]), None);
    }
}
