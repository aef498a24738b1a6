//! Words and codes of a mode column.

use crate::record::Operation;

/// The controller moves the actuator, on its own setpoint or on one from elsewhere.
const AUTOMATIC: [&str; 20] = [
    "auto",
    "aut",
    "automatic",
    "a",
    "cas",
    "casc",
    "cascade",
    "c",
    "rcas",
    "rc",
    "rsp",
    "remote",
    "remote setpoint",
    "rem",
    "normal",
    "closed",
    "on",
    "true",
    "automatik",
    "ae",
];

/// Somebody or something else moves it: by hand, locally, by tracking or from a program (`rout`).
const MANUAL: [&str; 17] = [
    "man",
    "manual",
    "m",
    "hand",
    "h",
    "iman",
    "rout",
    "ro",
    "lo",
    "local override",
    "local",
    "tracking",
    "track",
    "open",
    "off",
    "false",
    "initialisation manual",
];

/// Who moves the actuator by a cell of a mode column. Of bare numbers 0 is manual, 1 automatic and 2 cascade.
/// `automatic` lists the values that mean automatic in this file; then all other words mean manual.
pub(super) fn operation(cell: &str, automatic: &[String]) -> Operation {
    let word = cell.trim().to_lowercase();
    if word.is_empty() {
        return Operation::Unknown;
    }
    if !automatic.is_empty() {
        let listed = automatic.iter().any(|value| value.trim().to_lowercase() == word);
        return if listed { Operation::Automatic } else { Operation::Manual };
    }
    if let Ok(code) = word.parse::<f64>() {
        return match code {
            0.0 => Operation::Manual,
            1.0 | 2.0 => Operation::Automatic,
            _ => Operation::Unknown,
        };
    }
    match (AUTOMATIC.contains(&word.as_str()), MANUAL.contains(&word.as_str())) {
        (true, _) => Operation::Automatic,
        (false, true) => Operation::Manual,
        (false, false) => Operation::Unknown,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_codes_and_values_of_the_file_are_understood() {
        for word in ["AUTO", "Auto", "A", "CAS", "rcas", "1", "1.0", "2", "True"] {
            assert_eq!(operation(word, &[]), Operation::Automatic, "{word}");
        }
        for word in ["MAN", "Manual", "0", "ROUT", "hand", "IMAN"] {
            assert_eq!(operation(word, &[]), Operation::Manual, "{word}");
        }
        for word in ["", "Bad", "7", "OOS"] {
            assert_eq!(operation(word, &[]), Operation::Unknown, "{word}");
        }
        let own = ["0".to_owned()];
        assert_eq!(operation("0", &own), Operation::Automatic);
        assert_eq!(operation("1", &own), Operation::Manual);
    }
}
