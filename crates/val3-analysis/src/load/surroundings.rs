//! The file with the things around the arm of an application.

use camino::Utf8Path;

use super::Loader;
use super::outside::is_in_folder;
use crate::application::START;
use crate::db::{Configuration, File};
use crate::items::manifest::Manifest;
use crate::paths::file_in;
use crate::surroundings::FILE_NAME;

impl Loader<'_> {
    /// Reads the `cell.toml` of the application in `folder`: the file that `[run] cell` names, the file beside
    /// `val3.toml`, or without one the file in the folder. `None` for libraries and user types, and for files outside of
    /// the folder of `val3.toml`.
    pub(super) fn surroundings(
        &mut self,
        folder: &Utf8Path,
        manifest: &Manifest,
        configuration: Option<Configuration>,
    ) -> Option<File> {
        let stem = |program: &str| file_in(folder, program).file_stem().map(str::to_owned);
        if !manifest.programs.iter().any(|program| stem(program).is_some_and(|stem| stem.eq_ignore_ascii_case(START))) {
            return None;
        }
        let settings = configuration.map(|configuration| configuration.file(&self.db));
        let (around, name) = match settings {
            Some(file) => (file.folder().to_owned(), file.config.run.cell.clone()),
            None => (folder.to_owned(), None),
        };
        if name.as_ref().is_some_and(|name| name == "none") {
            return None;
        }
        let path = around.join(name.as_deref().unwrap_or(Utf8Path::new(FILE_NAME)));
        let is_readable = self.is_listed(&path) && is_in_folder(self.system, &around, &path);
        if is_readable { self.found_file(&path) } else { None }
    }
}
