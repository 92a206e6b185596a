//! `val3 check`: finds the faults of applications, libraries and whole cells, and mends what can be mended.

use std::process::ExitCode;

use crate::args::{CheckArgs, Color};
use crate::engine::Session;
use crate::fixing::{self, Fixed};
use crate::opening::{Request, open};
use crate::output::{to_file, to_stderr, to_stdout};
use crate::report::Report;
use crate::user_error::{EXIT_USAGE, UserError};
use crate::watch::Watch;
use crate::{explain_config, format, patch, rule_counts, selection, summary};

/// Runs the command; the exit code says whether findings reach the fail level.
pub(crate) fn run(args: &CheckArgs, color: Color) -> Result<ExitCode, UserError> {
    let request = request(args)?;
    if args.statistics {
        rule_counts::supports(args.format)?;
    }
    if args.explain_config {
        let opened = open(&request)?;
        to_stdout(color, |mut out| explain_config::write(&opened, &request, &mut out))?;
        return Ok(ExitCode::SUCCESS);
    }
    if args.watch {
        return watch(args, color, &request);
    }
    let mut session = Session::open(&request)?;
    let code = if args.diff { diff(args, color, &mut session) } else { check(args, color, &mut session) };
    session.abandon();
    code
}

fn request(args: &CheckArgs) -> Result<Request, UserError> {
    Ok(Request {
        asked: args.paths.clone(),
        selection: selection::read(&args.select, &args.ignore)?,
        baseline: args.baseline.clone(),
        mode: args.baseline_mode(),
        jobs: args.jobs,
    })
}

fn check(args: &CheckArgs, color: Color, session: &mut Session<'_>) -> Result<ExitCode, UserError> {
    let report = if args.fix {
        let fixed = fixed(args, session)?;
        fixing::write(session, &fixed.files)?;
        Report { mended: Some(fixed.mended), ..session.report(fixed.left) }
    } else {
        let found = session.check()?;
        session.report(found)
    };
    write_files(args, &report)?;
    write_findings(args, color, &report)?;
    Ok(exit_code(args, &report, report.reaches(args.fail_level)))
}

/// Checks again and again; every round reads all files anew. It ends when it cannot go on, or with the process.
fn watch(args: &CheckArgs, color: Color, request: &Request) -> Result<ExitCode, UserError> {
    let mut watch = Watch::start(&request.asked)?;
    let mut session = Some(Session::open(request)?);
    loop {
        if let Some(mut session) = session.take() {
            check(args, color, &mut session)?;
            session.folders().iter().try_for_each(|folder| watch.include(folder, false))?;
        }
        to_stderr(|out| writeln!(out, "Waiting for changes; Ctrl-C ends"));
        let changed = watch.changed()?;
        to_stderr(|out| writeln!(out, "\n{} was changed", changed.display()));
        match Session::open(request) {
            Ok(opened) => session = Some(opened),
            Err(error) => to_stderr(|out| writeln!(out, "{error}")),
        }
    }
}

/// Shows what the fixes would change.
fn diff(args: &CheckArgs, color: Color, session: &mut Session<'_>) -> Result<ExitCode, UserError> {
    let fixed = fixed(args, session)?;
    to_stdout(color, |out| patch::write(&fixed.files, out))?;
    let report = session.report(fixed.left);
    write_unreadable(&report);
    Ok(exit_code(args, &report, !fixed.files.is_empty()))
}

fn fixed(args: &CheckArgs, session: &mut Session<'_>) -> Result<Fixed, UserError> {
    let fixed = fixing::fix(session, args.unsafe_fixes)?;
    if !fixed.settled {
        to_stderr(|out| writeln!(out, "warning: the fixes do not settle, each round changes something again"));
    }
    Ok(fixed)
}

/// The rule on files that cannot be read: without them the check is not complete.
const UNREADABLE_FILE: &str = "V0502";

fn exit_code(args: &CheckArgs, report: &Report, failed: bool) -> ExitCode {
    if !report.unreadable.is_empty() || report.has(UNREADABLE_FILE) {
        return ExitCode::from(EXIT_USAGE);
    }
    if failed && !args.exit_zero { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

/// Findings go to the standard output; what only people want, to the standard error output.
fn write_findings(args: &CheckArgs, color: Color, report: &Report) -> Result<(), UserError> {
    to_stdout(color, |out| match args.statistics {
        true => rule_counts::write(args.format, report, out),
        false => format::write(args.format, report, &args.val3check_template, out),
    })?;
    write_unreadable(report);
    if args.format.is_for_people() {
        to_stderr(|out| summary::write(report, out));
    }
    Ok(())
}

fn write_unreadable(report: &Report) {
    for error in &report.unreadable {
        to_stderr(|out| writeln!(out, "{error}"));
    }
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
