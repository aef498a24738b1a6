//! The name of an exported controller: an identifier in every language.

use super::ExportError;

/// Longest name [characters]: with the longest ending of an external identifier, `_switch_on`, it fits the 31 characters
/// that C99 tells apart.
const LONGEST: usize = 20;

/// Words that Structured Text (IEC 61131-3, annex C) keeps for itself, and the names of its standard functions and
/// types. The other languages put something behind the name.
const RESERVED: &str = "abs acos action add and any array asin at atan begin bool by byte case concat configuration \
    constant cos ctd ctu ctud date delete dint div do dt dword else elsif end eq exit exp expt f_edge f_trig false \
    find for from function function_block ge gt if in initial_step insert int interval le left len limit lint ln log \
    lreal lt lword max mid min mod move mul mux ne non_retain not of on or or_else priority program r_edge r_trig \
    read_only read_write real repeat replace resource retain return right rol ror rs sel sema shl shr sin single sint \
    sqrt sr step string struct sub super tan task then this time to tod tof ton tp transition true trunc type udint \
    uint ulint until usint var var_access var_external var_global var_in_out var_input var_output var_temp while \
    with word wstring xor";

/// Checks a name and returns it.
pub(super) fn check(name: &str) -> Result<String, ExportError> {
    let letters = name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
    let good = letters
        && name.starts_with(|c: char| c.is_ascii_alphabetic())
        && !name.ends_with('_')
        && !name.contains("__")
        && name.len() <= LONGEST
        && !RESERVED.split_whitespace().any(|word| word.eq_ignore_ascii_case(name));
    if good {
        return Ok(name.to_owned());
    }
    let allowed = format!(
        "an identifier of at most {LONGEST} letters, digits and single underscores that begins with a letter and is \
         no keyword of Structured Text"
    );
    Err(ExportError::out_of_range("name", format!("'{}'", name.escape_default()), allowed))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_some_language_refuses_is_refused() {
        for name in ["level_d205", "LIC205", "a"] {
            assert_eq!(check(name).unwrap(), name);
        }
        let long = "a".repeat(LONGEST + 1);
        for name in ["", "2d", "_a", "a_", "a__b", "a-b", "a b", "Program", "pegel_ü", "*/", &long] {
            let error = check(name).unwrap_err().to_string();
            assert!(error.starts_with("name is '") && !error.contains('\n'), "{error}");
        }
    }
}
