//! Programs in both versions of a project.

use camino::Utf8Path;
use val3_analysis::paths::path_key;

use super::sides::versions;
use crate::applications::{Application, Matched, SourceFile};
use crate::compare::program::Rules;
use crate::compare::renames::Renamed;
use crate::compare::text::Version;
use crate::compare::{contents, interface, program, text};
use crate::exclusions::BlankComparison;
use crate::model::{ApplicationChange, InterfaceChange, Problem, ValuePair};
use crate::read::code::Renames;
use crate::read::program::ProgramVersion;
use crate::tree::text_of;

/// Old and new version of a file.
type FileVersions<'a, 't> = [Option<&'a SourceFile<'t>>; 2];

/// Two versions of a program that differ, or a program that exists in only one version.
pub(super) struct ProgramPair<'a, 't> {
    files: FileVersions<'a, 't>,
    programs: [Option<ProgramVersion>; 2],
}

impl ProgramPair<'_, '_> {
    /// Returns the program in both versions.
    pub(super) fn programs(&self) -> [Option<&ProgramVersion>; 2] {
        self.programs.each_ref().map(Option::as_ref)
    }

    fn name(&self, side: usize) -> Option<&str> {
        self.programs.get(side)?.as_ref().map(|program| program.header.name.as_str())
    }

    /// Whether the program `name` exists only on `side` (0 for the old version).
    fn is_only_in(&self, side: usize, name: &str) -> bool {
        self.name(side) == Some(name) && self.files.iter().flatten().count() == 1
    }
}

/// Reads the programs that differ. Files that are no programs are compared as text.
pub(super) fn read<'a, 't>(
    pair: &Matched<'a, 't>,
    compared: &mut ApplicationChange,
    problems: &mut Vec<Problem>,
) -> Vec<ProgramPair<'a, 't>> {
    let old = pair.old.map(|application| &application.programs);
    let new = pair.new.map(|application| &application.programs);
    let has_lists = has_lists(pair);
    let mut pairs = Vec::new();
    for files in moved_together(versions(old, new)) {
        let [old, new] = files;
        if old.zip(new).is_some_and(|(old, new)| old.bytes == new.bytes && old.listed == new.listed) {
            continue;
        }
        let programs = files.map(|file| ProgramVersion::read(&text_of(file?.bytes).ok()?));
        // An unlisted file is not loaded, so it is no program.
        let is_unlisted = has_lists && files.into_iter().flatten().all(|file| !file.listed);
        let is_read = old.is_some() == programs[0].is_some() && new.is_some() == programs[1].is_some();
        if is_read && !is_unlisted {
            pairs.push(ProgramPair { files, programs });
            continue;
        }
        let path = new.or(old).map(|file| file.path.to_string()).unwrap_or_default();
        let is_readable = programs.each_ref().map(|program| is_unlisted || program.is_some());
        let sides = [as_version(old, is_readable[0]), as_version(new, is_readable[1])];
        compared.texts.extend(text::compare(&path, sides, "a program file", problems));
    }
    pairs
}

/// Adds the programs that differ. Returns changes of the public interface.
pub(super) fn compare(
    pair: &Matched<'_, '_>,
    pairs: Vec<ProgramPair<'_, '_>>,
    renamed: &Renamed,
    layout: BlankComparison,
    compared: &mut ApplicationChange,
) -> Vec<InterfaceChange> {
    let names = renamed.names();
    let rules = Rules { has_lists: has_lists(pair), layout, renames: &names };
    let mut interface = Vec::new();
    for ProgramPair { files: [old, new], programs: [old_program, new_program] } in joined(pairs, &renamed.programs) {
        let located = [old.zip(old_program.as_ref()), new.zip(new_program.as_ref())];
        let Some(change) = program::compare(located, rules) else {
            if let (Some(old), Some(new)) = (old, new) {
                contents::add(new.path.as_str(), [old.bytes, new.bytes], |_| false, compared);
            }
            continue;
        };
        let types = |program: &Option<ProgramVersion>| program.as_ref().map(ProgramVersion::interface);
        let types = ValuePair { old: types(&old_program), new: types(&new_program) };
        interface.extend(interface::program(&change, types));
        compared.programs.push(change);
    }
    compared.programs.sort_by(|a, b| (path_key(&a.name), &a.file).cmp(&(path_key(&b.name), &b.file)));
    interface
}

fn has_lists(pair: &Matched<'_, '_>) -> bool {
    let has_list = |side: Option<&Application<'_>>| side.is_some_and(|side| side.project.is_some());
    has_list(pair.old) && has_list(pair.new)
}

/// Joins the old and the new name of a renamed program to one pair.
fn joined<'a, 't>(mut pairs: Vec<ProgramPair<'a, 't>>, renames: &Renames) -> Vec<ProgramPair<'a, 't>> {
    for (before, after) in renames {
        let old = pairs.iter().position(|pair| pair.is_only_in(0, before));
        let new = pairs.iter().position(|pair| pair.is_only_in(1, after));
        let (Some(old), Some(new)) = (old, new) else { continue };
        let [file, _] = pairs.get(old).map_or([None, None], |pair| pair.files);
        let program = pairs.get_mut(old).and_then(|pair| pair.programs.first_mut()?.take());
        if let Some(pair) = pairs.get_mut(new) {
            pair.files = [file, pair.files[1]];
            pair.programs = [program, pair.programs[1].take()];
        }
        pairs.remove(old);
    }
    pairs
}

fn as_version<'t>(file: Option<&SourceFile<'t>>, is_readable: bool) -> Option<Version<'t>> {
    file.map(|file| Version { bytes: file.bytes, is_readable })
}

/// Matches a file that was moved to another folder of the application, if its file name is unique.
fn moved_together<'a, 't>(files: Vec<FileVersions<'a, 't>>) -> Vec<FileVersions<'a, 't>> {
    let unmatched = files.iter().filter(|[old, new]| old.is_some() != new.is_some());
    let old: Vec<&SourceFile<'_>> = unmatched.clone().filter_map(|[old, _]| *old).collect();
    let new: Vec<&SourceFile<'_>> = unmatched.filter_map(|[_, new]| *new).collect();
    files
        .iter()
        .filter_map(|[first, second]| match (*first, *second) {
            (Some(file), None) if partner(file, &new, &old).is_some() => None,
            (None, Some(file)) => Some([partner(file, &old, &new), Some(file)]),
            both => Some([both.0, both.1]),
        })
        .collect()
}

/// Returns the file among `others` with the same file name, if the name is unique in `others` and in `own`, the files
/// on the side of `file`.
fn partner<'a, 't>(
    file: &SourceFile<'_>,
    others: &[&'a SourceFile<'t>],
    own: &[&SourceFile<'_>],
) -> Option<&'a SourceFile<'t>> {
    let name = file_name(file);
    let mut others = others.iter().copied().filter(|other| file_name(other) == name);
    let other = others.next()?;
    let is_unique = others.next().is_none() && own.iter().filter(|own| file_name(own) == name).count() == 1;
    is_unique.then_some(other)
}

/// Returns the file name in lower case.
fn file_name(file: &SourceFile<'_>) -> String {
    path_key(Utf8Path::new(&file.path).file_name().unwrap_or(""))
}
