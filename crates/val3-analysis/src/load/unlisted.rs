//! Unlisted programs and data in project folders.
//!
//! They belong to no project, but a name that they use is not reported as unused.

use camino::Utf8PathBuf;

use super::Loader;
use super::outside::is_in_folder;
use crate::items::unlisted::{is_data, is_program};
use crate::paths::path_key;

impl Loader<'_> {
    /// Reads the unlisted files after all listed files.
    pub(super) fn read_unlisted(&mut self) {
        let paths = self.unlisted_paths();
        // Their inputs are stored in a separate map.
        let listed = std::mem::take(&mut self.files);
        self.read_ahead(&paths);
        for path in &paths {
            self.found_file(path);
        }
        self.unlisted = std::mem::replace(&mut self.files, listed);
    }

    fn unlisted_paths(&mut self) -> Vec<Utf8PathBuf> {
        let manifests = self.projects.values().map(|project| project.manifest(&self.db).path(&self.db));
        let mut folders: Vec<Utf8PathBuf> = manifests.filter_map(|path| Some(path.parent()?.to_owned())).collect();
        folders.sort_unstable();
        folders.dedup();
        let mut paths = Vec::new();
        for folder in folders {
            paths.extend(self.names_in(&folder).iter().map(|name| folder.join(name.as_str())));
        }
        paths.retain(|path| is_program(path.as_str()) || is_data(path.as_str()));
        paths.retain(|path| path.parent().is_some_and(|folder| is_in_folder(self.system, folder, path)));
        paths.retain(|path| !self.files.contains_key(&path_key(path.as_str())));
        paths
    }
}
