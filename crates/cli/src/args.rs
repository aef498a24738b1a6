//! What the command line accepts. Values are read by the library, so that a fault names option, value and
//! what is allowed.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

use crate::commands::optimise::OptimiseArgs;
use crate::commands::robust::RobustArgs;
use crate::sampled::SampledArgs;

/// Design, prove and simulate control loops of integrating processes with dead time, exactly.
#[derive(Debug, Parser)]
#[command(
    name = "holdup",
    version,
    max_term_width = 100,
    after_help = "\
Example:
  holdup analyse -p K=0.0506,d=6 -c Kc=1.5321,Td=1.0343

Exit status: 0 success, 1 a --require that the result does not meet, 2 bad input."
)]
pub(crate) struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
    /// How to answer.
    #[command(flatten)]
    pub(crate) answer: AnswerArgs,
}

/// How to answer, the same for every command.
#[derive(Debug, Args)]
pub(crate) struct AnswerArgs {
    /// Write the result as JSON, and nothing else, to standard output
    #[arg(long, global = true)]
    pub(crate) json: bool,
    #[expect(clippy::doc_markdown, reason = "help text, shown as it is")]
    /// Exit with status 1 unless the result meets this, e.g. 'gain_margin>=2'; repeatable. The name is that of a field of
    /// the --json result: alone where it is unique, or a dotted path
    #[arg(long, global = true, value_name = "CONDITION")]
    pub(crate) require: Vec<String>,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// List the tuning rules, or show the page of one
    #[command(after_help = "\
Examples:
  holdup rules --structure pi --status recommended
  holdup rules pi-simc
  holdup rules --report atlas.html")]
    Rules(RulesArgs),
    /// Tune a controller by one rule, or by all that apply, ranked
    #[command(after_help = "\
Examples:
  holdup tune -p K=0.0506,d=6 --rule pid-wang-cluett-z1 --set beta=3
  holdup tune -p K=0.0506,d=6 --rule pd-exact --set Am=3 --set phi_m=65deg
  holdup tune -p K=0.0506,d=6 --structure pi --max-sensitivity 1.7 --sort load_iae")]
    Tune(TuneArgs),
    /// Prove a loop stable or not, and give its exact margins
    #[command(after_help = "\
Examples:
  holdup analyse -p K=0.0506,d=6 -c Kc=2.95,Ti=15,Td=3,N=100
  holdup analyse -p K=0.0506,d=6 -c Kc=1.5321,Td=1.0343,Ko=1.5321 --require 'gain_margin>=2'
  holdup analyse -p K=0.0506,d=6 -c Kc=2.95,Ti=15,Td=3,N=100 --limits 0:100 --initial-manipulated 40
  holdup analyse loop.toml --json
  holdup analyse -p K=0.0506,d=6 -c Kc=1.647,Ti=48 --sample-period 2 --require 'sampled.gain_margin>=2'
  holdup analyse -p K=0.0506,d=6 -c Kc=1.647,Ti=48 --largest-sample-period 'gain_margin>=2.5'")]
    Analyse(AnalyseArgs),
    /// Draw where a loop is stable in a plane of two settings, and where its robustness is constant
    #[command(after_help = "\
Examples:
  holdup region -p K=0.0506,d=6 --plane kc-ti --sensitivity 1.4,1.7,2 --plot region.svg
  holdup region -p K=0.0506,d=6 --plane kc-ko -c Kc=1.5321,Td=1.0343 --gain-margin 2,3 --json")]
    Region(RegionArgs),
    /// Simulate a loop exactly
    #[command(after_help = "\
Examples:
  holdup simulate -p K=0.0506,d=6 -c Kc=2.95,Ti=15,Td=3,N=100 --load 100:1
  holdup simulate -p K=0.0506,d=6 -c Kc=1.5321,Td=1.0343,N=100 --csv step.csv --plot step.svg
  holdup simulate -p K=0.0506,d=6 -c Kc=1.5321,Td=1.0343,N=2,Ko=0.7 --load 100:1 --sample-period 0.5 \
      --limits 0:100 --initial-manipulated 40 --rate-limit 5 --deadband 0.3 --noise 0.01 --seed 1 --plot real.png
  holdup simulate -p K=0.0506,d=6 -c Kc=1.647,Ti=48 --load-ramp 50:150:2 --sample-period 1 \
      --actual-process K=0.07,d=7 --stiction 1:0.5 --jitter 0.1 --drop 0.02 --computation-delay 0.1")]
    Simulate(Box<SimulateArgs>),
    /// Look at a plant record: what was read and repaired, what it shows, which part of it to use
    #[command(after_help = "\
Examples:
  holdup survey level.csv
  holdup survey export.txt --pv LIC101.PV --op LIC101.OP --plot record.png
  holdup survey rig.csv --time-unit min --pv-span 0:5 --from 13:05 --to 14:30 --json")]
    Survey(SurveyArgs),
    /// Compare several controllers on several scenarios, from a study file
    #[command(after_help = "\
Example:
  holdup compare studies/kadam-2017.toml --report kadam-2017.html")]
    Compare(CompareArgs),
    /// Find the best controller of a structure under limits on its robustness
    #[command(after_help = "\
Examples:
  holdup optimise -p K=0.0506,d=6 --structure pi --max-sensitivity 1.6
  holdup optimise -p K=0.0506,d=6 --structure pid --max-sensitivity 1.6 --max-noise-gain 15 --trade-off
  holdup optimise -p K=0.01,d=5 --objective averaging --load-step 10 --excursion 20")]
    Optimise(OptimiseArgs),
    /// Prove what a loop keeps over a range of process gains and dead times, and sample it
    #[command(after_help = "\
Examples:
  holdup robust -p K=0.0506,d=6 -c Kc=1.5,Ti=50 --gain 0.8:1.2 --dead-time 0.8:1.2
  holdup robust -p K=0.0506,d=6 -c Kc=1.5,Ti=50 --max-sensitivity 2 --samples 1000
  holdup robust -p K=0.0506,d=6 -c Kc=1.5,Ti=50 --load 0:1 --output runs.parquet --plot band.svg")]
    Robust(RobustArgs),
    /// Recompute every number that a paper prints, and judge each
    #[command(after_help = "Example:\n  holdup reproduce kadam-2017")]
    Reproduce(ReproduceArgs),
    /// Give the numbers to type into a vendor's controller block, or read them back
    #[command(after_help = "\
Examples:
  holdup convert
  holdup convert -c Kc=20,Ti=5min --to yokogawa-centum --pv-span 0:5 --op-span 0:100
  holdup convert -p K=0.0506,d=6 -c Kc=2.95,Ti=15,Td=3,N=100 --to all
  holdup convert --from rockwell-pide-dependent PGain=2,IGain=5 --pv-span 0:5 --op-span 0:100")]
    Convert(ConvertArgs),
    /// Write the controller as source code that runs in the plant: the same law, bit for bit
    #[command(after_help = "\
Examples:
  holdup export -p K=0.0506,d=6 -c Kc=1.5321,Td=1.0343,Ko=1.5321 --sample-period 0.5 --language c \\
      --limits 0:100 --rate-limit 10 --failure-time 60 --safe-output 20 --name level_d205 --output level_d205.c
  holdup export loop.toml --sample-period 100ms --language st --float f32")]
    Export(ExportArgs),
    /// Find gain and dead time of an integrating process from a relay test, exactly
    #[command(after_help = "\
Examples:
  holdup relay --high 55 --low 45 --high-time 40s --low-time 52s --swing 1.8 --hysteresis 0.2
  holdup relay --data relay-test.csv --pv level --op valve")]
    Relay(RelayArgs),
    /// Find gain and dead time, the controller that was running, and the load in a plant record
    #[command(after_help = "\
Examples:
  holdup identify export.csv
  holdup identify export.csv --pv LIC1.PV --op LIC1.OP --sp LIC1.SP --tune --report lic1.html")]
    Identify(IdentifyArgs),
    /// Write the completion script of a shell to standard output
    #[command(
        after_help = "Example:\n  holdup completions bash > ~/.local/share/bash-completion/completions/holdup"
    )]
    Completions(CompletionsArgs),
    /// Write the manual page to standard output
    #[command(after_help = "Example:\n  holdup man > holdup.1 && man ./holdup.1")]
    Man,
}

/// The loop: compact strings or a file.
#[derive(Debug, Args)]
pub(crate) struct LoopArgs {
    /// The loop as a file, instead of -p and -c
    #[arg(value_name = "LOOP.toml")]
    pub(crate) file: Option<PathBuf>,
    /// The process: K=…,d=…[,T=…][,integrators=2]; times take ms, s, min, h, gains /s, /min, /h
    #[arg(short, long, value_name = "K=…,d=…")]
    pub(crate) process: Option<String>,
    /// The controller: Kc=…[,Ti=…][,Td=…][,N=…|,Tf=…][,Ko=…[,Km=…][,dm=…]][,b=…][,c=…][,form=series|parallel]
    #[arg(short, long, value_name = "Kc=…,Ti=…")]
    pub(crate) controller: Option<String>,
    /// The loop as a file, instead of -p and -c
    #[arg(long = "loop", value_name = "LOOP.toml")]
    pub(crate) loop_file: Option<PathBuf>,
}

/// `holdup analyse`.
#[derive(Debug, Args)]
pub(crate) struct AnalyseArgs {
    /// The loop.
    #[command(flatten)]
    pub(crate) of: LoopArgs,
    /// The actuator.
    #[command(flatten)]
    pub(crate) actuator: ActuatorArgs,
    /// Also the exact margins of the loop sampled in this time, with hold and fractional dead time
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) sample_period: Option<String>,
    /// Time from a sample to the output that follows from it
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) computation_delay: Option<String>,
    /// Also the largest sample period up to which this holds for every smaller one: 'stable', or a margin with >= or <=
    #[arg(long, value_name = "CONDITION")]
    pub(crate) largest_sample_period: Option<String>,
}

/// The actuator of a loop.
#[derive(Debug, Args)]
pub(crate) struct ActuatorArgs {
    /// Limits of the manipulated variable: what the actuator allows, and what the design asks of it
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    pub(crate) limits: Option<String>,
    /// The manipulated variable at rest [default: 0, or the limit nearest to it]
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) initial_manipulated: Option<String>,
    /// Size of the setpoint step that is asked about [default: 1]
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) setpoint_step: Option<String>,
    /// Size of the load step that is asked about [default: 1]
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) load_step: Option<String>,
}

/// `holdup region`.
#[derive(Debug, Args)]
pub(crate) struct RegionArgs {
    /// The process: K=…,d=…[,T=…][,integrators=2]
    #[arg(short, long, value_name = "K=…,d=…")]
    pub(crate) process: Option<String>,
    /// The controller, whose settings outside the plane stay; when absent, there are none
    #[arg(short, long, value_name = "Kc=…,Td=…")]
    pub(crate) controller: Option<String>,
    /// The plane: kc-ti, kc-td or kc-ko
    #[arg(long, value_name = "PLANE", default_value = "kc-ti")]
    pub(crate) plane: String,
    /// Curves of these sensitivity peaks
    #[arg(long, value_name = "1.4,1.7,2")]
    pub(crate) sensitivity: Option<String>,
    /// Curves of these gain margins
    #[arg(long, value_name = "2,3")]
    pub(crate) gain_margin: Option<String>,
    /// Curves of these phase margins, in degrees
    #[arg(long, value_name = "45,60")]
    pub(crate) phase_margin: Option<String>,
    /// Greatest modulus of the proportional gain; when absent, 1.8/(K·d)
    #[arg(long, value_name = "GAIN", allow_hyphen_values = true)]
    pub(crate) max_gain: Option<String>,
    /// Greatest modulus of the other setting; when absent, 20 d, 1.5 d or 1.8/(K·d)
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) max_other: Option<String>,
    /// Write the picture to this file: .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
}

/// What happens to the loop.
#[derive(Debug, Args)]
pub(crate) struct ScenarioArgs {
    /// Setpoint, time:value,…; 0 before the first. A step to 1 at 0 where neither setpoint nor load is given
    #[arg(long, value_name = "0:1,100:3", allow_hyphen_values = true)]
    pub(crate) setpoint: Option<String>,
    /// Load disturbance at the process input, time:value,…
    #[arg(long, value_name = "100:1", allow_hyphen_values = true)]
    pub(crate) load: Option<String>,
    /// End of the simulation and of the integrals; when absent, 50 dead times after the last event
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) horizon: Option<String>,
    /// The output at rest before the first event; when absent, 0
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) initial: Option<String>,
}

/// A plant record and how to read it. What is not given is found out, and said.
#[derive(Debug, Args)]
pub(crate) struct RecordArgs {
    /// The record: CSV and its relatives, or Parquet
    #[arg(value_name = "DATA")]
    pub(crate) data: PathBuf,
    /// The time column, by name or by number from 1
    #[arg(long, value_name = "COLUMN")]
    pub(crate) time: Option<String>,
    /// The column of the controlled variable
    #[arg(long, value_name = "COLUMN")]
    pub(crate) pv: Option<String>,
    /// The column of the manipulated variable, the controller's output
    #[arg(long, value_name = "COLUMN")]
    pub(crate) op: Option<String>,
    /// The column of the setpoint
    #[arg(long, value_name = "COLUMN")]
    pub(crate) sp: Option<String>,
    /// The column that says manual or automatic
    #[arg(long, value_name = "COLUMN")]
    pub(crate) mode: Option<String>,
    /// A value of that column that means automatic, where it is unusual; repeatable
    #[arg(long, value_name = "VALUE")]
    pub(crate) automatic: Vec<String>,
    /// Unit of a time column of bare numbers: ms, s, min, h, d
    #[arg(long, value_name = "UNIT")]
    pub(crate) time_unit: Option<String>,
    /// Time from row to row, for a file without times
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) sample_period: Option<String>,
    /// Order of the numbers of a date: ymd, dmy, mdy
    #[arg(long, value_name = "ORDER")]
    pub(crate) date_order: Option<String>,
    /// What separates the fraction of a number: point, comma
    #[arg(long, value_name = "MARK")]
    pub(crate) decimal: Option<String>,
    /// Span of the controlled variable and the setpoint, which are then read in percent of it
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    pub(crate) pv_span: Option<String>,
    /// Span of the manipulated variable, which is then read in percent of it
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    pub(crate) op_span: Option<String>,
    /// Use the record from here on: seconds from its start, a time of day, or date and time
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) from: Option<String>,
    /// Use the record to here
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) to: Option<String>,
}

/// `holdup survey`.
#[derive(Debug, Args)]
pub(crate) struct SurveyArgs {
    /// The record.
    #[command(flatten)]
    pub(crate) record: RecordArgs,
    /// Draw the record with the proposed window; .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub(crate) plot: Option<PathBuf>,
}

/// `holdup identify`.
#[derive(Debug, Args)]
pub(crate) struct IdentifyArgs {
    /// The record.
    #[command(flatten)]
    pub(crate) record: RecordArgs,
    /// The kind of process: integrating, integrating-with-lag, double-integrating, first-order; chosen when absent
    #[arg(long, value_name = "KIND")]
    pub(crate) model: Option<String>,
    /// The greatest dead time that is looked for; when absent, a quarter of the record and at most 2000 rows
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) max_dead_time: Option<String>,
    /// How the manipulated variable goes between rows: constant, linear
    #[arg(long, value_name = "HOLD", default_value = "constant")]
    pub(crate) hold: String,
    /// What the load is taken for beside its random part: constant, drifting
    #[arg(long, value_name = "LOAD", default_value = "constant")]
    pub(crate) load: String,
    /// The greatest number of sudden changes of the load that are looked for, each of which must pay for itself; 0 for none
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u8).range(0..=3), default_value = "3")]
    pub(crate) load_steps: Option<u8>,
    /// How far the controlled variable may move in a test; when absent, half its range in the record
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) excursion: Option<String>,
    /// Tune a controller, with its margins over the whole confidence region and a replay of the record
    #[arg(long)]
    pub(crate) tune: bool,
    /// The rule that --tune uses
    #[arg(long, value_name = "ID", default_value = "pi-simc", requires = "tune")]
    pub(crate) rule: String,
    /// Write one self-contained page: record, fit, controller, load, before and after
    #[arg(long, value_name = "FILE.html")]
    pub(crate) report: Option<PathBuf>,
}

/// `holdup relay`.
#[derive(Debug, Args)]
pub(crate) struct RelayArgs {
    /// Upper value of the relay
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true, conflicts_with = "data")]
    pub(crate) high: Option<String>,
    /// Lower value of the relay
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true, conflicts_with = "data")]
    pub(crate) low: Option<String>,
    /// Time at the upper value in one period
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, conflicts_with = "data")]
    pub(crate) high_time: Option<String>,
    /// Time at the lower value in one period
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, conflicts_with = "data")]
    pub(crate) low_time: Option<String>,
    /// Period, where the two times are equal
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, conflicts_with_all = ["data", "high_time", "low_time"])]
    pub(crate) period: Option<String>,
    /// Swing of the controlled variable from trough to peak
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true, conflicts_with = "data")]
    pub(crate) swing: Option<String>,
    /// How far the controlled variable passes the setpoint before the relay switches; when absent, 0
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) hysteresis: Option<String>,
    /// The relay test as a record, instead of numbers
    #[arg(long, value_name = "FILE")]
    pub(crate) data: Option<PathBuf>,
    /// The column of the controlled variable in it
    #[arg(long, value_name = "COLUMN", requires = "data")]
    pub(crate) pv: Option<String>,
    /// The column of the manipulated variable in it
    #[arg(long, value_name = "COLUMN", requires = "data")]
    pub(crate) op: Option<String>,
}

/// `holdup rules`.
#[derive(Debug, Args)]
pub(crate) struct RulesArgs {
    /// Identifier of the rule to show
    #[arg(value_name = "ID")]
    pub(crate) id: Option<String>,
    /// List the rules of this structure only: p, pi, pd, pid, pd+dob
    #[arg(long, value_name = "STRUCTURE", conflicts_with = "id")]
    pub(crate) structure: Option<String>,
    /// List the rules for this process only: integrating, integrating-with-lag, double-integrating
    #[arg(short, long, value_name = "PROCESS", conflicts_with = "id")]
    pub(crate) process: Option<String>,
    /// List the rules of this status only: recommended, history, wrong
    #[arg(long, value_name = "STATUS", conflicts_with = "id")]
    pub(crate) status: Option<String>,
    /// Write the atlas of all rules as one self-contained page
    #[arg(long, value_name = "FILE.html", conflicts_with = "id")]
    pub(crate) report: Option<PathBuf>,
}

/// `holdup tune`.
#[derive(Debug, Args)]
pub(crate) struct TuneArgs {
    /// The process: K=…,d=…[,T=…][,integrators=2]
    #[arg(short, long, value_name = "K=…,d=…")]
    pub(crate) process: Option<String>,
    /// Identifier of the rule (see 'holdup rules'); all that apply when absent
    #[arg(long, value_name = "ID")]
    pub(crate) rule: Option<String>,
    /// Set a parameter of the rule; repeatable
    #[arg(long, value_name = "NAME=VALUE", requires = "rule")]
    pub(crate) set: Vec<String>,
    /// Rank the rules of this structure only: p, pi, pd, pid, pd+dob
    #[arg(long, value_name = "STRUCTURE", conflicts_with = "rule")]
    pub(crate) structure: Option<String>,
    /// Rank only rules whose loop has at most this sensitivity peak
    #[arg(long, value_name = "M_s", conflicts_with = "rule", allow_hyphen_values = true)]
    pub(crate) max_sensitivity: Option<String>,
    /// Rank by balance (the default), load_iae, setpoint_iae, sensitivity_peak, gain_margin, phase_margin,
    /// delay_margin, noise_gain, control_energy or total_variation
    #[arg(long, value_name = "QUANTITY", conflicts_with = "rule")]
    pub(crate) sort: Option<String>,
    /// Rank also the rules that are kept as history or as wrong
    #[arg(long, conflicts_with = "rule")]
    pub(crate) all: bool,
}

/// `holdup simulate`.
#[derive(Debug, Args)]
pub(crate) struct SimulateArgs {
    /// The loop.
    #[command(flatten)]
    pub(crate) of: LoopArgs,
    /// The scenario.
    #[command(flatten)]
    pub(crate) scenario: ScenarioArgs,
    #[expect(clippy::doc_markdown, reason = "help text, shown as it is")]
    /// Write t, setpoint, controlled_variable, manipulated_variable, load, load_estimate as CSV
    #[arg(long, value_name = "FILE.csv")]
    pub(crate) csv: Option<PathBuf>,
    /// Draw the response; .svg, .png or .html
    #[arg(long, value_name = "FILE.svg")]
    pub(crate) plot: Option<PathBuf>,
    /// Number of times in --csv and --plot, from 0 to the horizon [default: 2001]
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true, conflicts_with = "step")]
    pub(crate) points: Option<String>,
    /// Distance of the times in --csv and --plot, instead of their number
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) step: Option<String>,
    /// Sampling and equipment.
    #[command(flatten)]
    pub(crate) sampled: SampledArgs,
}

/// `holdup compare`.
#[derive(Debug, Args)]
pub(crate) struct CompareArgs {
    /// The study file
    #[arg(value_name = "STUDY.toml")]
    pub(crate) study: PathBuf,
    /// Write one self-contained page with every figure and table
    #[arg(long, value_name = "FILE.html")]
    pub(crate) report: Option<PathBuf>,
    /// Write one line per scenario, controller and metric as CSV
    #[arg(long, value_name = "FILE.csv")]
    pub(crate) csv: Option<PathBuf>,
    /// Draw the responses of one scenario; .svg, .png or .html
    #[arg(long, value_name = "FILE.svg")]
    pub(crate) plot: Option<PathBuf>,
    /// The scenario that --plot draws; the first when absent
    #[arg(long, value_name = "NAME", requires = "plot")]
    pub(crate) scenario: Option<String>,
}

/// `holdup reproduce`.
#[derive(Debug, Args)]
pub(crate) struct ReproduceArgs {
    /// The paper
    #[arg(value_name = "PAPER")]
    pub(crate) paper: String,
}

/// `holdup convert`.
#[derive(Debug, Args)]
pub(crate) struct ConvertArgs {
    /// Settings of the block of --from: name=value, separated by commas or spaces
    #[arg(value_name = "NAME=VALUE")]
    pub(crate) settings: Vec<String>,
    /// The process, for the margins of what the block really runs: K=…,d=…[,T=…][,integrators=2]
    #[arg(short, long, value_name = "K=…,d=…")]
    pub(crate) process: Option<String>,
    /// The controller, in the units of the plant
    #[arg(short, long, value_name = "Kc=…,Ti=…")]
    pub(crate) controller: Option<String>,
    /// Convert for this block, or for all
    #[arg(long, value_name = "VENDOR")]
    pub(crate) to: Option<String>,
    /// Read the controller out of the settings of this block
    #[arg(long, value_name = "VENDOR")]
    pub(crate) from: Option<String>,
    /// Range of the controlled variable, in the units of the design [default: 0:100]
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    pub(crate) pv_span: Option<String>,
    /// Range of the controller's output, in the units of the design [default: 0:100]
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    pub(crate) op_span: Option<String>,
    /// Unit of the controlled variable, for reading
    #[arg(long, value_name = "UNIT")]
    pub(crate) pv_unit: Option<String>,
    /// Period at which the block is executed
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) sample_period: Option<String>,
}

/// `holdup export`.
#[derive(Debug, Args)]
pub(crate) struct ExportArgs {
    /// The loop.
    #[command(flatten)]
    pub(crate) of: LoopArgs,
    /// The language: rust, c, st (Structured Text) or plcopen (the same as PLCopen XML)
    #[arg(short, long, value_name = "LANGUAGE")]
    pub(crate) language: String,
    /// Nominal sample period, at most the dead time; the law runs on the time that is measured
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) sample_period: String,
    /// What the controller is called in the source
    #[arg(long, value_name = "NAME", default_value = "controller")]
    pub(crate) name: String,
    /// The precision of the target: f64 or f32
    #[arg(long, value_name = "FLOAT", default_value = "f64")]
    pub(crate) float: String,
    /// Limits of the output, low:high; either may be left out
    #[arg(long, value_name = "0:100", allow_hyphen_values = true)]
    pub(crate) limits: Option<String>,
    /// Rate limit of the output, per second, up and down
    #[arg(long, value_name = "RATE", allow_hyphen_values = true)]
    pub(crate) rate_limit: Option<String>,
    /// Tracking time of the anti-windup; when absent, the integral time
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) tracking_time: Option<String>,
    /// Bias of the output; when absent, 0
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) bias: Option<String>,
    /// Time in which a bias that a transfer moved returns to its set value; when absent, it stays
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) bleed_time: Option<String>,
    /// Range of the measurement, low:high: one outside it holds the output
    #[arg(long, value_name = "0:100", allow_hyphen_values = true)]
    pub(crate) measurement_range: Option<String>,
    /// Age at which a measurement is stale, and holds the output
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) stale_time: Option<String>,
    /// Time without a good measurement after which the safe output is taken
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub(crate) failure_time: Option<String>,
    /// The output that is then taken
    #[arg(long, value_name = "VALUE", allow_hyphen_values = true)]
    pub(crate) safe_output: Option<String>,
    /// Segments of the observer's delay line; when absent, those that are needed and a quarter more
    #[arg(long, value_name = "COUNT", allow_hyphen_values = true)]
    pub(crate) segments: Option<String>,
    /// Write the source to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

/// `holdup completions`.
#[derive(Debug, Args)]
pub(crate) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum, value_name = "SHELL")]
    pub(crate) shell: clap_complete::Shell,
}
