//! Names in a folder, with lookup in any letter case.

use crate::paths::path_key;

/// Names in a folder with their keys, sorted by key.
pub(super) struct FolderNames(Vec<(String, String)>);

impl FolderNames {
    pub(super) fn new(names: Vec<String>) -> Self {
        let mut names: Vec<(String, String)> = names.into_iter().map(|name| (path_key(&name), name)).collect();
        names.sort_unstable();
        Self(names)
    }

    /// Returns the exact name if it exists, otherwise a name that differs only in letter case.
    pub(super) fn spelling(&self, name: &str) -> Option<&str> {
        let key = path_key(name);
        let start = self.0.partition_point(|(known, _)| *known < key);
        let mut alike =
            self.0.get(start..)?.iter().take_while(|(known, _)| *known == key).map(|(_, name)| name.as_str());
        alike.clone().find(|known| *known == name).or_else(|| alike.next())
    }

    /// Returns all names, as spelt on the disk.
    pub(super) fn spellings(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(_, name)| name.as_str())
    }
}
