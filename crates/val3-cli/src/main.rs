//! The `val3` command.

#![allow(clippy::disallowed_methods, reason = "the clock, the threads and the environment come in here")]

mod args;
mod arm;
mod arm_choice;
mod baseline;
mod check;
mod code_lines;
mod color;
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
mod history;
mod lsp;
mod markdown;
mod opening;
mod output;
mod parallel_disk;
mod patch;
mod paths;
mod progress;
mod report;
mod rule_counts;
mod run;
mod schema;
mod scope;
mod selection;
mod serve;
mod standard_input;
mod summary;
mod test;
mod translation;
mod unread;
mod user_error;
mod wall_clock;
mod watch;

use std::process::ExitCode;

use clap::Parser;

use crate::args::{Args, Command};
use crate::output::to_stderr;
use crate::user_error::{EXIT_USAGE, UserError};

fn main() -> ExitCode {
    run(&Args::parse()).unwrap_or_else(|error| {
        to_stderr(|out| writeln!(out, "{error}"));
        ExitCode::from(EXIT_USAGE)
    })
}

fn run(args: &Args) -> Result<ExitCode, UserError> {
    args.limits().set();
    match &args.command {
        Command::Check(check) => check::run(check, args.color),
        Command::Fmt(fmt) => fmt::run(fmt, args.color),
        Command::Diff(diff) => diff::run(diff, args.color),
        Command::Eval(eval) => eval::run(eval, args.color),
        Command::Run(run) => run::run(run, args.color),
        Command::Test(test) => test::run(test, args.color),
        Command::Explain(explain) => explain::run(explain, args.color).map(|()| ExitCode::SUCCESS),
        Command::Arm(arm) => arm::run(arm, args.color),
        Command::Lsp(lsp) => lsp::run(lsp),
        Command::Dap(dap) => dap::run(dap),
        Command::Schema(schema) => schema::run(schema).map(|()| ExitCode::SUCCESS),
    }
}
