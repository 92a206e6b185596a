//! The programs of both versions of a project.

use camino::Utf8Path;
use val3_analysis::paths::path_key;

use super::sides::versions;
use crate::applications::{Matched, SourceFile};
use crate::compare::text::Version;
use crate::compare::{interface, program, text};
use crate::exclusions::Layout;
use crate::model::{ApplicationChange, InterfaceChange, Pair, Problem};
use crate::read::program::Program;
use crate::tree::text_of;

/// Both versions of a file.
type Versions<'a, 't> = [Option<&'a SourceFile<'t>>; 2];

/// Adds the programs that differ. Returns the public ones that other projects see in another way.
pub(super) fn compare(
    pair: &Matched<'_, '_>,
    layout: Layout,
    compared: &mut ApplicationChange,
    problems: &mut Vec<Problem>,
) -> Vec<InterfaceChange> {
    let old = pair.old.map(|application| &application.programs);
    let new = pair.new.map(|application| &application.programs);
    let has_list =
        |side: Option<&crate::applications::Application<'_>>| side.is_some_and(|side| side.project.is_some());
    let lists = has_list(pair.old) && has_list(pair.new);
    let mut interface = Vec::new();
    for [old, new] in moved_together(versions(old, new)) {
        let is_same = |old: &SourceFile<'_>, new: &SourceFile<'_>| old.bytes == new.bytes && old.listed == new.listed;
        if old.zip(new).is_some_and(|(old, new)| is_same(old, new)) {
            continue;
        }
        // No project loads it, so it is no program.
        if lists && [old, new].into_iter().flatten().all(|file| !file.listed) {
            let path = new.or(old).map(|file| file.path.to_string()).unwrap_or_default();
            let sides = [as_version(old, true), as_version(new, true)];
            compared.texts.extend(text::compare(&path, sides, "a program file", problems));
            continue;
        }
        let read = |file: Option<&SourceFile<'_>>| file.and_then(|file| Program::read(&text_of(file.bytes).ok()?));
        let (old_program, new_program) = (read(old), read(new));
        if old.is_some() != old_program.is_some() || new.is_some() != new_program.is_some() {
            let path = new.or(old).map(|file| file.path.to_string()).unwrap_or_default();
            let sides = [as_version(old, old_program.is_some()), as_version(new, new_program.is_some())];
            compared.texts.extend(text::compare(&path, sides, "a program file", problems));
            continue;
        }
        let located = [old.zip(old_program.as_ref()), new.zip(new_program.as_ref())];
        let Some(change) = program::compare(located, lists, layout) else { continue };
        let types = |program: &Option<Program>| program.as_ref().map(Program::interface);
        let types = Pair { old: types(&old_program), new: types(&new_program) };
        interface.extend(interface::program(&change, types));
        compared.programs.push(change);
    }
    compared.programs.sort_by(|a, b| (path_key(&a.name), &a.file).cmp(&(path_key(&b.name), &b.file)));
    interface
}

fn as_version<'t>(file: Option<&SourceFile<'t>>, is_readable: bool) -> Option<Version<'t>> {
    file.map(|file| Version { bytes: file.bytes, is_readable })
}

/// A file that is in another folder of the application is the same file, if only one has its name.
fn moved_together<'a, 't>(files: Vec<Versions<'a, 't>>) -> Vec<Versions<'a, 't>> {
    let name = |file: &SourceFile<'_>| path_key(Utf8Path::new(&file.path).file_name().unwrap_or(""));
    let alone = |files: &[Versions<'a, 't>], at: usize| -> Vec<&'a SourceFile<'t>> {
        let sides = files.iter().filter(|[old, new]| old.is_some() != new.is_some());
        sides.filter_map(|sides| sides.get(at).copied().flatten()).collect()
    };
    let (old, new) = (alone(&files, 0), alone(&files, 1));
    let partner = |file: &SourceFile<'_>, others: &[&'a SourceFile<'t>], own: &[&'a SourceFile<'t>]| {
        let same = |list: &[&'a SourceFile<'t>]| -> Vec<&'a SourceFile<'t>> {
            list.iter().copied().filter(|other| name(other) == name(file)).collect()
        };
        match (same(others).as_slice(), same(own).len()) {
            ([other], 1) => Some(*other),
            _ => None,
        }
    };
    files
        .iter()
        .filter_map(|[first, second]| match (*first, *second) {
            (Some(file), None) if partner(file, &new, &old).is_some() => None,
            (None, Some(file)) => Some([partner(file, &old, &new), Some(file)]),
            both => Some([both.0, both.1]),
        })
        .collect()
}
