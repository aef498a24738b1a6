//! What plants call the columns of a loop.

/// What a column can be used as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Time,
    Controlled,
    Manipulated,
    Setpoint,
    Mode,
}

impl Role {
    /// Its word in files and on the screen.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Time => "time",
            Self::Controlled => "controlled_variable",
            Self::Manipulated => "manipulated_variable",
            Self::Setpoint => "setpoint",
            Self::Mode => "mode",
        }
    }

    /// Its word in a sentence.
    pub(super) fn phrase(self) -> &'static str {
        match self {
            Self::Controlled => "controlled variable",
            Self::Manipulated => "manipulated variable",
            other => other.word(),
        }
    }

    /// The option that names it.
    pub(super) fn option(self) -> &'static str {
        match self {
            Self::Time => "--time",
            Self::Controlled => "--pv",
            Self::Manipulated => "--op",
            Self::Setpoint => "--sp",
            Self::Mode => "--mode",
        }
    }
}

/// Names that say the role, those of a control loop first, those of a measurement or an actuator next; the last are
/// names whose meaning the other columns decide: an `output` is the controller's where there is a `pv`, and the
/// process's where there is an `input`.
const NAMES: [(Role, u8, &[&str]); 9] = [
    (
        Role::Controlled,
        0,
        &[
            "pv",
            "process value",
            "process variable",
            "processvalue",
            "controlled variable",
            "controlled value",
            "istwert",
        ],
    ),
    (
        Role::Manipulated,
        0,
        &[
            "op",
            "co",
            "mv",
            "controller output",
            "control output",
            "manipulated variable",
            "manipulated value",
            "stellwert",
            "stellgröße",
            "stellgroesse",
        ],
    ),
    (
        Role::Setpoint,
        0,
        &[
            "sp",
            "sv",
            "setpoint",
            "set point",
            "setvalue",
            "set value",
            "sollwert",
            "reference",
            "ref",
            "target",
        ],
    ),
    (
        Role::Mode,
        0,
        &[
            "mode",
            "auto",
            "aut",
            "auto man",
            "automan",
            "operation",
            "loop mode",
            "controller mode",
            "betriebsart",
            "mod",
        ],
    ),
    (
        Role::Controlled,
        1,
        &[
            "measurement",
            "measured value",
            "meas",
            "actual",
            "level",
            "lvl",
            "temperature",
            "temp",
            "pressure",
            "flow",
            "füllstand",
            "fuellstand",
            "temperatur",
            "druck",
            "cv",
            "y",
        ],
    ),
    (
        Role::Manipulated,
        1,
        &[
            "valve",
            "valve position",
            "heater",
            "pump",
            "actuator",
            "input",
            "u",
            "out",
            "cv",
            "damper",
            "speed",
            "ventil",
            "cmd",
            "command",
            "control signal",
        ],
    ),
    (Role::Setpoint, 1, &["r", "w"]),
    (Role::Controlled, 2, &["output", "value", "t"]),
    (Role::Manipulated, 2, &["output"]),
];

/// Names of time columns.
const TIMES: [&str; 21] = [
    "t stamp",
    "epoch",
    "unix time",
    "ts",
    "timestamp",
    "time stamp",
    "datetime",
    "date time",
    "time",
    "t",
    "date",
    "zeit",
    "zeitstempel",
    "datum",
    "uhrzeit",
    "clock",
    "elapsed",
    "elapsed time",
    "seconds",
    "day",
    "sample time stamp",
];

/// Words of columns that say something about a value and are none themselves.
const ABOUT: [&str; 26] = [
    "quality",
    "qual",
    "status",
    "flag",
    "limit",
    "alarm",
    "high",
    "low",
    "hi",
    "lo",
    "hh",
    "ll",
    "max",
    "min",
    "span",
    "range",
    "unit",
    "units",
    "eu",
    "deviation",
    "error",
    "tracking",
    "description",
    "count",
    "rate",
    "gain",
];

/// The words of a name in small letters: parted at everything but letters and digits, and before a capital.
pub(super) fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut small_before = false;
    for character in name.chars() {
        let parts = !character.is_alphanumeric() || (small_before && character.is_uppercase());
        if parts && words.last().is_some_and(|word| !word.is_empty()) {
            words.push(String::new());
        }
        if character.is_alphanumeric()
            && let Some(word) = words.last_mut()
        {
            word.extend(character.to_lowercase());
        }
        small_before = character.is_lowercase();
    }
    words.retain(|word| !word.is_empty());
    words
}

/// How a name says a role.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Meaning {
    pub(super) role: Role,
    /// 0 the clearest.
    pub(super) rank: u8,
    /// 3 the whole name, 2 its end or, for the clearest names, its start, 1 words in it.
    pub(super) strength: u8,
    /// Words of the name that say it: first and behind last.
    pub(super) words: (usize, usize),
}

/// Words behind a role that only say that its value is meant, as in `LIC1/PV.CV` and `LIC1/MODE.ACTUAL`.
const VALUE: [&str; 4] = ["cv", "value", "val", "actual"];

/// The roles that a name can have: all of the greatest clearness.
pub(super) fn meanings(name: &str) -> Vec<Meaning> {
    let mut words = words(name);
    if let [.., role, last] = &words[..]
        && VALUE.contains(&last.as_str())
        && ["pv", "op", "co", "mv", "out", "sp", "sv", "mode"].contains(&role.as_str())
    {
        words.pop();
    }
    let mut found: Vec<Meaning> = Vec::new();
    for (role, rank, names) in NAMES {
        let of_role = names.iter().filter_map(|name| place(&words, name));
        let best = of_role.max_by_key(|(strength, (first, end))| (*strength, end - first));
        if let Some((strength, place)) = best
            && (strength > 1 || !words.iter().any(|word| ABOUT.contains(&word.as_str())))
        {
            found.push(Meaning { role, rank, strength, words: place });
        }
    }
    let clearness = |meaning: &Meaning| i32::from(meaning.strength) * 10 - i32::from(meaning.rank);
    let most = found.iter().map(clearness).max().unwrap_or(0);
    found.retain(|meaning| clearness(meaning) == most);
    found
}

/// Whether the name says that a column is the time: 3 the whole name, 1 a part of it. A unit behind it is no part.
pub(super) fn says_time(name: &str) -> u8 {
    let mut words = words(name);
    if words.len() > 1 && words.last().is_some_and(|word| super::clock::unit_seconds(word).is_some()) {
        words.pop();
    }
    let strengths = TIMES.iter().filter_map(|time| place(&words, time)).map(|(strength, _)| strength);
    strengths.max().unwrap_or(0)
}

/// Whether a column tells how good values are.
pub(super) fn says_quality(name: &str) -> bool {
    words(name).iter().any(|word| {
        ["quality", "qual", "status", "stat", "st", "qualität", "dataintegrity"].contains(&word.as_str())
    })
}

/// Where the words of `wanted` stand in a name. A single letter counts only as the first word or the whole.
fn place(words: &[String], wanted: &str) -> Option<(u8, (usize, usize))> {
    let wanted: Vec<&str> = wanted.split(' ').collect();
    let count = wanted.len();
    let first = words.windows(count).rposition(|window| window.iter().zip(&wanted).all(|(a, b)| a == b))?;
    let place = (first, first + count);
    if words.len() == count {
        return Some((3, place));
    }
    if count == 1 && wanted[0].len() == 1 {
        return (first == 0).then_some((1, place));
    }
    Some((if first + count == words.len() { 2 } else { 1 }, place))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_plants_say_their_role() {
        for (name, role) in [
            ("PV", Role::Controlled),
            ("LIC101.PV", Role::Controlled),
            ("2411LIC30501.SV", Role::Setpoint),
            ("LIC101_OP", Role::Manipulated),
            ("ProcessValue", Role::Controlled),
            ("tank level", Role::Controlled),
            ("tank level sp", Role::Setpoint),
            ("level_valve", Role::Manipulated),
            ("Controller Output", Role::Manipulated),
            ("setPoint", Role::Setpoint),
            ("u_0_255", Role::Manipulated),
            ("FIC3.MODE", Role::Mode),
            ("Füllstand", Role::Controlled),
            ("heater", Role::Manipulated),
            ("LIC101/PV.CV", Role::Controlled),
            ("LIC101/OUT.CV", Role::Manipulated),
            ("LIC101/MODE.ACTUAL", Role::Mode),
        ] {
            let found = meanings(name);
            assert_eq!(found.len(), 1, "{name}: {found:?}");
            assert_eq!(found[0].role, role, "{name}");
        }
        for name in ["", "col3", "FT_115", "pv high limit", "temperature status x", "x14_sep_underflow_m3h"] {
            assert_eq!(meanings(name), [], "{name}");
        }
        assert_eq!(meanings("output").len(), 2);
        assert_eq!(meanings("CV").len(), 2);
    }

    #[test]
    fn times_are_known_with_their_unit() {
        for (name, strength) in
            [("time_s", 3), ("Time", 3), ("t", 3), ("PV time", 2), ("timeStamp", 3), ("level", 0)]
        {
            assert_eq!(says_time(name), strength, "{name}");
        }
    }
}
