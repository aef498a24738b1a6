//! The options of a sampled loop: sampling, sensor and valve, and the process that the loop really has.

use clap::Args;
use holdup::analysis::response::sampled::{
    Equipment, EquipmentError, EquipmentSettings, LoadRamp, SampledError,
};
use holdup::model::Process;
use holdup::model::notation::read_process;
use holdup::model::quantity::{read_number, read_time};

use crate::fault::Fault;

/// Sampling and equipment. Outputs are in the scale of the manipulated variable, in which it rests at
/// --initial-manipulated.
#[derive(Debug, Args)]
#[command(next_help_heading = "Sampled loop (each of these needs --sample-period)")]
pub(crate) struct SampledArgs {
    /// Run the sampled law, one sample in this time; the process stays exact between samples
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) sample_period: Option<String>,
    /// Least and greatest manipulated variable; the law knows them
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    pub(crate) limits: Option<String>,
    /// The manipulated variable at rest, before the first event, where --limits are those of its scale [default: 0]
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) initial_manipulated: Option<String>,
    /// Greatest rate of the valve, per second; the law knows it
    #[arg(long, value_name = "RATE", allow_hyphen_values = true)]
    pub(crate) rate_limit: Option<String>,
    /// Deadband (backlash) of the valve: --stiction D:0
    #[arg(long, value_name = "D", allow_hyphen_values = true, conflicts_with = "stiction")]
    pub(crate) deadband: Option<String>,
    /// Stiction of the valve, Kano's model (2004): stickband plus deadband, slip jump
    #[arg(long, value_name = "S:J", allow_hyphen_values = true)]
    pub(crate) stiction: Option<String>,
    /// Steps of the output
    #[arg(long, value_name = "STEP", allow_hyphen_values = true)]
    pub(crate) output_quantum: Option<String>,
    /// Steps of the measurement
    #[arg(long, value_name = "STEP", allow_hyphen_values = true)]
    pub(crate) measurement_quantum: Option<String>,
    /// Standard deviation of white Gaussian noise on the measurement
    #[arg(long, value_name = "DEVIATION", allow_hyphen_values = true)]
    pub(crate) noise: Option<String>,
    /// Seed of all that is random [default: 0]
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub(crate) seed: Option<String>,
    /// Each sample comes late by a random time from 0 to this
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) jitter: Option<String>,
    /// Probability that a measurement is lost
    #[arg(long, value_name = "PROBABILITY", allow_hyphen_values = true)]
    pub(crate) drop: Option<String>,
    /// Time from a sample to the output that follows from it
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) computation_delay: Option<String>,
    /// Load that changes in a straight line, in addition to --load: start:end:change,…
    #[arg(long, value_name = "50:150:2", allow_hyphen_values = true)]
    pub(crate) load_ramp: Option<String>,
    /// The process that is simulated, where it is another than the one (-p) that the controller's model was made for
    #[arg(long, value_name = "K=…,d=…")]
    pub(crate) actual_process: Option<String>,
}

impl SampledArgs {
    /// Name and text of every option but the sample period.
    fn others(&self) -> [(&'static str, &Option<String>); 14] {
        [
            ("--limits", &self.limits),
            ("--initial-manipulated", &self.initial_manipulated),
            ("--rate-limit", &self.rate_limit),
            ("--deadband", &self.deadband),
            ("--stiction", &self.stiction),
            ("--output-quantum", &self.output_quantum),
            ("--measurement-quantum", &self.measurement_quantum),
            ("--noise", &self.noise),
            ("--seed", &self.seed),
            ("--jitter", &self.jitter),
            ("--drop", &self.drop),
            ("--computation-delay", &self.computation_delay),
            ("--load-ramp", &self.load_ramp),
            ("--actual-process", &self.actual_process),
        ]
    }

    /// The equipment; none where there is no sample period.
    pub(crate) fn equipment(&self) -> Result<Option<Equipment>, Fault> {
        let Some(period) = &self.sample_period else {
            return match self.others().into_iter().find(|(_, given)| given.is_some()) {
                Some((option, _)) => {
                    Err(Fault::option(option, "needs --sample-period: without it the loop is continuous"))
                }
                None => Ok(None),
            };
        };
        let number = |option: &str, given: &Option<String>| {
            given.as_ref().map(|text| read_number(option, text)).transpose().map_err(Fault::input)
        };
        let time = |option: &str, given: &Option<String>| {
            given.as_ref().map(|text| read_time(option, text)).transpose().map_err(Fault::input)
        };
        let stiction = match number("--deadband", &self.deadband)? {
            Some(deadband) if deadband < 0.0 => {
                return Err(Fault::input(format!("--deadband is {deadband}: must be 0 or greater")));
            }
            Some(deadband) => Some((deadband, 0.0)),
            None => pair("--stiction", self.stiction.as_ref(), "two numbers S:J such as 1:0.5")?,
        };
        let settings = EquipmentSettings {
            sample_period: read_time("--sample-period", period).map_err(Fault::input)?,
            limits: pair("--limits", self.limits.as_ref(), "two numbers LOW:HIGH such as 0:100")?,
            rate_limit: number("--rate-limit", &self.rate_limit)?,
            initial_manipulated: number("--initial-manipulated", &self.initial_manipulated)?.unwrap_or(0.0),
            stiction,
            output_quantum: number("--output-quantum", &self.output_quantum)?,
            measurement_quantum: number("--measurement-quantum", &self.measurement_quantum)?,
            noise: number("--noise", &self.noise)?.unwrap_or(0.0),
            seed: self.seed.as_ref().map_or(Ok(0), |text| seed(text))?,
            jitter: time("--jitter", &self.jitter)?.unwrap_or(0.0),
            drop: number("--drop", &self.drop)?.unwrap_or(0.0),
            computation_delay: time("--computation-delay", &self.computation_delay)?.unwrap_or(0.0),
        };
        Equipment::new(settings).map(Some).map_err(|error| equipment_fault(&error))
    }

    /// The ramps of the load.
    pub(crate) fn ramps(&self) -> Result<Vec<LoadRamp>, Fault> {
        let Some(text) = &self.load_ramp else { return Ok(Vec::new()) };
        let read = |ramp: &str| {
            let refused =
                || Fault::input(format!("--load-ramp is {ramp}: must be start:end:change such as 50:150:2"));
            let parts: Vec<&str> = ramp.split(':').collect();
            let [start, end, change] = parts[..] else { return Err(refused()) };
            let start = read_time("", start).map_err(|_| refused())?;
            let end = read_time("", end).map_err(|_| refused())?;
            let change = read_number("", change).map_err(|_| refused())?;
            LoadRamp::new(start, end, change)
                .map_err(|error| Fault::input(error.to_string().replacen("load_ramp", "--load-ramp", 1)))
        };
        text.split(',').map(read).collect()
    }

    /// The process that is simulated, where it is another one.
    pub(crate) fn actual_process(&self) -> Result<Option<Process>, Fault> {
        let read =
            |text: &String| read_process(text).map_err(|error| Fault::option("--actual-process", error));
        self.actual_process.as_ref().map(read).transpose()
    }
}

/// Two numbers with a colon between.
fn pair(option: &str, given: Option<&String>, allowed: &str) -> Result<Option<(f64, f64)>, Fault> {
    let Some(text) = given else { return Ok(None) };
    let refused = || Fault::input(format!("{option} is {}: must be {allowed}", text.escape_debug()));
    let (one, other) = text.split_once(':').ok_or_else(refused)?;
    let number = |text| read_number("", text).map_err(|_| refused());
    Ok(Some((number(one)?, number(other)?)))
}

/// A whole number below 2⁶⁴.
fn seed(text: &str) -> Result<u64, Fault> {
    let refused = || {
        Fault::input(format!(
            "--seed is {}: must be a whole number from 0 to {}",
            text.escape_debug(),
            u64::MAX
        ))
    };
    text.parse().map_err(|_| refused())
}

/// The refusal of a setting, under the name of its option.
fn equipment_fault(error: &EquipmentError) -> Fault {
    let (value, allowed) = error.bare();
    Fault::input(format!("--{} is {value}: must be {allowed}", error.name().replace('_', "-")))
}

/// The refusal of a sampled loop, under the name of its option.
pub(crate) fn sampled_fault(error: &SampledError) -> Fault {
    let option = error.setting().map_or_else(String::new, |name| format!("--{}", name.replace('_', "-")));
    Fault::input(error.called(&option))
}
