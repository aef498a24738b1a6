//! Dead time, exact between samples and under jitter.

use crate::setting_error::require;
use crate::{Scalar, SettingError, Sum};

/// A value and how long it lasted [s]: one entry of a delay line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Segment<T> {
    /// The value, in the unit of the signal.
    pub value: T,
    /// How long it lasted [s].
    pub duration: T,
}

/// The last `dead_time` seconds of a signal that is constant between samples.
///
/// It stores values with their durations, so a dead time that is no multiple of the sample period and samples that
/// come early or late are exact: nothing is rounded to samples. The storage is `[Segment<T>; N]` on a target and
/// `Vec<Segment<T>>` in a simulation. When samples come so fast that it is full, the newest two segments become one
/// of the same area.
///
/// ```
/// use holdup_control::{DelayLine, Segment};
///
/// let mut line = DelayLine::new([Segment::default(); 5], 2.5, 1.0)?; // dead time 2.5 s, samples of 1 s
/// assert_eq!(line.advance(1.0, 1.0), 0.0);
/// assert_eq!(line.advance(1.0, 1.0), 0.0);
/// assert_eq!(line.advance(1.0, 1.0), 0.5); // the step arrives in the middle of this second
/// assert_eq!(line.advance(1.0, 1.0), 1.0);
/// # Ok::<(), holdup_control::SettingError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DelayLine<T, S> {
    /// The ring of segments.
    pub storage: S,
    /// Place of the oldest segment.
    pub oldest: usize,
    /// Number of segments in use.
    pub count: usize,
    /// Sum of the durations in use [s].
    pub span: Sum<T>,
    /// Dead time [s].
    pub dead_time: T,
}

/// Segments that a line needs for this dead time [s] at this sample period [s]: one for each whole sample within the
/// dead time, one for the rest of it, one for the newest sample and one against rounding.
#[must_use]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast truncates and saturates"
)]
pub fn segments_needed<T: Scalar>(dead_time: T, sample_period: T) -> usize {
    ((dead_time / sample_period).to_f64() as usize).saturating_add(3)
}

impl<T: Scalar, S: AsRef<[Segment<T>]> + AsMut<[Segment<T>]>> DelayLine<T, S> {
    /// A line at rest at 0 for a dead time [s], at a nominal sample period [s].
    ///
    /// # Errors
    /// A time that is not finite and above 0; storage that is too short, with the length needed.
    pub fn new(storage: S, dead_time: T, sample_period: T) -> Result<Self, SettingError> {
        require::positive("dead_time", dead_time)?;
        require::positive("sample_period", sample_period)?;
        let needed = segments_needed(dead_time, sample_period);
        let segments = storage.as_ref().len();
        if segments < needed {
            return Err(SettingError::LineTooShort { segments, needed });
        }
        let mut line = Self::unused(storage);
        line.dead_time = dead_time;
        line.fill(T::ZERO);
        Ok(line)
    }

    /// A line without dead time, for a law that needs none.
    pub(crate) fn unused(storage: S) -> Self {
        Self { storage, oldest: 0, count: 0, span: Sum::new(T::ZERO), dead_time: T::ZERO }
    }

    /// Puts in the `value` that lasted for `duration` [s] and returns the area [unit·s] under what came out at the
    /// other end in that time.
    pub fn advance(&mut self, value: T, duration: T) -> T {
        if duration >= self.dead_time {
            let area = self.area() + value * (duration - self.dead_time);
            self.fill(value);
            return area;
        }
        self.put(Segment { value, duration });
        let mut area = T::ZERO;
        let mut excess = self.span.value() - self.dead_time;
        while let Some(taken) = self.take(&mut excess) {
            area = area + taken.value * taken.duration;
        }
        area
    }

    /// Area [unit·s] under the whole content: what has been put in and has not yet come out.
    #[must_use]
    pub fn area(&self) -> T {
        let mut area = T::ZERO;
        for nth in 0..self.count.min(self.storage.as_ref().len()) {
            if let Some(segment) = self.storage.as_ref().get(self.place(nth)) {
                area = area + segment.value * segment.duration;
            }
        }
        area
    }

    /// Changes the dead time [s] while running.
    ///
    /// A shorter line forgets its oldest content. A longer one takes its oldest value to have lasted longer.
    pub fn set_dead_time(&mut self, dead_time: T) {
        let longer = dead_time - self.dead_time;
        self.dead_time = dead_time;
        if longer > T::ZERO {
            if let Some(oldest) = self.storage.as_mut().get_mut(self.oldest).filter(|_| self.count > 0) {
                let duration = oldest.duration + longer;
                self.span.add(duration - oldest.duration);
                oldest.duration = duration;
            } else {
                self.fill(T::ZERO);
            }
            return;
        }
        let mut excess = self.span.value() - dead_time;
        while self.take(&mut excess).is_some() {}
    }

    /// Makes the whole content one value, as after a long rest there.
    pub fn fill(&mut self, value: T) {
        self.oldest = 0;
        self.count = 0;
        self.span = Sum::new(T::ZERO);
        if self.dead_time > T::ZERO {
            self.put(Segment { value, duration: self.dead_time });
        }
    }

    fn put(&mut self, new: Segment<T>) {
        let free = self.place(self.count);
        let newest = self.place(self.count.saturating_sub(1));
        if self.count < self.storage.as_ref().len() {
            if let Some(segment) = self.storage.as_mut().get_mut(free) {
                *segment = new;
                self.count = self.count.saturating_add(1);
                self.span.add(new.duration);
            }
        } else if let Some(segment) = self.storage.as_mut().get_mut(newest) {
            let duration = segment.duration + new.duration;
            let mean = segment.value + (new.value - segment.value) * (new.duration / duration);
            let lasted = duration - segment.duration;
            *segment = Segment { value: if mean.is_finite() { mean } else { new.value }, duration };
            self.span.add(lasted);
        }
    }

    /// Takes the oldest segment, or so much of it as `excess` [s] asks, and lessens `excess` by that.
    fn take(&mut self, excess: &mut T) -> Option<Segment<T>> {
        if self.count == 0 || *excess <= T::ZERO {
            return None;
        }
        let oldest = self.storage.as_mut().get_mut(self.oldest)?;
        let left = oldest.duration - *excess;
        let mut taken = *oldest;
        if left > T::ZERO {
            // What the rounded remainder lacks, so that span and segments agree to the last bit.
            taken.duration = oldest.duration - left;
            oldest.duration = left;
            *excess = T::ZERO;
        } else {
            *excess = *excess - taken.duration;
            self.oldest = self.place(1);
            self.count = self.count.saturating_sub(1);
        }
        self.span.add(-taken.duration);
        Some(taken)
    }

    /// Place of the segment that is `nth` from the oldest.
    fn place(&self, nth: usize) -> usize {
        let place = self.oldest.wrapping_add(nth);
        let room = self.storage.as_ref().len();
        if place < room { place } else { place.wrapping_sub(room) }
    }
}
