//! `val3 fmt`: formats the code of programs.

mod bare;
mod program;
mod search;

use std::process::ExitCode;

use camino::{Utf8Path, Utf8PathBuf};
use rayon::prelude::*;
use val3_analysis::system::Disk;
use val3_files::FileClass;

use crate::args::FmtArgs;
use crate::color::Color;
use crate::opening::threads;
use crate::output::{OutputContent, to_stderr, to_stdout_as};
use crate::paths::{Paths, current_folder};
use crate::printable::one_line;
use crate::user_error::{EXIT_USAGE, UserError};
use crate::write_scope::WriteScope;
use crate::{patch, standard_input};
use program::Formatted;
use search::FoundProgram;

/// Runs the command. The exit code states whether a program is not formatted.
pub(crate) fn run(args: &FmtArgs, color: Color) -> Result<ExitCode, UserError> {
    let current = current_folder()?;
    let paths = Paths::new(&[], &current);
    if args.paths.iter().any(|path| path == "-") {
        return stream(args, color, &current);
    }
    if args.stdin_path.is_some() {
        return Err(UserError::new("--stdin-path requires the path `-`"));
    }
    if args.input.input.is_some() {
        return Err(UserError::new("--input requires the path `-`").with_help("write `val3 fmt - --input FILE`"));
    }
    let found = search::programs(&Disk, &args.paths, &current, &paths)?;
    let format = || found.par_iter().map(|found| format(found, &paths)).collect::<Vec<_>>();
    let (formatted, errors) = partition(threads(None)?.install(format));
    let writes = !args.check && !args.diff && args.output.output.is_none();
    if writes {
        let asked: Vec<Utf8PathBuf> = args.paths.iter().map(|path| current.join(path)).collect();
        let scope = WriteScope::new(&asked);
        formatted.iter().try_for_each(|program| program.check_scope(&scope))?;
        formatted.iter().try_for_each(Formatted::write)?;
    }
    if args.output.output.is_some() && !args.check && !args.diff {
        return match errors.into_iter().next() {
            Some(error) => Err(error),
            None => copy(&formatted),
        };
    }
    show(args, color, &formatted)?;
    errors.iter().for_each(|error| to_stderr(|out| writeln!(out, "{error}")));
    summarise(&formatted, writes);
    if !errors.is_empty() {
        return Ok(ExitCode::from(EXIT_USAGE));
    }
    Ok(exit_code(args, formatted.iter().any(Formatted::changes)))
}

/// Splits the results into formatted programs and errors.
fn partition(results: Vec<Result<Formatted, UserError>>) -> (Vec<Formatted>, Vec<UserError>) {
    let (mut formatted, mut errors) = (Vec::new(), Vec::new());
    for result in results {
        match result {
            Ok(program) => formatted.push(program),
            Err(error) => errors.push(error),
        }
    }
    (formatted, errors)
}

/// Writes the only program to the file of `--output`.
fn copy(formatted: &[Formatted]) -> Result<ExitCode, UserError> {
    let [program] = formatted else {
        let message = format!("--output needs one program, and there are {}", formatted.len());
        return Err(UserError::new(message).with_help("name one program, or omit --output"));
    };
    let bytes = program.bytes()?;
    to_stdout_as(OutputContent::File, Color::Never, |out| out.write_all(&bytes))?;
    report_unreadable(formatted);
    Ok(ExitCode::SUCCESS)
}

fn format(found: &FoundProgram, paths: &Paths) -> Result<Formatted, UserError> {
    let shown = paths.shown(&found.path);
    let bytes = val3_files::read(&found.path, FileClass::Program)
        .map_err(|error| UserError::new(format!("cannot read `{shown}`: {error}")))?;
    Formatted::new(found.path.clone(), shown, bytes, &found.style)
}

/// Formats a program from the standard input to the standard output.
fn stream(args: &FmtArgs, color: Color, current: &Utf8Path) -> Result<ExitCode, UserError> {
    if args.paths.len() > 1 {
        return Err(UserError::new("`-`, the standard input, cannot be combined with other paths"));
    }
    let bytes = standard_input::bytes(&args.input)?;
    let path = current.join(args.stdin_path.as_deref().unwrap_or(Utf8Path::new("program.pgx")));
    let style = search::style(&Disk, &path)?;
    let shown = args.stdin_path.as_deref().map_or("program.pgx", Utf8Path::as_str);
    let shown = one_line(shown).into_owned();
    let formatted = Formatted::of_stream(path, shown, bytes, &style)?;
    if args.check || args.diff {
        show(args, color, std::slice::from_ref(&formatted))?;
    } else {
        let bytes = formatted.bytes()?;
        to_stdout_as(OutputContent::File, Color::Never, |out| out.write_all(&bytes))?;
    }
    report_unreadable(std::slice::from_ref(&formatted));
    Ok(exit_code(args, formatted.changes()))
}

/// Shows the diffs or names of the programs that would change, according to the arguments.
fn show(args: &FmtArgs, color: Color, formatted: &[Formatted]) -> Result<(), UserError> {
    let mut changing = formatted.iter().filter(|program| program.changes());
    let content = if args.diff { OutputContent::Data } else { OutputContent::Words };
    to_stdout_as(content, color, |out| {
        changing.try_for_each(|program| match (args.diff, args.check) {
            (true, _) => patch::write_diff(&program.shown, &program.before, &program.after, out),
            (_, true) => writeln!(out, "{}", program.shown),
            _ => Ok(()),
        })
    })
}

/// Reports programs with code that was not formatted because of syntax errors.
fn report_unreadable(formatted: &[Formatted]) {
    for program in formatted.iter().filter(|program| program.left_alone) {
        to_stderr(|out| writeln!(out, "{}: code with syntax errors keeps its layout; see val3 check", program.shown));
    }
}

fn summarise(formatted: &[Formatted], written: bool) {
    report_unreadable(formatted);
    let changed = formatted.iter().filter(|program| program.changes()).count();
    let verb = if written { "changed" } else { "would change" };
    to_stderr(|out| writeln!(out, "{changed} of {} {verb}", programs(formatted.len())));
}

fn programs(count: usize) -> String {
    if count == 1 { "1 program".to_owned() } else { format!("{count} programs") }
}

fn exit_code(args: &FmtArgs, changes: bool) -> ExitCode {
    if changes && (args.check || args.diff) { ExitCode::FAILURE } else { ExitCode::SUCCESS }
}
