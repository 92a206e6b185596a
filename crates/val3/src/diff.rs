//! `val3 diff`: compares two backups of a controller, or a controller with local files.

mod base;
mod compared_versions;
mod controller;
mod folder;
mod git;
mod pair;
mod print;
mod revisions;
mod wanted;

use std::process::ExitCode;

use camino::Utf8Path;
use val3_diff::{Comparison, ReportClass, compare_with, listing};

use self::compared_versions::ComparedVersions;
use crate::args::{DiffArgs, DiffFormat};
use crate::color::Color;
use crate::controller::check_no_option;
use crate::output::{OutputContent, to_stdout_as};
use crate::paths::{current_folder, is_address};
use crate::printable::one_line;
use crate::user_error::UserError;

/// Runs the command. The exit code states whether the versions differ.
pub(crate) fn run(args: &DiffArgs, color: Color) -> Result<ExitCode, UserError> {
    let current = current_folder()?;
    if !args.paths.first().is_some_and(|path| is_address(path)) {
        check_no_option(&args.connection)?;
    }
    if let Some(file) = &args.textconv {
        return textconv(&current.join(file), file).map(|()| ExitCode::SUCCESS);
    }
    if let Some(base) = &args.base {
        return both_sides(&current, base, args, color);
    }
    let versions = if let [address, local @ ..] = args.paths.as_slice()
        && is_address(address)
    {
        let ([] | [_]) = local else { return Err(wrong_number(args.paths.len())) };
        controller::versions(address, local.first().map(|path| path.as_path()), &args.connection)?
    } else if args.git.is_empty() && !args.staged {
        let [old, new] = args.paths.as_slice() else { return Err(wrong_number(args.paths.len())) };
        pair::versions(&current, old, new)?
    } else {
        revisions::versions(&current, args)?
    };
    Ok(if report(&versions, args, color)? { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Shows both versions' changes since `base`, and the conflicts of a merge.
fn both_sides(current: &Utf8Path, base: &Utf8Path, args: &DiffArgs, color: Color) -> Result<ExitCode, UserError> {
    let [ours, theirs] = base::sides(args)?;
    let mut is_different = false;
    for (name, side) in [("OURS", ours), ("THEIRS", theirs)] {
        base::heading(&format!("Changes of {name}"), args.format)?;
        is_different |= report(&pair::versions(current, base, side)?, args, color)?;
    }
    base::write_conflicts(current, [base, ours, theirs], args.format)?;
    Ok(if is_different { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

/// Writes the differences, and returns whether there are any.
fn report(versions: &ComparedVersions, args: &DiffArgs, color: Color) -> Result<bool, UserError> {
    let comparison = compared(versions, args);
    print::write(&comparison, args, color)?;
    Ok(!comparison.is_empty())
}

fn compared(versions: &ComparedVersions, args: &DiffArgs) -> Comparison {
    let [old, new] = &versions.trees;
    let exclusions = args.exclusions();
    let mut comparison = compare_with(old, new, exclusions.layout);
    let [old_name, new_name] = &versions.names;
    comparison.old = written_name(old_name, args.format);
    comparison.new = written_name(new_name, args.format);
    if !args.only.is_empty() {
        let classes: Vec<ReportClass> = args.only.iter().copied().map(ReportClass::from).collect();
        comparison.keep(&classes);
    }
    comparison.leave_out(&exclusions);
    comparison
}

/// Name of a version in one line, or unchanged as a JSON string.
fn written_name(name: &str, format: DiffFormat) -> String {
    match format {
        DiffFormat::Json => name.to_owned(),
        DiffFormat::Human | DiffFormat::Markdown | DiffFormat::Html => one_line(name).into_owned(),
    }
}

fn wrong_number(count: usize) -> UserError {
    let message =
        format!("two versions are needed to compare, and {count} {} given", if count == 1 { "is" } else { "are" });
    UserError::new(message)
        .with_help("write `val3 diff OLD NEW`, or `val3 diff --git REV` for changes since a revision")
}

/// Prints one file as text lines that git compares.
fn textconv(path: &Utf8Path, shown: &Utf8Path) -> Result<(), UserError> {
    let bytes = folder::read(path, shown.as_str())?;
    let text = listing(&pair::named_by_content(path, &bytes), &bytes);
    let text = text.map_err(|reason| UserError::new(format!("cannot read `{shown}`: {reason}")))?;
    to_stdout_as(OutputContent::File, Color::Never, |out| out.write_all(text.as_bytes()))
}
