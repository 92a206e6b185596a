//! `val3 check`: finds the faults of applications, libraries and whole cells.

use std::process::ExitCode;

use crate::args::{CheckArgs, Color};
use crate::engine;
use crate::explain_config;
use crate::format;
use crate::opening::{Request, open};
use crate::output::{to_file, to_stderr, to_stdout};
use crate::report::Report;
use crate::selection;
use crate::summary;
use crate::user_error::{EXIT_USAGE, UserError};

/// Runs the command; the exit code says whether findings reach the fail level.
pub(crate) fn run(args: &CheckArgs, color: Color) -> Result<ExitCode, UserError> {
    let selection = selection::read(&args.select, &args.ignore)?;
    let request = Request {
        asked: args.paths.clone(),
        selection,
        baseline: args.baseline.clone(),
        mode: args.baseline_mode(),
        jobs: args.jobs,
    };
    if args.explain_config {
        let opened = open(&request)?;
        to_stdout(color, |mut out| explain_config::write(&opened, &request, &mut out))?;
        return Ok(ExitCode::SUCCESS);
    }
    let report = engine::check(&request)?;
    write_files(args, &report)?;
    write_findings(args, color, &report)?;
    Ok(exit_code(args, &report))
}

/// The rule on files that cannot be read: without them the check is not complete.
const UNREADABLE_FILE: &str = "V0502";

fn exit_code(args: &CheckArgs, report: &Report) -> ExitCode {
    if !report.unreadable.is_empty() || report.has(UNREADABLE_FILE) {
        return ExitCode::from(EXIT_USAGE);
    }
    let failed = report.reaches(args.fail_level) && !args.exit_zero;
    if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

/// Findings go to the standard output; what only people want, to the standard error output.
fn write_findings(args: &CheckArgs, color: Color, report: &Report) -> Result<(), UserError> {
    let template = &args.val3check_template;
    to_stdout(color, |out| format::write(args.format, report, template, out))?;
    for error in &report.unreadable {
        to_stderr(|out| writeln!(out, "{error}"));
    }
    if args.format.is_for_people() {
        to_stderr(|out| summary::write(report, out));
    }
    Ok(())
}

fn write_files(args: &CheckArgs, report: &Report) -> Result<(), UserError> {
    for output in &args.output {
        to_file(&output.path, |out| {
            format::write(output.format, report, &args.val3check_template, out)?;
            if output.format.is_for_people() { summary::write(report, out) } else { Ok(()) }
        })?;
    }
    Ok(())
}
