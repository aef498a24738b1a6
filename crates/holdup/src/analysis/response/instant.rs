//! Time as a sum of two numbers: adding thousands of cell lengths loses nothing.

/// A time [s] with twice the digits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Instant {
    high: f64,
    low: f64,
}

impl Instant {
    pub(super) fn new(seconds: f64) -> Self {
        Self { high: seconds, low: 0.0 }
    }

    pub(super) fn seconds(self) -> f64 {
        self.high
    }

    pub(super) fn plus(self, seconds: f64) -> Self {
        let sum = self.high + seconds;
        let part = sum - self.high;
        let low = self.low + ((self.high - (sum - part)) + (seconds - part));
        let high = sum + low;
        Self { high, low: low - (high - sum) }
    }

    /// Time from here until `other` [s].
    pub(super) fn until(self, other: f64) -> f64 {
        (other - self.high) - self.low
    }

    /// Time from `earlier` until here [s].
    pub(super) fn since(self, earlier: Self) -> f64 {
        (self.high - earlier.high) + (self.low - earlier.low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_tenths_are_a_hundred_thousand() {
        let end = (0..1_000_000).fold(Instant::new(0.0), |t, _| t.plus(0.1));
        // 0.1 is stored 5.55e-18 too large: 5.55e-12 after a million.
        assert!((end.until(100_000.0) + 5.551e-12).abs() < 1e-14);
    }
}
