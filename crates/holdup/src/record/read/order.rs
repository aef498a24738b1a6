//! Rows in the order of their times: reversed, shifted clocks, duplicates, coarse clocks.

use super::civil::{SECOND, iso};
use super::reading::{Repair, RepairKind, counted};

/// One hour [ns].
const HOUR: i64 = 3600 * SECOND;

/// Readings of a tag that is seldom written: their order in the file says nothing.
const FEW: usize = 40;

/// Rows in order.
#[derive(Debug)]
pub(super) struct Ordered {
    /// Numbers of the rows that are kept.
    pub(super) rows: Vec<usize>,
    /// Their instants [ns], strictly increasing.
    pub(super) instants: Vec<i64>,
}

/// Rows of several tags, the oldest first.
#[derive(Debug)]
pub(super) struct InFile {
    /// Numbers of the rows.
    pub(super) rows: Vec<usize>,
    /// Their instants [ns].
    pub(super) instants: Vec<i64>,
    /// Whether the tags' readings stand together by their times, and not one tag after the other.
    pub(super) together: bool,
}

/// Puts the readings of several tags the oldest first and, where they stand together, undoes a wall clock that was put
/// back: of a tag that is seldom written its own readings could not tell it.
pub(super) fn in_file_order(
    rows: Vec<usize>,
    instants: Vec<i64>,
    [local, dated]: [bool; 2],
    tag: impl Fn(usize) -> usize,
    repairs: &mut Vec<Repair>,
) -> InFile {
    let mut found = Ordered { rows, instants };
    reverse(&mut found, repairs);
    let mut seen = std::collections::HashSet::new();
    let mut together = true;
    for at in 0..found.rows.len() {
        let new = seen.insert(tag(found.rows[at]));
        together &= !(new && at > 0 && found.instants[at] < found.instants[at - 1]);
    }
    if together && local {
        back(&mut found, dated, repairs);
    }
    InFile { rows: found.rows, instants: found.instants, together }
}

/// Puts the readings of one tag in the order of their times; `clock` says that a wall clock may have been put back.
pub(super) fn sorted(
    rows: Vec<usize>,
    instants: Vec<i64>,
    [clock, dated]: [bool; 2],
    same: impl Fn(usize, usize) -> bool,
    repairs: &mut Vec<Repair>,
) -> Result<Ordered, Disorder> {
    let mut found = Ordered { rows, instants };
    if !found.instants.windows(2).all(|pair| pair[1] > pair[0]) {
        if clock {
            back(&mut found, dated, repairs);
        }
        sort(&mut found, FEW, repairs)?;
        repeat(&mut found, same, repairs);
    }
    Ok(found)
}

/// Rows that no sorting makes a record: the first that goes back, and how many do.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Disorder {
    pub(super) row: usize,
    pub(super) back: usize,
}

/// Puts rows in the order of their times. `local` says that a wall clock may have been changed, `dated` that the
/// instants have dates; `same` compares the values of two rows.
pub(super) fn ordered(
    rows: Vec<usize>,
    instants: Vec<i64>,
    local: bool,
    dated: bool,
    same: impl Fn(usize, usize) -> bool,
    repairs: &mut Vec<Repair>,
) -> Result<Ordered, Disorder> {
    let mut found = Ordered { rows, instants };
    if found.instants.windows(2).all(|pair| pair[1] > pair[0]) {
        forward(&found, local && dated, repairs);
        return Ok(found);
    }
    reverse(&mut found, repairs);
    if local {
        back(&mut found, dated, repairs);
    }
    sort(&mut found, 0, repairs)?;
    repeat(&mut found, same, repairs);
    forward(&found, local && dated, repairs);
    Ok(found)
}

fn reverse(found: &mut Ordered, repairs: &mut Vec<Repair>) {
    let steps = || found.instants.windows(2);
    let falls = steps().filter(|pair| pair[1] < pair[0]).count();
    if falls > steps().filter(|pair| pair[1] > pair[0]).count() {
        found.rows.reverse();
        found.instants.reverse();
        let rows = found.rows.len();
        let text = format!("the newest row stands first: {rows} rows are reversed");
        repairs.push(Repair::new(RepairKind::NewestFirst, rows, text));
    }
}

/// The median of the steps forward [ns].
fn median_step(instants: &[i64]) -> i64 {
    let mut steps: Vec<i64> =
        instants.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0).collect();
    if steps.is_empty() {
        return 0;
    }
    let middle = steps.len() / 2;
    *steps.select_nth_unstable(middle).1
}

/// A wall clock that goes back by an hour repeats that hour: what follows is moved on by it. It is told from rows out
/// of order by the rows after it, which fill the hour.
fn back(found: &mut Ordered, dated: bool, repairs: &mut Vec<Repair>) {
    let period = median_step(&found.instants);
    if period == 0 || period > HOUR / 2 {
        return;
    }
    let mut at = 1;
    while at < found.instants.len() {
        let before = found.instants[at - 1];
        let step = found.instants[at] - before;
        if step < 0 && (step + HOUR).abs() <= 3 * period {
            let again = found.instants[at..].iter().take_while(|instant| **instant <= before).count();
            let expected = usize::try_from(HOUR / period).unwrap_or(usize::MAX);
            if again * 2 > expected || at + again == found.instants.len() {
                let moved = found.instants.len() - at;
                found.instants[at..].iter_mut().for_each(|instant| *instant += HOUR);
                let when = if dated { format!(" after {}", iso(before)) } else { String::new() };
                let text =
                    format!("the clock goes back one hour{when}: {} moved on by it", counted(moved, "row"));
                repairs.push(Repair::new(RepairKind::ClockBack, moved, text));
            }
        }
        at += 1;
    }
}

/// A gap of just one hour at night in spring may be a clock put forward, and no gap.
fn forward(found: &Ordered, asked: bool, repairs: &mut Vec<Repair>) {
    let period = median_step(&found.instants);
    if !asked || period == 0 || period > HOUR / 2 {
        return;
    }
    for pair in found.instants.windows(2) {
        let hour = pair[0].rem_euclid(24 * HOUR) / HOUR;
        // 1970-01-04, day 3, was a Sunday.
        let sunday = pair[0].div_euclid(24 * HOUR).rem_euclid(7) == 3;
        let jump = pair[1] - pair[0] - HOUR;
        if sunday && hour <= 2 && (jump - period).abs() <= period / 2 {
            let text =
                format!("the gap of one hour after {} may be a clock put forward, and no gap", iso(pair[0]));
            repairs.push(Repair::new(RepairKind::ClockForward, 1, text));
        }
    }
}

/// Sorts, unless too many rows come late; `few` rows may do so in any order.
fn sort(found: &mut Ordered, few: usize, repairs: &mut Vec<Repair>) -> Result<(), Disorder> {
    let (mut latest, mut back, mut first) = (i64::MIN, 0, None);
    for (row, &instant) in found.rows.iter().zip(&found.instants) {
        if instant < latest {
            back += 1;
            first = first.or(Some(*row));
        }
        latest = latest.max(instant);
    }
    let Some(row) = first else { return Ok(()) };
    // A quarter of the rows is no longer a few that came late.
    if back * 4 > found.rows.len().max(few) {
        return Err(Disorder { row, back });
    }
    let mut pairs: Vec<(i64, usize)> =
        found.instants.iter().copied().zip(found.rows.iter().copied()).collect();
    pairs.sort_by_key(|(instant, _)| *instant);
    (found.instants, found.rows) = pairs.into_iter().unzip();
    let text = format!("{} behind later ones: sorted by time", counted(back, "row"));
    repairs.push(Repair::new(RepairKind::OutOfOrder, back, text));
    Ok(())
}

/// Rows of one time: all alike, or one that was corrected, or a clock that is coarser than the rows.
fn repeat(found: &mut Ordered, same: impl Fn(usize, usize) -> bool, repairs: &mut Vec<Repair>) {
    let mut groups: Vec<(usize, usize)> = Vec::new();
    for at in 0..found.rows.len() {
        match groups.last_mut() {
            Some((first, end)) if found.instants[*first] == found.instants[at] => *end = at + 1,
            _ => groups.push((at, at + 1)),
        }
    }
    if groups.len() == found.rows.len() {
        return;
    }
    let alike =
        |&(first, end): &(usize, usize)| (first + 1..end).all(|at| same(found.rows[first], found.rows[at]));
    let several: Vec<(usize, usize)> =
        groups.iter().copied().filter(|(first, end)| end - first > 1).collect();
    let differ = several.iter().filter(|group| !alike(group)).count();
    if several.len() * 10 > groups.len() * 7 && differ * 2 > several.len() && groups.len() > 1 {
        spread(found, &groups, repairs);
        return;
    }
    let (mut identical, mut conflicting) = (0, 0);
    let mut kept = Vec::with_capacity(groups.len());
    for group in &groups {
        let others = group.1 - group.0 - 1;
        *if alike(group) { &mut identical } else { &mut conflicting } += others;
        // Of rows that differ the last was written last.
        kept.push(group.1 - 1);
    }
    found.instants = kept.iter().map(|at| found.instants[*at]).collect();
    found.rows = kept.into_iter().map(|at| found.rows[at]).collect();
    if identical > 0 {
        let text = format!("{} there twice: one of each is kept", counted(identical, "row"));
        repairs.push(Repair::new(RepairKind::IdenticalRows, identical, text));
    }
    if conflicting > 0 {
        let text = format!(
            "{} with the time of another row but other values: the last of each time is kept",
            counted(conflicting, "row")
        );
        repairs.push(Repair::new(RepairKind::SameTime, conflicting, text));
    }
}

/// Spreads the rows of each time evenly until the next. The first and the last time may have lost rows: the first ends
/// at the second, and the last goes on with the usual distance.
fn spread(found: &mut Ordered, groups: &[(usize, usize)], repairs: &mut Vec<Repair>) {
    let mut sizes: Vec<usize> = groups.iter().map(|(first, end)| end - first).collect();
    sizes.sort_unstable();
    let usual = sizes[sizes.len() / 2].max(1);
    let starts: Vec<i64> = groups.iter().map(|(first, _)| found.instants[*first]).collect();
    let tick = median_step(&starts);
    let last = groups.len() - 1;
    for (index, &(first, end)) in groups.iter().enumerate() {
        let size = end - first;
        let room = starts.get(index + 1).map_or(tick, |next| (next - starts[index]).min(tick));
        let slots = if index == 0 || index == last { size.max(usual) } else { size };
        let skipped = if index == 0 { slots - size } else { 0 };
        for at in first..end {
            let slot = i64::try_from(at - first + skipped).unwrap_or(0);
            found.instants[at] = starts[index] + room * slot / i64::try_from(slots).unwrap_or(1);
        }
    }
    let rows = found.rows.len();
    let text = format!(
        "the clock steps by {} s while rows come faster: {rows} rows are spread evenly",
        tick / SECOND
    );
    repairs.push(Repair::new(RepairKind::CoarseClock, rows, text));
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn seconds(times: &[i64]) -> Vec<i64> {
        times.iter().map(|time| time * SECOND).collect()
    }

    fn order(times: &[i64], values: &[i32], local: bool) -> Result<(Vec<i64>, Vec<RepairKind>), Disorder> {
        let mut repairs = Vec::new();
        let rows = (0..times.len()).collect();
        let found = ordered(rows, seconds(times), local, true, |a, b| values[a] == values[b], &mut repairs)?;
        let times = found.instants.iter().map(|instant| instant / SECOND).collect();
        Ok((times, repairs.iter().map(|repair| repair.kind).collect()))
    }

    #[test]
    fn each_disorder_is_repaired_and_named() {
        let distinct: Vec<i32> = (0..20).collect();
        for (times, values, expected, kinds) in [
            (&[0, 1, 2][..], &distinct[..], &[0, 1, 2][..], &[][..]),
            (&[3, 2, 1], &distinct, &[1, 2, 3], &[RepairKind::NewestFirst]),
            (&[0, 1, 3, 2, 4], &distinct, &[0, 1, 2, 3, 4], &[RepairKind::OutOfOrder]),
            (&[0, 1, 1, 2, 3], &[7, 8, 8, 9, 10], &[0, 1, 2, 3], &[RepairKind::IdenticalRows]),
            (&[0, 1, 1, 2, 3], &distinct, &[0, 1, 2, 3], &[RepairKind::SameTime]),
            (
                &[60, 60, 120, 120, 120, 120, 180, 180, 180, 180, 240],
                &distinct,
                &[90, 105, 120, 135, 150, 165, 180, 195, 210, 225, 240],
                &[RepairKind::CoarseClock],
            ),
        ] {
            assert_eq!(
                order(times, values, false).unwrap(),
                (expected.to_vec(), kinds.to_vec()),
                "{times:?}"
            );
        }
        assert_eq!(order(&[5, 1, 4, 2, 3, 0, 7], &distinct, false).unwrap_err().row, 1);
    }

    #[test]
    fn an_hour_that_the_clock_repeats_is_moved_on() {
        let distinct: Vec<i32> = (0..200).collect();
        let wall: Vec<i64> = (0..120).map(|k| if k < 60 { k * 100 } else { k * 100 - 3600 }).collect();
        let (times, kinds) = order(&wall, &distinct, true).unwrap();
        assert_eq!(times, (0..120).map(|k| k * 100).collect::<Vec<_>>());
        assert_eq!(kinds, [RepairKind::ClockBack]);
    }

    proptest! {
        #[test]
        fn what_is_kept_rises_strictly(times in prop::collection::vec(0_i64..10_000, 3..60), values in prop::collection::vec(0..3, 60)) {
            if let Ok((times, _)) = order(&times, &values, true) {
                prop_assert!(times.windows(2).all(|pair| pair[1] >= pair[0]));
            }
        }
    }
}
