//! Changes of files that were read earlier.

use std::fs;

use camino::Utf8Path;

use crate::{FileClass, Unreadable, Unwritable, read, replace};

/// Replaces an existing file's content atomically. Fails if the content is no longer `before`, so that changes by other
/// programs are not lost.
///
/// # Errors
/// If the file has another content, is read-only, or cannot be written. Its content is then unchanged.
pub fn replace_unchanged(path: &Utf8Path, class: FileClass, before: &[u8], after: &[u8]) -> Result<(), Unwritable> {
    match read(path, class) {
        Ok(content) if content == before => {}
        Ok(_) | Err(Unreadable::Missing) => return Err(Unwritable::Changed),
        Err(reason) => return Err(Unwritable::System(reason.to_string())),
    }
    if fs::metadata(path)?.permissions().readonly() {
        return Err(Unwritable::ReadOnly);
    }
    replace(path, after)
}

#[cfg(test)]
mod tests {
    use camino::Utf8PathBuf;

    use super::*;
    use crate::testing::folder;

    fn file(text: &str) -> (tempfile::TempDir, Utf8PathBuf) {
        let (kept, folder) = folder();
        let path = folder.join("a.pgx");
        fs::write(&path, text).unwrap();
        (kept, path)
    }

    fn change(path: &Utf8Path) -> Result<(), Unwritable> {
        replace_unchanged(path, FileClass::Program, b"old", b"new")
    }

    #[test]
    fn a_file_is_replaced_without_leaving_others() {
        let (folder, path) = file("old");
        change(&path).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(folder.path().read_dir().unwrap().count(), 1);
    }

    #[test]
    fn a_file_changed_by_another_program_is_kept() {
        let (folder, path) = file("theirs");
        assert_eq!(change(&path), Err(Unwritable::Changed));
        assert_eq!(fs::read(&path).unwrap(), b"theirs");
        assert_eq!(folder.path().read_dir().unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn a_read_only_file_is_refused() {
        use std::os::unix::fs::PermissionsExt as _;
        let (_folder, path) = file("old");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o440)).unwrap();
        assert_eq!(change(&path), Err(Unwritable::ReadOnly));
    }
}
