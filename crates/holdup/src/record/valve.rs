//! Whether the valve follows its signal: valves that do not, beside one that does.
//!
//! A valve that sticks, has play or moves in steps is not a load: where it stands follows from the controller's output
//! alone. Its position by such a model takes the place of the output in the fit, and where the rows then leave much less,
//! the valve is what is wrong, whatever the shape of a cycle. The models have one number each: stiction with as much jump as
//! stick (M. Kano, H. Maruta, H. Kugemoto and K. Shimizu, IFAC DYCOPS 2004), play, and steps.

use super::Record;
use super::identify::{Joint, Noise, Problem, Whitened, Whitener, dot, with_noise};
use super::wording::three;

/// Sizes that are tried: from a hundredth to half of the output's range, each so much above the one before. Jumps that fall into
/// other rows cost more than a wrong load, so that a size a few percent off explains nothing.
const LEAST_SHARE: f64 = 0.01;
const RATIO: f64 = 1.015;
const SIZES: i32 = 260;

/// Rows beyond which the search would take seconds.
const MOST_ROWS: usize = 50_000;

/// Schwarz's criterion must fall by so much for each row, and by so much in all: what is no noise, like a cycle from
/// outside, makes any freedom look useful.
const EVIDENCE_OF_ROW: f64 = 0.08;
const EVIDENCE: f64 = 40.0;

/// Share of the noise's slow parts that may be the valve's doing.
const SLOW: f64 = 0.05;

/// How a valve fails to follow.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Fault {
    Sticks,
    Play,
    /// Steps from 0, or from so large a share of one.
    Steps(f64),
}

impl Fault {
    /// Position of the valve in each row.
    fn position(self, output: &[f64], size: f64) -> Vec<f64> {
        let mut position = output[0];
        let mut follow = |wanted: f64| {
            match self {
                Self::Sticks => {
                    if (wanted - position).abs() >= size {
                        position = wanted;
                    }
                }
                Self::Play => position = position.clamp(wanted - size / 2.0, wanted + size / 2.0),
                Self::Steps(share) => position = ((wanted / size - share).round() + share) * size,
            }
            position
        };
        output.iter().map(|wanted| follow(*wanted)).collect()
    }

    fn text(self) -> &'static str {
        match self {
            Self::Sticks => "stands until its signal is about",
            Self::Play => "has a play of about",
            Self::Steps(_) => "moves in steps of about",
        }
    }
}

/// What is found where a valve does not follow, as a sentence.
///
/// What a wandering load explains of it under an ideal valve would hide it, so that sizes are compared with little such load;
/// the best then has its own noise estimated, and that likelihood counts.
pub(crate) fn fault(record: &Record, problem: &Problem<'_>, joint: &Joint) -> Option<String> {
    let output = record.manipulated_variable();
    if output.len() > MOST_ROWS {
        return None;
    }
    let [low, high] = output
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| [low.min(value), high.max(value)]);
    let (fit, noise) = (&joint.fit, &joint.noise);
    let quiet = Noise {
        white: noise.white.hypot(SLOW * noise.coloured).max(SLOW * noise.walk * problem.step().sqrt()),
        coloured: 0.0,
        walk: SLOW * noise.walk,
        wander: SLOW * noise.wander,
        ..*noise
    };
    let whitener = Whitener::new(&quiet, &problem.times);
    let (basis, response) = Whitened::new(problem, &whitener, fit.kind).rest(fit.lag);
    let shape = fit.kind.shape(fit.lag);
    let mut best: Option<(f64, Fault, f64)> = None;
    let steps = [0.0, 0.25, 0.5, 0.75].map(Fault::Steps);
    for fault in [Fault::Sticks, Fault::Play].into_iter().chain(steps) {
        let mut size = LEAST_SHARE * (high - low);
        // What the position explains: the most is the best.
        let mut most: Option<(f64, f64)> = None;
        for _ in 0..SIZES {
            let column = problem.column_of(record, &fault.position(output, size), shape, fit.dead_time);
            let column = basis.projected(whitener.whiten(column));
            let with = dot(&column, &response);
            let explained = with * with / dot(&column, &column);
            if with * fit.gain > 0.0 && most.is_none_or(|(most, _)| explained > most) {
                most = Some((explained, size));
            }
            size *= RATIO;
        }
        let Some((_, size)) = most else { continue };
        let moved = problem.with_input(record, &fault.position(output, size));
        let likelihood = with_noise(&moved, *fit, None).likelihood;
        if best.is_none_or(|(most, ..)| likelihood > most) {
            best = Some((likelihood, fault, size));
        }
    }
    let (likelihood, fault, size) = best?;
    #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
    let rows = problem.len() as f64;
    let evidence = 2.0 * (likelihood - joint.likelihood) - rows.ln();
    (evidence > EVIDENCE.max(EVIDENCE_OF_ROW * rows)).then(|| {
        let off = if fault == Fault::Sticks { " away, and jumps" } else { "" };
        format!(
            "the valve {} {}{off}: with that the model explains the rows better than with a valve that follows (Schwarz's \
             criterion lower by {evidence:.0}), so that neither tuning nor load explains them: check the valve (stroke it in \
             manual by small steps) before tuning",
            fault.text(),
            three(size),
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_fault_follows_in_its_own_way() {
        let output = [0.0, 0.4, 1.25, 1.5, 0.9, -0.2];
        assert_eq!(Fault::Sticks.position(&output, 1.0), [0.0, 0.0, 1.25, 1.25, 1.25, -0.2]);
        assert_eq!(Fault::Play.position(&output, 1.0), [0.0, 0.0, 0.75, 1.0, 1.0, 0.3]);
        assert_eq!(Fault::Steps(0.0).position(&output, 1.0), [0.0, 0.0, 1.0, 2.0, 1.0, 0.0]);
    }
}
