//! The known name nearest to a mistyped one.

/// The name among `known` with the fewest edits from `given`, if it is near enough to be meant.
pub(crate) fn nearest<'a>(given: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let given: Vec<char> = given.chars().take(80).collect();
    let mut candidates: Vec<_> = known.into_iter().map(|name| (edits(&given, name), name)).collect();
    candidates.sort_by_key(|(distance, _)| *distance);
    let (distance, name) = *candidates.first()?;
    (distance <= (name.chars().count().max(given.len()) / 2).max(1)).then_some(name)
}

/// Insertions, deletions and replacements from one text to the other, letter case ignored.
fn edits(given: &[char], name: &str) -> usize {
    let mut row: Vec<usize> = (0..=given.len()).collect();
    for (i, c) in name.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, g) in given.iter().enumerate() {
            let replaced = diagonal + usize::from(!c.eq_ignore_ascii_case(g));
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[given.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_slip_of_the_finger_finds_its_name_and_nonsense_finds_none() {
        let known = ["pi-simc", "pd-kadam", "dob-kadam"];
        assert_eq!(nearest("pi_smic", known), Some("pi-simc"));
        assert_eq!(nearest("DOB-kadm", known), Some("dob-kadam"));
        assert_eq!(nearest("zzzzzzzzzzzz", known), None);
        assert_eq!(nearest("", known), None);
    }
}
