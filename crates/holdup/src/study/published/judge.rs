//! The verdict on one printed number.

use super::{Cell, Reading, Verdict};

/// Relative distance within which a number counts as reproduced.
const REPRODUCED: f64 = 0.005;

/// Relative distance within which a number counts as close.
const CLOSE: f64 = 0.05;

/// What a convention gives for a cell, and why it is not the stated one.
#[derive(Debug, Clone)]
pub(super) struct Candidate {
    /// The convention.
    pub(super) convention: String,
    /// The number computed under it.
    pub(super) computed: Option<f64>,
    /// What is different from what the paper states; absent for the stated convention.
    pub(super) departure: Option<String>,
}

/// A number that no cell of this kind can lie below, and why.
#[derive(Debug, Clone)]
pub(super) struct Floor {
    /// The least possible number.
    pub(super) least: f64,
    /// Why.
    pub(super) why: String,
}

/// Where a cell stands, and its text as printed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Printed<'t> {
    pub(super) table: &'static str,
    pub(super) row: &'static str,
    pub(super) column: &'static str,
    pub(super) text: &'t str,
    pub(super) value: f64,
}

impl Printed<'_> {
    /// Half a unit of the last printed digit.
    fn half_unit(&self) -> f64 {
        let decimals = self.text.split_once('.').map_or(0, |(_, digits)| digits.len());
        0.5 * 10f64.powi(-i32::try_from(decimals).unwrap_or(0))
    }

    fn distance(&self, computed: f64) -> f64 {
        (computed - self.value).abs() / self.value.abs()
    }

    /// Whether the computed number is the printed one when rounded; half a unit itself rounds either way.
    fn rounds(&self, computed: f64) -> bool {
        (computed - self.value).abs() <= self.half_unit() * (1.0 + 1e-9)
    }

    /// Judges the number under the convention that comes closest; the stated one where it rounds to it.
    pub(super) fn judge(self, candidates: &[Candidate], floors: &[Floor]) -> Cell {
        let readings = candidates
            .iter()
            .map(|candidate| Reading {
                convention: candidate.convention.clone(),
                computed: candidate.computed,
            })
            .collect();
        let stated = candidates.iter().find(|candidate| candidate.departure.is_none());
        let exact =
            stated.filter(|candidate| candidate.computed.is_some_and(|computed| self.rounds(computed)));
        let closest = candidates
            .iter()
            .filter_map(|candidate| Some((self.distance(candidate.computed?), candidate)))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, candidate)| candidate);
        let chosen = exact.or(closest);
        let computed = chosen.and_then(|candidate| candidate.computed);
        // The greatest number that prints like this must lie above the floor.
        let broken = floors.iter().find(|floor| self.value + self.half_unit() < floor.least * (1.0 - 1e-9));
        let verdict = match (broken, computed) {
            (Some(_), _) => Verdict::Impossible,
            (None, Some(computed)) if self.rounds(computed) || self.distance(computed) <= REPRODUCED => {
                Verdict::Reproduced
            }
            (None, Some(computed)) if self.distance(computed) <= CLOSE => Verdict::Close,
            (None, _) => Verdict::NotReproduced,
        };
        let reason = match (broken, computed) {
            (Some(floor), _) => Some(format!("printed {}, but {}", self.text, floor.why)),
            (None, Some(computed)) => self.reason(
                verdict,
                computed,
                chosen.and_then(|candidate| candidate.departure.as_ref()),
                stated,
            ),
            (None, None) => Some("no convention gives a finite number".to_owned()),
        };
        Cell {
            table: self.table,
            row: self.row,
            column: self.column,
            printed: self.value,
            computed,
            convention: chosen.map_or_else(String::new, |candidate| candidate.convention.clone()),
            verdict,
            reason,
            readings,
        }
    }

    fn reason(
        &self,
        verdict: Verdict,
        computed: f64,
        departure: Option<&String>,
        stated: Option<&Candidate>,
    ) -> Option<String> {
        let differs = (verdict != Verdict::Reproduced).then(|| {
            let percent = 100.0 * (self.value - computed) / computed;
            format!("printed {percent:+.1} % from the computed {}", short(computed))
        });
        let departs = departure.map(|departure| {
            let of_stated = stated.and_then(|stated| stated.computed);
            let of_stated = of_stated.map_or_else(|| "no finite number".to_owned(), short);
            format!("{departure}; the stated convention gives {of_stated}")
        });
        match (differs, departs) {
            (None, None) => None,
            (Some(one), None) => Some(format!("{one}, under the stated convention, which comes closest")),
            (None, Some(other)) => Some(other),
            (Some(one), Some(other)) => Some(format!("{one}: {other}")),
        }
    }
}

/// Five significant digits.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    rounded.to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judged(text: &str, computed: &[f64], floor: f64) -> Cell {
        let printed =
            Printed { table: "t", row: "r", column: "c", text, value: text.parse().expect("a number") };
        let candidate = |(index, computed): (usize, &f64)| Candidate {
            convention: index.to_string(),
            computed: Some(*computed),
            departure: (index > 0).then(|| "differs".to_owned()),
        };
        let candidates: Vec<_> = computed.iter().enumerate().map(candidate).collect();
        printed.judge(&candidates, &[Floor { least: floor, why: "below".to_owned() }])
    }

    #[test]
    fn the_limits_of_the_verdicts_are_half_a_percent_and_five_percent() {
        for (computed, verdict) in [
            (100.5, Verdict::Reproduced),
            (100.51, Verdict::Close),
            (105.0, Verdict::Close),
            (105.1, Verdict::NotReproduced),
        ] {
            assert_eq!(judged("100.00", &[computed], 0.0).verdict, verdict, "{computed}");
        }
        assert_eq!(judged("0.2", &[0.249], 0.0).verdict, Verdict::Reproduced);
    }

    #[test]
    fn a_number_below_its_floor_is_impossible_even_where_it_is_close() {
        assert_eq!(judged("5.9", &[6.0], 6.0).verdict, Verdict::Impossible);
        assert_eq!(judged("6.0", &[6.0], 6.04).verdict, Verdict::Reproduced);
    }

    #[test]
    fn the_closest_convention_is_named_and_the_stated_one_preferred_where_it_rounds_to_the_print() {
        assert_eq!(judged("10.0", &[11.0, 10.1], 0.0).convention, "1");
        assert_eq!(judged("10.0", &[10.04, 10.0], 0.0).convention, "0");
        assert!(judged("10.0", &[10.04, 10.0], 0.0).reason.is_none());
    }
}
