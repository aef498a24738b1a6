//! Small systems of linear equations.

/// A pivot below this part of the greatest is none.
const LEAST: f64 = 1e-6;

/// The columns for which the rows are best solved: those of the pivots of Gauss's elimination, each the greatest left.
pub(super) fn pivots(rows: &[Vec<f64>]) -> Option<Vec<usize>> {
    let mut rows = rows.to_vec();
    let greatest = |rows: &[Vec<f64>]| {
        let cells =
            rows.iter().enumerate().flat_map(|(i, row)| row.iter().enumerate().map(move |(j, x)| (i, j, *x)));
        cells.max_by(|a, b| a.2.abs().total_cmp(&b.2.abs()))
    };
    let scale = greatest(&rows)?.2.abs();
    let mut columns = Vec::new();
    while !rows.is_empty() {
        let (row, column, pivot) = greatest(&rows)?;
        if pivot.abs() <= LEAST * scale || !pivot.is_finite() {
            return None;
        }
        let taken = rows.swap_remove(row);
        for row in &mut rows {
            let share = row[column] / pivot;
            row.iter_mut().zip(&taken).for_each(|(x, y)| *x -= share * y);
            row[column] = 0.0;
        }
        columns.push(column);
    }
    Some(columns)
}

/// The solution of as many equations as unknowns.
pub(super) fn solved(mut rows: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let count = right.len();
    for k in 0..count {
        let pivot = (k..count).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()))?;
        rows.swap(k, pivot);
        right.swap(k, pivot);
        if rows[k][k] == 0.0 || !rows[k][k].is_finite() {
            return None;
        }
        for i in k + 1..count {
            let share = rows[i][k] / rows[k][k];
            let (above, below) = rows.split_at_mut(i);
            below[0].iter_mut().zip(&above[k]).for_each(|(x, y)| *x -= share * y);
            right[i] -= share * right[k];
        }
    }
    for k in (0..count).rev() {
        let known: f64 = (k + 1..count).map(|j| rows[k][j] * right[j]).sum();
        right[k] = (right[k] - known) / rows[k][k];
    }
    Some(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_are_solved_for_the_columns_that_bear_it() {
        let rows = vec![vec![1e-9, 0.0, 2.0], vec![1e-9, 3.0, 1.0]];
        assert_eq!(pivots(&rows), Some(vec![1, 2]));
        assert_eq!(pivots(&[vec![1.0, 2.0, 3.0], vec![2.0, 4.0, 6.0]]), None);
        let found = solved(vec![vec![0.0, 2.0], vec![3.0, 1.0]], vec![4.0, 5.0]).unwrap();
        assert_eq!(found, [1.0, 2.0]);
    }
}
