//! Files on one side of a comparison.

use std::collections::{BTreeMap, BTreeSet};
use std::hash::{BuildHasher as _, BuildHasherDefault, DefaultHasher};

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::system::DecodedFile;

/// Name of the applications folder on a controller.
const APPLICATIONS: &str = "usrapp";
/// Name of the configuration folder next to it.
const SETTINGS: &str = "configs";
/// Name of the fieldbus folder next to it.
const FIELDBUSES: &str = "applicom";

/// Name of the folder that contains them.
const CONTROLLER: &str = "usr";

/// Files by path, relative to a common root.
#[derive(Debug, Clone, Default)]
pub struct FileTree {
    files: BTreeMap<Utf8PathBuf, Vec<u8>>,
    /// Other kinds of files, which are compared by length and hash.
    others: BTreeMap<Utf8PathBuf, (usize, u64)>,
}

impl FileTree {
    /// Creates a tree with these files. Paths are relative and use `/`.
    pub fn new<P: Into<Utf8PathBuf>, B: Into<Vec<u8>>>(files: impl IntoIterator<Item = (P, B)>) -> Self {
        let mut tree = Self::default();
        for (path, bytes) in files {
            let (path, bytes) = (path.into(), bytes.into());
            if Self::includes(&path) {
                tree.files.insert(path, bytes);
            } else {
                tree.others
                    .insert(path, (bytes.len(), BuildHasherDefault::<DefaultHasher>::default().hash_one(&bytes)));
            }
        }
        tree
    }

    /// Whether a comparison reads the content of a file with this path. Other files are compared by their bytes.
    #[must_use]
    pub fn includes(path: &Utf8Path) -> bool {
        has_extension(path, &["pjx", "dtx", "pgx"]) || is_settings(path)
    }

    /// Whether another kind of file is part of a backup: it is below `usr` or one of the folders in `usr`.
    #[must_use]
    pub fn is_in_backup(path: &Utf8Path) -> bool {
        [CONTROLLER, APPLICATIONS, SETTINGS, FIELDBUSES].iter().any(|name| below(path, name).is_some())
    }

    /// Returns the number of files.
    #[must_use]
    pub fn len(&self) -> usize {
        self.files.len() + self.others.len()
    }

    /// Whether the tree has no files.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.files.is_empty() && self.others.is_empty()
    }

    /// Returns the files by displayed path.
    pub(crate) fn files(&self, is_one_cell: bool) -> BTreeMap<Utf8PathBuf, &[u8]> {
        let mut files = BTreeMap::new();
        for (path, bytes) in &self.files {
            let short = if is_one_cell { in_cell(path) } else { path };
            let key = if files.contains_key(short) { path } else { short };
            files.insert(key.to_owned(), bytes.as_slice());
        }
        files
    }

    /// Returns the lengths and hashes of other kinds of files by displayed path.
    pub(crate) fn others(&self, is_one_cell: bool) -> BTreeMap<Utf8PathBuf, (usize, u64)> {
        let shown = |path: &Utf8Path| if is_one_cell { in_cell(path).to_owned() } else { path.to_owned() };
        self.others.iter().map(|(path, content)| (shown(path), *content)).collect()
    }

    /// Whether the tree has at most one folder of applications, so that paths below it are unique.
    pub(crate) fn has_one_cell(&self) -> bool {
        let before = |path: &Utf8PathBuf| path.as_str().split_once("usrapp/").map(|(before, _)| before.to_owned());
        self.files.keys().filter_map(before).collect::<BTreeSet<_>>().len() <= 1
    }
}

/// Returns the path below the folder of applications, or from the folder that contains the configuration.
fn in_cell(path: &Utf8Path) -> &Utf8Path {
    let mut rest = path.components();
    while let Some(part) = rest.next() {
        if part.as_str().eq_ignore_ascii_case(APPLICATIONS) && !rest.as_path().as_str().is_empty() {
            return rest.as_path();
        }
    }
    let inside = [FIELDBUSES, SETTINGS].iter().find_map(|name| below(path, name)).and_then(Utf8Path::parent);
    let above = inside.or_else(|| below(path, CONTROLLER)).unwrap_or(Utf8Path::new(""));
    path.strip_prefix(above).unwrap_or(path)
}

/// Whether the file is a configuration file: in `usr/configs` or below, or in `usr/applicom`, which describes
/// fieldbuses.
pub(crate) fn is_settings(path: &Utf8Path) -> bool {
    if below(path, FIELDBUSES).is_some() {
        return has_extension(path, &["xml"]);
    }
    below(path, SETTINGS).is_some() && has_extension(path, &["cfx", "cf", "xml"])
}

/// Returns the outermost folder with this name that contains a file.
fn below<'p>(path: &'p Utf8Path, name: &str) -> Option<&'p Utf8Path> {
    let folders = path.ancestors().skip(1);
    folders.filter(|folder| folder.file_name().is_some_and(|own| own.eq_ignore_ascii_case(name))).last()
}

/// Whether the file has one of these extensions, in any letter case.
pub(crate) fn has_extension(path: &Utf8Path, extensions: &[&str]) -> bool {
    let extension = path.extension().unwrap_or("");
    extensions.iter().any(|wanted| extension.eq_ignore_ascii_case(wanted))
}

/// Decodes a file.
///
/// # Errors
/// If the bytes are no text, with the reason.
pub(crate) fn text_of(bytes: &[u8]) -> Result<std::sync::Arc<str>, String> {
    use val3_analysis::db::FileStatus;
    let Some(content) = DecodedFile::of(Ok(bytes.to_vec())) else { return Err("it does not exist".to_owned()) };
    match content.status {
        Some(FileStatus::Unreadable(reason)) => Err(reason),
        _ => Ok(content.text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_start_at_the_folder_of_applications() {
        let tree =
            FileTree::new([("backup/usr/usrapp/a/a.pjx", ""), ("backup/usr/configs/arm.cfx", ""), ("b/b.pgx", "")]);
        assert!(tree.has_one_cell());
        let files: Vec<_> = tree.files(true).into_keys().collect();
        assert_eq!(files, ["a/a.pjx", "b/b.pgx", "configs/arm.cfx"]);
        let two = FileTree::new([("1/usrapp/a/a.pjx", ""), ("2/usrapp/a/a.pjx", "")]);
        assert!(!two.has_one_cell());
        assert_eq!(two.files(true).len(), 2);
    }

    #[test]
    fn files_of_other_kinds_are_not_wanted() {
        let wanted = |path: &str| FileTree::includes(path.into());
        assert!(wanted("a/START.PGX") && wanted("usr/configs/bio.cfx") && wanted("usr/applicom/Modbus/modbus.xml"));
        assert!(!wanted("a/a.html") && !wanted("usr/app/val3.Motion.anthro.cfx"));
    }

    #[test]
    fn utf_16_has_no_text() {
        assert!(text_of(b"\xff\xfea\0").unwrap_err().contains("UTF-16"));
        assert_eq!(text_of("a".as_bytes()).as_deref(), Ok("a"));
    }
}
