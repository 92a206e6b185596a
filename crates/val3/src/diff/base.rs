//! Comparison of two versions with their common ancestor, and the conflicts of a merge.

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashMap;
use val3_merge::{MergeResult, MergedKind, merge};
use val3_syntax::encoding::decode;

use super::folder;
use crate::args::{DiffArgs, DiffFormat};
use crate::color::Color;
use crate::output::{OutputContent, to_stdout_as};
use crate::printable::one_line;
use crate::user_error::UserError;

/// File contents by the path relative to the compared folder.
type BaseFiles = FxHashMap<Utf8PathBuf, Vec<u8>>;

/// Returns the two versions to compare with the base.
///
/// # Errors
/// The number of versions is not 2, or the format supports only one comparison.
pub(super) fn sides(args: &DiffArgs) -> Result<[&Utf8PathBuf; 2], UserError> {
    let [ours, theirs] = args.paths.as_slice() else {
        return Err(UserError::new(format!("--base compares two versions, and {} are given", args.paths.len()))
            .with_help("write `val3 diff --base BASE OURS THEIRS`"));
    };
    if matches!(args.format, DiffFormat::Json | DiffFormat::Html) {
        return Err(UserError::new("--base prints only the formats `human` and `markdown`")
            .with_help("compare each version with the base: `val3 diff BASE OURS`"));
    }
    Ok([ours, theirs])
}

/// Writes the conflicts of merging base, ours and theirs.
pub(super) fn write_conflicts(
    current: &Utf8Path,
    [base, ours, theirs]: [&Utf8Path; 3],
    format: DiffFormat,
) -> Result<(), UserError> {
    let name = ours.file_name().unwrap_or("file");
    let files = [files(current, base, name)?, files(current, ours, name)?, files(current, theirs, name)?];
    let left = left_by_merge(&files);
    heading(if left.is_empty() { "A merge has no conflict" } else { "Conflicts of a merge" }, format)?;
    to_stdout_as(OutputContent::Words, Color::Never, |out| left.iter().try_for_each(|line| writeln!(out, "{line}")))
}

/// Writes a section heading.
pub(super) fn heading(text: &str, format: DiffFormat) -> Result<(), UserError> {
    let mark = if format == DiffFormat::Markdown { "# " } else { "== " };
    to_stdout_as(OutputContent::Words, Color::Never, |out| writeln!(out, "{mark}{text}"))
}

/// Returns the files of a folder, or one file under the name `name`, which is the same for all versions.
fn files(current: &Utf8Path, path: &Utf8Path, name: &str) -> Result<BaseFiles, UserError> {
    let whole = current.join(path);
    if whole.is_dir() || val3_files::is_archive_name(path) {
        return Ok(folder::files(&whole)?.into_iter().collect());
    }
    if folder::is_absent(path) {
        return Ok(BaseFiles::default());
    }
    Ok([(name.into(), folder::read(&whole, path.as_str())?)].into_iter().collect())
}

/// Conflicts in files that both sides have changed.
fn left_by_merge([base, ours, theirs]: &[BaseFiles; 3]) -> Vec<String> {
    let mut paths: Vec<&Utf8PathBuf> = ours.keys().chain(theirs.keys()).chain(base.keys()).collect();
    paths.sort();
    paths.dedup();
    let mut lines = Vec::new();
    for path in paths {
        let [b, o, t] = [base, ours, theirs].map(|files| files.get(path));
        if b == o || b == t || o == t {
            continue;
        }
        let (Some(o), Some(t)) = (o, t) else {
            lines.push(
                one_line(&format!("{path}: one side has removed it, and the other one has changed it")).into_owned(),
            );
            continue;
        };
        let Some(kind) = MergedKind::of_name(path.as_str()) else {
            lines.push(one_line(&format!("{path}: both sides have changed it")).into_owned());
            continue;
        };
        let text = |bytes: &[u8]| decode(bytes.to_vec()).text;
        let merged = merge(kind, &b.map(|bytes| text(bytes)).unwrap_or_default(), &text(o), &text(t));
        lines.extend(left(&merged).into_iter().map(|line| one_line(&format!("{path}: {line}")).into_owned()));
    }
    lines
}

fn left(merged: &MergeResult) -> Vec<String> {
    let by_lines = merged.by_lines.iter().map(|reason| format!("merged by lines: {reason}"));
    by_lines.chain(merged.conflicts.iter().map(ToString::to_string)).collect()
}
