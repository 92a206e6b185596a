//! Comparison of other kinds of files: recipes, add-ons, user pages, logs.

use std::collections::{BTreeMap, BTreeSet};

use camino::Utf8Path;
use val3_analysis::paths::path_key;

use crate::applications::{Application, Matched};
use crate::model::{Change, OtherChange};
use crate::tree::FileTree;

/// Index of the matched application that contains a file, and the path below its folder. A file outside of applications
/// has `None` and its whole path.
type FileKey = (Option<usize>, String);

/// A file with its length and hash.
type FileHash = (String, (usize, u64));

/// Returns the files that differ. A file in an application is compared with the file in the matched application.
pub(super) fn compare([old, new]: [&FileTree; 2], pairs: &[Matched<'_, '_>], is_one_cell: bool) -> Vec<OtherChange> {
    let old = by_key(old, &pairs.iter().map(|pair| pair.old).collect::<Vec<_>>(), is_one_cell);
    let new = by_key(new, &pairs.iter().map(|pair| pair.new).collect::<Vec<_>>(), is_one_cell);
    let keys: BTreeSet<&FileKey> = old.keys().chain(new.keys()).collect();
    let changes = keys.into_iter().filter_map(|key| compare_file(old.get(key), new.get(key)));
    let mut changes: Vec<OtherChange> = changes.collect();
    changes.sort_by(|one, other| one.path.cmp(&other.path));
    changes
}

fn compare_file(before: Option<&FileHash>, after: Option<&FileHash>) -> Option<OtherChange> {
    let (path, _) = after.or(before)?;
    let is_same = before.map(|(_, content)| content) == after.map(|(_, content)| content);
    let change = Change::of(before.is_some(), after.is_some());
    (!is_same).then(|| OtherChange { path: path.clone(), change })
}

fn by_key(
    tree: &FileTree,
    applications: &[Option<&Application<'_>>],
    is_one_cell: bool,
) -> BTreeMap<FileKey, FileHash> {
    let folder = |application: &Option<&Application<'_>>| application.map(|it| path_key(it.folder().as_str()));
    let folders: Vec<Option<String>> = applications.iter().map(folder).collect();
    let files = tree.others(is_one_cell).into_iter();
    files.map(|(path, content)| (file_key(&path, &folders), (path.into_string(), content))).collect()
}

/// Returns the key of a file. `folders` are the folders of the matched applications; the innermost folder counts.
fn file_key(path: &Utf8Path, folders: &[Option<String>]) -> FileKey {
    let path = path_key(path.as_str());
    let inside = |folder: &str| Utf8Path::new(&path).strip_prefix(folder).ok().map(|inner| inner.to_string());
    let around = folders.iter().enumerate().filter_map(|(pair, folder)| Some((pair, inside(folder.as_deref()?)?)));
    match around.min_by_key(|(_, inner)| inner.len()) {
        Some((pair, inner)) => (Some(pair), inner),
        None => (None, path),
    }
}
