//! The controller as source code that runs in the plant: the same law, step for step, in the plant's language.
//!
//! A language is one file beside this one and its line in [`LANGUAGES`]; its text is a template under `templates/`,
//! which reads as the language it is.
//!
//! ```
//! use holdup::deploy::export::{Export, Installation, language};
//! use holdup::model::notation::{read_controller, read_process};
//! use holdup::model::Seconds;
//!
//! let (process, controller) = (read_process("K=0.0506,d=6")?, read_controller("Kc=1.5321,Td=1.0343,Ko=1.5321")?);
//! let mut installation = Installation::sampled(Seconds(0.5));
//! (installation.output_low, installation.output_high) = (Some(0.0), Some(100.0));
//! let export = Export::new("level_d205", &process, &controller, &installation)?;
//! let source = language("c").map(|c| c.write(&export)).unwrap_or_default();
//! assert!(source.contains("level_d205_output level_d205_update("));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod c;
mod error;
mod header;
mod installation;
mod marks;
mod name;
mod plcopen;
mod rust;
mod st;
mod template;

use holdup_control::{Scalar, SettingError, Settings};

use crate::analysis::frequency::{Margins, margins};
use crate::model::{ClosedLoop, Controller, Process, Seconds};

pub use error::ExportError;
pub use installation::{Float, Installation};

/// A language that a controller can be exported to.
#[derive(Debug, Clone, Copy)]
pub struct Language {
    /// What it is called on the command line.
    pub id: &'static str,
    /// What it is.
    pub title: &'static str,
    /// The ending of its files, without the dot.
    pub extension: &'static str,
    write: fn(&Export) -> String,
}

impl Language {
    /// The source, whole: ASCII text that ends with a line feed.
    #[must_use]
    pub fn write(&self, export: &Export) -> String {
        (self.write)(export)
    }
}

/// Every language.
pub const LANGUAGES: [Language; 4] = [rust::LANGUAGE, c::LANGUAGE, st::LANGUAGE, plcopen::LANGUAGE];

/// The language of this identifier.
#[must_use]
pub fn language(id: &str) -> Option<&'static Language> {
    LANGUAGES.iter().find(|language| language.id == id)
}

/// A controller that can be exported: every setting checked, the delay line measured, the loop analysed.
#[derive(Debug, Clone)]
pub struct Export {
    name: String,
    process: Process,
    controller: Controller,
    installation: Installation,
    settings: Settings<f64>,
    needed: usize,
    segments: usize,
    margins: Margins,
}

impl Export {
    /// The controller under this name, on this process, in this installation.
    ///
    /// # Errors
    /// [`ExportError`] with the setting, its value and what is allowed: a name that is none in every language, a sample
    /// period longer than the dead time, a delay line that is too short, limits in the wrong order, a controller that
    /// has no sampled law.
    pub fn new(
        name: &str,
        process: &Process,
        controller: &Controller,
        installation: &Installation,
    ) -> Result<Self, ExportError> {
        let name = name::check(name)?;
        let settings = installation.settings(process, controller)?;
        let (needed, segments) = installation.segments(&settings)?;
        let margins = margins(&ClosedLoop::new(process, controller))?;
        Ok(Self {
            name,
            process: *process,
            controller: *controller,
            installation: *installation,
            settings,
            needed,
            segments,
            margins,
        })
    }

    /// The settings that are exported, in this precision.
    ///
    /// # Errors
    /// A number that is out of its range in a precision that is not the target's.
    pub fn settings<T: Scalar>(&self) -> Result<Settings<T>, SettingError> {
        installation::converted(&self.settings)
    }

    /// Segments of the delay line that the dead time needs at the sample period; 0 without a delay line.
    #[must_use]
    pub fn segments_needed(&self) -> usize {
        self.needed
    }

    /// Segments that the exported delay line has.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.segments
    }

    /// What the loop achieves, not sampled.
    #[must_use]
    pub fn margins(&self) -> &Margins {
        &self.margins
    }

    /// What must be known before this is run in a plant, one sentence each.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = self.margins.warnings.clone();
        let Seconds(h) = self.installation.sample_period;
        if !self.margins.stable {
            warnings.push("The loop is not stable: this controller must not be run.".to_owned());
        }
        if let Some(Seconds(delay_margin)) = self.margins.delay_margin
            && h / 2.0 >= delay_margin
        {
            warnings.push(format!(
                "The hold of a sample period of {h} s acts like about {} s more dead time, and the delay margin is \
                 {delay_margin:.4} s: choose a shorter sample period.",
                h / 2.0
            ));
        }
        if self.controller.derivative_time().is_some() && self.controller.derivative_filter().is_none() {
            let pid = self.settings.law().pid;
            let observer_gain = self.settings.law().observer.map_or(0.0, |observer| observer.observer_gain());
            let kc = pid.proportional_gain();
            let gain = kc * (1.0 + pid.derivative_time().unwrap_or(0.0) / h) + observer_gain;
            warnings.push(format!(
                "The derivative is not filtered: sampled, it passes measurement noise with a gain of {:.4}.",
                gain.abs()
            ));
        }
        warnings
    }
}
