//! The files of a repository that belong to a comparison: those of VAL 3 and of the cell, and all others of a backup or of an
//! application. A repository also has files about them, such as a readme.

use std::collections::BTreeSet;

use camino::{Utf8Path, Utf8PathBuf};
use val3_diff::Tree;

/// Says which files belong to a comparison.
pub(super) struct Wanted {
    /// The folders with a project file.
    applications: BTreeSet<Utf8PathBuf>,
}

impl Wanted {
    /// The files among these paths.
    pub(super) fn among<'p>(paths: impl Iterator<Item = &'p Utf8Path>) -> Self {
        let is_project = |path: &&Utf8Path| path.extension().is_some_and(|end| end.eq_ignore_ascii_case("pjx"));
        let folders = paths.filter(is_project).filter_map(Utf8Path::parent);
        Self { applications: folders.map(Utf8Path::to_owned).collect() }
    }

    /// Whether a file belongs to the comparison.
    pub(super) fn has(&self, path: &Utf8Path) -> bool {
        let is_of_application = || path.ancestors().skip(1).any(|folder| self.applications.contains(folder));
        Tree::wants(path) || (Tree::is_in_backup(path) || is_of_application()) && !is_hidden(path)
    }
}

/// Whether a file is one of another tool, because its name or that of a folder begins with a dot.
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
        // The folder of an application itself.
        assert!(Wanted::among([Utf8Path::new("a.pjx")].into_iter()).has("recipes/12.txt".into()));
    }
}
