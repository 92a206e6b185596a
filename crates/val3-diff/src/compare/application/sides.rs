//! Files in both versions of a project.

use std::collections::{BTreeMap, BTreeSet};

use crate::applications::SourceFile;
use crate::compare::text::Version;
use crate::read::data::{self, DataVersion};
use crate::tree::text_of;

/// Files by their path below the folder.
type FolderFiles<'t> = BTreeMap<String, SourceFile<'t>>;

/// Returns the versions of every file, sorted by path.
pub(super) fn versions<'a, 't>(
    old: Option<&'a FolderFiles<'t>>,
    new: Option<&'a FolderFiles<'t>>,
) -> Vec<[Option<&'a SourceFile<'t>>; 2]> {
    let keys: BTreeSet<&String> = [old, new].into_iter().flatten().flat_map(BTreeMap::keys).collect();
    let get = |files: Option<&'a FolderFiles<'t>>, key: &String| files.and_then(|files| files.get(key));
    keys.into_iter().map(|key| [get(old, key), get(new, key)]).collect()
}

/// Data in both versions, in the order of the project files.
#[derive(Default)]
pub(super) struct DataSides {
    pub(super) old: Vec<DataVersion>,
    pub(super) new: Vec<DataVersion>,
}

/// Path and versions of a file that is broken in at least one version.
type Broken<'t> = (String, [Option<Version<'t>>; 2]);

/// A data file in one version.
struct DataFile<'a, 't> {
    key: &'a str,
    file: &'a SourceFile<'t>,
    /// Data in the file; `None` if the file is broken.
    data: Option<Vec<DataVersion>>,
}

impl<'t> DataFile<'_, 't> {
    fn version(&self) -> Version<'t> {
        Version { bytes: self.file.bytes, is_readable: self.data.is_some() }
    }
}

impl DataSides {
    /// Reads the data files in use. If a file is broken in one version, both versions are omitted, so that its data are
    /// not reported as added or removed.
    pub(super) fn read<'t>(
        old: &[(&str, &SourceFile<'t>)],
        new: &[(&str, &SourceFile<'t>)],
    ) -> (Self, Vec<Broken<'t>>) {
        let mut sides = [old, new].map(|files| -> Vec<DataFile<'_, 't>> {
            files.iter().map(|(key, file)| DataFile { key, file, data: read(file.bytes) }).collect()
        });
        let broken_files = sides.iter().flatten().filter(|file| file.data.is_none());
        let keys: BTreeSet<&str> = broken_files.map(|file| file.key).collect();
        let mut broken = Vec::new();
        for key in keys {
            let [old, new] = sides.each_ref().map(|side| side.iter().find(|file| file.key == key));
            let path = new.or(old).map(|found| found.file.path.to_string()).unwrap_or_default();
            broken.push((path, [old.map(DataFile::version), new.map(DataFile::version)]));
            sides.iter_mut().for_each(|side| side.retain(|file| file.key != key));
        }
        let [old, new] = sides.map(|side| side.into_iter().filter_map(|file| file.data).flatten().collect());
        (Self { old, new }, broken)
    }
}

/// Reads the data in a file; `None` if the file is broken.
pub(super) fn read(bytes: &[u8]) -> Option<Vec<DataVersion>> {
    let text = text_of(bytes).ok()?;
    let parse = val3_syntax::parse_shared(text);
    let root = val3_analysis::xml::root(parse.view())?;
    let is_data = matches!(root.name(), "Database" | "dataList") && parse.errors().is_empty();
    is_data.then(|| data::read(parse.view()))
}
