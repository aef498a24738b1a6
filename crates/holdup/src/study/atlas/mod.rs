//! The atlas: every registered rule on the normalised process, with exact figures, and its published values judged.

pub mod markdown;
#[cfg(feature = "report")]
pub mod page;

use crate::model::Radians;
use crate::tuning::ranking::{ORDERS, Ranked, normalised, rank};
use crate::tuning::{Applies, Entry, Judgement, rules};

/// One rule of the atlas.
#[derive(Debug, Clone)]
pub struct AtlasRule {
    /// The rule.
    pub entry: &'static Entry,
    /// What it achieves on the normalised process, or why its defaults give no controller.
    pub figures: Result<Box<Ranked>, String>,
    /// Its published values, judged.
    pub published: Vec<Judgement>,
}

/// The rules of the atlas in the order of their identifiers.
#[derive(Debug, Clone)]
pub struct Atlas {
    /// The rules.
    pub rules: Vec<AtlasRule>,
}

impl Atlas {
    /// The atlas of these rules.
    ///
    /// ```
    /// use holdup::study::atlas::Atlas;
    /// let atlas = Atlas::of(|entry| entry.id == "pi-simc");
    /// let simc = atlas.rules[0].figures.as_ref().unwrap();
    /// assert!((simc.achieved.sensitivity_peak.unwrap() - 1.70352).abs() < 5e-6);
    /// ```
    pub fn of(wanted: impl Fn(&Entry) -> bool) -> Self {
        let mut figures: Vec<(&'static str, Result<Box<Ranked>, String>)> = Vec::new();
        for applies in Applies::ALL {
            let ranking = rank(&normalised(applies), &ORDERS[0], &wanted);
            figures.extend(ranking.rules.into_iter().map(|rule| (rule.entry.id, Ok(Box::new(rule)))));
            figures.extend(ranking.left_out.into_iter().map(|(id, why)| (id, Err(why))));
        }
        let rules = rules().iter().copied().filter_map(|entry| {
            let index = figures.iter().position(|(id, _)| *id == entry.id)?;
            let (_, figures) = figures.swap_remove(index);
            // A test of the registry keeps every values file valid.
            Some(AtlasRule { entry, figures, published: entry.judge().unwrap_or_default() })
        });
        Self { rules: rules.collect() }
    }
}

impl AtlasRule {
    /// The exact figures as text, in the order of [`FIGURES`]; `–` is infinite or absent.
    fn figures(&self) -> Vec<String> {
        let Ok(rule) = &self.figures else { return vec!["–".to_owned(); FIGURES.len()] };
        let achieved = &rule.achieved;
        vec![
            digits(rule.load_iae()),
            digits(rule.load_percent()),
            digits(rule.setpoint_iae()),
            digits(rule.setpoint_percent()),
            if achieved.stable { digits(achieved.sensitivity_peak) } else { "unstable".to_owned() },
            digits(achieved.gain_margin),
            digits(achieved.phase_margin.map(Radians::degrees)),
            digits(achieved.delay_margin.map(|time| time.0)),
            digits(rule.noise_gain),
        ]
    }

    /// How many published values are reproduced.
    fn verdict(&self) -> String {
        let reproduced = self.published.iter().filter(|value| value.reproduced).count();
        match (self.published.len(), reproduced) {
            (0, _) => "none printed".to_owned(),
            (all, good) if all == good => format!("{all} reproduced"),
            (all, good) => format!("{good} of {all} reproduced"),
        }
    }
}

/// The headings of the exact figures.
const FIGURES: [&str; 9] = [
    "load IAE",
    "load %",
    "step IAE",
    "step %",
    "M_s",
    "gain margin",
    "phase margin [°]",
    "delay margin [s]",
    "noise gain",
];

/// The process of a table, in words.
fn process_words(applies: Applies) -> &'static str {
    match applies {
        Applies::Integrating => "Integrating: K = 1, d = 1 s",
        Applies::IntegratingWithLag => "Integrating with lag: K = 1, d = 1 s, T = 1 s",
        Applies::DoubleIntegrating => "Double integrating: K = 1, d = 1 s",
    }
}

/// A number to four significant digits.
fn digits(value: Option<f64>) -> String {
    let Some(value) = value.filter(|value| value.is_finite()) else { return "–".to_owned() };
    let scientific = format!("{value:.3e}");
    let exponent: i32 = scientific.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    match exponent {
        _ if value == 0.0 => "0".to_owned(),
        -3..=5 => format!("{value:.*}", usize::try_from(3 - exponent).unwrap_or(0)),
        _ => scientific,
    }
}
