//! The fits of all kinds to a record, and the choice among them.

use super::LEAST_ROWS;
use crate::record::Record;
use crate::record::advice::{SafeTest, safe_test};
use crate::record::confidence::{Profile, inflations};
use crate::record::excitation::Excitation;
use crate::record::identification::{FitQuality, IdentifiedProcess, IdentifyOptions};
use crate::record::identify::{
    Joint, Kind, MOST_LOAD_STEPS, Noise, Problem, Stepped, Whitened, exact, generalised, greatest_dead_time,
    joint, starting_noises, with_load_steps,
};

/// Rows above which neighbours are taken together.
const MOST_ROWS: usize = 3000;

/// Another kind than the plain integrator must be better by so much of Schwarz's criterion.
const EVIDENCE: f64 = 6.0;

/// A kind counts only if its gain is so many variances from 0.
const ACTS: f64 = 16.0;

/// The fits of all kinds, the chosen first.
pub(super) struct Found<'r> {
    pub(super) problem: Problem<'r>,
    pub(super) joint: Joint,
    pub(super) candidates: Vec<(Joint, f64)>,
    pub(super) choice: String,
    pub(super) greatest: f64,
    pub(super) step: f64,
    pub(super) block: usize,
}

impl<'r> Found<'r> {
    pub(super) fn of(record: &'r Record, options: &IdentifyOptions, excitation: &Excitation) -> Option<Self> {
        let time = record.time();
        #[expect(clippy::cast_precision_loss, reason = "a number of rows")]
        let step = (time[time.len() - 1] - time[0]) / (time.len() - 1) as f64;
        let mut greatest = options.greatest_dead_time.unwrap_or_else(|| greatest_dead_time(record));
        let rest = at_rest(record, excitation.closed_loop);
        let mut block = record.len().div_ceil(MOST_ROWS);
        let of = |greatest: f64, block: usize| {
            let from = if rest { 0 } else { time.partition_point(|t| t - time[0] < greatest) };
            let from = from.min(record.len() - LEAST_ROWS / 2);
            Problem::new(record, from, block, options.hold, options.load)
        };
        let mut problem = of(greatest, block);
        let first = options.kind.unwrap_or(Kind::Integrating);
        let mut plain = joint(&problem, first, step, greatest, &starting_noises(problem.step()))?;
        if !rest && options.greatest_dead_time.is_none() {
            // What a long dead time would need of the record's start is free once the dead time is known to be short.
            let inflation = inflations(&problem, &plain, 0.0);
            let whitener = plain.whitener(&problem);
            let whitened = Whitened::new(&problem, &whitener, first);
            let ends = Profile::new(&whitened, &plain, greatest, inflation).confidence().dead_time;
            let shorter = (1.5 * ends[1] + 5.0 * step).min(greatest);
            if shorter < 0.8 * greatest {
                greatest = shorter;
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "from 1 to some thousand"
                )]
                let most = (shorter / step / 4.0).floor().max(1.0) as usize;
                block = block.min(most);
                problem = of(greatest, block);
                plain = joint(&problem, first, step, greatest, &[plain.noise, Noise::WHITE])?;
            }
        }
        let mut candidates = vec![plain];
        if options.kind.is_none() && !exact(&problem, &plain.fit) {
            for kind in &Kind::ALL[1..] {
                candidates.extend(joint(&problem, *kind, step, greatest, &[plain.noise, Noise::WHITE]));
            }
        }
        // A working loop has K·Kc > 0, so a candidate of the other sign is none.
        let sign = excitation.sign * f64::from(u8::from(excitation.closed_loop));
        candidates.retain(|joint| joint.fit.kind == first || sign * joint.fit.gain >= 0.0);
        let (mut candidates, mut choice) = choose(&problem, &candidates);
        let most = options.load_steps.unwrap_or(MOST_LOAD_STEPS);
        if most > 0
            && excitation.any()
            && !exact(&problem, &candidates[0].0.fit)
            && let Some(stepped) = stepped(&problem, &candidates, first, step, greatest, most)
        {
            problem = stepped.problem;
            let found = stepped.joint;
            let others = |(joint, _): &&(Joint, f64)| joint.fit.kind != found.fit.kind;
            let starts = [found.noise, Noise::WHITE];
            let again = candidates
                .iter()
                .filter(others)
                .filter_map(|(other, _)| joint(&problem, other.fit.kind, step, greatest, &starts));
            let mut all: Vec<Joint> = again.chain([found]).collect();
            // The plain kind in front, as `choose` has it.
            all.sort_by_key(|joint| joint.fit.kind != first);
            all.retain(|joint| joint.fit.kind == first || sign * joint.fit.gain >= 0.0);
            (candidates, choice) = choose(&problem, &all);
        }
        Some(Self { joint: candidates[0].0, problem, candidates, choice, greatest, step, block })
    }

    pub(super) fn test(&self, record: &Record, options: &IdentifyOptions) -> Option<SafeTest> {
        let values = record.controlled_variable();
        let [low, high] = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], &value| {
            [low.min(value), high.max(value)]
        });
        safe_test(&self.joint, self.step, options.excursion.unwrap_or((high - low) / 2.0))
    }
}

/// The steps of the load beside the chosen kind, or beside the plain one where they make that the better explanation.
fn stepped<'r>(
    problem: &Problem<'r>,
    candidates: &[(Joint, f64)],
    first: Kind,
    step: f64,
    greatest: f64,
    most: usize,
) -> Option<Stepped<'r>> {
    let chosen = &candidates[0];
    let plain = candidates.iter().find(|(joint, _)| joint.fit.kind == first);
    let plain = plain.filter(|(joint, _)| joint.fit.kind != chosen.0.fit.kind);
    let with = |(joint, _): &(Joint, f64)| with_load_steps(problem, joint, step, greatest, most);
    let cost = |found: &Stepped<'r>| criterion(&found.problem, &found.joint);
    match (with(chosen), plain.and_then(with)) {
        (of_chosen, None) => of_chosen,
        (None, Some(of_plain)) => (cost(&of_plain) < criterion(problem, &chosen.0)).then_some(of_plain),
        (Some(of_chosen), Some(of_plain)) => {
            Some(if cost(&of_plain) < cost(&of_chosen) { of_plain } else { of_chosen })
        }
    }
}

/// Schwarz's criterion: own columns, gain, dead time and lag are paid for; the noise costs all kinds the same.
fn criterion(problem: &Problem<'_>, joint: &Joint) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a number of rows, and a handful")]
    let (rows, own) =
        (problem.len() as f64, problem.own_columns(joint.fit.kind, joint.fit.lag.max(1e-9)).len() as f64);
    let fitted = own + 2.0 + f64::from(u8::from(joint.fit.kind.has_lag()));
    fitted * rows.ln() - 2.0 * joint.likelihood
}

/// Whether the input may be taken as constant before the record: it is at the start, or it is a hand's that seldom moves.
fn at_rest(record: &Record, closed_loop: bool) -> bool {
    let input = record.manipulated_variable();
    let first = input.iter().position(|value| *value != input[0]).unwrap_or(input.len());
    let moves = input.windows(2).filter(|pair| pair[0] != pair[1]).count();
    first >= 4 || (!closed_loop && first >= 2 && 10 * moves < input.len())
}

/// Orders the candidates by Schwarz's criterion, the plain integrator in front unless another is clearly better.
fn choose(problem: &Problem<'_>, joints: &[Joint]) -> (Vec<(Joint, f64)>, String) {
    let mut ranked: Vec<(Joint, f64)> =
        joints.iter().map(|joint| (*joint, criterion(problem, joint))).collect();
    let plain = ranked[0].1;
    // A simulation without noise: the simplest kind that leaves rounding only.
    if let Some(place) = joints.iter().position(|joint| exact(problem, &joint.fit)) {
        ranked.swap(0, place);
        let kind = ranked[0].0.fit.kind;
        return (ranked, format!("{kind}: it leaves rounding only"));
    }
    ranked.sort_by(|a, b| a.1.total_cmp(&b.1));
    let best = ranked[0];
    // A first order so slow that the record does not see it settle is an integrator, a lag below a row is none.
    let real = match best.0.fit.kind {
        Kind::FirstOrder => best.0.fit.lag < 2.0 * problem.span(),
        Kind::IntegratingWithLag => best.0.fit.lag > 0.5 * problem.step(),
        _ => true,
    };
    // Nor is one whose input explains nothing: its noise does the work.
    let acts =
        best.0.fit.gain.powi(2) * best.0.fit.column_squares * best.0.freedom > ACTS * best.0.fit.squares;
    let clearly = plain - best.1 > EVIDENCE && real && acts;
    if !clearly && let Some(place) = ranked.iter().position(|(joint, _)| joint.fit.kind == joints[0].fit.kind)
    {
        let plain = ranked.remove(place);
        ranked.insert(0, plain);
    }
    let chosen = ranked[0];
    for candidate in &mut ranked {
        candidate.1 -= chosen.1;
    }
    let kind = chosen.0.fit.kind;
    let choice = if ranked.len() == 1 {
        format!("{kind}: the only one compared")
    } else if clearly && kind != joints[0].fit.kind {
        format!(
            "{kind}: Schwarz's criterion is lower by {:.0} than for {} (above {EVIDENCE:.0} is clear)",
            plain - best.1,
            joints[0].fit.kind
        )
    } else {
        let next = ranked[1..].iter().map(|(_, criterion)| *criterion).fold(f64::INFINITY, f64::min);
        format!(
            "{kind}: the simplest, and no other is clearly better (Schwarz's criterion of the next: {next:+.0})"
        )
    };
    (ranked, choice)
}

/// The process of a fit.
pub(super) fn process_of(joint: &Joint) -> IdentifiedProcess {
    let fit = &joint.fit;
    IdentifiedProcess {
        kind: fit.kind,
        process_gain: fit.process_gain(),
        dead_time: fit.dead_time,
        lag: fit.kind.has_lag().then_some(fit.lag),
        static_gain: (fit.kind == Kind::FirstOrder).then_some(fit.gain),
    }
}

/// How the fit goes with the record.
pub(super) fn quality(found: &Found<'_>, whitened: &Whitened<'_, '_>) -> FitQuality {
    let Found { problem, joint, .. } = found;
    let fit = &joint.fit;
    // The part of initial state and load by the whitened fit, put back on the rows themselves.
    let own = problem.own_columns(fit.kind, fit.lag);
    let column = problem.column(fit.kind.shape(fit.lag), fit.dead_time);
    let rest: Vec<f64> = problem.response.iter().zip(&column).map(|(y, v)| y - fit.gain * v).collect();
    let smooth = generalised(whitened.whitener, &own, &rest);
    let model: Vec<f64> = smooth.iter().zip(&column).map(|(own, v)| own + fit.gain * v).collect();
    let residual = problem.response.iter().zip(&model).map(|(y, m)| y - m).collect();
    FitQuality {
        rows: problem.len(),
        block_rows: found.block,
        prediction_error: (fit.squares / joint.freedom).sqrt() * whitened.whitener.innovation(),
        noise: joint.noise,
        time: problem.times.clone(),
        model,
        residual,
    }
}
