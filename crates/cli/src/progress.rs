//! Progress of what takes longer than a second, on standard error; and Ctrl-C, which ends it early.

use std::io::{IsTerminal, stderr};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// What is quicker than this shows nothing.
const PATIENCE: Duration = Duration::from_secs(1);

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
static HANDLER: OnceLock<bool> = OnceLock::new();

/// A bar on standard error where that is a terminal; nothing elsewhere.
pub(crate) struct Progress {
    bar: ProgressBar,
    started: Instant,
    shown: AtomicBool,
}

impl Progress {
    /// Starts to count towards `total` of what `unit` names.
    pub(crate) fn start(unit: &'static str, total: u64) -> Self {
        // The first Ctrl-C asks for an end, a second one is obeyed at once.
        HANDLER.get_or_init(|| {
            let handler = || {
                if INTERRUPTED.swap(true, Ordering::SeqCst) {
                    std::process::exit(130);
                }
            };
            ctrlc::set_handler(handler).is_ok()
        });
        Self::without_end(unit, total)
    }

    /// The same where Ctrl-C ends the command at once: nothing is written before the last of it is known.
    pub(crate) fn without_end(unit: &'static str, total: u64) -> Self {
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::hidden());
        let template = format!("{{wide_bar}} {{human_pos}} of {{human_len}} {unit}, {{eta}} left");
        if let Ok(style) = ProgressStyle::with_template(&template) {
            bar.set_style(style);
        }
        Self { bar, started: Instant::now(), shown: AtomicBool::new(false) }
    }

    /// Counts.
    pub(crate) fn add(&self, count: u64) {
        if self.started.elapsed() > PATIENCE
            && stderr().is_terminal()
            && !self.shown.swap(true, Ordering::Relaxed)
        {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.inc(count);
    }

    /// Whether Ctrl-C was pressed.
    #[expect(clippy::unused_self, reason = "only someone who shows progress asks")]
    pub(crate) fn interrupted(&self) -> bool {
        INTERRUPTED.load(Ordering::SeqCst)
    }

    /// Takes the bar away.
    pub(crate) fn end(&self) {
        self.bar.finish_and_clear();
    }
}
