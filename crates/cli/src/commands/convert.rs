//! `holdup convert`: the numbers to type into a vendor's block, and back.

use std::fmt::Write as _;

use holdup::analysis::frequency::Margins;
use holdup::deploy::conversion::{
    Conversion, Effect, Given, Parameter, Scaling, Sheet, Span, Value, Vendor, convert, read, vendor, vendors,
};
use holdup::model::description::ControllerDescription;
use holdup::model::notation::{read_controller, write_controller};
use holdup::model::quantity::read_time;
use holdup::model::{Controller, Process};
use serde_json::{Value as Json, json};

use super::view::{controller_line, margins_table, process_line};
use crate::args::ConvertArgs;
use crate::console::{Answer, Console};
use crate::fault::Fault;
use crate::input::process;
use crate::table::{fold, number, table, title};

/// The spans that stand where none are given: percent.
const PERCENT: (f64, f64) = (0.0, 100.0);

/// Lists the blocks, converts a controller for one or all, or reads the settings of one.
pub(crate) fn run(args: &ConvertArgs, console: Console) -> Result<Answer, Fault> {
    let scaling = scaling(args)?;
    let process = args.process.as_ref().map(|_| process(args.process.as_ref())).transpose()?;
    let (controller, origin) = match (&args.from, &args.controller) {
        (Some(_), Some(_)) => {
            return Err(Fault::option("--controller", "the settings of --from say it already"));
        }
        (Some(id), None) => {
            let from = vendor(id).map_err(|error| Fault::option("--from", error))?;
            let given = Given::read(from, &args.settings).map_err(Fault::input)?;
            (Some(read(from, &given, &scaling).map_err(Fault::input)?), Some(from))
        }
        (None, text) => {
            if let Some(word) = args.settings.first() {
                let word = holdup::model::text::one_line(word);
                return Err(Fault::input(format!(
                    "'{word}' is a setting of a block: name the block with --from"
                )));
            }
            let read =
                |text: &String| read_controller(text).map_err(|error| Fault::option("--controller", error));
            (text.as_ref().map(read).transpose()?, None)
        }
    };
    let Some(controller) = controller else {
        return match &args.to {
            Some(_) => Err(Fault::input("--controller is missing: must be such as -c Kc=2.95,Ti=15,Td=3")),
            None => Ok(listed(console)),
        };
    };
    let asked = Asked { controller, process, scaling, given: given_spans(args) };
    match args.to.as_deref() {
        None => match origin {
            Some(from) => asked.origin(from, console),
            None => {
                Err(Fault::input("--to is missing: must be all or one of those that 'holdup convert' lists"))
            }
        },
        Some("all") => asked.all(console),
        Some(id) => {
            let to = vendor(id).map_err(|error| Fault::option("--to", error))?;
            asked.one(to, console)
        }
    }
}

/// What is converted, and for which plant.
struct Asked {
    controller: Controller,
    process: Option<Process>,
    scaling: Scaling,
    /// Whether each span was given.
    given: [bool; 2],
}

impl Asked {
    /// For one block.
    fn one(&self, to: &'static Vendor, console: Console) -> Result<Answer, Fault> {
        let conversion = convert(to, &self.controller, &self.scaling);
        let (json, warnings, effect) = self.described(&conversion)?;
        let mut text = String::new();
        if !console.json {
            text = format!("{}\nfor {}\n", controller_line(&self.controller), to.name);
            text += &folded(console, " equation  ", to.equation);
            text += &folded(console, " source    ", to.source.citation);
            text += &folded(console, " read there", to.source.read);
            text.push('\n');
            match &conversion.sheet {
                Err(refusal) => text += &folded(console, "refused:", &refusal.reason),
                Ok(sheet) => text += &shown(console, to, sheet, effect.as_ref()),
            }
        }
        Ok(Answer { json, text, warnings, ..Answer::default() })
    }

    /// For every block.
    fn all(&self, console: Console) -> Result<Answer, Fault> {
        let mut text = format!("{}\n", controller_line(&self.controller));
        let mut entries = Vec::new();
        for &to in vendors() {
            let conversion = convert(to, &self.controller, &self.scaling);
            entries.push(self.described(&conversion)?.0);
            text += &format!("\n{}\n", to.id);
            text += &match &conversion.sheet {
                Err(refusal) => folded(console, "   ", &format!("refused: {}", refusal.reason)),
                Ok(sheet) => folded(console, "   ", &typed(sheet)),
            };
        }
        let mut warnings = Vec::new();
        if self.given.contains(&false) {
            warnings.push(self.assumed());
        }
        if console.json {
            text.clear();
        }
        Ok(Answer { json: Json::Array(entries), text, warnings, ..Answer::default() })
    }

    /// What a block runs with the settings that were read out of it.
    fn origin(&self, from: &'static Vendor, console: Console) -> Result<Answer, Fault> {
        let margins = match &self.process {
            Some(process) => {
                Some(Effect::of(process, &self.controller, &self.controller).map_err(Fault::input)?.run)
            }
            None => None,
        };
        let mut warnings = Vec::new();
        if from.uses_spans() && self.given.contains(&false) {
            warnings.push(self.assumed());
        }
        warnings.extend(margins.iter().flat_map(|margins| margins.warnings.clone()));
        let notation = write_controller(&self.controller);
        let json = json!({
            "vendor": from.id,
            "equation": from.equation,
            "source": from.source.citation,
            "controller": ControllerDescription::from(&self.controller),
            "notation": notation,
            "margins": margins,
            "warnings": warnings,
        });
        let mut text = String::new();
        if !console.json {
            text = format!("{}\nis what {} runs\n\n", controller_line(&self.controller), from.name);
            let _ = writeln!(text, " -c {notation}");
            if let (Some(margins), Some(process)) = (&margins, &self.process) {
                let _ = write!(text, "\non {}\n\n", process_line(process));
                text += &margins_table(console, &[("loop", margins)]);
            }
        }
        Ok(Answer { json, text, warnings, ..Answer::default() })
    }

    /// A conversion as JSON, with its warnings and, where there is a process, its effect.
    fn described(&self, conversion: &Conversion) -> Result<(Json, Vec<String>, Option<Effect>), Fault> {
        let to = conversion.vendor;
        let base = |parameters: &[Parameter], refused: Option<&str>, cannot: &[String]| {
            json!({
                "vendor": to.id,
                "name": to.name,
                "equation": to.equation,
                "source": to.source.citation,
                "read_in_source": to.source.read,
                "parameters": parameters,
                "refused": refused,
                "cannot": cannot,
            })
        };
        let sheet = match &conversion.sheet {
            Ok(sheet) => sheet,
            Err(refusal) => {
                let mut json = base(&[], Some(&refusal.reason), &[]);
                json["warnings"] = json!([]);
                return Ok((json, Vec::new(), None));
            }
        };
        let effect = match &self.process {
            Some(process) => Some(Effect::of(process, &self.controller, &sheet.run).map_err(Fault::input)?),
            None => None,
        };
        let mut warnings = sheet.warnings.clone();
        if to.uses_spans() && self.given.contains(&false) {
            warnings.push(self.assumed());
        }
        if let (Some(period), Some(filter)) = (self.scaling.sample_period, sheet.run.derivative_filter())
            && filter.time() < period
        {
            warnings.push(format!(
                "The filter time of {} s is shorter than the sample period of {period} s: it filters little.",
                number(filter.time())
            ));
        }
        warnings.extend(effect.iter().flat_map(Effect::sentences));
        let mut json = base(&sheet.parameters, None, &sheet.cannot);
        json["notes"] = json!(to.notes);
        json["run"] = json!(ControllerDescription::from(&sheet.run));
        let of = |pick: fn(&Effect) -> &Margins| effect.as_ref().map(pick);
        json["margins"] = json!({"designed": of(|e| &e.designed), "run": of(|e| &e.run)});
        json["warnings"] = json!(warnings);
        Ok((json, warnings, effect))
    }

    fn assumed(&self) -> String {
        let name = |index: usize, option: &'static str, span: Span| {
            (!self.given[index]).then(|| format!("{option} {}:{}", span.low(), span.high()))
        };
        let assumed = [name(0, "--pv-span", self.scaling.pv), name(1, "--op-span", self.scaling.op)];
        format!(
            "The gain is for {}: give the real span.",
            assumed.into_iter().flatten().collect::<Vec<_>>().join(" and ")
        )
    }
}

/// The sheet of one block for reading.
fn shown(console: Console, to: &Vendor, sheet: &Sheet, effect: Option<&Effect>) -> String {
    let rows: Vec<Vec<String>> = sheet
        .parameters
        .iter()
        .map(|parameter| {
            let unit = [parameter.unit.as_str(), parameter.note].into_iter().filter(|part| !part.is_empty());
            vec![parameter.name.to_owned(), exact(parameter.value), unit.collect::<Vec<_>>().join(", ")]
        })
        .collect();
    let mut text = table(console, &["parameter", "type", "unit"], &rows);
    let notes: Vec<String> = to.notes.iter().map(|&note| note.to_owned()).collect();
    for (heading, sentences) in [("What the block cannot", &sheet.cannot), ("To know", &notes)] {
        if !sentences.is_empty() {
            text.push('\n');
            text += &title(console, heading);
        }
        for sentence in sentences {
            text += &folded(console, " -", sentence);
        }
    }
    if let Some(effect) = effect {
        text.push('\n');
        let columns = [("as designed", &effect.designed), ("as the block runs it", &effect.run)];
        text += &margins_table(console, &columns);
    }
    text
}

/// The numbers of a sheet in one line.
fn typed(sheet: &Sheet) -> String {
    let pairs =
        sheet.parameters.iter().map(|parameter| format!("{}={}", parameter.name, exact(parameter.value)));
    pairs.collect::<Vec<_>>().join(", ")
}

/// A value to be typed: six significant digits are more than any process deserves.
fn exact(value: Value) -> String {
    match value {
        Value::Word(word) => word.to_owned(),
        Value::Number(value) => {
            let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
            if rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs()) {
                rounded.to_string()
            } else {
                format!("{rounded:e}")
            }
        }
    }
}

/// The blocks that are known.
fn listed(console: Console) -> Answer {
    let entries = vendors().iter().map(|vendor| {
        json!({
            "vendor": vendor.id,
            "name": vendor.name,
            "equation": vendor.equation,
            "source": vendor.source.citation,
            "read_in_source": vendor.source.read,
            "notes": vendor.notes,
        })
    });
    let json = entries.collect();
    let mut text = String::new();
    if !console.json {
        let rows: Vec<Vec<String>> =
            vendors().iter().map(|vendor| vec![vendor.id.to_owned(), vendor.name.to_owned()]).collect();
        text = table(console, &["vendor", "block"], &rows);
    }
    Answer { json, text, ..Answer::default() }
}

/// A sentence behind a mark, folded to the console.
fn folded(console: Console, mark: &str, sentence: &str) -> String {
    let indent = mark.chars().count() + 1;
    let mut text = String::new();
    for (index, line) in fold(sentence, console.width.saturating_sub(indent)).iter().enumerate() {
        let start = if index == 0 { format!("{mark} ") } else { " ".repeat(indent) };
        let _ = writeln!(text, "{start}{line}");
    }
    text
}

fn given_spans(args: &ConvertArgs) -> [bool; 2] {
    [args.pv_span.is_some(), args.op_span.is_some()]
}

/// Spans, unit and sample period of the options.
fn scaling(args: &ConvertArgs) -> Result<Scaling, Fault> {
    let span = |option: &str, text: &Option<String>| match text {
        Some(text) => Span::read(option, text),
        None => Span::new(PERCENT.0, PERCENT.1),
    };
    let mut scaling = Scaling::new(
        span("--pv-span", &args.pv_span).map_err(Fault::input)?,
        span("--op-span", &args.op_span).map_err(Fault::input)?,
    );
    scaling.pv_unit = args.pv_unit.as_deref().map(holdup::model::text::one_line).unwrap_or_default();
    if let Some(text) = &args.sample_period {
        let period = read_time("--sample-period", text).map_err(Fault::input)?;
        if period <= 0.0 {
            return Err(Fault::input(format!("--sample-period is {text}: must be a time greater than 0")));
        }
        scaling.sample_period = Some(period);
    }
    Ok(scaling)
}
