//! Selects the compared files of a repository: VAL 3 and cell files, and all other files of a backup or an application.
//! Other files of a repository, such as a readme, are not compared.

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};
use val3_diff::FileTree;

use crate::paths::has_extension;

/// Selects compared files.
pub(super) struct Wanted {
    /// Folders that contain a project file.
    applications: BTreeSet<Utf8PathBuf>,
}

impl Wanted {
    /// Finds the application folders among these paths.
    pub(super) fn among<'p>(paths: impl Iterator<Item = &'p Utf8Path>) -> Self {
        let folders = paths.filter(|path| has_extension(path, "pjx")).filter_map(Utf8Path::parent);
        Self { applications: folders.map(Utf8Path::to_owned).collect() }
    }

    /// Whether the file is compared.
    pub(super) fn has(&self, path: &Utf8Path) -> bool {
        let is_of_application = || path.ancestors().skip(1).any(|folder| self.applications.contains(folder));
        FileTree::includes(path) || (FileTree::is_in_backup(path) || is_of_application()) && !is_hidden(path)
    }
}

/// Whether the file belongs to another tool, because its name or a folder's name begins with a dot.
pub(super) fn is_hidden(path: &Utf8Path) -> bool {
    path.components().any(|part| part.as_str().starts_with('.'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_backups_and_applications_belong_to_a_comparison() {
        let paths = ["README.md", "cell/a/a.pjx", "cell/a/recipes/12.txt", "cell/a/.git", "usr/app/x.dll", "src/x.c"];
        let wanted = Wanted::among(paths.iter().map(Utf8Path::new));
        let found: Vec<&str> = paths.into_iter().filter(|path| wanted.has(Utf8Path::new(path))).collect();
        assert_eq!(found, ["cell/a/a.pjx", "cell/a/recipes/12.txt", "usr/app/x.dll"]);
        // Checks an application at the root.
        assert!(Wanted::among([Utf8Path::new("a.pjx")].into_iter()).has("recipes/12.txt".into()));
    }
}
