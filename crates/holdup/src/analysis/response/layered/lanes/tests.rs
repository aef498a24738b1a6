//! Lanes against plain numbers.

use fearless_simd::{Level, Simd, dispatch, f64x8};

use super::*;

/// For a token, what is computed with it for all θ.
fn decayed<S: Simd>(token: S, theta: &[f64; 8]) -> [f64; 8] {
    let lanes = <f64x8<S> as Number>::from_fn(token, |l| theta[l]).decayed();
    std::array::from_fn(|l| lanes[l])
}

#[test]
fn exponentials_are_those_of_the_standard_library() {
    for block in 0..800 {
        let theta = std::array::from_fn(|l| 0.109_31 * f64::from(block * 8 + i32::try_from(l).unwrap()));
        let found = dispatch!(Level::new(), simd => decayed(simd, &theta));
        for (found, theta) in found.iter().zip(theta) {
            // 1e-15: a few roundings.
            assert!((found / (-theta).exp() - 1.0).abs() < 1e-15, "{theta}");
        }
    }
}

fn compared<V: Lanes>(token: V::Token) {
    let rising = V::from_fn(token, |l| f64::from(u8::try_from(l).unwrap()) - 2.0);
    let below = rising.below(V::zero(token));
    let upto = rising.at_most(V::zero(token));
    for l in 0..V::COUNT {
        assert_eq!((below.has(l), upto.has(l)), (l < 2, l <= 2));
        assert_eq!(rising.only_in(below, V::all(token, 9.0))[l], if l < 2 { rising[l] } else { 9.0 });
    }
    let places: Vec<usize> = (V::every() & upto & !below).iter().collect();
    assert_eq!(places, if V::COUNT > 2 { vec![2] } else { vec![] });
    assert_eq!((rising.smallest(), rising.largest()), (-2.0, rising[V::COUNT - 1]));
    assert!((below | upto) == upto && rising.all_at_most(V::all(token, 5.0)));
}

#[test]
fn sets_hold_the_lanes_that_they_are_made_of() {
    dispatch!(Level::new(), simd => compared::<One<_>>(simd));
    dispatch!(Level::new(), simd => compared::<f64x8<_>>(simd));
}
