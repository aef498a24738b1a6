//! The timed part of `bench/run` that is ours, and the peer that is a crate. Prints one line of JSON for each measurement.
//!
//! `cargo run --release -p holdup --example bench -- single | crate | horizon | processes COUNT THREADS |
//! controllers COUNT THREADS | identify FILE`

use std::error::Error;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

mod identification;
mod many;
mod peer;
mod single;
mod work;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["single"] => single::run(),
        ["crate"] => {
            peer::run();
            Ok(())
        }
        ["horizon"] => single::horizon(),
        ["processes", count, threads] => many::processes(count.parse()?, threads.parse()?),
        ["controllers", count, threads] => many::controllers(count.parse()?, threads.parse()?),
        ["identify", file] => identification::run(file),
        _ => Err("usage: single | crate | horizon | processes COUNT THREADS | controllers COUNT THREADS | \
             identify FILE"
            .into()),
    }
}

/// Best time of one call [s]: calls until the time is spent, at least three.
fn best(spend: Duration, mut call: impl FnMut()) -> f64 {
    let begin = Instant::now();
    let mut least = f64::INFINITY;
    let mut calls = 0;
    while calls < 3 || (begin.elapsed() < spend && calls < 100_000) {
        let from = Instant::now();
        call();
        least = least.min(from.elapsed().as_secs_f64());
        calls += 1;
    }
    least
}

/// One measurement: what was done, the time of one unit of it [s], and the numbers that came out.
#[expect(clippy::needless_pass_by_value, reason = "a value made for this line")]
fn report(what: &str, size: u64, seconds: f64, values: Value) {
    println!("{}", json!({ "what": what, "size": size, "seconds": seconds, "values": values }));
}
