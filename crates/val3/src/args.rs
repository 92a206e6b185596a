//! The command line.

mod arm;
mod byte_size;
mod controller;
mod coverage;
mod diff;
mod new;
mod packaging;
#[cfg(test)]
mod pages;
mod streams;
mod testing;

use std::str::FromStr;

use camino::Utf8PathBuf;
use clap::builder::styling::{AnsiColor, Styles};
use clap::{Parser, Subcommand, ValueEnum};

use val3_files::Limits;
use val3_machine::script::{key_codes, typed_keys};

use crate::baseline::Mode;
use crate::color::Color;
use crate::format::Format;
use crate::format::val3check::{DEFAULT_TEMPLATE, Template};
use crate::report::Severity;
use crate::serve::ServeAddress;
use crate::version::VERSION;

pub(crate) use arm::{ArmAction, ArmArgs, ArmFitArgs, ArmMeasureArgs, ArmShowArgs, AxisRange};
pub(crate) use byte_size::ByteSize;
pub(crate) use controller::ControllerArgs;
pub(crate) use coverage::{CoverageArgs, CoverageFormat};
pub(crate) use diff::{DiffArgs, DiffFormat};
pub(crate) use new::{NewArgs, NewFormat};
pub(crate) use packaging::{CompletionsArgs, ManArgs};
pub(crate) use streams::{InputArgs, OutputArgs};
pub(crate) use testing::{LIMITS, TestArgs, TestFormat};

const EXIT_CODES: &str = "\
Exit codes:
  0  no finding at or above the fail level
  1  findings; with --diff, something to change
  2  wrong usage, or a file that cannot be read or written";

const FMT_EXIT_CODES: &str = "\
Exit codes:
  0  done, or nothing to do
  1  with --check or --diff, something to change
  2  wrong usage, or a file that cannot be read or written";

const RUN_EXIT_CODES: &str = "\
Exit codes:
  0  the application has ended, or reached --until with --until-ok, or the replay has reached the end of the recording
  1  the compiler refuses the application, a run-time error was not handled, no task can continue, or the replay differs
  2  wrong usage, or a file that cannot be read or written
  3  the run has reached --until";

const TEST_EXIT_CODES: &str = "\
Exit codes:
  0  every test has passed
  1  a test has failed
  2  wrong usage, no tests, or an application that cannot be read or that the compiler refuses";

const FMT_SETTINGS: &str = "\
Settings:
  [format] in the nearest val3.toml, then .editorconfig (indent_style, indent_size).
  Comments, strings, lines with syntax errors and everything outside of the code are not changed.";

const CONFIGURATION: &str = "\
Settings:
  An application uses the nearest val3.toml in its folder or above.
  The comment //val3: allow(V0203) silences findings in the next line of code,
  //val3: allow-program(V0203) before the first line those in the program.";

const TRUST: &str = "\
Files that come with a cell (val3.toml, projects, scenarios, links) steer the tools inside the cell only: the
repository around them, otherwise their folder. Folders, serial devices and other machines outside need your word:
an argument such as --network or --line, the environment variable VAL3_TRUST with folders as in PATH, or this list.";

const STYLES: Styles = Styles::styled()
    .header(AnsiColor::Green.on_default().bold())
    .usage(AnsiColor::Green.on_default().bold())
    .literal(AnsiColor::Cyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

/// Tools for VAL 3, the language of Stäubli robots.
#[derive(Debug, Parser)]
#[command(name = "val3", version = VERSION, propagate_version = true, styles = STYLES, arg_required_else_help = true)]
pub(crate) struct Args {
    /// The command to run
    #[command(subcommand)]
    pub(crate) command: Command,
    /// When to colour the output
    #[arg(long, value_name = "WHEN", default_value = "auto", global = true)]
    pub(crate) color: Color,
    /// Read files up to this size, such as 2G. By default settings and scripts have at most 1M, files of a cell 16M,
    /// shapes 32M, programs and data 256M, and recordings 1G
    #[arg(long, value_name = "SIZE", global = true, hide_short_help = true)]
    pub(crate) max_file_size: Option<ByteSize>,
    /// Read programs and data up to this size in all
    #[arg(long, value_name = "SIZE", default_value = "2G", global = true, hide_short_help = true)]
    pub(crate) max_workspace_size: ByteSize,
}

impl Args {
    /// The limits of files.
    pub(crate) fn limits(&self) -> Limits {
        Limits { file: self.max_file_size.map(|ByteSize(bytes)| bytes), workspace: Some(self.max_workspace_size.0) }
    }
}

/// The commands, one a file.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Write an application with a move, a user page and a test
    #[command(disable_version_flag = true)]
    New(NewArgs),
    /// Check applications, libraries or whole cells
    #[command(after_help = EXIT_CODES, after_long_help = format!("{CONFIGURATION}\n\n{EXIT_CODES}"))]
    Check(CheckArgs),
    /// Format the code of programs
    #[command(after_help = FMT_EXIT_CODES, after_long_help = format!("{FMT_SETTINGS}\n\n{FMT_EXIT_CODES}"))]
    Fmt(FmtArgs),
    /// Compare two backups of a controller: programs, data, points, inputs and outputs
    #[command(override_usage = diff::USAGE, after_help = diff::EXIT_CODES)]
    Diff(DiffArgs),
    /// Run an application on the embedded controller
    #[command(after_help = RUN_EXIT_CODES)]
    Run(Box<RunArgs>),
    /// Execute the tests of applications, each on a controller of its own
    #[command(after_help = TEST_EXIT_CODES)]
    Test(Box<TestArgs>),
    /// Print values of expressions, and execute statements
    Eval(EvalArgs),
    /// Print the page of a finding, an instruction, a type or another word, or search all pages
    Explain(ExplainArgs),
    /// List arms, print their files, and measure the times of yours
    Arm(ArmArgs),
    /// Run the language server for an editor, on standard input and output
    Lsp(LspArgs),
    /// Debug applications for an editor with the Debug Adapter Protocol
    Dap(DapArgs),
    /// Trust the settings in a folder, so that they may reach outside of their cell
    #[command(after_help = TRUST)]
    Trust(TrustArgs),
    /// Print the JSON schema of val3.toml, for completion in editors
    Schema(SchemaArgs),
    /// Print a script that completes commands and options in a shell
    Completions(CompletionsArgs),
    /// Write manual pages into a folder, for packages
    Man(ManArgs),
    /// Print the version
    #[command(hide = true)]
    Version,
}

/// Arguments of `val3 check`.
#[derive(Debug, clap::Args)]
pub(crate) struct CheckArgs {
    /// Application folders, .pjx files, cells, or folders that contain them. For a program (.pgx) or data file (.dtx)
    /// only its own findings are reported; `-` reads one from the standard input
    #[arg(value_name = "PATH", default_value = ".")]
    pub(crate) paths: Vec<Utf8PathBuf>,
    /// With `-`: the path of the file that the standard input replaces
    #[arg(long, value_name = "PATH")]
    pub(crate) stdin_path: Option<Utf8PathBuf>,
    /// The source of the text
    #[command(flatten)]
    pub(crate) input: InputArgs,
    /// How findings are written to the standard output
    #[arg(long, default_value = "human")]
    pub(crate) format: Format,
    /// Also write the findings to a file, in a format of its own; may be repeated
    #[arg(long, value_name = "FORMAT=FILE")]
    pub(crate) output: Vec<Output>,
    /// The lowest level that makes the check fail
    #[arg(long, value_name = "LEVEL", default_value = "error")]
    pub(crate) fail_level: Severity,
    /// Exit with 0 even when there are findings
    #[arg(long)]
    pub(crate) exit_zero: bool,
    /// Report only these rules: codes (V0203), prefixes of codes (V02) or names, separated by commas
    #[arg(long, value_name = "CODES", value_delimiter = ',')]
    pub(crate) select: Vec<String>,
    /// Report these rules as well, even those that are off: codes, prefixes of codes or names
    #[arg(long, value_name = "CODES", value_delimiter = ',')]
    pub(crate) extend_select: Vec<String>,
    /// Do not report these rules; takes precedence over --select and --extend-select
    #[arg(long, value_name = "CODES", value_delimiter = ',')]
    pub(crate) ignore: Vec<String>,
    /// Also compare points, joints and moves with the arm: reach, limits, singularities, configurations
    #[arg(long)]
    pub(crate) motion: bool,
    /// With --motion: the arm (tx2-60l) or a file that describes it; takes precedence over val3.toml and the cell
    #[arg(long, value_name = "NAME")]
    pub(crate) arm: Option<String>,
    /// Apply safe fixes, which do not change what the programs do, and report the other findings
    #[arg(long, group = "fixing")]
    pub(crate) fix: bool,
    /// With --fix or --diff: also apply fixes that are a guess, such as a similar name
    #[arg(long, requires = "fixing")]
    pub(crate) unsafe_fixes: bool,
    /// Show what --fix would change, and write nothing; exits with 1 if there are changes
    #[arg(long, group = "fixing")]
    pub(crate) diff: bool,
    /// Add comments to the programs that silence their findings, and report the other findings
    #[arg(long, conflicts_with_all = ["fixing", "write_baseline", "prune_baseline", "explain_config"])]
    pub(crate) add_suppressions: bool,
    /// Count the findings of each rule instead of listing them
    #[arg(long, conflicts_with = "diff")]
    pub(crate) statistics: bool,
    /// Print only findings and errors: no summary, no hints, no progress
    #[arg(long, short)]
    pub(crate) quiet: bool,
    /// Check again whenever a file changes, until Ctrl-C, and mark new findings
    #[arg(long, conflicts_with_all = ["diff", "add_suppressions", "write_baseline", "prune_baseline", "explain_config"])]
    pub(crate) watch: bool,
    /// A file with known findings, which are not reported; takes precedence over `baseline` in val3.toml
    #[arg(long, value_name = "FILE")]
    pub(crate) baseline: Option<Utf8PathBuf>,
    /// Write all findings to the baseline, so that they are known, and report nothing
    #[arg(long, conflicts_with_all = ["prune_baseline", "fixing"])]
    pub(crate) write_baseline: bool,
    /// Remove findings that no longer occur from the baseline
    #[arg(long, conflicts_with = "fixing")]
    pub(crate) prune_baseline: bool,
    /// Check nothing; print each setting of each application with its source
    #[arg(long)]
    pub(crate) explain_config: bool,
    /// Number of threads [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(crate) jobs: Option<u16>,
    /// Template of a record of the val3check format: %e level, %f file, %l line, %m message, %c class, %p program,
    /// %s section
    #[arg(long, value_name = "TEMPLATE", default_value = DEFAULT_TEMPLATE, hide_default_value = true)]
    pub(crate) val3check_template: Template,
}

impl CheckArgs {
    /// The treatment of the baselines.
    pub(crate) fn baseline_mode(&self) -> Mode {
        match (self.write_baseline, self.prune_baseline) {
            (true, _) => Mode::Write,
            (_, true) => Mode::Prune,
            _ => Mode::Use,
        }
    }
}

/// Arguments of `val3 fmt`.
#[derive(Debug, clap::Args)]
pub(crate) struct FmtArgs {
    /// Programs (.pgx), or folders that contain them; `-` reads one program, or only its code, and writes it to the standard output
    #[arg(value_name = "PATH", default_value = ".")]
    pub(crate) paths: Vec<Utf8PathBuf>,
    /// Write nothing; list the programs that would change, and exit with 1 if there are any
    #[arg(long)]
    pub(crate) check: bool,
    /// Write nothing; show the changes, and exit with 1 if there are any
    #[arg(long)]
    pub(crate) diff: bool,
    /// With `-`: the path of the program, by which its settings are found
    #[arg(long, value_name = "PATH")]
    pub(crate) stdin_path: Option<Utf8PathBuf>,
    /// The source of the text
    #[command(flatten)]
    pub(crate) input: InputArgs,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// The program that an application starts with (2.2.3).
pub(crate) const START: &str = "start";

/// Arguments of `val3 run`.
#[derive(Debug, clap::Args)]
pub(crate) struct RunArgs {
    /// The folder or .pjx of the application, or a folder that contains exactly one
    #[arg(value_name = "APP", default_value = ".")]
    pub(crate) application: Utf8PathBuf,
    /// The program to start with
    #[arg(long, value_name = "NAME", default_value = START)]
    pub(crate) program: String,
    /// Run as fast as possible, or in real time [default: virtual, with --serve real]
    #[arg(long, value_name = "TIME")]
    pub(crate) time: Option<RunTime>,
    /// End the run after this many seconds of the controller's clock
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub(crate) until: Option<f64>,
    /// Exit with 0 when the time of --until is reached: the normal end of a cyclic program
    #[arg(long, requires = "until")]
    pub(crate) until_ok: bool,
    /// Write the events of the run, one JSON object per line, to a file or, with `-`, to the standard output
    #[arg(long, value_name = "FILE")]
    pub(crate) events: Option<Utf8PathBuf>,
    /// Write the arm every 4 ms while anything moves to a file, as a table with commas: time, move id, phase, joints, pose and
    /// speed of the tool centre point
    #[arg(long, value_name = "FILE.csv")]
    pub(crate) trace: Option<Utf8PathBuf>,
    /// As --trace, also while nothing moves
    #[arg(long, value_name = "FILE.csv", conflicts_with = "trace")]
    pub(crate) trace_all: Option<Utf8PathBuf>,
    /// Draw the path of the tool centre point from three sides, and joints and speeds over time
    #[arg(long, value_name = "FILE.svg")]
    pub(crate) plot: Option<Utf8PathBuf>,
    /// Draw the accelerations of the joints over time, too
    #[arg(long, requires = "plot")]
    pub(crate) plot_accelerations: bool,
    /// Write a page for browsers that plays the run again, without a server
    #[arg(long, value_name = "FILE.html", conflicts_with = "debug_port")]
    pub(crate) export: Option<Utf8PathBuf>,
    /// Show where the time went, by program line; with a file, as JSON
    #[arg(long, value_name = "FILE.json", num_args = 0..=1, require_equals = true)]
    pub(crate) times: Option<Option<Utf8PathBuf>>,
    /// A TOML file with what happens outside of the application and when; each variable and signal in it must exist
    #[arg(long, value_name = "FILE")]
    pub(crate) script: Option<Utf8PathBuf>,
    /// Keys to type whenever a program reads one: codes and names with commas (49,50,Return), or a text with
    /// names in braces (12.5{Return})
    #[arg(long, value_name = "KEYS", value_parser = keys)]
    pub(crate) keys: Vec<Keys>,
    /// Repeat the run whose --events this file contains: serial lines and sockets answer as recorded, the first
    /// difference is reported, and the run ends where the recording ends
    #[arg(long, value_name = "FILE")]
    pub(crate) replay: Option<Utf8PathBuf>,
    /// Let debuggers attach through this TCP port of this machine; 0 chooses a free one
    #[arg(long, value_name = "PORT", conflicts_with_all = ["replay", "interactive"])]
    pub(crate) debug_port: Option<u16>,
    /// Begin the run when a debugger has attached
    #[arg(long, requires = "debug_port")]
    pub(crate) debug_wait: bool,
    /// Print the arm, positions and signals of the application as JSON instead of running it
    #[arg(long)]
    pub(crate) scene: bool,
    /// The controller for the run
    #[command(flatten)]
    pub(crate) controller: ControllerArgs,
    /// Show the user page when the run has ended
    #[arg(long)]
    pub(crate) screen: bool,
    /// Show the user page in the terminal and use its keyboard as the pendant's; implies --time real
    #[arg(long)]
    pub(crate) interactive: bool,
    /// Show the run in a browser, where it can be operated, until Ctrl-C; implies --time real. Without an address only
    /// this machine can connect; port 0 chooses a free one
    #[arg(long, value_name = "ADDRESS:PORT", num_args = 0..=1, default_missing_value = "", conflicts_with = "interactive")]
    pub(crate) serve: Option<ServeAddress>,
    /// Open the browser with the address of --serve
    #[arg(long, requires = "serve")]
    pub(crate) open: bool,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

impl RunArgs {
    /// Time passes as on the wall.
    pub(crate) fn follows_wall(&self) -> bool {
        let is_operated = self.interactive || self.serve.is_some() && self.time.is_none();
        self.time == Some(RunTime::Real) || is_operated
    }
}

/// Arguments of `val3 eval`.
#[derive(Debug, clap::Args)]
pub(crate) struct EvalArgs {
    /// Expressions and statements; without any, lines of the standard input are executed
    #[arg(value_name = "TEXT", allow_hyphen_values = true)]
    pub(crate) texts: Vec<String>,
    /// The application whose data, programs and libraries the texts can use
    #[arg(long, value_name = "DIR")]
    pub(crate) app: Option<Utf8PathBuf>,
    /// A variable for the texts: `num nVal`, `point pA[3]`; may be repeated
    #[arg(long, value_name = "TYPE NAME")]
    pub(crate) local: Vec<String>,
    /// The controller for the texts
    #[command(flatten)]
    pub(crate) controller: ControllerArgs,
    /// The source of the text
    #[command(flatten)]
    pub(crate) input: InputArgs,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// How time passes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum RunTime {
    /// As fast as possible; time in which nothing happens is skipped
    Virtual,
    /// In real time
    Real,
}

fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse().ok().filter(|seconds: &f64| (0.0..1e9).contains(seconds));
    seconds.ok_or_else(|| "write a number of seconds from 0 to 1e9".to_owned())
}

/// The codes of keys that are typed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Keys(pub(crate) Vec<u16>);

/// Reads a list of codes and names, or a text as the `keys` of a script.
fn keys(text: &str) -> Result<Keys, String> {
    let is_key = |part: &str| key_codes(part).is_ok_and(|codes| !codes.is_empty());
    let is_list = text.contains(',') && text.split(',').any(is_key);
    let codes = match key_codes(text) {
        Err(_) if !is_list => typed_keys(text),
        listed => listed,
    };
    codes.map(Keys)
}

/// Arguments of `val3 explain`.
#[derive(Debug, clap::Args)]
pub(crate) struct ExplainArgs {
    /// A code (V0203), the name of a rule, an instruction, a keyword, a type, a field, an operator, a word of the field
    /// (father, world) or the number of a run-time error. Other words, and several, are searched in all pages; without
    /// any, all pages are listed
    #[arg(value_name = "WORDS")]
    pub(crate) words: Vec<String>,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Arguments of `val3 lsp`.
#[derive(Debug, clap::Args)]
pub(crate) struct LspArgs {
    /// Write the log of the server to this file
    #[arg(long, value_name = "FILE")]
    pub(crate) log: Option<Utf8PathBuf>,
    /// Use standard input and output. This is the default; many clients pass the option
    #[arg(long)]
    pub(crate) stdio: bool,
    /// The process of the editor, which clients also name in their first message
    #[arg(long = "clientProcessId", alias = "client-process-id", value_name = "PID", hide = true)]
    pub(crate) client_process_id: Option<u32>,
}

/// Arguments of `val3 dap`.
#[derive(Debug, clap::Args)]
pub(crate) struct DapArgs {
    /// Use standard input and output. This is the default; many clients pass the option
    #[arg(long, conflicts_with = "port")]
    pub(crate) stdio: bool,
    /// Serve clients on this TCP port of this machine, each with a session of its own; 0 chooses a free one
    #[arg(long, value_name = "PORT")]
    pub(crate) port: Option<u16>,
}

/// Arguments of `val3 trust`.
#[derive(Debug, clap::Args)]
#[group(required = true, multiple = true)]
pub(crate) struct TrustArgs {
    /// A folder whose settings, and those in folders below, may reach outside of their cell
    #[arg(value_name = "DIR")]
    pub(crate) folder: Option<Utf8PathBuf>,
    /// Print the trusted folders
    #[arg(long)]
    pub(crate) list: bool,
    /// Trust a folder no longer
    #[arg(long, value_name = "DIR")]
    pub(crate) remove: Option<Utf8PathBuf>,
}

/// Arguments of `val3 schema`.
#[derive(Debug, clap::Args)]
pub(crate) struct SchemaArgs {
    /// Print the schemas of the requests `launch` and `attach` of `val3 dap` instead, by the name of the request
    #[arg(long)]
    pub(crate) debugger: bool,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// A file and the format it gets.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Output<F = Format> {
    /// The format.
    pub(crate) format: F,
    /// The file; replaced if it exists.
    pub(crate) path: Utf8PathBuf,
}

impl<F: ValueEnum> FromStr for Output<F> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (format, path) = text
            .split_once('=')
            .filter(|(_, path)| !path.is_empty())
            .ok_or("write FORMAT=FILE, for example json=report.json")?;
        let format = F::from_str(format, true).map_err(|_| unknown_format::<F>(format))?;
        Ok(Self { format, path: path.into() })
    }
}

fn unknown_format<F: ValueEnum>(name: &str) -> String {
    let formats = F::value_variants().iter().filter_map(F::to_possible_value);
    let names: Vec<_> = formats.map(|format| format.get_name().to_owned()).collect();
    format!("`{name}` is not a format; known formats:  {}", names.join(", "))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_command_line_is_sound() {
        Args::command().debug_assert();
    }

    #[test]
    fn an_output_names_format_and_file() {
        let output: Output = "json-lines=out/a=b.json".parse().unwrap();
        assert_eq!(output.format, Format::JsonLines);
        assert_eq!(output.path, "out/a=b.json");
        assert!("json".parse::<Output>().is_err());
        assert!("json=".parse::<Output>().is_err());
        assert!("yaml=x".parse::<Output>().unwrap_err().contains("concise"));
    }
}
