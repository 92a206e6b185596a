//! Edits of other files when files are renamed, created or deleted in the editor.
//!
//! Each function returns the edits to make before the editor changes the files themselves.

mod references;

pub(crate) use references::relative;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Db, File, Project, Sources};
use val3_analysis::items::manifest::{Spelling, entries, spelling};
use val3_analysis::items::parse;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{find_file, folder};
use val3_analysis::occurrences::Symbol;
use val3_analysis::paths::{is_same, normalise, path_key};

use val3_analysis::xml::{self, Attribute, XmlElement};
use val3_lang::keywords::is_identifier;

use crate::declare::{data_entries, program_entries, without};
use crate::edit::{FileEdit, SourceChange};
use crate::references::uses;
use crate::xml_list::escaped;

/// Edits for renamed files and folders (old path, new path). A program is renamed with its file, including all its
/// calls. Elements in `.pjx` files and references to libraries and types are adapted.
pub fn will_rename_files(db: &dyn Db, renames: &[(Utf8PathBuf, Utf8PathBuf)]) -> SourceChange {
    let mut edits = Vec::new();
    for (from, to) in renames {
        match find(db, from) {
            Some(file) => edits.extend(renamed_file(db, file, from, to)),
            None => edits.extend(references::of_folder(db, from, to)),
        }
    }
    SourceChange::of(edits).sorted(db)
}

/// Adds new programs and data to the `.pjx` in the same folder.
pub fn will_create_files(db: &dyn Db, paths: &[Utf8PathBuf]) -> SourceChange {
    let mut edits = Vec::new();
    for project in projects(db) {
        let (programs, data) = (new_files(db, project, paths, "pgx"), new_files(db, project, paths, "dtx"));
        if !programs.is_empty() {
            edits.extend(program_entries(db, project, &programs));
        }
        if !data.is_empty() {
            edits.extend(data_entries(db, project, &data));
        }
    }
    SourceChange::of(edits).sorted(db)
}

/// Names of the files with this extension in the project's folder that are neither loaded nor listed.
fn new_files(db: &dyn Db, project: Project, paths: &[Utf8PathBuf], extension: &str) -> Vec<String> {
    let files = paths.iter().filter(|path| has_extension(path, extension) && lies_in(path, folder(db, project)));
    let new = files.filter(|path| find(db, path).is_none() && !is_listed(db, project, path));
    new.filter_map(|path| path.file_name()).map(str::to_owned).collect()
}

/// Removes deleted files from the `.pjx` files.
pub fn will_delete_files(db: &dyn Db, paths: &[Utf8PathBuf]) -> SourceChange {
    let files: Vec<File> = paths.iter().filter_map(|path| find(db, path)).collect();
    let mut edits = Vec::new();
    for project in projects(db) {
        each_entry(db, project, |entry, path| {
            let named = find_file(db, project, &path.text());
            if named.is_some_and(|file| files.contains(&file)) {
                edits.push(without(db, project.manifest(db), entry.view().range()));
            }
        });
    }
    SourceChange::of(edits).sorted(db)
}

fn renamed_file(db: &dyn Db, file: File, from: &Utf8Path, to: &Utf8Path) -> Vec<FileEdit> {
    if has_extension(from, "pjx") {
        return references::of_manifest(db, file, to);
    }
    let mut edits = entry_edits(db, file, to);
    if has_extension(from, "pgx") {
        edits.extend(program_edits(db, file, from, to));
    }
    edits
}

/// Edits of the file's elements in each `.pjx`; if the file moves to another project, the element moves there.
fn entry_edits(db: &dyn Db, file: File, to: &Utf8Path) -> Vec<FileEdit> {
    let mut edits = Vec::new();
    let target = projects(db).into_iter().find(|project| lies_in(to, folder(db, *project)));
    let mut listed = false;
    for project in projects(db) {
        let manifest = project.manifest(db);
        each_entry(db, project, |entry, path| {
            if find_file(db, project, &path.text()) != Some(file) {
                return;
            }
            listed = true;
            if target.is_some_and(|target| target != project) {
                edits.push(without(db, manifest, entry.view().range()));
            } else if let Some(reference) = relative(folder(db, project), to) {
                edits.push(FileEdit { file: manifest, range: path.range, text: escaped(&reference) });
            }
        });
    }
    if let Some(target) = target.filter(|target| listed && !lies_in(file.path(db), folder(db, *target))) {
        let name = vec![to.file_name().unwrap_or("").to_owned()];
        edits.extend(match has_extension(to, "pgx") {
            true => program_entries(db, target, &name),
            false => data_entries(db, target, &name),
        });
    }
    edits
}

/// Renames the program and its calls if the file had the program's name. A file whose name differs only in letter case,
/// before and after, changes nothing.
fn program_edits(db: &dyn Db, file: File, from: &Utf8Path, to: &Utf8Path) -> Vec<FileEdit> {
    let name = &header(db, file).name;
    let new = to.file_stem().unwrap_or("");
    let Some(old) = from.file_stem().filter(|old| old.eq_ignore_ascii_case(name)) else { return Vec::new() };
    let only_letter_case = old != name && new.eq_ignore_ascii_case(name);
    if name == new || only_letter_case || !is_identifier(new) {
        return Vec::new();
    }
    let mut edits = Vec::new();
    for project in crate::owner::projects_of(db, file) {
        let symbol = Symbol::Program(*project, name.clone());
        let manifest = project.manifest(db);
        let places = uses(db, &symbol).filter(|(file, ..)| *file != manifest);
        edits.extend(places.map(|(file, _, range)| FileEdit { file, range, text: new.to_owned() }));
    }
    edits
}

/// Calls `see` for the elements of a `.pjx` that list files, with the attribute that contains the file name.
fn each_entry(db: &dyn Db, project: Project, mut see: impl FnMut(XmlElement<'_>, Attribute<'_>)) {
    let parse = parse(db, project.manifest(db));
    let Some(root) = xml::root(parse.view()) else { return };
    let Spelling { programs, data, .. } = spelling(root);
    for entry in entries(root, *programs).chain(entries(root, *data)) {
        if let Some(path) = entry.attribute("file") {
            see(entry, path);
        }
    }
}

fn is_listed(db: &dyn Db, project: Project, path: &Utf8Path) -> bool {
    let mut listed = false;
    each_entry(db, project, |_, entry| {
        let named = val3_analysis::paths::file_in(folder(db, project), &entry.text());
        listed |= is_same(&named, path);
    });
    listed
}

fn projects(db: &dyn Db) -> Vec<Project> {
    let mut projects: Vec<Project> = Sources::get(db).projects(db).values().copied().collect();
    projects.sort_unstable_by_key(|project| project.manifest(db).path(db));
    projects
}

/// Whether `path` is directly in `folder`.
fn lies_in(path: &Utf8Path, folder: &Utf8Path) -> bool {
    path.parent().is_some_and(|parent| is_same(parent, folder))
}

fn find(db: &dyn Db, path: &Utf8Path) -> Option<File> {
    Sources::get(db).files(db).get(&path_key(normalise(path).as_str())).copied()
}

fn has_extension(path: &Utf8Path, extension: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(extension))
}

#[cfg(test)]
mod tests;
