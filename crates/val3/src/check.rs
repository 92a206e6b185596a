//! `val3 check`: finds faults in applications, libraries and whole cells, and fixes faults that have a fix.

use std::io;
use std::process::ExitCode;

use codespan_reporting::term::termcolor::WriteColor;
use val3_check::fix::{AppliedFixes, add_suppressions, apply_fixes};
use val3_check::rules;
use val3_check::settings::RuleSelection;

use crate::args::CheckArgs;
use crate::color::Color;
use crate::engine::Session;
use crate::format::ReportFormat;
use crate::history::History;
use crate::opening::{OpenRequest, open};
use crate::output::{Destination, OutputContent, clear_screen, filtered, to_file, to_stderr, to_stdout, to_stdout_as};
use crate::report::CheckReport;
use crate::standard_input::StandardInput;
use crate::user_error::{EXIT_USAGE, UserError};
use crate::watch::FolderWatch;
use crate::{explain_config, fixing, format, patch, rule_counts, selection, summary};

/// Runs the command. The exit code states whether a finding reaches the fail level.
pub(crate) fn run(args: &CheckArgs, color: Color) -> Result<ExitCode, UserError> {
    if args.watch && args.fix {
        let message = "--watch cannot be used with --fix: each time a file is saved, programs would be rewritten";
        return Err(UserError::new(message).with_help("run `val3 check --fix` on its own"));
    }
    let request = request(args)?;
    if args.statistics {
        rule_counts::supports(args.format)?;
    }
    if args.max_findings.is_some() {
        supports_limit(args.format)?;
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
    let code = if args.diff {
        diff(args, color, &mut session)
    } else if args.fix || args.add_suppressions {
        rewrite(args, color, &request, &mut session)
    } else {
        check(args, color, &mut session)
    };
    session.abandon();
    code
}

fn request(args: &CheckArgs) -> Result<OpenRequest, UserError> {
    let input = standard_input(args)?;
    Ok(OpenRequest {
        asked: input.as_ref().map_or_else(|| args.paths.clone(), |input| vec![input.path.clone()]),
        selection: selection(args)?,
        arm: args.arm.clone(),
        baseline: args.baseline.clone(),
        mode: args.baseline_mode(),
        jobs: args.jobs,
        files_alone: true,
        input,
        quiet: args.quiet,
    })
}

/// Checks that readers of a format do not depend on all findings.
fn supports_limit(format: ReportFormat) -> Result<(), UserError> {
    use ReportFormat::{Concise, Human, Json, JsonLines};
    if matches!(format, Human | Concise | Json | JsonLines) {
        return Ok(());
    }
    let message = "--max-findings cannot be used with this --format, whose readers need every finding";
    Err(UserError::new(message).with_help("it works with human, concise, json and json-lines"))
}

/// Rules selected by the arguments. `--motion` adds the rules about the arm.
fn selection(args: &CheckArgs) -> Result<RuleSelection, UserError> {
    let motion = if args.motion { rules::of_motion().map(|rule| rule.code.to_owned()).to_vec() } else { Vec::new() };
    let extend = [args.extend_select.as_slice(), &motion].concat();
    let selection = selection::read(&args.select, &extend, &args.ignore)?;
    Ok(RuleSelection { target: args.target, ..selection })
}

/// The file that the standard input replaces (`-`).
fn standard_input(args: &CheckArgs) -> Result<Option<StandardInput>, UserError> {
    let help = "write `val3 check - --stdin-path FILE`";
    let error = |message: &str| Err(UserError::new(message).with_help(help));
    match (args.paths.iter().any(|path| path == "-"), &args.stdin_path) {
        (false, None) if args.input.input.is_some() => error("--input requires the path `-`"),
        (false, None) => Ok(None),
        (false, Some(_)) => error("--stdin-path requires the path `-`"),
        (true, None) => error("`-` requires --stdin-path: the path of the file that the standard input replaces"),
        (true, Some(_)) if args.paths.len() > 1 => {
            error("`-`, the standard input, cannot be combined with other paths")
        }
        (true, Some(_)) if args.fix || args.add_suppressions || args.watch => {
            error("`-` cannot be used with --fix, --add-suppressions or --watch: its text is not stored in a file")
        }
        (true, Some(path)) => Ok(Some(StandardInput::read(path, &args.input)?)),
    }
}

fn check(args: &CheckArgs, color: Color, session: &mut Session<'_>) -> Result<ExitCode, UserError> {
    let found = session.check()?;
    write_report(args, color, session.report(found))
}

/// Writes fixes or suppression comments, and reports the findings of a second check.
fn rewrite(
    args: &CheckArgs,
    color: Color,
    request: &OpenRequest,
    session: &mut Session<'_>,
) -> Result<ExitCode, UserError> {
    let applied = if args.fix { fixes(args, session)? } else { add_suppressions(session)? };
    fixing::write(session, &applied.files)?;
    let mut written = Session::open(request)?;
    let left = written.check()?;
    let mut report = written.report(left);
    match args.fix {
        true => (report.fixed, report.refused) = (Some(applied.count), applied.refused),
        false => report.newly_silenced = Some(applied.count),
    }
    written.abandon();
    write_report(args, color, report)
}

fn write_report(args: &CheckArgs, color: Color, mut report: CheckReport) -> Result<ExitCode, UserError> {
    write_files(args, &report)?;
    args.max_findings.into_iter().for_each(|most| report.limit(most));
    write_findings(args, color, &report)?;
    Ok(exit_code(args, &report, report.reaches(args.fail_level)))
}

/// Repeats the check after each change. Each round reads all files again. It ends only with an error or with the
/// process.
fn watch(args: &CheckArgs, color: Color, request: &OpenRequest) -> Result<ExitCode, UserError> {
    let mut watch = FolderWatch::start(&request.asked)?;
    let mut session = Some(Session::open(request)?);
    let mut history = History::default();
    let hint = |text: &str| to_stderr(|out| if args.quiet { Ok(()) } else { writeln!(out, "{text}") });
    loop {
        if let Some(mut session) = session.take() {
            let found = session.check()?;
            let mut report = session.report(found);
            history.mark(&mut report);
            if args.format.is_for_people() {
                clear_screen();
            }
            write_report(args, color, report)?;
            session.folders().iter().try_for_each(|folder| watch.include(folder, false))?;
        }
        hint("Waiting for changes; press Ctrl-C to stop");
        let changed = watch.changed()?;
        hint(&format!("\n{} was changed", changed.display()));
        match Session::open(request) {
            Ok(opened) => session = Some(opened),
            Err(error) => to_stderr(|out| writeln!(out, "{error}")),
        }
    }
}

/// Shows the changes that the fixes would make.
fn diff(args: &CheckArgs, color: Color, session: &mut Session<'_>) -> Result<ExitCode, UserError> {
    let applied = fixes(args, session)?;
    to_stdout_as(OutputContent::Data, color, |out| patch::write(&applied.files, session.paths(), out))?;
    let left = session.check()?;
    let report = session.report(left);
    write_unreadable(&report);
    Ok(exit_code(args, &report, !applied.files.is_empty()))
}

fn fixes(args: &CheckArgs, session: &mut Session<'_>) -> Result<AppliedFixes, UserError> {
    let applied = apply_fixes(session, args.unsafe_fixes)?;
    if !applied.settled {
        to_stderr(|out| writeln!(out, "warning: the fixes do not converge: each round makes further changes"));
    }
    Ok(applied)
}

fn exit_code(args: &CheckArgs, report: &CheckReport, failed: bool) -> ExitCode {
    if !report.is_complete() {
        return ExitCode::from(EXIT_USAGE);
    }
    if failed && !args.exit_zero { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}

/// Writes findings to the standard output and the summary to the standard error output.
fn write_findings(args: &CheckArgs, color: Color, report: &CheckReport) -> Result<(), UserError> {
    to_stdout_as(args.format.content(), color, |out| match args.statistics {
        true => rule_counts::write(args.format, report, out),
        false => format::write(args.format, report, &args.val3check_template, out),
    })?;
    write_unreadable(report);
    if let Some(notice) = report.notice.as_ref().filter(|_| !args.quiet) {
        to_stderr(|out| writeln!(out, "note: {notice}"));
    }
    if args.format.is_for_people() && !args.quiet {
        to_stderr(|out| summary::write(report, out));
    } else if let Some(limited) = summary::limited(report) {
        to_stderr(|out| writeln!(out, "note: not shown: {limited}"));
    }
    Ok(())
}

fn write_unreadable(report: &CheckReport) {
    for error in &report.unreadable {
        to_stderr(|out| writeln!(out, "{error}"));
    }
}

fn write_files(args: &CheckArgs, report: &CheckReport) -> Result<(), UserError> {
    for output in &args.output {
        let format = output.format;
        to_file(&output.path, format.file_kind(), |out| {
            filtered(format.content(), Destination::FILE, out, |out| write_with_summary(args, format, report, out))
        })?;
    }
    Ok(())
}

/// Writes findings, and the summary if the format is for people.
fn write_with_summary(
    args: &CheckArgs,
    format: ReportFormat,
    report: &CheckReport,
    mut out: &mut dyn WriteColor,
) -> io::Result<()> {
    format::write(format, report, &args.val3check_template, out)?;
    if format.is_for_people() { summary::write(report, &mut out) } else { Ok(()) }
}
