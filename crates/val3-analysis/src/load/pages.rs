//! User pages of applications: HTML and binding files in the folder `interface`.

use camino::{Utf8Path, Utf8PathBuf};
use smol_str::SmolStr;

use super::Loader;
use super::outside::is_in_folder;
use crate::db::File;
use crate::pages::{BINDINGS, FOLDER, HTML, page_name};

impl Loader<'_> {
    /// Reads the page files of the application in `folder`; `beside` is the content of the folder.
    pub(super) fn pages(&mut self, folder: &Utf8Path, beside: &[SmolStr]) -> Vec<File> {
        let Some(name) = beside.iter().find(|name| name.eq_ignore_ascii_case(FOLDER)) else { return Vec::new() };
        let pages = folder.join(name.as_str());
        let names = self.names_in(&pages);
        let names = names.iter().filter(|name| [BINDINGS, HTML].iter().any(|ending| page_name(name, ending).is_some()));
        let mut paths: Vec<Utf8PathBuf> = names.map(|name| pages.join(name.as_str())).collect();
        paths.retain(|path| is_in_folder(self.system, folder, path));
        self.read_ahead(&paths);
        paths.iter().filter_map(|path| self.found_file(path)).collect()
    }
}
