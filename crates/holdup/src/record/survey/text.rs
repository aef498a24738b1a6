//! The summary for a terminal.

use std::fmt::Write as _;

use super::signal::{Limit, Signal, Span};
use super::{CompressionKind, Shape, Survey};

/// Width of the text.
const WIDTH: usize = 80;

/// Entries of a list; more are counted.
const LISTED: usize = 5;

impl Survey {
    /// The summary as lines of at most 80 columns.
    ///
    /// ```
    /// use holdup::record::{Record, Survey};
    ///
    /// let record = Record::new(vec![0.0, 1.0, 2.0], vec![4.0, 4.1, 4.2], vec![50.0, 50.0, 60.0])?;
    /// assert!(Survey::of(&record).text().lines().all(|line| line.chars().count() <= 80));
    /// # Ok::<(), holdup::record::RecordError>(())
    /// ```
    #[must_use]
    pub fn text(&self) -> String {
        let mut page = Page::default();
        let sampling = &self.sampling;
        let mut rows =
            format!("{} over {}, every {}", self.rows, span(self.duration_s), span(sampling.period_s));
        if sampling.irregular_share > 0.0 {
            let (shortest, longest) = (span(sampling.shortest_s), span(sampling.longest_s));
            _ = write!(
                rows,
                " ({:.1} % of the steps differ: {shortest} to {longest})",
                100.0 * sampling.irregular_share
            );
        }
        page.entry("rows", &rows);
        let gaps: Vec<String> = sampling
            .gaps
            .iter()
            .map(|gap| format!("{} after {} s", span(gap.length_s), short(gap.from_s)))
            .collect();
        page.list("gaps", &gaps);
        if let Some(operation) = &self.operation {
            let mut text = format!(
                "{:.0} % automatic, {:.0} % manual",
                100.0 * operation.automatic,
                100.0 * operation.manual
            );
            if operation.unknown > 0.0 {
                _ = write!(text, ", {:.0} % unknown", 100.0 * operation.unknown);
            }
            page.entry("mode", &text);
            let switches: Vec<String> = operation
                .switches
                .iter()
                .map(|one| {
                    format!(
                        "{} at {} s",
                        if one.to_automatic { "automatic" } else { "manual" },
                        short(one.at_s)
                    )
                })
                .collect();
            page.list("switches", &switches);
        }
        let moves = |moves: &[super::Move]| -> Vec<String> {
            moves
                .iter()
                .map(|one| format!("{} → {} at {} s", short(one.from), short(one.to), short(one.at_s)))
                .collect()
        };
        if self.setpoint_follows {
            page.entry("setpoint", "moves all the time");
        } else if let Some(setpoint) = &self.setpoint {
            let constant = if setpoint.is_constant {
                format!("{} throughout", short(setpoint.least))
            } else {
                String::new()
            };
            if constant.is_empty() {
                page.list("setpoint", &moves(&self.setpoint_moves));
            } else {
                page.entry("setpoint", &constant);
            }
        }
        page.list("output steps", &moves(&self.output_steps));
        page.signal("controlled variable", &self.controlled_variable);
        page.signal("manipulated variable", &self.manipulated_variable);
        let window = &self.window;
        page.heading("proposed window");
        let ends = format!(
            "{} s to {} s, rows {} to {}",
            short(window.from_s),
            short(window.to_s),
            window.from + 1,
            window.to
        );
        page.entry("window", &ends);
        page.entry("because", &window.reason);
        page.text
    }
}

/// A text that grows line by line.
#[derive(Default)]
struct Page {
    text: String,
}

impl Page {
    fn heading(&mut self, title: &str) {
        self.text += "\n";
        self.text += title;
        self.text += "\n";
    }

    /// A word and what is to be said of it, folded.
    fn entry(&mut self, word: &str, said: &str) {
        const NAME: usize = 14;
        let mut line = format!("  {word:<NAME$}");
        let mut used = line.chars().count();
        let indent = " ".repeat(NAME + 2);
        let mut first = true;
        for piece in said.split_whitespace() {
            let width = piece.chars().count();
            if !first && used + 1 + width > WIDTH {
                self.text += line.trim_end();
                self.text += "\n";
                line.clone_from(&indent);
                used = NAME + 2;
                first = true;
            }
            if !first {
                line.push(' ');
                used += 1;
            }
            line += piece;
            used += width;
            first = false;
        }
        self.text += line.trim_end();
        self.text += "\n";
    }

    fn list(&mut self, word: &str, entries: &[String]) {
        if entries.is_empty() {
            return;
        }
        let shown = entries.iter().take(LISTED).cloned().collect::<Vec<_>>().join(", ");
        let more = entries.len().saturating_sub(LISTED);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        self.entry(word, &format!("{shown}{more}"));
    }

    fn signal(&mut self, name: &str, signal: &Signal) {
        self.heading(name);
        if signal.is_constant {
            self.entry("constant", &format!("{} throughout: it tells nothing", short(signal.least)));
            return;
        }
        self.entry("range", &format!("{} to {}", short(signal.least), short(signal.greatest)));
        if let Some(noise) = signal.noise {
            let text = match noise.lag_1_autocorrelation {
                Some(rho) => format!(
                    "standard deviation {}, autocorrelation from row to row {rho:.2}",
                    short(noise.standard_deviation)
                ),
                None => format!(
                    "at most {} (standard deviation): the signal is too smooth to tell",
                    short(noise.standard_deviation)
                ),
            };
            self.entry("noise", &text);
        }
        if let Some(steps) = signal.quantisation {
            let beside = signal.noise.map(|noise| steps.quantum / noise.standard_deviation);
            let coarse = match beside {
                Some(ratio) if ratio > 1.0 => format!(": coarse, {ratio:.1} times the noise"),
                Some(ratio) if ratio > 0.2 => format!(": {ratio:.2} times the noise"),
                _ => String::new(),
            };
            self.entry("quantum", &format!("{}, {} levels{coarse}", short(steps.quantum), steps.levels));
        }
        if let Some(found) = &signal.compression {
            let kind = match found.kind {
                CompressionKind::Interpolated => "straight lines between archived points",
                CompressionKind::Held => "archived points are held",
                CompressionKind::OnChange => "archived on change",
            };
            self.entry("compression", &format!("{kind}: {}", found.evidence));
        }
        let spans = |spans: &[Span]| -> Vec<String> {
            spans.iter().map(|span| format!("{} s to {} s", short(span.from_s), short(span.to_s))).collect()
        };
        let dead: Vec<String> = signal
            .flat
            .iter()
            .zip(spans(&signal.flat))
            .map(|(own, span)| format!("{span} at {}", short(own.value)))
            .collect();
        self.list("dead", &dead);
        for Limit { value, is_high, share, spans: own } in &signal.limits {
            let end = if *is_high { "upper" } else { "lower" };
            let text = format!(
                "{:.0} % of the rows at the {end} end, {}, first {}",
                100.0 * share,
                short(*value),
                spans(own)[0]
            );
            self.entry("limit", &text);
        }
        if !signal.spikes.is_empty() {
            let rows: Vec<String> = signal.spikes.iter().map(|row| format!("row {}", row + 1)).collect();
            self.list("spikes", &rows);
        }
        if let Some(found) = signal.oscillation {
            let shape = match found.shape {
                Shape::Sinusoidal => "sinusoidal",
                Shape::Triangular => "triangular",
                Shape::Square => "square",
            };
            let text = format!(
                "period {} ± {}, amplitude {}, {shape}, {:.1} cycles (regularity {:.1}, strength {:.2})",
                span(found.period_s),
                span(found.period_deviation_s),
                short(found.amplitude),
                found.cycles,
                found.regularity,
                found.strength
            );
            self.entry("oscillation", &text);
        }
    }
}

/// A number of four digits for reading.
fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-3..1e7).contains(&size) {
        return format!("{value:.3e}");
    }
    let decimals = match size {
        size if size >= 1000.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        size if size >= 1.0 => 3,
        _ => 4,
    };
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// A length of time for reading.
fn span(seconds: f64) -> String {
    match seconds {
        seconds if seconds < 600.0 => format!("{} s", short(seconds)),
        seconds if seconds < 36_000.0 => format!("{} min", short(seconds / 60.0)),
        seconds if seconds < 864_000.0 => format!("{} h", short(seconds / 3600.0)),
        seconds => format!("{} d", short(seconds / 86_400.0)),
    }
}
