//! What the historian did to the controlled variable, as far as it is above the noise.

use crate::record::identify::Noise;
use crate::record::wording::three;
use crate::record::{CompressionKind, Record, Survey};

/// The typical step from one archived point to the next, where rows between them lie on straight lines: an archive keeps a
/// point when it is farther off than its band, so that the band is not wider.
fn archived_step(record: &Record) -> f64 {
    let (time, values) = (record.time(), record.controlled_variable());
    let slope = |k: usize| (values[k + 1] - values[k]) / (time[k + 1] - time[k]);
    let bends = |k: &usize| {
        let (before, after) = (slope(k - 1), slope(*k));
        (after - before).abs() > 1e-6 * before.abs().max(after.abs())
    };
    let corners: Vec<f64> = (1..values.len() - 1).filter(bends).map(|k| values[k]).collect();
    let mut steps: Vec<f64> = corners.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    if steps.is_empty() {
        return 0.0;
    }
    let middle = steps.len() / 2;
    *steps.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// How far single rows are from the truth by what the historian did, where that is above the noise.
pub(super) fn resolution(record: &Record, survey: &Survey, noise: &Noise) -> (f64, Option<String>) {
    let signal = &survey.controlled_variable;
    let spread = noise.white.hypot(noise.coloured);
    if let Some(compression) = &signal.compression
        && compression.kind != CompressionKind::OnChange
        && compression.share > 0.1
    {
        let text = format!("the controlled variable was compressed ({})", compression.evidence);
        return (spread.max(archived_step(record)), Some(text));
    }
    match &signal.quantisation {
        Some(quantisation) if quantisation.quantum > spread => {
            let text = format!(
                "the controlled variable is rounded to {}, more than the noise",
                three(quantisation.quantum)
            );
            (quantisation.quantum / 4.0, Some(text))
        }
        _ => (0.0, None),
    }
}
