//! What the input's integral is by itself at every delay.

use super::sums::own_sums;
use crate::analysis::widest;

/// Sums over the input's integral, outside initial value and constant load.
pub(super) struct Own {
    /// Squares at every delay from 0 on.
    pub(super) squares: Vec<f64>,
    /// Products with the integral at the next delay, one fewer.
    pub(super) neighbour: Vec<f64>,
    /// Below it the squares are what sums over the rows have lost, or near it.
    pub(super) floor: f64,
    /// Bound of the sum of squares by which the column changes from delay to delay.
    change: f64,
}

/// The least share of the integral that must lie outside straight lines for its moves to show, squared: eleven of sixteen
/// digits are lost there.
const SHOWN: f64 = 1e-10;

/// Of the window at one delay: sum, moment about its middle, squares, and products with the window at the next delay.
type Place = [f64; 4];

impl Own {
    /// `integral` begins `delays` rows before the input.
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    pub(super) fn new(integral: &[f64], input: &[f64], mean: f64, delays: usize) -> Self {
        let rows = input.len();
        let half = (rows as f64 - 1.0) / 2.0;
        let ([mut sum, mut moment, mut squares, mut neighbour], change) =
            own_sums(&integral[delays..], &integral[delays - 1..], input, mean);
        let floor = SHOWN * squares;
        let mut places: Vec<Place> = Vec::with_capacity(delays + 1);
        // From delay to delay one value enters at the front of the window, one leaves at its end.
        let (fronts, backs) = (&integral[..delays], &integral[rows..rows + delays]);
        let (mut enters, mut leaves) = (fronts[delays - 1], backs[delays - 1]);
        for k in (0..delays).rev() {
            places.push([sum, moment, squares, neighbour]);
            // The last place has no next one, and its product is not used.
            let (next_enters, next_leaves) = (fronts[k.saturating_sub(1)], backs[k.saturating_sub(1)]);
            moment += sum - (leaves * (half + 1.0) + enters * half);
            sum += enters - leaves;
            squares += enters * enters - leaves * leaves;
            neighbour += enters * next_enters - leaves * next_leaves;
            (enters, leaves) = (next_enters, next_leaves);
        }
        places.push([sum, moment, squares, 0.0]);
        let (squares, neighbour) = outside(&places, rows as f64);
        let change = change + (delays + 1) as f64 * (input[0] - mean).powi(2);
        Self { squares, neighbour, floor, change }
    }

    /// No column between these delays has a smaller sum of squares. Between two delays it is a parabola that bends by the
    /// squares of the change.
    pub(super) fn least(&self, from: usize, to: usize) -> f64 {
        let least = self.squares[from..=to].iter().fold(f64::INFINITY, |least, &squares| least.min(squares));
        least - self.change / 4.0
    }
}

/// Squares and products with the neighbour outside the mean and the straight line of so many rows.
fn outside(places: &[Place], rows: f64) -> (Vec<f64>, Vec<f64>) {
    widest(
        #[inline(always)]
        || {
            let (per_row, per_spread) = (1.0 / rows, 12.0 / (rows * (rows * rows - 1.0)));
            let squares = places
                .iter()
                .map(|[sum, moment, squares, _]| squares - sum * sum * per_row - moment * moment * per_spread)
                .collect();
            let neighbour = places
                .iter()
                .zip(&places[1..])
                .map(|([sum, moment, _, with], [next_sum, next_moment, ..])| {
                    with - sum * next_sum * per_row - moment * next_moment * per_spread
                })
                .collect();
            (squares, neighbour)
        },
    )
}
