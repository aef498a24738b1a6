//! The delay line against the integral of the delayed signal, computed apart.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use holdup_control::{DelayLine, Segment, SettingError, segments_needed};
use proptest::prelude::*;

/// ∫ of the piecewise constant signal up to `time`; it is 0 before 0.
fn integral(signal: &[(f64, f64)], time: f64) -> f64 {
    let mut start = 0.0;
    let mut area = 0.0;
    for &(value, duration) in signal {
        area += value * (time - start).clamp(0.0, duration);
        start += duration;
    }
    area
}

fn line(segments: usize, dead_time: f64) -> DelayLine<f64, Vec<Segment<f64>>> {
    DelayLine::new(vec![Segment::default(); segments], dead_time, dead_time / 4.0).unwrap()
}

proptest! {
    #[test]
    fn a_line_shows_the_past_exactly_at_any_sample_times(
        signal in prop::collection::vec((-1.0..1.0, 0.01..3.0), 1..80),
        dead_time in 0.1..5.0,
    ) {
        // 5 s at 0.01 s at the worst.
        let mut line = line(600, dead_time);
        let mut time = 0.0;
        let mut last = 0.0;
        for (sample, &(value, duration)) in signal.iter().enumerate() {
            let area = line.advance(value, duration);
            time += duration;
            let expected = integral(&signal[..=sample], time - dead_time);
            // Sums of 80 areas of size 3: 80 roundings of 240.
            prop_assert!((area - (expected - last)).abs() < 5e-12);
            let inside = integral(&signal[..=sample], time) - expected;
            prop_assert!((line.area() - inside).abs() < 5e-12);
            last = expected;
        }
    }

    #[test]
    fn a_full_line_loses_no_area(
        signal in prop::collection::vec((-1.0..1.0, 0.01..0.2), 1..200),
    ) {
        // Seven segments where a hundred would be needed.
        let mut line = line(7, 1.0);
        let mut out = 0.0;
        let mut put_in = 0.0;
        for &(value, duration) in &signal {
            out += line.advance(value, duration);
            put_in += value * duration;
            // 200 roundings of areas of size 1, and of their means.
            prop_assert!((out + line.area() - put_in).abs() < 1e-12);
            prop_assert!((line.span.value() - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn a_line_that_is_too_short_says_the_length_it_needs() {
    let error = DelayLine::new([Segment::<f64>::default(); 10], 6.0, 0.5).unwrap_err();
    assert_eq!(error, SettingError::LineTooShort { segments: 10, needed: 15 });
    assert_eq!(error.to_string(), "the delay line has 10 segments: the dead time needs 15");
    assert_eq!(segments_needed(6.0, 0.5), 15);
    assert_eq!(segments_needed(f64::MAX, f64::MIN_POSITIVE), usize::MAX);
}

#[test]
fn the_length_needed_is_enough_at_any_fraction_of_a_sample() {
    for hundredths in 1..1000_u32 {
        let dead_time = f64::from(hundredths) * 0.01;
        let mut line =
            DelayLine::new(vec![Segment::default(); segments_needed(dead_time, 0.1)], dead_time, 0.1)
                .unwrap();
        let mut put_in = Vec::new();
        for sample in 0..300_u32 {
            let value = f64::from(sample % 17);
            put_in.push((value, 0.1));
            let area = line.advance(value, 0.1);
            let time = f64::from(sample + 1) * 0.1 - dead_time;
            let expected = integral(&put_in, time) - integral(&put_in, time - 0.1);
            // 300 roundings of times up to 30, on values up to 16; a merged segment would be wrong by 0.1.
            assert!(
                (area - expected).abs() < 1e-10,
                "{dead_time} s, sample {sample}: {area}, not {expected}"
            );
        }
    }
}

#[test]
fn an_f32_line_keeps_its_dead_time_under_jitter_for_a_million_samples() {
    let mut line = DelayLine::new([Segment::default(); 40], 1.3_f32, 0.1).unwrap();
    let mut random = 1_u32;
    for _ in 0..1_000_000 {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let duration = 0.05 + 0.1 * f32::from(u16::try_from(random >> 16).unwrap()) / 65536.0;
        line.advance(1.0, duration);
    }
    // The whole content is 1: its area is the dead time, to the rounding of some twenty terms near 1.
    assert!((line.area() - 1.3).abs() < 3e-6, "{}", line.area());
}

#[test]
fn a_changed_dead_time_cuts_or_stretches_the_oldest_content() {
    let mut line = line(20, 2.0);
    for value in [1.0, 2.0, 3.0, 4.0] {
        line.advance(value, 0.5);
    }
    line.set_dead_time(1.25);
    assert_eq!(line.area(), 0.5 * 4.0 + 0.5 * 3.0 + 0.25 * 2.0);
    assert_eq!(line.advance(0.0, 0.5), 0.25 * 2.0 + 0.25 * 3.0);
    line.set_dead_time(2.25);
    assert_eq!(line.area(), 0.5 * 0.0 + 0.5 * 4.0 + 1.25 * 3.0);
}

#[test]
fn a_sample_longer_than_the_dead_time_is_exact_too() {
    let mut line = line(20, 0.5);
    assert_eq!(line.advance(1.0, 4.0), 3.5);
    assert_eq!(line.advance(2.0, 1.0), 0.5 + 1.0);
    assert_eq!(line.area(), 1.0);
}
