//! Comparison of the controller's configuration files.

use std::collections::{BTreeMap, BTreeSet};

use camino::Utf8Path;
use val3_analysis::paths::path_key;

use super::text::{self, Version};
use crate::applications::TreeFiles;
use crate::model::{Change, EntryChange, Problem, SettingsChange};
use crate::read::entries::XmlEntry;
use crate::read::settings::{is_io, read};
use crate::tree::{is_settings, text_of};

/// Returns the files that differ.
pub(super) fn compare(old: &TreeFiles<'_>, new: &TreeFiles<'_>, problems: &mut Vec<Problem>) -> Vec<SettingsChange> {
    let (old, new) = (settings_by_key(old), settings_by_key(new));
    let keys: BTreeSet<&String> = old.keys().chain(new.keys()).collect();
    let changes = keys.into_iter().filter_map(|key| {
        let (old, new) = (old.get(key), new.get(key));
        let path = new.or(old)?.path;
        file(path, old.map(|file| file.bytes), new.map(|file| file.bytes), problems)
    });
    changes.collect()
}

/// A settings file in a tree.
struct SettingsFile<'t> {
    path: &'t str,
    bytes: &'t [u8],
}

/// Returns the settings files by path in lower case.
fn settings_by_key<'t>(files: &'t TreeFiles<'_>) -> BTreeMap<String, SettingsFile<'t>> {
    let settings = files.iter().filter(|(path, _)| is_settings(path));
    settings.map(|(path, bytes)| (path_key(path.as_str()), SettingsFile { path: path.as_str(), bytes })).collect()
}

fn file(path: &str, old: Option<&[u8]>, new: Option<&[u8]>, problems: &mut Vec<Problem>) -> Option<SettingsChange> {
    let change = Change::of(old.is_some(), new.is_some());
    let is_io = is_io(Utf8Path::new(path).file_name().unwrap_or(path));
    let mut compared = SettingsChange { path: path.to_owned(), change, is_io, entries: Vec::new(), text: None };
    let (Some(old), Some(new)) = (old, new) else { return Some(compared) };
    if old == new {
        return None;
    }
    let read = |bytes: &[u8]| text_of(bytes).ok().and_then(|text| read(&text));
    match (read(old), read(new)) {
        (Some(old), Some(new)) => compared.entries = entries(&old, &new),
        (old_read, new_read) => {
            let old = Version { bytes: old, is_readable: old_read.is_some() };
            let new = Version { bytes: new, is_readable: new_read.is_some() };
            compared.text = text::compare(path, [Some(old), Some(new)], text::XML, problems);
        }
    }
    (!compared.entries.is_empty() || compared.text.is_some()).then_some(compared)
}

/// Returns the entries that differ, in the order of the new file, followed by removed entries.
pub(super) fn entries(old: &[XmlEntry], new: &[XmlEntry]) -> Vec<EntryChange> {
    let (old_values, new_values) = (values(old), values(new));
    let removed = old.iter().filter(|entry| !new_values.contains_key(entry.path.as_str()));
    let mut seen = BTreeSet::new();
    let all = new.iter().chain(removed).map(|entry| entry.path.as_str()).filter(|path| seen.insert(*path));
    let changes = all.map(|path| EntryChange {
        entry: path.to_owned(),
        old: old_values.get(path).map(|value| (*value).to_owned()),
        new: new_values.get(path).map(|value| (*value).to_owned()),
    });
    changes.filter(|change| change.old != change.new).collect()
}

/// Values by path; for a path that occurs twice, the last value.
fn values(entries: &[XmlEntry]) -> BTreeMap<&str, &str> {
    entries.iter().map(|entry| (entry.path.as_str(), entry.value.as_str())).collect()
}
