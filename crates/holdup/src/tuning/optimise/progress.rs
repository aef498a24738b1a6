//! How far a search has come.

use std::sync::atomic::{AtomicU64, Ordering};

/// Thousandths that one optimum counts.
pub const WHOLE: u64 = 1000;

/// Shares of the sweep, the searches and the end, in millionths.
pub(super) const SWEEP: u64 = 150_000;
pub(super) const SEARCHES: u64 = 600_000;
pub(super) const END: u64 = 240_000;

/// Evaluations after which half of the share of a search is counted: nobody knows how many there will be.
const HALF: u64 = 300;

/// Counts what is done of one optimum, on all threads.
pub(super) struct Progress<'a> {
    tell: &'a (dyn Fn(u64) + Sync),
    millionths: AtomicU64,
}

impl<'a> Progress<'a> {
    /// `tell` is called with thousandths of the whole as they are done.
    pub(super) fn new(tell: &'a (dyn Fn(u64) + Sync)) -> Self {
        Self { tell, millionths: AtomicU64::new(0) }
    }

    /// One that nobody listens to.
    pub(super) fn silent() -> Self {
        Self::new(&|_| {})
    }

    pub(super) fn add(&self, millionths: u64) {
        let before = self.millionths.fetch_add(millionths, Ordering::Relaxed);
        let thousandths = |millionths: u64| (millionths / 1000).min(WHOLE);
        let more = thousandths(before + millionths) - thousandths(before);
        if more > 0 {
            (self.tell)(more);
        }
    }

    /// Counts the evaluations of a search that has this share.
    pub(super) fn search(&self, share: u64) -> Search<'_> {
        Search { of: self, share, evaluations: 0, counted: 0 }
    }

    /// Counts what is left.
    pub(super) fn finish(&self) {
        self.add(1_000_000_u64.saturating_sub(self.millionths.load(Ordering::Relaxed)));
    }
}

/// One search among those of an optimum; what it has not counted by its end is counted there.
pub(super) struct Search<'a> {
    of: &'a Progress<'a>,
    share: u64,
    evaluations: u64,
    counted: u64,
}

impl Search<'_> {
    pub(super) fn evaluated(&mut self) {
        self.evaluations += 1;
        let counted = self.share * self.evaluations / (self.evaluations + HALF);
        self.of.add(counted - self.counted);
        self.counted = counted;
    }
}

impl Drop for Search<'_> {
    fn drop(&mut self) {
        self.of.add(self.share - self.counted);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_optimum_counts_a_thousand_whatever_the_searches_took() {
        let told = AtomicU64::new(0);
        let tell = |more: u64| {
            told.fetch_add(more, Ordering::Relaxed);
        };
        let progress = Progress::new(&tell);
        progress.add(SWEEP);
        for evaluations in [0, 3, 5000] {
            let mut search = progress.search(SEARCHES / 3);
            (0..evaluations).for_each(|_| search.evaluated());
        }
        let before = told.load(Ordering::Relaxed);
        assert_eq!(before, (SWEEP + SEARCHES) / 1000);
        progress.finish();
        progress.finish();
        assert_eq!(told.load(Ordering::Relaxed), WHOLE);
    }
}
