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
    let of = |files: &TreeFiles<'_>| -> BTreeMap<String, String> {
        let settings = files.keys().filter(|path| is_settings(path));
        settings.map(|path| (path_key(path.as_str()), path.to_string())).collect()
    };
    let (old_paths, new_paths) = (of(old), of(new));
    let keys: BTreeSet<&String> = old_paths.keys().chain(new_paths.keys()).collect();
    let change = |key: &String| {
        let path = new_paths.get(key).or(old_paths.get(key))?;
        let bytes = |paths: &BTreeMap<String, String>, files: &TreeFiles<'_>| -> Option<Vec<u8>> {
            files.get(Utf8Path::new(paths.get(key)?)).map(|bytes| bytes.to_vec())
        };
        file(path, bytes(&old_paths, old), bytes(&new_paths, new), problems)
    };
    keys.into_iter().filter_map(change).collect()
}

fn file(path: &str, old: Option<Vec<u8>>, new: Option<Vec<u8>>, problems: &mut Vec<Problem>) -> Option<SettingsChange> {
    let change = Change::of(old.is_some(), new.is_some());
    let is_io = is_io(Utf8Path::new(path).file_name().unwrap_or(path));
    let mut compared = SettingsChange { path: path.to_owned(), change, is_io, entries: Vec::new(), text: None };
    let (Some(old), Some(new)) = (old, new) else { return Some(compared) };
    if old == new {
        return None;
    }
    let read = |bytes: &[u8]| text_of(bytes).ok().and_then(|text| read(&text));
    match (read(&old), read(&new)) {
        (Some(old), Some(new)) => compared.entries = entries(&old, &new),
        (old_read, new_read) => {
            let old = Version { bytes: &old, is_readable: old_read.is_some() };
            let new = Version { bytes: &new, is_readable: new_read.is_some() };
            compared.text = text::compare(path, [Some(old), Some(new)], text::XML, problems);
        }
    }
    (!compared.entries.is_empty() || compared.text.is_some()).then_some(compared)
}

/// Returns the entries that differ, in the order of the new file, followed by removed entries.
pub(super) fn entries(old: &[XmlEntry], new: &[XmlEntry]) -> Vec<EntryChange> {
    let (old_values, new_values): (BTreeMap<_, _>, BTreeMap<_, _>) =
        (old.iter().cloned().collect(), new.iter().cloned().collect());
    let gone = old.iter().filter(|(name, _)| !new_values.contains_key(name));
    let change = |(name, _): &XmlEntry| EntryChange {
        entry: name.clone(),
        old: old_values.get(name).cloned(),
        new: new_values.get(name).cloned(),
    };
    let mut seen = BTreeSet::new();
    let all = new.iter().chain(gone).filter(|(name, _)| seen.insert(name.clone()));
    all.map(change).filter(|change| change.old != change.new).collect()
}
