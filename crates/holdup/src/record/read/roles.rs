//! Which column is which: by the options, by names, by what the cells look like.

use super::ReadOptions;
use super::column::{Heading, Kind};
use super::error::ReadError;
use super::names::{Meaning, Role, meanings, says_quality, says_time, words};
use super::reading::{Repair, RepairKind};
use crate::model::text::{nearest, one_line};

/// Columns of a message: more are not listed.
const LISTED: usize = 40;

/// Where the times are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TimeColumn {
    /// In one column.
    One(usize),
    /// Dates in one column, times of day in another.
    Two(usize, usize),
    /// Nowhere: rows are evenly spaced.
    None,
}

/// Columns by number, from 0.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Roles {
    pub(super) time: TimeColumn,
    pub(super) controlled: usize,
    pub(super) manipulated: usize,
    pub(super) setpoint: Option<usize>,
    pub(super) mode: Option<usize>,
    pub(super) quality: Vec<usize>,
}

impl TimeColumn {
    /// Its columns.
    pub(super) fn columns(self) -> Vec<usize> {
        match self {
            Self::One(column) => vec![column],
            Self::Two(date, clock) => vec![date, clock],
            Self::None => Vec::new(),
        }
    }
}

impl Roles {
    /// All columns that must be read.
    pub(super) fn needed(&self) -> Vec<usize> {
        let mut all =
            [self.time.columns(), vec![self.controlled, self.manipulated], self.quality.clone()].concat();
        all.extend(self.setpoint);
        all.extend(self.mode);
        all.sort_unstable();
        all.dedup();
        all
    }

    /// What a column is used as.
    pub(super) fn used_as(&self, column: usize) -> Option<&'static str> {
        let role = if self.time.columns().contains(&column) {
            Role::Time
        } else if column == self.controlled {
            Role::Controlled
        } else if column == self.manipulated {
            Role::Manipulated
        } else if self.setpoint == Some(column) {
            Role::Setpoint
        } else if self.mode == Some(column) {
            Role::Mode
        } else {
            return self.quality.contains(&column).then_some("quality");
        };
        Some(role.word())
    }
}

/// Finds the role of each column.
pub(super) fn roles(
    headings: &[Heading],
    options: &ReadOptions,
    repairs: &mut Vec<Repair>,
) -> Result<Roles, ReadError> {
    let mut search = Search { headings, taken: Vec::new(), tags: false };
    search.given(options)?;
    if let Some(given) = &options.time {
        search.give(Role::Time, given)?;
    }
    let time = search.time(options, repairs)?;
    search.by_names(repairs)?;
    let free = |column: &usize| search.is_free(*column);
    let quality = (0..headings.len()).filter(free).filter(|&column| says_quality(&headings[column].name));
    let quality = quality.collect();
    search.roles(time, quality)
}

/// The time among columns of which some are taken for something else.
pub(super) fn find_time(
    headings: &[Heading],
    taken: &[usize],
    options: &ReadOptions,
    repairs: &mut Vec<Repair>,
) -> Result<TimeColumn, ReadError> {
    let taken = taken.iter().map(|column| (*column, Role::Controlled)).collect();
    let mut search = Search { headings, taken, tags: false };
    if let Some(given) = &options.time {
        search.give(Role::Time, given)?;
    } else if let Some(period) = options.sample_period {
        let allowed =
            "absent where a row of the file is a reading of a tag: readings have times of their own";
        return Err(ReadError::Option { option: "--sample-period", given: format!("{period} s"), allowed });
    }
    search.time(options, repairs)
}

/// The roles of tags: the first heading is that of the time, the others are tags.
pub(super) fn of_tags(
    headings: &[Heading],
    options: &ReadOptions,
    repairs: &mut Vec<Repair>,
) -> Result<Roles, ReadError> {
    let mut search = Search { headings, taken: vec![(0, Role::Time)], tags: true };
    search.given(options)?;
    search.by_names(repairs)?;
    search.roles(TimeColumn::One(0), Vec::new())
}

struct Search<'h> {
    headings: &'h [Heading],
    taken: Vec<(usize, Role)>,
    /// Whether the headings are tags, with the time before them.
    tags: bool,
}

impl Search<'_> {
    /// What an error calls a heading.
    fn noun(&self) -> &'static str {
        if self.tags { "tag" } else { "column" }
    }

    /// All headings, for an error.
    fn all(&self) -> String {
        self.list(0..self.headings.len())
    }

    /// Headings for an error: columns with their numbers, tags without.
    fn list(&self, columns: impl Iterator<Item = usize>) -> String {
        let all: Vec<usize> = columns.filter(|column| !self.tags || *column > 0).collect();
        let shown = all.iter().take(LISTED).map(|&n| {
            let name = one_line(&self.headings[n].full);
            if self.tags { format!("'{name}'") } else { format!("{} '{name}'", n + 1) }
        });
        let mut text = shown.collect::<Vec<_>>().join(", ");
        if all.len() > LISTED {
            text += &format!(" and {} more", all.len() - LISTED);
        }
        text
    }

    /// Takes what the options name.
    fn given(&mut self, options: &ReadOptions) -> Result<(), ReadError> {
        for (role, given) in [
            (Role::Controlled, &options.controlled_variable),
            (Role::Manipulated, &options.manipulated_variable),
            (Role::Setpoint, &options.setpoint),
            (Role::Mode, &options.mode),
        ] {
            if let Some(given) = given {
                self.give(role, given)?;
            }
        }
        Ok(())
    }

    /// Takes what names say, the clearest first.
    fn by_names(&mut self, repairs: &mut Vec<Repair>) -> Result<(), ReadError> {
        for rank in 0..3 {
            for role in [Role::Controlled, Role::Manipulated, Role::Setpoint, Role::Mode] {
                self.by_name(role, rank, repairs)?;
            }
        }
        Ok(())
    }

    /// What was found, with the time and the quality columns.
    fn roles(&self, time: TimeColumn, quality: Vec<usize>) -> Result<Roles, ReadError> {
        let needed = |role: Role| {
            self.of(role).ok_or_else(|| ReadError::Missing {
                noun: self.noun(),
                what: role.phrase(),
                option: role.option(),
                columns: self.all(),
            })
        };
        Ok(Roles {
            time,
            controlled: needed(Role::Controlled)?,
            manipulated: needed(Role::Manipulated)?,
            setpoint: self.of(Role::Setpoint),
            mode: self.of(Role::Mode),
            quality,
        })
    }

    fn of(&self, role: Role) -> Option<usize> {
        self.taken.iter().find(|(_, own)| *own == role).map(|(column, _)| *column)
    }

    fn is_free(&self, column: usize) -> bool {
        self.taken.iter().all(|(own, _)| *own != column)
    }

    /// A column by its name, or by its number from 1.
    fn give(&mut self, role: Role, given: &str) -> Result<(), ReadError> {
        let wanted = given.trim().to_lowercase();
        let named = |heading: &Heading| {
            heading.name.to_lowercase() == wanted || heading.full.to_lowercase() == wanted
        };
        let by_number = || {
            let number: usize = wanted.parse().ok().filter(|_| !self.tags)?;
            number.checked_sub(1).filter(|column| *column < self.headings.len())
        };
        let first = usize::from(self.tags);
        let by_name = self.headings.iter().skip(first).position(named).map(|place| place + first);
        let column = by_name.or_else(by_number).ok_or_else(|| {
            let near = nearest(given, self.headings.iter().skip(first).map(|heading| heading.name.as_str()));
            ReadError::NoColumn {
                noun: self.noun(),
                option: role.option(),
                given: one_line(given),
                hint: near.map_or_else(String::new, |near| format!(": did you mean '{}'?", one_line(near))),
                columns: self.all(),
            }
        })?;
        if let Some((_, other)) = self.taken.iter().find(|(own, _)| *own == column) {
            let column = one_line(&self.headings[column].name);
            return Err(ReadError::Twice {
                noun: self.noun(),
                column,
                first: other.option(),
                second: role.option(),
            });
        }
        self.taken.push((column, role));
        Ok(())
    }

    fn of_kind(&self, kind: Kind) -> Vec<usize> {
        (0..self.headings.len()).filter(|&n| self.is_free(n) && self.headings[n].kind == kind).collect()
    }

    fn time(&mut self, options: &ReadOptions, repairs: &mut Vec<Repair>) -> Result<TimeColumn, ReadError> {
        let given = self.of(Role::Time);
        if given.is_none() && options.sample_period.is_some() {
            return Ok(TimeColumn::None);
        }
        let (dates, clocks) = (self.of_kind(Kind::Date), self.of_kind(Kind::Clock));
        let found = match given {
            Some(column) => match (self.headings[column].kind, &dates[..], &clocks[..]) {
                (Kind::Date, _, [clock]) => TimeColumn::Two(column, *clock),
                (Kind::Clock, [date], _) => TimeColumn::Two(*date, column),
                _ => TimeColumn::One(column),
            },
            None => self.time_by_cells(&dates, &clocks, repairs)?,
        };
        let used = match found {
            TimeColumn::One(column) => vec![column],
            TimeColumn::Two(date, clock) => vec![date, clock],
            TimeColumn::None => Vec::new(),
        };
        self.taken.retain(|(_, role)| *role != Role::Time);
        self.taken.extend(used.into_iter().map(|column| (column, Role::Time)));
        Ok(found)
    }

    fn time_by_cells(
        &self,
        dates: &[usize],
        clocks: &[usize],
        repairs: &mut Vec<Repair>,
    ) -> Result<TimeColumn, ReadError> {
        let instants = self.of_kind(Kind::Instant);
        if !instants.is_empty() {
            return self.clearest(&instants).map(TimeColumn::One);
        }
        if let ([date], [clock]) = (dates, clocks) {
            return Ok(TimeColumn::Two(*date, *clock));
        }
        let numbers: Vec<usize> = [Kind::Number, Kind::Missing].map(|kind| self.of_kind(kind)).concat();
        let named: Vec<usize> =
            numbers.iter().copied().filter(|&n| says_time(&self.headings[n].name) >= 2).collect();
        for candidates in [&named[..], clocks, dates] {
            if !candidates.is_empty() {
                return self.clearest(candidates).map(TimeColumn::One);
            }
        }
        // Without a name that says it, an index that rises in the first column is most likely the time.
        let first = self.headings.first().filter(|first| first.kind == Kind::Number && first.rises);
        let nameless = |name: &str| name.is_empty() || name == "col1" || name.starts_with("Unnamed");
        if let Some(first) = first.filter(|first| nameless(&first.name) && self.is_free(0)) {
            let text = format!("column 1 ({}) rises and is taken as the time", first.name);
            repairs.push(Repair::new(RepairKind::ColumnAssumed, 0, text));
            return Ok(TimeColumn::One(0));
        }
        Err(ReadError::Missing {
            noun: self.noun(),
            what: "time",
            option: "--time, or give the --sample-period",
            columns: self.all(),
        })
    }

    /// The candidate whose name says most clearly that it is the time.
    fn clearest(&self, candidates: &[usize]) -> Result<usize, ReadError> {
        let strength = |column: &usize| says_time(&self.headings[*column].name);
        let most = candidates.iter().map(strength).max().unwrap_or(0);
        let best: Vec<usize> = candidates.iter().copied().filter(|column| strength(column) == most).collect();
        match best[..] {
            [only] => Ok(only),
            _ => Err(self.ambiguous(Role::Time, &best)),
        }
    }

    fn ambiguous(&self, role: Role, candidates: &[usize]) -> ReadError {
        let candidates = self.list(candidates.iter().copied());
        ReadError::Ambiguous { noun: self.noun(), what: role.phrase(), option: role.option(), candidates }
    }

    /// Takes the one column whose name says the role with this rank; of several, the one of the same tag as a column
    /// that is known already.
    fn by_name(&mut self, role: Role, rank: u8, repairs: &mut Vec<Repair>) -> Result<(), ReadError> {
        if self.of(role).is_some() {
            return Ok(());
        }
        let value = |kind: Kind| role == Role::Mode || matches!(kind, Kind::Number | Kind::Missing);
        let mut found: Vec<(usize, Meaning)> = (0..self.headings.len())
            .filter(|&n| {
                self.is_free(n) && value(self.headings[n].kind) && !says_quality(&self.headings[n].name)
            })
            .flat_map(|n| meanings(&self.headings[n].name).into_iter().map(move |meaning| (n, meaning)))
            .filter(|(_, meaning)| meaning.role == role && meaning.rank == rank)
            .collect();
        let most = found.iter().map(|(_, meaning)| meaning.strength).max().unwrap_or(0);
        found.retain(|(_, meaning)| meaning.strength == most);
        if found.len() > 1 {
            let known: Vec<Vec<String>> = self
                .taken
                .iter()
                .filter(|(_, own)| *own != Role::Time)
                .map(|(n, own)| self.stem(*n, *own))
                .collect();
            let same: Vec<(usize, Meaning)> =
                found.iter().copied().filter(|(n, _)| known.contains(&self.stem(*n, role))).collect();
            if same.len() == 1 {
                found = same;
            }
        }
        let columns: Vec<usize> = found.iter().map(|(column, _)| *column).collect();
        match columns[..] {
            [] => Ok(()),
            [only] => {
                self.taken.push((only, role));
                Ok(())
            }
            _ if matches!(role, Role::Controlled | Role::Manipulated) => Err(self.ambiguous(role, &columns)),
            _ => {
                let text = format!(
                    "no {} is used, because several {}s may be it: {}; {} names one",
                    role.phrase(),
                    self.noun(),
                    self.list(columns.iter().copied()),
                    role.option()
                );
                if !repairs.iter().any(|repair| repair.text == text) {
                    repairs.push(Repair::new(RepairKind::ColumnAssumed, 0, text));
                }
                Ok(())
            }
        }
    }

    /// The words of a column's name without those that say its role: the tag of the loop.
    fn stem(&self, column: usize, role: Role) -> Vec<String> {
        let name = &self.headings[column].name;
        let mut words = words(name);
        let place =
            meanings(name).into_iter().find(|meaning| meaning.role == role).map(|meaning| meaning.words);
        let (first, end) = place.unwrap_or((words.len().saturating_sub(1), words.len()));
        words.drain(first..end);
        words
    }
}
