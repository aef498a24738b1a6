//! The delayed signal of one channel: a queue of cells that come out one delay after they went in.

use std::collections::VecDeque;

use super::legendre::{Poly, TERMS, project, restricted, without_noise};

/// One cell of a delayed signal.
#[derive(Debug, Clone)]
struct Piece {
    length: f64,
    poly: Poly,
    terms: usize,
    /// How often the breakpoint at this piece's start has gone through the loop; `None` for a plain cell edge.
    breakpoint: Option<u32>,
}

/// Cells still to come out, in order; the delay is the sum of their lengths.
#[derive(Debug, Clone)]
pub(super) struct DelayLine {
    pieces: VecDeque<Piece>,
    /// How much of the first piece has come out [s].
    consumed: f64,
    /// Whether the remainder of a rounded step is carried on, so that no drift accumulates.
    carry: bool,
}

impl DelayLine {
    /// A line that has been at rest for at least its delay.
    pub(super) fn at_rest(delay: f64, carry: bool) -> Self {
        let rest = Piece { length: delay, poly: [0.0; TERMS], terms: 0, breakpoint: None };
        Self { pieces: VecDeque::from([rest]), consumed: 0.0, carry }
    }

    /// Time until the first piece has come out [s].
    pub(super) fn to_edge(&self) -> f64 {
        self.pieces.front().map_or(f64::INFINITY, |p| p.length - self.consumed)
    }

    /// Whether a piece starts to come out now.
    pub(super) fn at_edge(&self) -> bool {
        self.consumed == 0.0
    }

    /// Whether the piece that comes out now is at least this long [s].
    pub(super) fn is_within(&self, length: f64) -> bool {
        self.pieces.front().is_none_or(|p| p.length >= length)
    }

    /// Time until `count` pieces have come out, or until the next breakpoint comes out if that is earlier [s].
    pub(super) fn to_edge_within(&self, count: usize, tiny: f64) -> f64 {
        let mut ahead = -self.consumed;
        for (index, piece) in self.pieces.iter().enumerate() {
            if ahead > tiny && (index >= count || piece.breakpoint.is_some()) {
                break;
            }
            ahead += piece.length;
        }
        ahead
    }

    /// Order of the breakpoint that comes out now.
    pub(super) fn breakpoint_now(&self, tiny: f64) -> Option<u32> {
        self.pieces.front().filter(|_| self.consumed.abs() <= tiny).and_then(|p| p.breakpoint)
    }

    /// The signal that comes out over the next `length` seconds, and whether it is a stored cell unchanged.
    pub(super) fn ahead(&self, length: f64, tiny: f64) -> (Poly, bool) {
        let Some(front) = self.pieces.front() else { return ([0.0; TERMS], true) };
        let rest = front.length - self.consumed;
        if self.consumed.abs() <= tiny && (rest - length).abs() <= tiny {
            return (front.poly, true);
        }
        if length <= rest + tiny {
            if front.terms <= 1 {
                return (front.poly, true);
            }
            let from = 2.0 * self.consumed / front.length - 1.0;
            let to = (2.0 * (self.consumed + length) / front.length - 1.0).min(1.0);
            return (restricted(&front.poly[..front.terms], from, to), false);
        }
        let mut sum = [0.0; TERMS];
        let mut ahead = -self.consumed;
        for piece in &self.pieces {
            let (start, end) = (ahead.max(0.0), (ahead + piece.length).min(length));
            if start >= length {
                break;
            }
            if end > start {
                let own = |t: f64| 2.0 * (t - ahead) / piece.length - 1.0;
                let new = |t: f64| 2.0 * t / length - 1.0;
                project(&mut sum, &piece.poly[..piece.terms], (own(start), own(end)), (new(start), new(end)));
            }
            ahead += piece.length;
        }
        without_noise(&mut sum);
        (sum, false)
    }

    /// Lets `length` seconds come out.
    pub(super) fn advance(&mut self, length: f64, tiny: f64) {
        self.consumed += length;
        while let Some(front) = self.pieces.front() {
            let over = self.consumed - front.length;
            if over < -tiny {
                break;
            }
            self.pieces.pop_front();
            self.consumed = if self.carry || over > tiny { over } else { 0.0 };
        }
    }

    /// Puts a cell in.
    pub(super) fn push(&mut self, length: f64, poly: &Poly, terms: usize, breakpoint: Option<u32>) {
        let mut poly = *poly;
        poly[terms..].fill(0.0);
        self.pieces.push_back(Piece { length, poly, terms, breakpoint });
    }

    /// Adds a constant to everything in the line: its reference has moved.
    pub(super) fn shift(&mut self, by: f64) {
        for piece in &mut self.pieces {
            piece.poly[0] += by;
            piece.terms = piece.terms.max(1);
        }
    }
}
