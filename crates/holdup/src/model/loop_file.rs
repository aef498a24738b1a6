//! The loop file: a process and its controller in long names, as TOML.
//!
//! ```toml
//! [process]
//! process_gain = 0.0506
//! dead_time_s = 6.0
//!
//! [controller]
//! proportional_gain = 1.5321
//! derivative_time_s = 1.0343
//! derivative_filter_bandwidth = 100.0
//! observer_gain = 1.5321
//! ```
//!
//! Process: `process_gain`, `dead_time_s`, `lag_s`, `integrators`. Controller: `proportional_gain`,
//! `integral_time_s`, `derivative_time_s`, `derivative_filter_bandwidth` or `filter_time_s`, `observer_gain`,
//! `observer_model_gain`, `observer_model_dead_time_s`, `setpoint_weight`, `derivative_setpoint_weight`,
//! `output_filter = { a1_s, a2_s2 }`, `form` (`ideal`, `series`, `parallel`; with parallel also
//! `integral_gain` and `derivative_gain`). A dead-time compensator has `structure` and `parameters = { … }` instead of
//! all these, with the names of [`Compensator::parameters`].

use super::compensator::Compensator;
use super::controller::{Controller, DerivativeFilter};
use super::error::ModelError;
use super::forms::Form;
use super::notation::read_form;
use super::process::Process;
use super::settings::{ControllerSettings, Extras, ProcessSettings};
use super::text::TextError;
use super::toml_section::{Document, Section};

/// Keys of the table of a process.
const PROCESS_KEYS: [&str; 4] = ["process_gain", "dead_time_s", "lag_s", "integrators"];

/// Keys of the table of a controller whose settings are given.
const CONTROLLER_KEYS: [&str; 16] = [
    "proportional_gain",
    "integral_time_s",
    "derivative_time_s",
    "integral_gain",
    "derivative_gain",
    "form",
    "structure",
    "parameters",
    "derivative_filter_bandwidth",
    "filter_time_s",
    "observer_gain",
    "observer_model_gain",
    "observer_model_dead_time_s",
    "setpoint_weight",
    "derivative_setpoint_weight",
    "output_filter",
];

/// How many of [`CONTROLLER_KEYS`], from the front, are the law, which a rule gives.
const TERMS: usize = 8;

/// The keys that give the three terms: a rule takes their place.
pub(crate) fn term_keys() -> &'static [&'static str] {
    &CONTROLLER_KEYS[..TERMS]
}

/// The keys of filters, weights and observer, which may stand beside a rule.
pub(crate) fn extra_keys() -> &'static [&'static str] {
    &CONTROLLER_KEYS[TERMS..]
}

/// Reads a loop file.
///
/// ```
/// let text = "[process]\nprocess_gain = 0.0506\ndead_time_s = 6.0\n[controller]\nproportional_gain = 1.5\n";
/// let (process, controller) = holdup::model::loop_file::read_loop(text)?;
/// assert_eq!((process.dead_time(), controller.structure()), (6.0, "P"));
/// let error = holdup::model::loop_file::read_loop(&text.replace("time_s", "tine_s")).unwrap_err();
/// assert_eq!(error.line, Some(3));
/// # Ok::<(), holdup::model::TextError>(())
/// ```
///
/// # Errors
/// [`TextError`] with line, key, value and what is allowed.
pub fn read_loop(text: &str) -> Result<(Process, Controller), TextError> {
    let document = Document::parse(text)?;
    let root = document.root();
    root.only(&["process", "controller"])?;
    let (process, controller) = (root.require_section("process")?, root.require_section("controller")?);
    controller.only(&CONTROLLER_KEYS)?;
    Ok((process_section(&process)?, controller_section(&controller)?))
}

/// Writes a loop file; reading it back gives the same loop.
#[must_use]
pub fn write_loop(process: &Process, controller: &Controller) -> String {
    let mut lines = vec!["[process]".to_owned()];
    let mut push =
        |key: &str, value: Option<f64>| lines.extend(value.map(|value| format!("{key} = {value:?}")));
    push("process_gain", Some(process.process_gain()));
    push("dead_time_s", Some(process.dead_time()));
    push("lag_s", process.lag());
    push("integrators", (process.integrators() != 1).then(|| f64::from(process.integrators())));
    lines.push("\n[controller]".to_owned());
    if let Some(compensator) = controller.compensator() {
        let pairs = compensator.parameters().into_iter().map(|(name, value)| format!("{name} = {value:?}"));
        let pairs = pairs.collect::<Vec<_>>().join(", ");
        lines.push(format!("structure = {:?}\nparameters = {{ {pairs} }}", compensator.structure()));
        return lines.join("\n") + "\n";
    }
    let mut push =
        |key: &str, value: Option<f64>| lines.extend(value.map(|value| format!("{key} = {value:?}")));
    push("proportional_gain", Some(controller.proportional_gain()));
    push("integral_time_s", controller.integral_time());
    push("derivative_time_s", controller.derivative_time());
    match controller.derivative_filter() {
        Some(DerivativeFilter::Bandwidth(n)) => push("derivative_filter_bandwidth", Some(n)),
        Some(DerivativeFilter::Time(tf)) => push("filter_time_s", Some(tf)),
        None => {}
    }
    if let Some(observer) = controller.observer() {
        push("observer_gain", Some(observer.gain()));
        push("observer_model_gain", observer.model_gain());
        push("observer_model_dead_time_s", observer.model_dead_time());
    }
    let other_than_1 = |weight: f64| (weight != 1.0).then_some(weight);
    push("setpoint_weight", other_than_1(controller.setpoint_weight()));
    push("derivative_setpoint_weight", other_than_1(controller.derivative_setpoint_weight()));
    if let Some(filter) = controller.output_filter() {
        lines.push(format!("output_filter = {{ a1_s = {:?}, a2_s2 = {:?} }}", filter.a1, filter.a2));
    }
    lines.join("\n") + "\n"
}

/// Reads the table of a process, all of it.
pub(crate) fn process_section(section: &Section<'_>) -> Result<Process, TextError> {
    section.only(&PROCESS_KEYS)?;
    let settings = ProcessSettings {
        process_gain: section.require_number("process_gain")?,
        dead_time: section.require_number("dead_time_s")?,
        lag: section.number("lag_s")?,
        integrators: section.number("integrators")?,
    };
    settings.process().map_err(|error| section.model_error(&error, with_unit))
}

/// Reads the settings of a controller from a table whose keys are checked.
pub(crate) fn controller_section(section: &Section<'_>) -> Result<Controller, TextError> {
    if section.has("parameters") || section.has("structure") {
        return compensator_section(section);
    }
    let form = section.text("form")?.map_or(Ok(Form::Ideal), |text| read_form("form", &text));
    let settings = ControllerSettings {
        integral_time: section.number("integral_time_s")?,
        derivative_time: section.number("derivative_time_s")?,
        integral_gain: section.number("integral_gain")?,
        derivative_gain: section.number("derivative_gain")?,
        extras: extras_section(section)?,
        form: form.map_err(|error| section.error("form", error.problem))?,
        proportional_gain: section.require_number("proportional_gain")?,
    };
    settings.controller().map_err(|error| section.model_error(&error, with_unit))
}

/// Reads a dead-time compensator, whose parameters leave no room for the terms of a PID law.
fn compensator_section(section: &Section<'_>) -> Result<Controller, TextError> {
    for key in CONTROLLER_KEYS.iter().filter(|key| !["structure", "parameters"].contains(key)) {
        if section.has(key) {
            let reason = "is not a setting of a dead-time compensator";
            return Err(section.model_error(&ModelError::Conflict { name: key, reason }, |name| name));
        }
    }
    let structure = section.text("structure")?.unwrap_or_default();
    let parameters = section.named_numbers("parameters")?.unwrap_or_default();
    let compensator = Compensator::from_parameters(&structure, &parameters);
    compensator.map(Controller::from).map_err(|error| section.model_error(&error, |name| name))
}

/// Reads filters, weights and observer, which may also stand beside a rule.
pub(crate) fn extras_section(section: &Section<'_>) -> Result<Extras, TextError> {
    let output_filter = match section.section("output_filter")? {
        None => None,
        Some(filter) => {
            filter.only(&["a1_s", "a2_s2"])?;
            let coefficients = (filter.require_number("a1_s")?, filter.number("a2_s2")?.unwrap_or(0.0));
            Some(coefficients)
        }
    };
    Ok(Extras {
        derivative_filter_bandwidth: section.number("derivative_filter_bandwidth")?,
        filter_time: section.number("filter_time_s")?,
        observer_gain: section.number("observer_gain")?,
        observer_model_gain: section.number("observer_model_gain")?,
        observer_model_dead_time: section.number("observer_model_dead_time_s")?,
        setpoint_weight: section.number("setpoint_weight")?,
        derivative_setpoint_weight: section.number("derivative_setpoint_weight")?,
        output_filter,
    })
}

/// The key of a file for the name of a setting: the unit belongs to the key.
pub(crate) fn with_unit(name: &'static str) -> &'static str {
    match name {
        "dead_time" => "dead_time_s",
        "lag" => "lag_s",
        "integral_time" => "integral_time_s",
        "derivative_time" => "derivative_time_s",
        "filter_time" => "filter_time_s",
        "observer_model_dead_time" => "observer_model_dead_time_s",
        "output_filter.a1" => "output_filter.a1_s",
        "output_filter.a2" => "output_filter.a2_s2",
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::notation::{read_controller, read_process, write_controller};
    use crate::model::{CompensatorLaw, Lead, Seconds};

    const LOOP: &str = "# a level\n[process]\nprocess_gain = 0.0506\ndead_time_s = 6\n\n[controller]\nproportional_gain = 1.5321\nderivative_time_s = 1.0343\nderivative_filter_bandwidth = 100.0\nobserver_gain = 1.5321\n";

    fn error(from: &str, to: &str) -> String {
        assert!(LOOP.contains(from), "{from}");
        read_loop(&LOOP.replace(from, to)).unwrap_err().to_string()
    }

    #[test]
    fn the_file_of_the_contract_is_read() {
        let (process, controller) = read_loop(LOOP).unwrap();
        assert_eq!(process, read_process("K=0.0506,d=6").unwrap());
        assert_eq!(controller, read_controller("Kc=1.5321,Td=1.0343,N=100,Ko=1.5321").unwrap());
    }

    #[test]
    fn each_fault_names_line_key_value_and_what_is_allowed() {
        for (from, to, parts) in [
            (
                "dead_time_s",
                "dead_tim_s",
                "line 4: unknown key 'process.dead_tim_s': did you mean 'dead_time_s'?",
            ),
            ("0.0506", "nan", "line 3: process.process_gain is nan: must be a finite number"),
            ("0.0506", "1e999", "line 3: process.process_gain is 1e999: must be a finite number"),
            ("0.0506", "\"0.05\"", "line 3: process.process_gain is \"0.05\": must be a finite number"),
            ("= 6", "= -6", "line 4: process.dead_time_s is -6: must be a finite number greater than 0"),
            ("proportional_gain = 1.5321", "", "line 6: controller.proportional_gain is missing"),
            ("1.0343", "-1.0", "line 8: controller.derivative_time_s is -1: must be"),
            (
                "derivative_time_s = 1.0343",
                "",
                "line 9: controller.derivative_filter_bandwidth: needs a derivative",
            ),
            (
                "observer_gain = 1.5321",
                "observer_model_gain = 1.0",
                "line 10: controller.observer_model_gain: needs an observer",
            ),
            ("[controller]", "[control]", "line 6: unknown key 'control': did you mean 'controller'?"),
            ("dead_time_s = 6", "dead_time_s = 6\ndead_time_s = 7", "line 5: not valid TOML: duplicate key"),
            ("dead_time_s = 6", "dead_time_s 6", "line 4: not valid TOML"),
        ] {
            assert!(error(from, to).contains(parts), "{to}: {}", error(from, to));
        }
    }

    #[test]
    fn a_loop_reads_back_as_it_was_written() {
        for text in
            ["Kc=1", "Kc=-2.5,Ti=3,Td=1e-3,Tf=7,Ko=-1,Km=2,dm=3,b=0,c=0.5,a1=2,a2=3", "Kc=1,Td=2,N=100"]
        {
            let written =
                (read_process("K=-1e-7,d=3,T=2,integrators=2").unwrap(), read_controller(text).unwrap());
            assert_eq!(read_loop(&write_loop(&written.0, &written.1)), Ok(written), "{text}");
        }
    }

    #[test]
    fn a_dead_time_compensator_reads_back_as_it_was_written_and_takes_no_terms_beside_it() {
        let lead = Some(Lead { derivative_time: 0.4, filter_time: 0.04 });
        for law in [
            CompensatorLaw::ModifiedSmith { main_gain: 0.5, disturbance_gain: 0.2, lead: None },
            CompensatorLaw::ModifiedSmith { main_gain: 0.5, disturbance_gain: 0.2, lead },
            CompensatorLaw::TwoDegree { setpoint_time: 1.0, a1: 4.0, a2: 1e-7 },
            CompensatorLaw::InverseModel { main_gain: -1e9, filter_time: 0.1 },
            CompensatorLaw::DisturbanceRejection { controller_bandwidth: 0.3, observer_bandwidth: 0.5 },
        ] {
            let compensator = Compensator::new(law, 2.0, Seconds(3.0)).unwrap();
            let written = (read_process("K=1,d=3").unwrap(), Controller::from(compensator));
            let text = write_loop(&written.0, &written.1);
            assert_eq!(read_loop(&text), Ok(written), "{text}");
            let error = read_loop(&(text + "proportional_gain = 1.0\n")).unwrap_err().to_string();
            assert!(error.contains("is not a setting of a dead-time compensator"), "{error}");
            assert!(read_controller(&write_controller(&written.1)).is_err());
        }
    }
}
