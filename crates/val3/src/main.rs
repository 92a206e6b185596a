//! The `val3` command.

#![allow(clippy::disallowed_methods, reason = "the clock, the threads and the environment come in here")]

mod args;
mod arm;
mod arm_choice;
mod backup_files;
mod baseline;
mod check;
mod code_lines;
mod color;
mod completions;
mod controller;
mod dap;
mod diff;
mod engine;
mod eval;
mod explain;
mod explain_config;
mod fingerprint;
mod fixing;
mod fmt;
mod format;
mod guide;
mod history;
mod http;
mod in_memory;
mod info;
mod internal_error;
mod log;
mod loose;
mod lsp;
mod man;
mod markdown;
mod mcp;
mod merge;
mod modbus;
mod new;
mod opening;
mod output;
mod parallel_disk;
mod patch;
mod paths;
mod printable;
mod progress;
mod pull;
mod push;
mod report;
mod rule_counts;
mod run;
mod schema;
mod scope;
mod secret;
mod selection;
mod serve;
mod signals;
mod soap;
mod sockets;
mod standard_input;
mod status;
mod summary;
mod test;
mod translation;
mod trust;
mod unread;
mod user_error;
mod version;
mod wall_clock;
mod watch;
mod write_scope;

use std::ffi::OsString;
use std::io::IsTerminal as _;
use std::process::ExitCode;

use camino::Utf8Path;
use clap::{CommandFactory as _, FromArgMatches as _};
use val3_analysis::load::request_configuration;
use val3_files::FileClass;

use crate::args::{Args, CliCommand};
use crate::color::Color;
use crate::output::{commit, redirect, set_verbose, shown_argument, to_stderr, to_verbose};
use crate::paths::current_folder;
use crate::user_error::{EXIT_USAGE, UserError};

fn main() -> ExitCode {
    trust::connect();
    internal_error::connect();
    let args = match parse(std::env::args_os()) {
        Ok(args) => args,
        Err(error) => refuse(&error),
    };
    run(&args).map(internal_error::exit_code).unwrap_or_else(|error| {
        to_stderr(|out| writeln!(out, "{error}"));
        ExitCode::from(EXIT_USAGE)
    })
}

/// Parses the arguments. The arguments and the environment determine the colours of help and messages.
fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Args, clap::Error> {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    let color = Color::of_help(arguments.iter().cloned(), std::io::stdout().is_terminal());
    let matches = Args::command().color(color).try_get_matches_from(arguments)?;
    Args::from_arg_matches(&matches)
}

/// Prints a usage error or the requested help, and ends the process.
///
/// The message quotes arguments, so the arguments are parsed once more with visible control characters.
fn refuse(error: &clap::Error) -> ! {
    let shown = std::env::args_os().map(|argument| shown_argument(&argument.to_string_lossy()));
    match parse(shown.map(OsString::from)) {
        Err(worded) => worded.exit(),
        Ok(_) => {
            to_stderr(|out| write!(out, "{error}"));
            std::process::exit(EXIT_USAGE.into())
        }
    }
}

fn run(args: &Args) -> Result<ExitCode, UserError> {
    args.limits().set();
    if args.verbose {
        set_verbose();
        to_verbose(|| format!("val3 {}", version::VERSION));
    }
    if let Some(path) = &args.config {
        request_settings(path)?;
    }
    if let Some((path, kind)) = args.command.destination()? {
        redirect(path, kind)?;
    }
    let code = execute(args)?;
    commit()?;
    Ok(code)
}

/// Replaces the nearest `val3.toml` by a file.
fn request_settings(path: &Utf8Path) -> Result<(), UserError> {
    val3_files::read_text(path, FileClass::Settings).map_err(|reason| {
        UserError::new(format!("cannot read the settings `{path}`: {reason}")).with_help("name a file like val3.toml")
    })?;
    let path = current_folder()?.join(path);
    request_configuration(path.canonicalize_utf8().unwrap_or(path));
    Ok(())
}

fn execute(args: &Args) -> Result<ExitCode, UserError> {
    match &args.command {
        CliCommand::New(new) => new::run(new, args.color),
        CliCommand::Check(check) => check::run(check, args.color),
        CliCommand::Fmt(fmt) => fmt::run(fmt, args.color),
        CliCommand::Diff(diff) => diff::run(diff, args.color),
        CliCommand::Merge(merge) => merge::run(merge),
        CliCommand::Pull(pull) => pull::run(pull),
        CliCommand::Status(status) => status::run(status, args.color),
        CliCommand::Push(push) => push::run(push, args.color),
        CliCommand::Eval(eval) => eval::run(eval, args.color),
        CliCommand::Run(run) => run::run(run, args.color),
        CliCommand::Test(test) => test::run(test, args.color),
        CliCommand::Guide => guide::run().map(|()| ExitCode::SUCCESS),
        CliCommand::Explain(explain) => explain::run(explain, args.color).map(|()| ExitCode::SUCCESS),
        CliCommand::Log(log) => log::run(log, args.color),
        CliCommand::Info(info) => info::run(info, args.color),
        CliCommand::Arm(arm) => arm::run(arm, args.color),
        CliCommand::Lsp(lsp) => lsp::run(lsp),
        CliCommand::Dap(dap) => dap::run(dap),
        CliCommand::Mcp(mcp) => mcp::run(mcp),
        CliCommand::Trust(trust) => trust::run(trust),
        CliCommand::Schema(schema) => schema::run(schema).map(|()| ExitCode::SUCCESS),
        CliCommand::Completions(completions) => completions::run(completions).map(|()| ExitCode::SUCCESS),
        CliCommand::Man(man) => man::run(man).map(|()| ExitCode::SUCCESS),
        CliCommand::Version => version::run().map(|()| ExitCode::SUCCESS),
    }
}
