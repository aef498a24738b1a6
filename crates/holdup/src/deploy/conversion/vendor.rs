//! The description of a vendor's controller block: what its file under `deploy/vendors` says.

/// A controller block of a vendor: its equation, its parameters as they are typed, and what it cannot do.
///
/// Inside a block the law is `u = K·(b·r − y + (1/Ti)·∫e + Td·s/(Tf·s + 1)·(c·r − y))`, or its interacting
/// counterpart, on scaled signals; the fields say how K, Ti, Td, Tf, b and c are typed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vendor {
    /// Identifier: the file's name with hyphens.
    pub id: &'static str,
    /// Vendor and block, for reading.
    pub name: &'static str,
    /// The equation as text, in the vendor's names.
    pub equation: &'static str,
    /// Where the equation and the names come from.
    pub source: Source,
    /// How the controlled variable enters the equation.
    pub input: Scale,
    /// How the manipulated variable leaves it.
    pub output: Scale,
    /// Whether the form is interacting (series): `K·(1 + 1/(Ti·s))·(Td·s + 1)/(Tf·s + 1)`.
    pub interacting: bool,
    /// The proportional gain.
    pub gain: Gain,
    /// The integral action.
    pub integral: Integral,
    /// The derivative action.
    pub derivative: Derivative,
    /// The filter of the derivative action.
    pub filter: Filter,
    /// The setpoint weights.
    pub weights: Weights,
    /// Where the sign of the gain is set.
    pub action: Action,
    /// The parameters that hold the spans, where there are any.
    pub spans: Option<SpanNames>,
    /// The parameter that holds the sample period, with the seconds that its unit has.
    pub sample_period: Option<(Number, f64)>,
    /// Settings that choose this form of the block.
    pub fixed: &'static [Fixed],
    /// What a user of the block must know, one sentence each.
    pub notes: &'static [&'static str],
}

/// Where a description comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source {
    /// Title and number of the manual or name of the source file.
    pub citation: &'static str,
    /// What of the description was read there; the rest is from memory.
    pub read: &'static str,
}

/// How a signal is scaled inside a block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scale {
    /// In the units of the plant.
    Engineering,
    /// The whole span is this number: 100 for percent, 1 for a fraction.
    Span(f64),
}

/// A parameter that is a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// Name, as typed.
    pub name: &'static str,
    /// Unit; empty for a ratio.
    pub unit: &'static str,
    /// Steps in a unit, where the block takes whole steps only: 10 for a resolution of 0.1.
    pub steps: Option<f64>,
    /// Whether the number of steps is typed instead of the value.
    pub counted: bool,
    /// The range that the block accepts, where the source says so, as typed.
    pub range: Option<(f64, f64)>,
    /// What must be known, or empty.
    pub note: &'static str,
}

impl Number {
    /// A parameter of any value.
    #[must_use]
    pub const fn new(name: &'static str, unit: &'static str) -> Self {
        Self { name, unit, steps: None, counted: false, range: None, note: "" }
    }

    /// The same in whole steps, so many a unit.
    #[must_use]
    pub const fn steps(self, steps: f64) -> Self {
        Self { steps: Some(steps), ..self }
    }

    /// The same typed as a number of steps, so many a unit.
    #[must_use]
    pub const fn counted(self, steps: f64) -> Self {
        Self { steps: Some(steps), counted: true, ..self }
    }

    /// The same within a range.
    #[must_use]
    pub const fn range(self, low: f64, high: f64) -> Self {
        Self { range: Some((low, high)), ..self }
    }

    /// The same with a note.
    #[must_use]
    pub const fn note(self, note: &'static str) -> Self {
        Self { note, ..self }
    }
}

/// How the proportional gain is typed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Gain {
    /// As a gain.
    Gain(Number),
    /// As a proportional band [%], 100 divided by the gain.
    Band(Number),
}

/// How a time is typed; each holds the seconds in its unit of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// As a time.
    Time(f64),
    /// As its reciprocal: repeats per unit of time.
    Rate(f64),
    /// As a gain of its own, K/Ti or K·Td.
    Gain(f64),
}

/// How the integral action is typed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integral {
    /// Its parameter.
    pub number: Number,
    /// What the number is.
    pub kind: Kind,
    /// How it is switched off.
    pub off: Off,
}

/// How integral action is switched off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Off {
    /// By this value.
    Value(f64),
    /// It cannot be.
    Never,
}

/// How the derivative action is typed; 0 is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Derivative {
    /// Its parameter.
    pub number: Number,
    /// What the number is.
    pub kind: Kind,
}

/// The filter of the derivative action.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Filter {
    /// None: the difference over one sample.
    Absent,
    /// Fixed: Tf is this multiple of Td.
    Fixed(f64),
    /// Fixed ratio, which a switch turns on or off.
    Switch {
        /// Name of the switch.
        name: &'static str,
        /// Its word for on.
        on: &'static str,
        /// Its word for off, its default.
        off: &'static str,
        /// Tf/Td when on.
        ratio: f64,
    },
    /// Typed as Tf/Td; the value where the design has no filter, which is the block's default (0: no filter).
    Ratio(Number, f64),
    /// Typed as Td/Tf; the value where the design has no filter, which is the block's default.
    Divisor(Number, f64),
    /// Typed as the time Tf, with the seconds in its unit; the value where the design has no filter, which is the
    /// block's default (0: no filter).
    Time(Number, f64, f64),
}

/// One setpoint weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weight {
    /// It is always this.
    Fixed(f64),
    /// Typed as it is; the default.
    Number(Number, f64),
    /// Typed as 1 − weight; the default of the typed number.
    Complement(Number, f64),
    /// A switch between 1 and 0.
    Words {
        /// Name of the switch.
        name: &'static str,
        /// Its word for 1.
        one: &'static str,
        /// Its word for 0.
        zero: &'static str,
        /// Whether 1 is the default.
        one_is_default: bool,
    },
}

/// The setpoint weights b (proportional) and c (derivative).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Weights {
    /// Each by itself.
    Each {
        /// Weight b.
        b: Weight,
        /// Weight c.
        c: Weight,
    },
    /// Both by the choice of an equation; the first is the default.
    Choice {
        /// Name of the choice.
        name: &'static str,
        /// The equations.
        choices: &'static [Choice],
        /// The word of the equation with free weights, and these, where there is one.
        free: Option<(&'static str, Number, Number)>,
    },
}

/// One equation of several: on what its terms act.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choice {
    /// Its word.
    pub word: &'static str,
    /// Weight b: 1 where proportional action is on the error, 0 where it is on the measurement.
    pub b: f64,
    /// Weight c of the derivative action.
    pub c: f64,
    /// Whether it is for controllers with integral action, or without; either where it is not said.
    pub integral: Option<bool>,
}

/// Where the sign of the gain is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Action {
    /// By a parameter; gains are typed positive.
    Words {
        /// Its name.
        name: &'static str,
        /// Its word for an output that falls when the measurement rises (positive gain), the default.
        reverse: &'static str,
        /// Its word for an output that rises with the measurement (negative gain).
        direct: &'static str,
    },
    /// By the sign of the gain.
    Sign,
    /// Nowhere: the gain is positive.
    ReverseOnly,
}

/// The parameters that hold the ends of the spans.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SpanNames {
    /// Low and high end of the controlled variable.
    pub pv: Option<(&'static str, &'static str)>,
    /// Low and high end of the output.
    pub op: Option<(&'static str, &'static str)>,
}

/// A setting that chooses this form of the block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fixed {
    /// Its name.
    pub name: &'static str,
    /// What is typed.
    pub word: &'static str,
    /// What must be known, or empty.
    pub note: &'static str,
}

impl Vendor {
    /// Whether the typed gain depends on the spans.
    #[must_use]
    pub fn uses_spans(&self) -> bool {
        [self.input, self.output].iter().any(|scale| matches!(scale, Scale::Span(_)))
    }
}
