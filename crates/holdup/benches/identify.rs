//! Identification: `cargo bench -p holdup --all-features --bench identify`.

use divan::{Bencher, black_box};
use holdup::model::Seconds;
use holdup::record::Record;
use holdup::record::identify::{greatest_dead_time, point_fit};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn main() {
    divan::main();
}

/// A tank with a valve that moves at random every few rows, and uniform noise.
fn record(rows: u32) -> Record {
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let (mut valve, mut level, mut before) = (50.0, 40.0, [50.0; 8]);
    let (mut time, mut input, mut output) = (Vec::new(), Vec::new(), Vec::new());
    for row in 0..rows {
        if random.random_range(0.0..1.0) < 0.05 {
            valve = random.random_range(40.0..60.0);
        }
        level += 5e-4 * (before[7] - 50.0);
        before.rotate_right(1);
        before[0] = valve;
        time.push(f64::from(row));
        input.push(valve);
        output.push(level + random.random_range(-0.05..0.05));
    }
    Record::new(time, output, input).expect("a record")
}

/// The point fit: gain and dead time, the dead time found globally up to the default limit.
#[divan::bench(args = [10_000, 1_000_000])]
fn point_fit_of_rows(bencher: Bencher, rows: u32) {
    let record = record(rows);
    let greatest = Seconds(greatest_dead_time(&record));
    bencher.bench_local(|| point_fit(black_box(&record), greatest));
}
