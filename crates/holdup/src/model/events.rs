//! Events: a signal that is constant between the times at which it changes, as text `0:1,100:3`.

use super::quantity::{read_number, read_time};
use super::text::TextError;

/// Reads the changes of a signal: `time:value` pairs separated by commas. Whether the times increase is the
/// scenario's to check.
///
/// ```
/// use holdup::model::events::read_events;
/// assert_eq!(read_events("--setpoint", "0:1,100s:3")?, [(0.0, 1.0), (100.0, 3.0)]);
/// assert!(read_events("--setpoint", "0;1").is_err());
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
    Ok(events)
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
        ] {
            let error = read_events("--load", text).unwrap_err().to_string();
            assert!(error.contains(parts), "{text}: {error}");
        }
    }
}
