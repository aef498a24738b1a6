//! Quantiles of 95 %.

/// Square of the two-sided 95 % quantile of Student's t: the threshold of one parameter in units of the residual variance.
/// Expansion of R. A. Fisher and E. A. Cornish, Technometrics 2 (1960) 209; right to 3e-3 from 5 degrees of freedom on.
pub(crate) fn one(freedom: f64) -> f64 {
    let n = freedom.max(3.0);
    let z: f64 = 1.959_963_984_540_054;
    let (z3, z5, z7) = (z.powi(3), z.powi(5), z.powi(7));
    let t = z
        + (z3 + z) / (4.0 * n)
        + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n)
        + (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n.powi(3));
    t * t
}

/// Twice the 95 % quantile of F with 2 degrees of freedom: the threshold of two parameters at once.
pub(super) fn two(freedom: f64) -> f64 {
    let n = freedom.max(3.0);
    n * (0.05f64.powf(-2.0 / n) - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Table values: 3e-3 is the first term that the expansion leaves out, at 5 degrees of freedom, and 1e-3 the digits of the table.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        for (freedom, t) in [(5.0, 2.571), (10.0, 2.228), (30.0, 2.042), (120.0, 1.980)] {
            assert!((one(freedom).sqrt() - t).abs() < 4e-3, "{freedom}");
        }
        for (freedom, f) in [(10.0, 4.103), (30.0, 3.316), (120.0, 3.072)] {
            assert!((two(freedom) / 2.0 - f).abs() < 6e-4, "{freedom}");
        }
    }
}
