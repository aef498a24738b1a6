//! What is put into a signal is found in it, and what is not is not.

#![expect(clippy::unwrap_used, clippy::cast_precision_loss, reason = "helpers of tests")]

use holdup::record::{CompressionKind, Operation, Record, Shape, Survey};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

const ROWS: usize = 1200;
const PERIOD: f64 = 5.0;

/// Numbers of mean 0 and variance 1: twelve uniform ones, less six.
fn normal(seed: u64) -> impl FnMut() -> f64 {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    move || (0..12).map(|_| f64::from(random.next_u32()) / f64::from(u32::MAX)).sum::<f64>() - 6.0
}

fn times() -> Vec<f64> {
    (0..ROWS).map(|row| row as f64 * PERIOD).collect()
}

/// A level with this movement and white noise of size 0.1, under a valve that moves a little all the time.
fn level(of: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut noise = normal(3);
    times().iter().map(|time| 50.0 + of(*time) + 0.1 * noise()).collect()
}

fn valve() -> Vec<f64> {
    let mut noise = normal(4);
    (0..ROWS).map(|_| 30.0 + noise()).collect()
}

fn survey(level: Vec<f64>, valve: Vec<f64>) -> Survey {
    Survey::of(&Record::new(times(), level, valve).unwrap())
}

#[test]
fn a_healthy_signal_shows_nothing_but_its_noise() {
    let found = survey(level(|_| 0.0), valve()).controlled_variable;
    let noise = found.noise.unwrap();
    // 1200 rows: the inner 68 % scatter by 3 %, the autocorrelation by 0.06.
    assert!((noise.standard_deviation / 0.1 - 1.0).abs() < 0.12 && !noise.is_bound, "{noise:?}");
    assert!(noise.lag_1_autocorrelation.unwrap().abs() < 0.15, "{noise:?}");
    assert!(found.flat.is_empty() && found.limits.is_empty() && found.spikes.is_empty(), "{found:?}");
    assert_eq!((found.quantisation, found.compression, found.oscillation), (None, None, None));
    assert!(!found.is_constant);
}

#[test]
fn a_converter_is_found_with_its_quantum() {
    let quantum = 0.037;
    let values = level(|time| 3.0 * (time * 0.002).sin())
        .iter()
        .map(|value| (value / quantum).round() * quantum)
        .collect();
    let found = survey(values, valve()).controlled_variable;
    // All distances are multiples to rounding.
    assert!((found.quantisation.unwrap().quantum - quantum).abs() < 1e-9, "{:?}", found.quantisation);
    assert_eq!(found.compression, None);
}

#[test]
fn a_historian_is_found_by_what_it_left() {
    let raw = level(|time| 2.0 * (time * 0.003).sin());
    // A point of every six is archived.
    let archived = |row: usize| raw[row / 6 * 6];
    let held = (0..ROWS).map(archived).collect();
    let lines = (0..ROWS)
        .map(|row| {
            let (before, after) = (archived(row), raw[(row / 6 * 6 + 6).min(ROWS - 1)]);
            before + (after - before) * (row % 6) as f64 / 6.0
        })
        .collect();
    for (values, kind) in [(held, CompressionKind::Held), (lines, CompressionKind::Interpolated)] {
        let found = survey(values, valve()).controlled_variable.compression.unwrap();
        assert_eq!(found.kind, kind);
        // Five of six rows; a neighbour of a point is never on a line.
        assert!((0.6..=0.85).contains(&found.share), "{found:?}");
    }
    // Exception reporting: a row for each move of 0.3 or more.
    let (mut time, mut values) = (vec![0.0], vec![raw[0]]);
    for row in 1..ROWS {
        if (raw[row] - values[values.len() - 1]).abs() >= 0.3 {
            time.push(row as f64 * PERIOD);
            values.push(raw[row]);
        }
    }
    let count = time.len();
    let record = Record::new(time, values, valve()[..count].to_vec()).unwrap();
    let found = Survey::of(&record).controlled_variable.compression.unwrap();
    assert_eq!(found.kind, CompressionKind::OnChange, "{found:?}");
}

#[test]
fn dead_stretches_limits_and_spikes_are_found_where_they_are() {
    let mut values = level(|time| 3.0 * (time * 0.004).sin());
    values[400..460].fill(49.123);
    values[900] += 9.0;
    let found = survey(values, valve()).controlled_variable;
    assert_eq!(found.flat.iter().map(|span| (span.from, span.to)).collect::<Vec<_>>(), [(400, 459)]);
    assert_eq!(found.spikes, [900]);
    assert_eq!(found.limits, []);
    let clipped: Vec<f64> =
        level(|time| 3.0 * (time * 0.004).sin()).iter().map(|value| value.min(52.0)).collect();
    let found = survey(clipped, valve());
    let limits = &found.controlled_variable.limits;
    assert_eq!((limits.len(), limits[0].value, limits[0].is_high), (1, 52.0, true));
    assert!(limits[0].spans.iter().all(|span| span.value == 52.0) && limits[0].share > 0.1, "{limits:?}");
    let inside = |row: usize| (found.window.from..found.window.to).contains(&row);
    assert!(limits[0].spans.iter().all(|span| !inside(span.from)), "{:?}", found.window);
}

#[test]
fn a_level_at_rest_without_noise_is_neither_dead_nor_at_a_limit_nor_archived() {
    // At rest, then driven by a pulse with a dead time of ten rows, then at rest again where it began.
    let valve: Vec<f64> = (0..ROWS)
        .map(|row| if (300..600).contains(&row) { (row as f64 * 0.05).sin() } else { 0.0 })
        .collect();
    let mut level = vec![0.0; ROWS];
    for row in 11..ROWS {
        level[row] = 0.98 * level[row - 1] + 0.01 * valve[row - 11];
        if row > 900 {
            level[row] = 0.0;
        }
    }
    let found = survey(level, valve);
    let signal = &found.controlled_variable;
    assert_eq!(
        (signal.flat.len(), signal.limits.len(), signal.compression.as_ref()),
        (0, 0, None),
        "{signal:?}"
    );
    assert_eq!((found.window.from, found.window.to), (0, ROWS));
}

#[test]
fn a_constant_says_so_and_an_empty_one_tells_nothing() {
    let found = survey(level(|_| 0.0), vec![40.0; ROWS]);
    assert!(found.manipulated_variable.is_constant);
    assert!(found.window.reason.contains("does not move"), "{}", found.window.reason);
}

#[test]
fn an_oscillation_is_found_with_period_amplitude_and_shape() {
    let triangle = |phase: f64| 4.0 * (phase - (phase + 0.5).floor()).abs() - 1.0;
    for period in [60.0, 143.0, 700.0] {
        for (shape, of) in [
            (
                Shape::Sinusoidal,
                Box::new(move |phase: f64| (phase * std::f64::consts::TAU).sin()) as Box<dyn Fn(f64) -> f64>,
            ),
            (Shape::Triangular, Box::new(triangle)),
            (Shape::Square, Box::new(|phase: f64| if phase.fract() < 0.5 { 1.0 } else { -1.0 })),
        ] {
            if shape != Shape::Sinusoidal && period < 100.0 {
                // Twelve rows a cycle do not show a shape.
                continue;
            }
            let values = level(|time| 2.0 * of(time / period) + 0.0005 * time);
            let found = survey(values, valve()).controlled_variable.oscillation.unwrap();
            assert!((found.period_s / period - 1.0).abs() < 0.01, "{period} {shape:?}: {found:?}");
            assert!((found.amplitude / 2.0 - 1.0).abs() < 0.15, "{period} {shape:?}: {found:?}");
            assert!(found.regularity > 1.0 && found.strength > 0.7, "{found:?}");
            assert_eq!(found.shape, shape, "{period}: {found:?}");
        }
    }
}

#[test]
fn noise_and_drift_are_no_oscillation() {
    let mut seen = 0;
    for seed in 0..60 {
        let mut noise = normal(100 + seed);
        let rho = [0.0, 0.9, 1.0][usize::try_from(seed % 3).unwrap()];
        let mut state = 0.0;
        let values = (0..ROWS)
            .map(|_| {
                state = rho * state + noise();
                state
            })
            .collect();
        seen += usize::from(survey(values, valve()).controlled_variable.oscillation.is_some());
    }
    // Three means are tried besides the signal itself, each at a level of about one in a hundred.
    assert!(seen <= 3, "{seen} of 60");
}

#[test]
fn switches_moves_and_steps_are_listed() {
    let operation = (0..ROWS)
        .map(|row| if (300..500).contains(&row) { Operation::Manual } else { Operation::Automatic })
        .collect();
    let setpoint = (0..ROWS).map(|row| match row {
        0..=699 => 50.0,
        700..=709 => 50.0 + 0.1 * (row - 699) as f64,
        _ => 51.0,
    });
    let mut output = valve();
    for value in &mut output[350..] {
        *value += 15.0;
    }
    let record = Record::new(times(), level(|_| 0.0), output).unwrap();
    let record = record.with_setpoint(setpoint.collect()).unwrap().with_operation(operation).unwrap();
    let found = Survey::of(&record);
    let shares = found.operation.as_ref().unwrap();
    let switches: Vec<(usize, bool)> =
        shares.switches.iter().map(|one| (one.row, one.to_automatic)).collect();
    assert_eq!(switches, [(300, false), (500, true)]);
    assert_eq!(shares.manual, 200.0 / 1200.0);
    assert_eq!(found.setpoint_moves.len(), 1);
    let step = found.setpoint_moves[0];
    assert_eq!((step.row, step.from, step.to, step.takes_s), (700, 50.0, 51.0, 9.0 * PERIOD));
    assert_eq!(found.output_steps.iter().map(|step| step.row).collect::<Vec<_>>(), [350]);
    assert!(
        found.window.reason.contains("one setpoint move, one output step, 2 switches of mode"),
        "{}",
        found.window.reason
    );
    assert!(found.text().lines().all(|line| line.chars().count() <= 80), "{}", found.text());
}

#[test]
fn gaps_cut_the_record_and_the_livelier_part_is_proposed() {
    let mut time = times();
    for (row, time) in time.iter_mut().enumerate() {
        *time += if row >= 800 { 4000.0 } else { 0.0 } + if row >= 1000 { 900.0 } else { 0.0 };
    }
    let mut output = valve();
    for (row, value) in output.iter_mut().enumerate() {
        *value += if (900..950).contains(&row) { 40.0 } else { 0.0 };
    }
    let found = Survey::of(&Record::new(time, level(|_| 0.0), output).unwrap());
    assert_eq!(found.sampling.period_s, PERIOD);
    assert_eq!(found.sampling.gaps.iter().map(|gap| gap.after).collect::<Vec<_>>(), [799, 999]);
    assert_eq!((found.window.from, found.window.to), (800, 1000));
    assert!(
        found.window.reason.contains("2 gaps") && found.window.reason.contains("2 output steps"),
        "{}",
        found.window.reason
    );
}

#[test]
fn any_record_of_three_rows_has_a_survey() {
    for values in [[0.0, 0.0, 0.0], [1e300, -1e300, 1e300], [0.0, 1e-300, 2e-300]] {
        let record = Record::new(vec![0.0, 1e-9, 1e9], values.to_vec(), values.to_vec()).unwrap();
        let found = Survey::of(&record);
        assert_eq!((found.window.from, found.window.to), (0, 3));
        assert!(found.text().lines().all(|line| line.chars().count() <= 80), "{}", found.text());
    }
}
