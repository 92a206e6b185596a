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

/// The data of both versions.
#[derive(Default)]
pub(super) struct DataSides {
    pub(super) old: Vec<Data>,
    pub(super) new: Vec<Data>,
}

/// The path of a file that is broken in a version, and both versions.
type Broken<'t> = (String, [Option<Version<'t>>; 2]);

impl DataSides {
    /// Adds the data of both versions of a file.
    ///
    /// # Errors
    /// If one of them is broken; then nothing is added, so that the data of the other do not count as added or removed.
    pub(super) fn add<'t>(
        &mut self,
        old: Option<&SourceFile<'t>>,
        new: Option<&SourceFile<'t>>,
    ) -> Result<(), Broken<'t>> {
        let (old_data, new_data) = (old.map(|file| read(file.bytes)), new.map(|file| read(file.bytes)));
        if let (Some(None), _) | (_, Some(None)) = (&old_data, &new_data) {
            let version = |file: Option<&SourceFile<'t>>, data: &Option<Option<_>>| {
                file.map(|file| Version { bytes: file.bytes, is_readable: matches!(data, Some(Some(_))) })
            };
            let path = new.or(old).map(|file| file.path.to_string()).unwrap_or_default();
            return Err((path, [version(old, &old_data), version(new, &new_data)]));
        }
        self.old.extend(old_data.into_iter().flatten().flatten());
        self.new.extend(new_data.into_iter().flatten().flatten());
        Ok(())
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
