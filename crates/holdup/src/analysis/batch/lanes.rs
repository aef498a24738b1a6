//! Elementary functions without branches, so that loops over lanes become vector instructions.
//!
//! Taylor series after one reduction each, to rounding; sums and products in a fixed order and no fused
//! multiplication, so that every instruction set gives the same bits.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Loops that are worked on together.
pub(super) const WIDTH: usize = 32;

/// One number of each of these loops.
pub(super) type Lanes = [f64; WIDTH];

/// The reciprocals of the odd factorials 3!, 5! … 15! with alternating signs, highest first.
const SINE: [f64; 7] = [
    -1.0 / 1_307_674_368_000.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 39_916_800.0,
    1.0 / 362_880.0,
    -1.0 / 5040.0,
    1.0 / 120.0,
    -1.0 / 6.0,
];

/// The reciprocals of the even factorials 2!, 4! … 16! with alternating signs, highest first.
const COSINE: [f64; 8] = [
    1.0 / 20_922_789_888_000.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 479_001_600.0,
    -1.0 / 3_628_800.0,
    1.0 / 40320.0,
    -1.0 / 720.0,
    1.0 / 24.0,
    -0.5,
];

/// Terms of the series of the arc tangent: 0.1716^20/41 is below rounding.
const ARC: usize = 20;

/// Sine and cosine of an angle in [0, π], each to 1e-15.
#[inline(always)]
pub(super) fn sin_cos(angle: f64) -> (f64, f64) {
    // Half the angle from π/2 is at most π/4: the series end at 15! and 16!.
    let half = 0.5 * (angle - FRAC_PI_2);
    let square = half * half;
    let mut sine = SINE[0];
    for term in &SINE[1..] {
        sine = sine * square + term;
    }
    let mut cosine = COSINE[0];
    for term in &COSINE[1..] {
        cosine = cosine * square + term;
    }
    let (sine, cosine) = (half + half * square * sine, 1.0 + square * cosine);
    (1.0 - 2.0 * sine * sine, -2.0 * sine * cosine)
}

/// Angle of the point (x, y), y > 0, in (0, π), to 1e-15.
#[inline(always)]
pub(super) fn angle(x: f64, y: f64) -> f64 {
    // Reduced to |t| ≤ tan(π/8).
    const LOW: f64 = std::f64::consts::SQRT_2 - 1.0;
    const HIGH: f64 = std::f64::consts::SQRT_2 + 1.0;
    let size = x.abs();
    let (steep, flat) = (size > HIGH * y, size < LOW * y);
    let top = if steep { -y } else { size - y };
    let top = if flat { size } else { top };
    let bottom = if steep { size } else { size + y };
    let bottom = if flat { y } else { bottom };
    let offset = if steep { FRAC_PI_2 } else { FRAC_PI_4 };
    let offset = if flat { 0.0 } else { offset };
    let t = top / bottom;
    let square = t * t;
    let mut sum = 0.0;
    for i in (1..ARC).rev() {
        sum = (sum + ODD[i]) * square;
    }
    let arc = offset + (t + t * sum);
    FRAC_PI_2 - if x < 0.0 { -arc } else { arc }
}

/// `(−1)^i/(2i + 1)`.
#[expect(clippy::cast_precision_loss, reason = "at most 41")]
const ODD: [f64; ARC] = {
    let mut table = [1.0; ARC];
    let mut i = 1;
    while i < ARC {
        let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
        table[i] = sign / (2 * i + 1) as f64;
        i += 1;
    }
    table
};

/// The lesser of two numbers; the second if one is not a number.
#[inline(always)]
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The greater of two numbers; the second if one is not a number.
#[inline(always)]
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// 1 for yes.
#[inline(always)]
pub(super) fn flag(yes: bool) -> f64 {
    if yes { 1.0 } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_are_those_of_the_standard_library_to_rounding() {
        for i in 0..=20_000 {
            let angle_ = std::f64::consts::PI * f64::from(i) / 20_000.0;
            let (sine, cosine) = sin_cos(angle_);
            // Two roundings of the half sine, doubled twice, and those of the sum.
            assert!((sine - angle_.sin()).abs() < 1e-15 && (cosine - angle_.cos()).abs() < 1e-15, "{angle_}");
            if i > 0 && i < 20_000 {
                let found = angle(3.0 * angle_.cos(), 3.0 * angle_.sin());
                // Half a unit in the last place of π, and that of the argument.
                assert!((found - angle_).abs() < 1e-15, "{angle_}: {found}");
            }
        }
    }
}
