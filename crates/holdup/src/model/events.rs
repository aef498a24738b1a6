//! Events: a signal that is constant between the times at which it changes, as text `0:1,100:3`.

use super::quantity::{read_number, read_time};
use super::text::{Problem, TextError};

/// Reads the changes of a signal: `time:value` pairs separated by commas, times increasing.
///
/// ```
/// use holdup::model::events::read_events;
/// assert_eq!(read_events("--setpoint", "0:1,100s:3")?, [(0.0, 1.0), (100.0, 3.0)]);
/// assert!(read_events("--setpoint", "100:3,0:1").is_err());
/// # Ok::<(), holdup::model::TextError>(())
/// ```
///
/// # Errors
/// [`TextError`] under the name `key` that names the pair and what is allowed.
pub fn read_events(key: &str, text: &str) -> Result<Vec<(f64, f64)>, TextError> {
    let mut events = Vec::new();
    for pair in text.split(',') {
        let refused = || TextError::value(key, pair, "time:value pairs such as 0:1,100:3");
        let (time, value) = pair.split_once(':').ok_or_else(refused)?;
        events.push((
            read_time(key, time).map_err(|_| refused())?,
            read_number(key, value).map_err(|_| refused())?,
        ));
    }
    check_order(key, &events)?;
    Ok(events)
}

/// Refuses events whose times are negative or do not increase.
///
/// # Errors
/// [`TextError`] under the name `key`.
pub fn check_order(key: &str, events: &[(f64, f64)]) -> Result<(), TextError> {
    let mut last = None;
    for &(time, value) in events {
        let given = || format!("{time}:{value}");
        if !(time.is_finite() && value.is_finite() && time >= 0.0) {
            return Err(TextError::value(key, given(), "a finite value at a finite time of 0 or later"));
        }
        if last.is_some_and(|last| time <= last) {
            return Err(TextError::value(key, given(), "later than the event before it: times increase"));
        }
        last = Some(time);
    }
    Ok(())
}

/// Refuses events at or beyond the horizon [s].
///
/// # Errors
/// [`TextError`] under the name `key`.
pub fn check_horizon(key: &str, events: &[(f64, f64)], horizon: f64) -> Result<(), TextError> {
    match events.iter().find(|(time, _)| *time >= horizon) {
        Some((time, value)) => {
            Err(TextError::value(key, format!("{time}:{value}"), format!("before the horizon of {horizon} s")))
        }
        None => Ok(()),
    }
}

/// Refuses a horizon that is not a finite time greater than 0.
///
/// # Errors
/// [`TextError`] under the name `key`.
pub fn check_positive(key: &str, value: f64) -> Result<f64, TextError> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    Err(TextError::at(
        key,
        Problem::Value { value: value.to_string(), allowed: "a finite number greater than 0".into() },
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_fault_of_an_event_list_is_named() {
        for (text, parts) in [
            ("", "--load is empty: must be time:value pairs"),
            ("0", "--load is 0: must be time:value pairs"),
            ("0:nan", "--load is 0:nan: must be time:value pairs"),
            ("0:1,", "--load is empty"),
            ("-1:1", "--load is -1:1: must be a finite value at a finite time of 0 or later"),
            ("5:1,5:2", "--load is 5:2: must be later than the event before it"),
        ] {
            let error = read_events("--load", text).unwrap_err().to_string();
            assert!(error.contains(parts), "{text}: {error}");
        }
        assert!(check_horizon("--load", &[(0.0, 1.0), (300.0, 2.0)], 300.0).is_err());
    }
}
