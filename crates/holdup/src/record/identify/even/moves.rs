//! The moves of the input.

use super::sums::LANES;
use crate::analysis::widest;

/// Row and size of a change of the input.
pub(super) type Move = (usize, f64);

/// The moves of the input, in order.
pub(super) fn moves(input: &[f64]) -> Vec<Move> {
    widest(
        #[inline(always)]
        || {
            let mut found = Vec::with_capacity(input.len() / 8);
            let mut push = |row: usize| found.push((row, input[row] - input[row - 1]));
            let (before, _) = input.as_chunks::<LANES>();
            let (after, rest) = input[1..].as_chunks::<LANES>();
            for (k, (before, after)) in before.iter().zip(after).enumerate() {
                let mut changed = 0_u32;
                for lane in 0..LANES {
                    changed |= u32::from(before[lane] != after[lane]) << lane;
                }
                while changed != 0 {
                    push(k * LANES + 1 + changed.trailing_zeros() as usize);
                    changed &= changed - 1;
                }
            }
            (input.len() - rest.len()..input.len())
                .filter(|&row| input[row] != input[row - 1])
                .for_each(push);
            found
        },
    )
}

/// The moves on a grid four times as coarse: each shared between the two places next to it, by its distance to them.
#[expect(clippy::cast_precision_loss, reason = "0 to 3")]
pub(super) fn shared(moves: &[Move]) -> Vec<Move> {
    let mut found = Vec::with_capacity(moves.len() + moves.len() / 2 + 2);
    // The place before the last move and what it and the next one have of the moves so far.
    let (mut place, mut here, mut next) = (0, 0.0, 0.0);
    for &(row, size) in moves {
        let (before, later) = (row / 4, size * ((row % 4) as f64 / 4.0));
        if before != place {
            found.push((place, here));
            if before == place + 1 {
                here = next;
            } else {
                found.push((place + 1, next));
                here = 0.0;
            }
            (place, next) = (before, 0.0);
        }
        here += size - later;
        next += later;
    }
    found.extend([(place, here), (place + 1, next)]);
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_move_is_found_where_it_is() {
        let mut input = vec![2.0; 37];
        input[8..].fill(3.0);
        input[17..].fill(2.5);
        input[36] = 0.0;
        assert_eq!(moves(&input), [(8, 1.0), (17, -0.5), (36, -2.5)]);
        assert_eq!(moves(&input[..3]), []);
    }

    /// Sum and first moment stay: what is linear between the places of the grid has the same product before and after.
    #[test]
    fn shared_moves_keep_sum_and_moment() {
        let before = [(1, 4.0), (2, -1.0), (6, 2.0), (7, 1.0), (8, 8.0), (21, 3.0), (40, 1.0)];
        let after = shared(&before);
        let sum = |moves: &[Move], rows: f64| {
            moves.iter().fold((0.0, 0.0), |(sum, moment), (place, size)| {
                (sum + size, moment + size * rows * f64::from(u32::try_from(*place).unwrap()))
            })
        };
        assert_eq!(sum(&before, 1.0), sum(&after, 4.0));
        assert!(after.windows(2).all(|pair| pair[0].0 < pair[1].0), "{after:?}");
    }
}
