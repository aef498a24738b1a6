//! The compact notation: `K=0.0506,d=6` is a process, `Kc=2.95,Ti=15,Td=3,N=100` a controller.
//!
//! Pairs of key and value are separated by commas without spaces. Times, rates and gains may carry units
//! (see [`super::quantity`]). Nothing is added that was not asked for: an absent `Ti` means no integral
//! action, an absent `N` and `Tf` an unfiltered derivative. With `form=series` or `form=parallel` the settings
//! are converted; in parallel form `Ti` and `Td` are the weights of their own terms,
//! `Kc + 1/(Ti·s) + Td·s`, and `Ki`, `Kd` may be given instead.

use std::fmt::Write as _;

use super::controller::{Controller, DerivativeFilter};
use super::forms::Form;
use super::process::Process;
use super::quantity::{read_number, read_rate, read_time};
use super::settings::{ControllerSettings, Extras, ProcessSettings};
use super::text::{Problem, TextError};

/// Keys of a process and the long names they stand for.
const PROCESS: [(&str, &str); 4] =
    [("K", "process_gain"), ("d", "dead_time"), ("T", "lag"), ("integrators", "integrators")];

/// Keys of a controller and the long names they stand for.
const CONTROLLER: [(&str, &str); 15] = [
    ("Kc", "proportional_gain"),
    ("Ti", "integral_time"),
    ("Td", "derivative_time"),
    ("N", "derivative_filter_bandwidth"),
    ("Tf", "filter_time"),
    ("Ko", "observer_gain"),
    ("Km", "observer_model_gain"),
    ("dm", "observer_model_dead_time"),
    ("b", "setpoint_weight"),
    ("c", "derivative_setpoint_weight"),
    ("form", "form"),
    ("Ki", "integral_gain"),
    ("Kd", "derivative_gain"),
    ("a1", "output_filter.a1"),
    ("a2", "output_filter.a2"),
];

/// Reads a process such as `K=0.0506,d=6`.
///
/// `K` [output unit per (input unit · s)] and `d` [s] are required; `T` [s] adds a lag, `integrators=2` makes
/// a double integrator, whose gain is a bare number per s².
///
/// ```
/// use holdup::model::notation::read_process;
/// assert_eq!(read_process("K=3.036/min,d=0.1min")?.dead_time(), 6.0);
/// let error = read_process("K=0.0506,dead=6").unwrap_err().to_string();
/// assert_eq!(error, "unknown key 'dead': did you mean 'd'? (allowed: K, d, T, integrators)");
/// # Ok::<(), holdup::model::TextError>(())
/// ```
///
/// # Errors
/// [`TextError`] that names the key, the value and what is allowed.
pub fn read_process(text: &str) -> Result<Process, TextError> {
    let pairs = Pairs::read(text, &PROCESS, "process pairs such as K=0.0506,d=6")?;
    let integrators = pairs.get("integrators", read_number)?;
    let gain = if integrators == Some(2.0) {
        pairs.require("K", read_number, "a finite number other than 0, in 1/s²")?
    } else {
        pairs.require("K", read_rate, "a finite number other than 0")?
    };
    let settings = ProcessSettings {
        process_gain: gain,
        dead_time: pairs.require("d", read_time, "a time greater than 0, such as 6 or 0.1min")?,
        lag: pairs.get("T", read_time)?,
        integrators,
    };
    settings.process().map_err(|error| TextError::from_model(&error, |name| short(&PROCESS, name)))
}

/// Reads a controller such as `Kc=2.95,Ti=15,Td=3,N=100`.
///
/// ```
/// use holdup::model::notation::read_controller;
/// assert_eq!(read_controller("Kc=2.95,Ti=15,Td=3,N=100")?.structure(), "PID");
/// assert!(read_controller("Kc=2.95,N=100").is_err()); // nothing there to filter
/// # Ok::<(), holdup::model::TextError>(())
/// ```
///
/// # Errors
/// [`TextError`] that names the key, the value and what is allowed.
pub fn read_controller(text: &str) -> Result<Controller, TextError> {
    let pairs = Pairs::read(text, &CONTROLLER, "controller pairs such as Kc=2.95,Ti=15,Td=3,N=100")?;
    let form = pairs.text("form").map_or(Ok(Form::Ideal), |text| read_form("form", text))?;
    let (a1, a2) = (pairs.get("a1", read_time)?, pairs.get("a2", read_number)?);
    let output_filter = match (a1, a2) {
        (None, Some(_)) => return Err(TextError::at("a2", Problem::Conflict { reason: "needs a1".into() })),
        (a1, a2) => a1.map(|a1| (a1, a2.unwrap_or(0.0))),
    };
    let settings = ControllerSettings {
        proportional_gain: pairs.require("Kc", read_number, "a finite number other than 0")?,
        integral_time: pairs.get("Ti", read_time)?,
        derivative_time: pairs.get("Td", read_time)?,
        integral_gain: pairs.get("Ki", read_rate)?,
        derivative_gain: pairs.get("Kd", read_time)?,
        extras: Extras {
            derivative_filter_bandwidth: pairs.get("N", read_rate)?,
            filter_time: pairs.get("Tf", read_time)?,
            observer_gain: pairs.get("Ko", read_number)?,
            observer_model_gain: pairs.get("Km", read_rate)?,
            observer_model_dead_time: pairs.get("dm", read_time)?,
            setpoint_weight: pairs.get("b", read_number)?,
            derivative_setpoint_weight: pairs.get("c", read_number)?,
            output_filter,
        },
        form,
    };
    settings.controller().map_err(|error| TextError::from_model(&error, |name| short(&CONTROLLER, name)))
}

/// Reads the name of a form.
pub(crate) fn read_form(key: &str, text: &str) -> Result<Form, TextError> {
    match text {
        "ideal" => Ok(Form::Ideal),
        "series" => Ok(Form::Series),
        "parallel" => Ok(Form::Parallel),
        _ => Err(TextError::value(key, text, "ideal, series or parallel")),
    }
}

/// Writes a process in compact notation; reading it back gives the same process.
///
/// ```
/// use holdup::model::notation::{read_process, write_process};
/// assert_eq!(write_process(&read_process("d=6s,K=0.0506/s")?), "K=0.0506,d=6");
/// # Ok::<(), holdup::model::TextError>(())
/// ```
#[must_use]
pub fn write_process(process: &Process) -> String {
    let mut text = format!("K={},d={}", process.process_gain(), process.dead_time());
    let mut push = |key: &str, value: f64| {
        let _ = write!(text, ",{key}={value}");
    };
    if let Some(lag) = process.lag() {
        push("T", lag);
    }
    if process.integrators() != 1 {
        push("integrators", f64::from(process.integrators()));
    }
    text
}

/// Writes a controller in compact notation; reading it back gives the same controller.
///
/// The notation has no keys for dead-time compensators: of one, this is its structure and its parameters in
/// parentheses, for reading; [`read_controller`] refuses it.
#[must_use]
pub fn write_controller(controller: &Controller) -> String {
    if let Some(compensator) = controller.compensator() {
        let parameters = compensator.parameters();
        let pairs: Vec<String> = parameters.iter().map(|(name, value)| format!("{name}={value}")).collect();
        return format!("{}({})", compensator.structure(), pairs.join(","));
    }
    let mut text = format!("Kc={}", controller.proportional_gain());
    let mut push = |key: &str, value: Option<f64>| {
        if let Some(value) = value {
            let _ = write!(text, ",{key}={value}");
        }
    };
    push("Ti", controller.integral_time());
    push("Td", controller.derivative_time());
    match controller.derivative_filter() {
        Some(DerivativeFilter::Bandwidth(n)) => push("N", Some(n)),
        Some(DerivativeFilter::Time(tf)) => push("Tf", Some(tf)),
        None => {}
    }
    if let Some(observer) = controller.observer() {
        push("Ko", Some(observer.gain()));
        push("Km", observer.model_gain());
        push("dm", observer.model_dead_time());
    }
    let other_than_1 = |weight: f64| (weight != 1.0).then_some(weight);
    push("b", other_than_1(controller.setpoint_weight()));
    push("c", other_than_1(controller.derivative_setpoint_weight()));
    if let Some(filter) = controller.output_filter() {
        push("a1", Some(filter.a1));
        push("a2", (filter.a2 != 0.0).then_some(filter.a2));
    }
    text
}

/// The key that stands for a long name.
fn short(keys: &[(&'static str, &'static str)], long: &'static str) -> &'static str {
    keys.iter().find(|(_, name)| *name == long).map_or(long, |(key, _)| key)
}

/// The pairs of a compact string, each key known and given once.
struct Pairs<'t>(Vec<(&'t str, &'t str)>);

impl<'t> Pairs<'t> {
    fn read(
        text: &'t str,
        keys: &[(&'static str, &'static str)],
        expected: &'static str,
    ) -> Result<Self, TextError> {
        let syntax = |key: &str, message: String| Err(TextError::at(key, Problem::Syntax { message }));
        if text.trim().is_empty() {
            return syntax("", format!("the text is empty: must be {expected}"));
        }
        let mut pairs: Vec<(&str, &str)> = Vec::new();
        for pair in text.split(',') {
            if pair.is_empty() {
                return syntax(
                    "",
                    format!("nothing stands between two commas, or behind the last: must be {expected}"),
                );
            }
            let Some((key, value)) = pair.split_once('=') else {
                return syntax(
                    pair,
                    format!("is not key=value: must be {expected}, separated by single commas"),
                );
            };
            if key.contains(char::is_whitespace) || value.starts_with(' ') || value.ends_with(' ') {
                return syntax(pair, format!("has a space: must be {expected}, without spaces"));
            }
            if !keys.iter().any(|(known, _)| *known == key) {
                return Err(unknown(key, keys));
            }
            if pairs.iter().any(|(earlier, _)| *earlier == key) {
                return Err(TextError::at(key, Problem::Twice));
            }
            pairs.push((key, value));
        }
        Ok(Self(pairs))
    }

    fn text(&self, key: &str) -> Option<&'t str> {
        self.0.iter().find(|(given, _)| *given == key).map(|(_, value)| *value)
    }

    fn get(
        &self,
        key: &'static str,
        read: fn(&str, &str) -> Result<f64, TextError>,
    ) -> Result<Option<f64>, TextError> {
        self.text(key).map(|value| read(key, value)).transpose()
    }

    fn require(
        &self,
        key: &'static str,
        read: fn(&str, &str) -> Result<f64, TextError>,
        allowed: &'static str,
    ) -> Result<f64, TextError> {
        self.get(key, read)?.ok_or_else(|| TextError::at(key, Problem::Missing { allowed }))
    }
}

/// An unknown key: the nearest is sought among the short keys and among the long names they stand for.
fn unknown(key: &str, keys: &[(&'static str, &'static str)]) -> TextError {
    let short_keys: Vec<&str> = keys.iter().map(|(key, _)| *key).collect();
    let same_letters = short_keys.iter().find(|known| known.eq_ignore_ascii_case(key)).copied();
    let by_long_name = || {
        let names = keys.iter().map(|(_, name)| *name);
        let found = super::text::nearest(key, names)?;
        keys.iter().find(|(_, name)| *name == found).map(|(key, _)| *key)
    };
    let by_first_letters =
        || keys.iter().map(|(k, _)| *k).filter(|k| key.starts_with(k)).max_by_key(|k| k.len());
    let by_short_key = || super::text::nearest(key, short_keys.iter().copied());
    let found = if key.len() > 3 {
        same_letters.or_else(by_long_name).or_else(by_short_key).or_else(by_first_letters)
    } else {
        same_letters.or_else(by_first_letters).or_else(by_short_key).or_else(by_long_name)
    };
    let allowed = short_keys.iter().map(|&k| k.to_owned()).collect();
    TextError::at(key, Problem::Unknown { nearest: found.map(str::to_owned), allowed })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn controller_error(text: &str) -> String {
        read_controller(text).unwrap_err().to_string()
    }

    fn process_error(text: &str) -> String {
        read_process(text).unwrap_err().to_string()
    }

    #[test]
    fn each_key_of_the_contract_reaches_its_setting() {
        let controller = read_controller("Kc=-2,Ti=15s,Td=3,Tf=0.1,Ko=-1,Km=-0.05,dm=7,b=0.5,c=0").unwrap();
        let observer = controller.observer().unwrap();
        assert_eq!(controller.proportional_gain(), -2.0);
        assert_eq!(controller.derivative_filter(), Some(DerivativeFilter::Time(0.1)));
        assert_eq!(
            (observer.gain(), observer.model_gain(), observer.model_dead_time()),
            (-1.0, Some(-0.05), Some(7.0))
        );
        assert_eq!((controller.setpoint_weight(), controller.derivative_setpoint_weight()), (0.5, 0.0));
        let process = read_process("K=2,d=1,T=5,integrators=2").unwrap();
        assert_eq!((process.lag(), process.integrators()), (Some(5.0), 2));
    }

    #[test]
    fn forms_are_converted_on_input() {
        let series = read_controller("Kc=2,Ti=6,Td=3,form=series").unwrap();
        assert_eq!(series, read_controller("Kc=3,Ti=9,Td=2").unwrap());
        let parallel = read_controller("Kc=2,Ti=6,Td=3,form=parallel").unwrap();
        assert_eq!(parallel, read_controller("Kc=2,Ti=12,Td=1.5").unwrap());
        let gains = read_controller("Kc=2,Ki=0.5,Kd=3,form=parallel").unwrap();
        assert_eq!(gains, read_controller("Kc=2,Ti=4,Td=1.5").unwrap());
        assert!(controller_error("Kc=2,Ki=0.5").contains("Ki: needs form"));
    }

    #[test]
    fn each_fault_names_its_key_and_what_is_allowed() {
        for (text, parts) in [
            ("", "the text is empty"),
            ("K=0.05", "d is missing: must be a time"),
            ("K=0,d=6", "K is 0: must be a finite number other than 0"),
            ("K=nan,d=6", "K is nan: must be a finite number"),
            ("K=1e999,d=6", "K is 1e999: must be"),
            ("K=1,d=6,d=7", "d is given twice"),
            ("K=1,d=6,", "nothing stands between"),
            ("K=1, d=6", "' d=6' has a space"),
            ("K=1,d=", "d is empty: must be a time"),
            ("K=1,d=6,integrators=3", "integrators is 3: must be 1 or 2"),
            ("K=1,d=6,Lag=3", "did you mean 'T'?"),
            ("k=1,d=6", "did you mean 'K'?"),
            ("K=1/min,d=6,integrators=2", "K is 1/min: must be a finite number"),
        ] {
            assert!(process_error(text).contains(parts), "{text}: {}", process_error(text));
        }
        for (text, parts) in [
            ("Ti=3", "Kc is missing"),
            ("Kc=0", "Kc is 0: must be a finite number other than 0"),
            ("Kc=1,Ti=0", "Ti is 0: must be a finite number greater than 0"),
            ("Kc=1,Td=-1", "Td is -1: must be a finite number, 0 or greater"),
            ("Kc=1,Td=1,N=100,Tf=0.1", "Tf: the filter has a bandwidth already"),
            ("Kc=1,N=100", "N: needs a derivative time"),
            ("Kc=1,Td=0,Tf=1", "Tf: needs a derivative time"),
            ("Kc=1,Km=1", "Km: needs an observer gain"),
            ("Kc=1,dm=1", "dm: needs an observer gain"),
            ("Kc=1,Tdd=1", "did you mean 'Td'?"),
            ("Kc=1,form=serial", "form is serial: must be ideal, series or parallel"),
            ("Kc=1,Td=-1,form=parallel", "Kd: the derivative gain must have the sign"),
        ] {
            assert!(controller_error(text).contains(parts), "{text}: {}", controller_error(text));
        }
    }

    fn positive() -> impl Strategy<Value = f64> {
        (-6.0..6.0_f64).prop_map(|exponent| 10f64.powf(exponent))
    }

    proptest! {
        #[test]
        fn a_process_reads_back_as_it_was_written(
            gain in positive(), negative in any::<bool>(), d in positive(),
            lag in proptest::option::of(positive()), two in any::<bool>(),
        ) {
            let settings = ProcessSettings {
                process_gain: if negative { -gain } else { gain },
                dead_time: d,
                lag,
                integrators: two.then_some(2.0),
            };
            let process = settings.process().unwrap();
            prop_assert_eq!(read_process(&write_process(&process)), Ok(process));
        }

        #[test]
        fn a_controller_reads_back_as_it_was_written(
            kc in positive(), ti in proptest::option::of(positive()), td in proptest::option::of(positive()),
            filter in proptest::option::of((any::<bool>(), positive())),
            observer in proptest::option::of((positive(), proptest::option::of(positive()), proptest::option::of(positive()))),
            weights in (-2.0..2.0_f64, -2.0..2.0_f64), output in proptest::option::of((positive(), positive())),
        ) {
            let filter = filter.filter(|_| td.is_some());
            let settings = ControllerSettings {
                proportional_gain: kc,
                integral_time: ti,
                derivative_time: td,
                extras: Extras {
                    derivative_filter_bandwidth: filter.filter(|f| f.0).map(|f| f.1),
                    filter_time: filter.filter(|f| !f.0).map(|f| f.1),
                    observer_gain: observer.map(|o| o.0),
                    observer_model_gain: observer.and_then(|o| o.1),
                    observer_model_dead_time: observer.and_then(|o| o.2),
                    setpoint_weight: Some(weights.0),
                    derivative_setpoint_weight: Some(weights.1),
                    output_filter: output,
                },
                ..ControllerSettings::default()
            };
            let controller = settings.controller().unwrap();
            prop_assert_eq!(read_controller(&write_controller(&controller)), Ok(controller));
        }

        #[test]
        fn no_text_makes_the_readers_panic_and_every_error_is_one_line(text in "[KTdcimNfoab=,0-9.e\\-/ \\n]{0,24}") {
            for error in [read_process(&text).err(), read_controller(&text).err()].into_iter().flatten() {
                prop_assert!(!error.to_string().contains('\n'));
            }
        }
    }
}
