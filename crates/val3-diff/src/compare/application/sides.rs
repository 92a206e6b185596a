//! The files of both versions of a project, side by side.

use std::collections::{BTreeMap, BTreeSet};

use crate::applications::SourceFile;
use crate::compare::text::Version;
use crate::read::data::{self, Data};
use crate::tree::text_of;

/// Files by their path from the folder.
type Files<'t> = BTreeMap<String, SourceFile<'t>>;

/// The versions of each file, in the order of the paths.
pub(super) fn versions<'a, 't>(
    old: Option<&'a Files<'t>>,
    new: Option<&'a Files<'t>>,
) -> Vec<[Option<&'a SourceFile<'t>>; 2]> {
    let keys: BTreeSet<&String> = [old, new].into_iter().flatten().flat_map(BTreeMap::keys).collect();
    let get = |files: Option<&'a Files<'t>>, key: &String| files.and_then(|files| files.get(key));
    keys.into_iter().map(|key| [get(old, key), get(new, key)]).collect()
}

/// The data of both versions, each in the order of its project.
#[derive(Default)]
pub(super) struct DataSides {
    pub(super) old: Vec<Data>,
    pub(super) new: Vec<Data>,
}

/// The path of a file that is broken in a version, and both versions.
type Broken<'t> = (String, [Option<Version<'t>>; 2]);

impl DataSides {
    /// Reads the files that count. If a version of a file is broken, neither counts, so that the data of the other are not
    /// added or removed.
    pub(super) fn read<'t>(
        old: &[(&str, &SourceFile<'t>)],
        new: &[(&str, &SourceFile<'t>)],
    ) -> (Self, Vec<Broken<'t>>) {
        let [mut old, mut new] = [old, new].map(|files| -> Vec<_> {
            files.iter().map(|(key, file)| (*key, (file.path.to_string(), file.bytes, read(file.bytes)))).collect()
        });
        let keys: BTreeSet<&str> = old.iter().chain(&new).map(|(key, _)| *key).collect();
        let mut broken = Vec::new();
        for key in keys {
            let of = |side: &[(&str, (String, &'t [u8], Option<Vec<Data>>))]| {
                let found = side.iter().find(|(known, _)| *known == key);
                found.map(|(_, (path, bytes, data))| (path.clone(), Version { bytes, is_readable: data.is_some() }))
            };
            let versions = [of(&old), of(&new)];
            if versions.iter().flatten().all(|(_, version)| version.is_readable) {
                continue;
            }
            let path = versions.iter().flatten().next_back().map(|(path, _)| path.clone()).unwrap_or_default();
            broken.push((path, versions.map(|side| side.map(|(_, version)| version))));
            [&mut old, &mut new].into_iter().for_each(|side| side.retain(|(known, _)| *known != key));
        }
        let data = |side: Vec<(&str, (String, &[u8], Option<Vec<Data>>))>| {
            side.into_iter().filter_map(|(_, (_, _, data))| data).flatten().collect()
        };
        (Self { old: data(old), new: data(new) }, broken)
    }
}

/// The data of a file; `None` if it is broken.
fn read(bytes: &[u8]) -> Option<Vec<Data>> {
    let text = text_of(bytes).ok()?;
    let parse = val3_syntax::parse_shared(text);
    let root = val3_analysis::xml::root(parse.view())?;
    let is_data = matches!(root.name(), "Database" | "dataList") && parse.errors().is_empty();
    is_data.then(|| data::read(parse.view()))
}
