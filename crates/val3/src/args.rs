//! The command line.

mod arm;
mod byte_size;
mod check;
mod connection;
mod controller;
mod coverage;
mod destination;
mod diff;
mod info;
mod log;
mod mcp;
mod merge;
mod new;
mod packaging;
#[cfg(test)]
mod pages;
mod report_file;
mod run;
mod streams;
mod testing;
mod transfer;

use camino::Utf8PathBuf;
use clap::builder::styling::{AnsiColor, Styles};
use clap::{Parser, Subcommand, ValueEnum};

use val3_files::ProcessLimits;

use crate::color::Color;
use crate::version::VERSION;

pub(crate) use arm::{ArmAction, ArmArgs, ArmFitArgs, ArmMeasureArgs, ArmShowArgs, ArmUrdfArgs, AxisRange};
pub(crate) use byte_size::ByteSize;
pub(crate) use check::CheckArgs;
pub(crate) use connection::ConnectionArgs;
pub(crate) use controller::{ControllerArgs, calendar};
pub(crate) use coverage::{CoverageArgs, CoverageFormat};
pub(crate) use diff::{DiffArgs, DiffFormat};
pub(crate) use info::{InfoArgs, InfoFormat};
pub(crate) use log::{LogArgs, LogFormat, Since};
pub(crate) use mcp::McpArgs;
pub(crate) use merge::MergeArgs;
pub(crate) use new::{NewArgs, NewFormat};
pub(crate) use packaging::{CompletionsArgs, ManArgs};
pub(crate) use report_file::ReportOutput;
pub(crate) use run::{RunArgs, RunTime, START, SummaryFormat};
pub(crate) use streams::{InputArgs, OutputArgs};
pub(crate) use testing::{EVENTS, LIMITS, TestArgs, TestFormat};
pub(crate) use transfer::{PullArgs, PushArgs, StatusArgs, TransferFormat};

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
  0  the application has ended, or has reached --until with --until-ok, or the recording has ended
  1  the compiler rejects the application, a run-time error was not handled, no task can continue,
     or the replay differs
  2  wrong usage, or a file that cannot be read or written
  3  the run has reached --until";

const TEST_EXIT_CODES: &str = "\
Exit codes:
  0  every test has passed
  1  a test has failed
  2  wrong usage, no tests, or an application that cannot be read or that the compiler rejects";

const FMT_SETTINGS: &str = "\
Settings:
  [format] in the nearest val3.toml, then .editorconfig (indent_style, indent_size).
  Comments, strings, lines with syntax errors and everything outside of the code are not changed.";

const CONFIGURATION: &str = "\
Settings:
  An application uses the nearest val3.toml in its folder or above.
  The comment //val3: allow(V0203) silences findings in the next line of code,
  //val3: allow-program(V0203) before the first line silences findings in the entire program.";

const TRUST: &str = "\
Files of a cell (val3.toml, projects, scenarios, links) control tools only inside the cell: the
repository around them, otherwise their folder. Folders, serial devices and other machines outside
require permission: an argument such as --network or --line, the environment variable VAL3_TRUST
with folders as in PATH, or this list.";

const STYLES: Styles = Styles::styled()
    .header(AnsiColor::Green.on_default().bold())
    .usage(AnsiColor::Green.on_default().bold())
    .literal(AnsiColor::Cyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

/// Tools for VAL 3, the language of Stäubli robots.
#[derive(Debug, Parser)]
#[command(name = "val3", version = VERSION, propagate_version = true, styles = STYLES, arg_required_else_help = true)]
#[command(max_term_width = 100, args_override_self = true)]
pub(crate) struct Args {
    /// The command to run
    #[command(subcommand)]
    pub(crate) command: CliCommand,
    /// Use this file instead of each application's nearest val3.toml
    #[arg(hide_short_help = true, help_heading = "Global options", long, value_name = "FILE", global = true)]
    pub(crate) config: Option<Utf8PathBuf>,
    /// Report the version, and each application's settings and arm, on the standard error output
    #[arg(hide_short_help = true, help_heading = "Global options", long, short, global = true)]
    pub(crate) verbose: bool,
    /// When to colour the output
    #[arg(help_heading = "Global options", long, value_name = "WHEN", default_value = "auto", global = true)]
    pub(crate) color: Color,
    /// Read files up to this size, such as 2G. By default settings and scripts have at most 1M, files of a cell 16M,
    /// shapes 32M, programs and data 256M, and recordings 1G
    #[arg(help_heading = "Global options", long, value_name = "SIZE", global = true, hide_short_help = true)]
    pub(crate) max_file_size: Option<ByteSize>,
    /// Read programs and data up to this size in all
    #[arg(
        help_heading = "Global options",
        long,
        value_name = "SIZE",
        default_value = "2G",
        global = true,
        hide_short_help = true
    )]
    pub(crate) max_workspace_size: ByteSize,
}

impl Args {
    /// Size limits for files that are read.
    pub(crate) fn limits(&self) -> ProcessLimits {
        ProcessLimits {
            file: self.max_file_size.map(|ByteSize(bytes)| bytes),
            workspace: Some(self.max_workspace_size.0),
        }
    }
}

/// The commands, one a file.
#[derive(Debug, Subcommand)]
pub(crate) enum CliCommand {
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
    /// Merge two versions of a file by their changes since the common ancestor, also as git's merge driver
    #[command(override_usage = merge::USAGE, after_help = merge::EXIT_CODES)]
    Merge(MergeArgs),
    /// Copy the applications of a controller by FTP, and keep local changes
    #[command(after_help = transfer::PULL_EXIT_CODES, after_long_help = format!("{}\n\n{}", transfer::PASSWORD, transfer::PULL_EXIT_CODES))]
    Pull(PullArgs),
    /// List the files that have changed here and on the controller since the last pull or push
    #[command(after_help = transfer::STATUS_EXIT_CODES, after_long_help = format!("{}\n\n{}", transfer::PASSWORD, transfer::STATUS_EXIT_CODES))]
    Status(StatusArgs),
    /// Check local changes and upload them to the controller, with a backup, and verify or undo them
    #[command(after_help = transfer::PUSH_EXIT_CODES, after_long_help = format!("{}\n\n{}", transfer::PASSWORD, transfer::PUSH_EXIT_CODES))]
    Push(PushArgs),
    /// Run an application on the embedded controller
    #[command(after_help = RUN_EXIT_CODES)]
    Run(Box<RunArgs>),
    /// Execute the tests of applications, each test on a separate controller
    #[command(after_help = TEST_EXIT_CODES)]
    Test(Box<TestArgs>),
    /// Print values of expressions, and execute statements
    Eval(EvalArgs),
    /// Print the page of a finding, an instruction, a type or another word, or search all pages
    Explain(ExplainArgs),
    /// Describe a backup of a controller: serial numbers, arm, version, options, applications, signals, users
    #[command(after_help = info::EXIT_CODES, after_long_help = format!("{}\n\n{}", transfer::PASSWORD, info::EXIT_CODES))]
    Info(InfoArgs),
    /// Show the messages of a controller's logs: what they mean, what to do, and the line of the program
    #[command(after_help = log::EXIT_CODES, after_long_help = format!("{}\n\n{}", transfer::PASSWORD, log::EXIT_CODES))]
    Log(LogArgs),
    /// Print a short primer of VAL 3 and of these commands, for people and for the instructions of an agent
    Guide,
    /// List arms, print their files, and measure the times of yours
    Arm(ArmArgs),
    /// Run the language server for an editor, on standard input and output
    Lsp(LspArgs),
    /// Debug applications for an editor with the Debug Adapter Protocol
    Dap(DapArgs),
    /// Serve tools for language models with the Model Context Protocol, on standard input and output
    Mcp(McpArgs),
    /// Trust the settings in a folder, so that they may reach outside the cell
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

/// Arguments of `val3 explain`.
#[derive(Debug, clap::Args)]
pub(crate) struct ExplainArgs {
    /// A code (V0203), the name of a rule, an instruction, a keyword, a type, a field, an operator, a word of the field
    /// (father, world), the number of a run-time error, the code of a message in a controller's log (0x5405) or a message
    /// of its compiler (undefined program). Other words, and several, are searched in all pages; without
    /// any, all pages are listed
    #[arg(value_name = "WORDS")]
    pub(crate) words: Vec<String>,
    /// The form of the pages
    #[arg(help_heading = "Output", long, value_name = "FORMAT", default_value = "human")]
    pub(crate) format: ExplainFormat,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

/// Output format of `val3 explain`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ExplainFormat {
    /// Text for a terminal
    Human,
    /// A JSON object with the pages in Markdown
    Json,
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
    /// Serve clients on this TCP port of this machine, each with a separate session; 0 chooses a free port
    #[arg(long, value_name = "PORT")]
    pub(crate) port: Option<u16>,
}

/// Arguments of `val3 trust`.
#[derive(Debug, clap::Args)]
#[group(required = true, multiple = true)]
pub(crate) struct TrustArgs {
    /// A folder: its settings, and settings in folders below, may reach outside the cell
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
    /// Print the schema of cell.toml instead, the things around the arm
    #[arg(long, conflicts_with = "debugger")]
    pub(crate) cell: bool,
    /// The destination of the text
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_command_line_is_sound() {
        Args::command().debug_assert();
    }

    /// All commands' short and long help, as shown in a terminal of at least 100 columns.
    #[test]
    fn the_help_of_each_command() {
        let mut command = Args::command().color(clap::ColorChoice::Never);
        command.build();
        check_help(&mut command);
    }

    fn check_help(command: &mut clap::Command) {
        let name = command.get_display_name().unwrap_or("val3").to_owned();
        let (short, long) = (plain_text(&command.render_help()), plain_text(&command.render_long_help()));
        insta::assert_snapshot!(format!("{name}_short"), short);
        insta::assert_snapshot!(format!("{name}_long"), long);
        for line in short.lines().chain(long.lines()) {
            assert!(line.chars().count() <= 100, "{name}: {line}");
        }
        let inner = command.get_subcommands_mut().filter(|inner| !inner.is_hide_set() && inner.get_name() != "help");
        inner.for_each(check_help);
    }

    /// Text of a help page without the blanks that clap writes at the end of descriptions.
    fn plain_text(help: &clap::builder::StyledStr) -> String {
        help.to_string().lines().flat_map(|line| [line.trim_end(), "\n"]).collect()
    }
}
