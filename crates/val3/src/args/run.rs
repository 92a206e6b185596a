//! Arguments of `val3 run`.

use camino::Utf8PathBuf;
use clap::ValueEnum;
use val3_machine::script::{ScriptValue, key_codes, typed_keys};

use super::{ControllerArgs, OutputArgs};
use crate::modbus::ModbusAddress;
use crate::serve::ServeAddress;
use crate::soap::SoapAddress;

/// Program with which an application starts (2.2.3).
pub(crate) const START: &str = "start";

/// Arguments of `val3 run`.
#[derive(Debug, Clone, clap::Args)]
pub(crate) struct RunArgs {
    /// The folder or .pjx of the application, or a folder that contains exactly one, or whose val3.toml chooses one as
    /// `[run.default]`
    #[arg(value_name = "APP", default_value = ".")]
    pub(crate) application: Utf8PathBuf,
    /// The program to start with
    #[arg(long, value_name = "NAME", default_value = START)]
    pub(crate) program: String,
    /// Run as fast as possible, or in real time [default: virtual, with --serve or --controller real]
    #[arg(help_heading = "Time", long, value_name = "TIME")]
    pub(crate) time: Option<RunTime>,
    /// End the run after this many seconds of the controller's clock
    #[arg(help_heading = "Time", long, value_name = "SECONDS", value_parser = seconds)]
    pub(crate) until: Option<f64>,
    /// Exit with 0 when the time of --until is reached: the normal end of a cyclic program
    #[arg(help_heading = "Time", long, requires = "until")]
    pub(crate) until_ok: bool,
    /// Write the events of the run, one JSON object per line, to a file or, with `-`, to the standard output
    #[arg(help_heading = "Output", long, value_name = "FILE.jsonl")]
    pub(crate) events: Option<Utf8PathBuf>,
    /// Write the arm every 4 ms while anything moves to a file, as a table with commas: time, move id, phase, joints, pose and
    /// speed of the tool centre point
    #[arg(help_heading = "Output", long, value_name = "FILE.csv")]
    pub(crate) trace: Option<Utf8PathBuf>,
    /// As --trace, also while nothing moves
    #[arg(hide_short_help = true, help_heading = "Output", long, value_name = "FILE.csv", conflicts_with = "trace")]
    pub(crate) trace_all: Option<Utf8PathBuf>,
    /// Draw the path of the tool centre point from three sides, and joints and speeds over time
    #[arg(help_heading = "Output", long, value_name = "FILE.svg")]
    pub(crate) plot: Option<Utf8PathBuf>,
    /// Draw the accelerations of the joints over time, too
    #[arg(hide_short_help = true, help_heading = "Output", long, requires = "plot")]
    pub(crate) plot_accelerations: bool,
    /// Write a page for browsers that plays the run again, without a server
    #[arg(help_heading = "Output", long, value_name = "FILE.html", conflicts_with = "debug_port")]
    pub(crate) export: Option<Utf8PathBuf>,
    /// List the time by program line; with a file, as JSON
    #[arg(help_heading = "Output", long, value_name = "FILE.json", num_args = 0..=1, require_equals = true)]
    pub(crate) times: Option<Option<Utf8PathBuf>>,
    /// Measure the cycles from each EVENT to the next one, such as "move = 'pick:12'" or "io = { valve1 = true }"; without
    /// EVENT, list the moves and signals that repeat
    #[arg(help_heading = "Output", long, value_name = "EVENT", num_args = 0..=1, require_equals = true)]
    pub(crate) cycles: Option<Option<String>>,
    /// Compare the cycles with those in a file of --times
    #[arg(hide_short_help = true, help_heading = "Output", long, value_name = "FILE.json")]
    pub(crate) against: Option<Utf8PathBuf>,
    /// Print a summary of the run instead of its output: why it ended, errors, printed lines, screen, moves, waits, signals, and
    /// what to do next
    #[arg(help_heading = "Output", long, value_name = "FORMAT", num_args = 0..=1, require_equals = true, default_missing_value = "text", conflicts_with_all = ["interactive", "serve", "soap", "debug_port", "screen"])]
    pub(crate) summary: Option<SummaryFormat>,
    /// Write the summary of the run to a file, as JSON with up to 1,000 entries in each list
    #[arg(help_heading = "Output", long, value_name = "FILE.json")]
    pub(crate) result: Option<Utf8PathBuf>,
    /// Set a global variable or a field of one before the run begins: `nSpeed=50`, `mFast.leave=20`, `sNames[1]=bolt`
    #[arg(help_heading = "Surroundings", long, value_name = "NAME=VALUE", value_parser = variable)]
    pub(crate) set: Vec<(String, ScriptValue)>,
    /// A TOML file with the events outside the application and their times; each variable and signal in it must exist
    #[arg(help_heading = "Surroundings", long, value_name = "FILE")]
    pub(crate) script: Option<Utf8PathBuf>,
    /// Keys to type whenever a program reads one: codes and names with commas (49,50,Return), or a text with
    /// names in braces (12.5{Return})
    #[arg(help_heading = "Surroundings", long, value_name = "KEYS", value_parser = keys)]
    pub(crate) keys: Vec<Keys>,
    /// Repeat the run whose --events this file contains: serial lines and sockets respond as recorded, the first
    /// difference is reported, and the run ends where the recording ends
    #[arg(hide_short_help = true, help_heading = "Surroundings", long, value_name = "FILE")]
    pub(crate) replay: Option<Utf8PathBuf>,
    /// Let debuggers attach through this TCP port of this machine; 0 chooses a free one
    #[arg(hide_short_help = true, help_heading = "Debugging", long, value_name = "PORT", conflicts_with_all = ["replay", "interactive"])]
    pub(crate) debug_port: Option<u16>,
    /// Begin the run when a debugger has attached
    #[arg(hide_short_help = true, help_heading = "Debugging", long, requires = "debug_port")]
    pub(crate) debug_wait: bool,
    /// Print the arm, positions and signals of the application as JSON instead of running it
    #[arg(hide_short_help = true, help_heading = "Output", long)]
    pub(crate) scene: bool,
    /// The controller for the run
    #[command(flatten)]
    pub(crate) controller: ControllerArgs,
    /// Show the user page when the run has ended
    #[arg(help_heading = "Output", long)]
    pub(crate) screen: bool,
    /// Show the user page in the terminal and use its keyboard as the pendant's; implies --time real
    #[arg(help_heading = "Operation", long)]
    pub(crate) interactive: bool,
    /// Show the run in a browser, where it can be operated, until Ctrl-C; implies --time real. Without an address only
    /// this machine can connect; port 0 chooses a free one
    #[arg(help_heading = "Operation", long, value_name = "ADDRESS:PORT", num_args = 0..=1, default_missing_value = "", conflicts_with = "interactive")]
    pub(crate) serve: Option<ServeAddress>,
    /// Serve the tables in the cell's applicom/Modbus/modbus.xml to Modbus TCP clients, such as a PLC; implies --time real.
    /// Without an address, only this machine can connect, to port 1502; port 0 chooses a free one
    #[arg(hide_short_help = true, help_heading = "Operation", long, value_name = "ADDRESS:PORT", num_args = 0..=1, default_missing_value = "", conflicts_with = "replay")]
    pub(crate) modbus: Option<ModbusAddress>,
    /// Answer clients of the SOAP interface as a CS8 or CS9 does, until Ctrl-C; implies --time real. Without an address
    /// only this machine can connect, to port 5653; port 0 chooses a free one
    #[arg(help_heading = "Operation", long = "controller", value_name = "ADDRESS:PORT", num_args = 0..=1, default_missing_value = "", conflicts_with_all = ["replay", "debug_port"])]
    pub(crate) soap: Option<SoapAddress>,
    /// Open the browser with the address of --serve
    #[arg(hide_short_help = true, help_heading = "Operation", long, requires = "serve")]
    pub(crate) open: bool,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

impl RunArgs {
    /// Whether virtual time follows real time.
    pub(crate) fn follows_wall(&self) -> bool {
        let is_served = (self.serve.is_some() || self.soap.is_some()) && self.time.is_none();
        let is_operated = self.interactive || self.modbus.is_some() || is_served;
        self.time == Some(RunTime::Real) || is_operated
    }

    /// Whether an operator or a client may act at any time.
    pub(crate) fn is_attended(&self) -> bool {
        self.interactive || self.serve.is_some() || self.modbus.is_some() || self.soap.is_some()
    }
}

/// Form of the summary of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SummaryFormat {
    /// Lines for people and language models
    Text,
    /// A JSON document
    Json,
}

/// How time passes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum RunTime {
    /// As fast as possible; time in which nothing happens is skipped
    Virtual,
    /// In real time
    Real,
}

/// Parses a variable and its value.
fn variable(text: &str) -> Result<(String, ScriptValue), String> {
    let (name, value) = text.split_once('=').ok_or("write NAME=VALUE, such as nSpeed=50")?;
    Ok((name.trim().to_owned(), ScriptValue::from(value.trim())))
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds: &f64| (0.0..1e9).contains(seconds));
    seconds.ok_or_else(|| "write a number of seconds from 0 to 1e9".to_owned())
}

/// Codes of the keys to press.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Keys(pub(crate) Vec<u16>);

/// Parses a list of key codes and names, or a text as in the `keys` of a script.
fn keys(text: &str) -> Result<Keys, String> {
    let is_list = text.contains(',') && text.split(',').any(is_key);
    let codes = match key_codes(text) {
        Err(_) if !is_list => typed_keys(text),
        listed => listed,
    };
    codes.map(Keys)
}

fn is_key(part: &str) -> bool {
    key_codes(part).is_ok_and(|codes| !codes.is_empty())
}
