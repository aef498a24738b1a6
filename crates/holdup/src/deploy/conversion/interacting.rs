//! Ideal form with filtered derivative, and the interacting form whose lead is filtered, in both directions.
//!
//! The interacting block is `K'·(1 + 1/(Ti'·s))·(Td'·s + 1)/(Tf·s + 1)`. Its partial fractions are those of the ideal
//! form with `P = (Ti' + Td' − Tf)/Ti'`: `K = K'·P`, `Ti = Ti'·P`, `Td = Td'/P − Tf`, the same Tf. Without integral
//! action P is 1. Nothing is lost on the way: the two are the same transfer function.

/// Gain and times of a controller, in the form that the context names.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Terms {
    /// Proportional gain [input unit / output unit], with its sign.
    pub(super) gain: f64,
    /// Integral time [s], where there is integral action.
    pub(super) ti: Option<f64>,
    /// Derivative time [s], where there is derivative action.
    pub(super) td: Option<f64>,
    /// Filter time [s], where the derivative is filtered.
    pub(super) tf: Option<f64>,
}

/// The filter that an interacting block is to have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Lag {
    /// This time Tf [s], 0 for none.
    Time(f64),
    /// This ratio Tf/Td', 0 for none.
    Ratio(f64),
}

/// P, by which the ideal form's gain and integral time are greater than those of the block.
pub(super) fn factor(block: &Terms) -> f64 {
    match (block.ti, block.td) {
        (Some(ti), Some(td)) => (ti + (td - block.tf.unwrap_or(0.0))) / ti,
        _ => 1.0,
    }
}

/// The ideal form of an interacting block; `None` where its filter outweighs its lead, so that the derivative time
/// would be negative.
pub(super) fn ideal(block: &Terms) -> Option<Terms> {
    let p = factor(block);
    let td = block.td.map(|td| td / p - block.tf.unwrap_or(0.0));
    let sound = p > 0.0 && td.is_none_or(|td| td > 0.0);
    sound.then_some(Terms { gain: block.gain * p, ti: block.ti.map(|ti| ti * p), td, tf: block.tf })
}

/// The interacting block of an ideal form with the same gain, integral and derivative time and this filter; `None`
/// where its zeros are complex. Of the two blocks that exist otherwise, the one with the longer integral time.
pub(super) fn block(ideal: &Terms, lag: Lag) -> Option<Terms> {
    let Some(td) = ideal.td else { return Some(*ideal) };
    let Some(ti) = ideal.ti else {
        let block_td = match lag {
            Lag::Time(tf) => td + tf,
            Lag::Ratio(a) => td / (1.0 - a),
        };
        return Some(Terms { td: Some(block_td), tf: filter(lag, block_td), ..*ideal });
    };
    // Td' is the smaller root of x² − sum·x + product, found from the larger one: no cancellation.
    let smaller = |sum: f64, product: f64| {
        let under = 1.0 - 4.0 * product / (sum * sum);
        (under >= 0.0).then(|| product / (0.5 * sum * (1.0 + under.sqrt())))
    };
    let (block_ti, block_td) = match lag {
        Lag::Time(tf) => {
            let x = smaller(ti + tf, ti * (td + tf))?;
            (ti + tf - x, x)
        }
        // Ti' = Ti − (1 − a)·x, put into Ti·Td = x·(Ti' − a·Ti).
        Lag::Ratio(a) => {
            let x = smaller(ti, ti * td / (1.0 - a))?;
            (ti - (1.0 - a) * x, x)
        }
    };
    let tf = filter(lag, block_td);
    Some(Terms { gain: ideal.gain * (block_ti / ti), ti: Some(block_ti), td: Some(block_td), tf })
}

fn filter(lag: Lag, block_td: f64) -> Option<f64> {
    let tf = match lag {
        Lag::Time(tf) => tf,
        Lag::Ratio(a) => a * block_td,
    };
    (tf > 0.0).then_some(tf)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_complex::Complex64;
    use proptest::prelude::*;

    fn at(s: Complex64, t: &Terms) -> Complex64 {
        let integral = t.ti.map_or(Complex64::ZERO, |ti| (s * ti).inv());
        let derivative = t.td.map_or(Complex64::ZERO, |td| s * td / (s * t.tf.unwrap_or(0.0) + 1.0));
        (integral + derivative + 1.0) * t.gain
    }

    fn interacting_at(s: Complex64, t: &Terms) -> Complex64 {
        let reset = t.ti.map_or(Complex64::ZERO, |ti| (s * ti).inv()) + 1.0;
        let lead = (s * t.td.unwrap_or(0.0) + 1.0) / (s * t.tf.unwrap_or(0.0) + 1.0);
        reset * lead * t.gain
    }

    proptest! {
        #[test]
        fn both_forms_are_the_same_transfer_function(
            ti in proptest::option::of(1.0..100.0_f64), ratio in 0.01..0.99_f64, a in 0.0..0.9_f64, w in 0.001..10.0_f64,
        ) {
            let td = ratio * ti.unwrap_or(10.0);
            let given = Terms { gain: -2.0, ti, td: Some(td), tf: (a > 0.0).then_some(a * td) };
            let s = Complex64::new(0.1 * w, w);
            let same = ideal(&given).unwrap();
            let (left, right) = (at(s, &same), interacting_at(s, &given));
            // A dozen operations on numbers that cancel to at worst 1 − a = 0.1.
            prop_assert!((left - right).norm() <= 1e-12 * right.norm(), "{left} {right}");
        }

        #[test]
        fn a_block_comes_back_by_its_ratio_and_by_its_filter_time(
            ti in proptest::option::of(1.0..100.0_f64), ratio in 0.01..0.5_f64, a in 0.0..0.9_f64,
        ) {
            let td = ratio * ti.unwrap_or(10.0);
            let given = Terms { gain: 3.0, ti, td: Some(td), tf: (a > 0.0).then_some(a * td) };
            let same = ideal(&given).unwrap();
            for lag in [Lag::Ratio(a), Lag::Time(given.tf.unwrap_or(0.0))] {
                let back = block(&same, lag).unwrap();
                for (l, r) in [(back.gain, 3.0), (back.ti.unwrap_or(1.0), ti.unwrap_or(1.0)), (back.td.unwrap(), td)] {
                    // Td'/Ti' is at most 1/2, where the root's square root loses at most two digits.
                    prop_assert!((l / r - 1.0).abs() < 1e-13, "{lag:?}: {back:?} is not {given:?}");
                }
            }
        }
    }

    #[test]
    fn a_short_integral_time_has_no_interacting_block() {
        let short = Terms { gain: 1.0, ti: Some(7.9), td: Some(2.0), tf: None };
        assert_eq!(block(&short, Lag::Time(0.0)), None);
        // With a lag of a tenth the limit is Ti = 4·Td/(1 − a), a little longer.
        assert_eq!(block(&Terms { ti: Some(8.5), ..short }, Lag::Ratio(0.1)), None);
        assert!(block(&Terms { ti: Some(9.0), ..short }, Lag::Ratio(0.1)).is_some());
    }
}
