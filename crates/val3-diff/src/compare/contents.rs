//! Differences in the XML of files that are not differences of items: namespaces, unknown attributes, texts.

use super::application::initial_values::DeclaredFields;
use super::settings::entries;
use crate::applications::{Application, SourceFile};
use crate::model::{ApplicationChange, Change, ContentChange, EntryChange, ProgramChange};
use crate::read::contents::Contents;
use crate::tree::text_of;

/// Adds the entries of a file that differ, except entries that are `is_known`, because their item is listed as changed.
pub(super) fn add(
    path: &str,
    bytes: [&[u8]; 2],
    mut is_known: impl FnMut(&EntryChange) -> bool,
    compared: &mut ApplicationChange,
) {
    if bytes[0] == bytes[1] || compared.texts.iter().any(|text| text.path == path) {
        return;
    }
    let [old, new] = bytes.map(|bytes| Contents::read(&text_of(bytes).ok()?));
    let Some((old, new)) = old.zip(new).filter(|(old, new)| old.root == new.root) else { return };
    let mut entries = entries(&old.entries, &new.entries);
    entries.retain(|change| !is_known(change));
    if !entries.is_empty() {
        compared.contents.push(ContentChange { path: path.to_owned(), entries });
    }
}

/// Adds differences of data files outside of the listed data. `fields` are the declared fields of both versions: a field
/// that only one version contains is no difference if it is declared in the same way.
pub(super) fn add_data(
    files: [&[(&str, &SourceFile<'_>)]; 2],
    mut fields: Option<[DeclaredFields<'_, '_>; 2]>,
    compared: &mut ApplicationChange,
) {
    let [old, new] = files;
    let names = compared.data.iter().flat_map(|data| [Some(&data.name), data.renamed_from.as_ref()]).flatten();
    let names: Vec<String> = names.map(|name| format!("[{name}]")).collect();
    for (key, file) in new {
        if let Some((_, before)) = old.iter().find(|(other, _)| other == key) {
            add(
                file.path.as_str(),
                [before.bytes, file.bytes],
                |change| {
                    is_of_data(&change.entry, &names)
                        || fields.as_mut().is_some_and(|fields| is_declared(change, fields))
                },
                compared,
            );
        }
    }
}

/// Whether the version without the entry declares the field in its user type.
fn is_declared(change: &EntryChange, [old, new]: &mut [DeclaredFields<'_, '_>; 2]) -> bool {
    match (&change.old, &change.new) {
        (None, Some(value)) => old.declare(&change.entry, value),
        (Some(value), None) => new.declare(&change.entry, value),
        _ => false,
    }
}

/// Whether the second word of the entry is one of the data: `Datas Data[nA] size`, `numSection num[nA] public`.
fn is_of_data(entry: &str, names: &[String]) -> bool {
    let item = entry.split(' ').nth(1).unwrap_or_default();
    names.iter().any(|name| item.ends_with(name.as_str()))
}

/// Adds differences in the project file outside its parameters and the listed items.
pub(super) fn add_project([old, new]: [&Application<'_>; 2], compared: &mut ApplicationChange) {
    let Some(bytes) = old.manifest.zip(new.manifest) else { return };
    let listed = ListedChanges::of(compared);
    let path = compared.path.clone();
    add(&path, [bytes.0, bytes.1], |change| listed.explain(&change.entry), compared);
}

/// Kinds of listed changes that change lists of the project file.
struct ListedChanges {
    programs: bool,
    references: bool,
    /// Further texts are programs or data that one of the versions does not list.
    texts: bool,
}

impl ListedChanges {
    fn of(compared: &ApplicationChange) -> Self {
        Self {
            programs: compared.programs.iter().any(changes_list),
            references: !compared.project.is_empty() || !compared.libraries.is_empty() || !compared.types.is_empty(),
            texts: !compared.texts.is_empty(),
        }
    }

    /// Whether a listed change is the reason for a difference in this entry of the project file.
    fn explain(&self, entry: &str) -> bool {
        match entry.split(' ').next().unwrap_or_default().to_lowercase().as_str() {
            "parameters" => self.references,
            "programs" | "programsection" => self.programs || self.texts,
            "database" | "datasection" | "libraries" | "aliassection" | "types" => self.references || self.texts,
            _ => false,
        }
    }
}

/// Whether the change of a program changes the project file's list of programs.
fn changes_list(program: &ProgramChange) -> bool {
    program.change != Change::Changed || program.listed.is_some() || program.renamed_from.is_some()
}
