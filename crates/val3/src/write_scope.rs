//! Paths in which a command may change files: the paths in its arguments.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::system::{Disk, System as _};

use crate::in_memory::archive_around;
use crate::user_error::UserError;

/// Folders in which a command may change files. Links are resolved, so that no link points outside.
#[derive(Debug)]
pub(crate) struct WriteScope {
    folders: Vec<Utf8PathBuf>,
}

impl WriteScope {
    /// Creates the scope for absolute paths in the arguments; for a file, its folder is used.
    pub(crate) fn new(asked: &[Utf8PathBuf]) -> Self {
        let folders = asked.iter().map(|path| path.parent().filter(|_| path.is_file()).unwrap_or(path));
        Self { folders: folders.map(|folder| Disk.target(folder)).collect() }
    }

    /// Checks that a file may be changed; messages call it `shown`.
    ///
    /// # Errors
    /// The file is outside of the scope after links are resolved.
    pub(crate) fn check(&self, path: &Utf8Path, shown: &str) -> Result<(), UserError> {
        if archive_around(path).is_some() {
            return Err(UserError::new(format!("`{shown}` is not changed: it is in an archive"))
                .with_help("unpack the archive, and name the folder"));
        }
        let target = Disk.target(path);
        if self.folders.iter().any(|folder| target.starts_with(folder)) {
            return Ok(());
        }
        Err(UserError::new(format!("`{shown}` is not changed: it is outside of the paths that the command names"))
            .with_help(format!("no file was changed; name the folder of `{target}`, too")))
    }
}

#[cfg(all(test, unix))]
mod tests {
    use std::fs;
    use std::os::unix::fs::symlink;

    use super::*;

    #[test]
    fn links_do_not_lead_out_of_the_named_paths() {
        let folder = tempfile::tempdir().unwrap();
        let root = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
        for name in ["cell/app", "prod"] {
            fs::create_dir_all(root.join(name)).unwrap();
            fs::write(root.join(name).join("start.pgx"), "").unwrap();
        }
        symlink("../prod", root.join("cell/linked")).unwrap();
        symlink("../../prod/start.pgx", root.join("cell/app/link.pgx")).unwrap();
        symlink("cell", root.join("way")).unwrap();
        let may_change =
            |asked: &str, path: &str| WriteScope::new(&[root.join(asked)]).check(&root.join(path), path).is_ok();
        assert!(may_change("cell", "cell/app/start.pgx") && may_change("way", "cell/app/start.pgx"));
        assert!(may_change("cell/app/start.pgx", "cell/app/new.pgx"), "a file stands for its folder");
        assert!(!may_change("cell", "prod/start.pgx") && !may_change("cell", "cell/app/link.pgx"));
        assert!(!may_change("cell", "cell/linked/start.pgx"));
    }
}
