//! Folder of a new application: in an existing cell or in a new cell.

use camino::{Utf8Path, Utf8PathBuf};

use crate::paths::Paths;
use crate::user_error::UserError;

/// Folder of a controller's applications, in lower case.
const USRAPP: &str = "usrapp";

/// Location of a new application.
pub(super) struct NewLocation {
    /// Folder of a controller, which contains `usr`; `None` if `usrapp` has no such parent.
    pub(super) cell: Option<Utf8PathBuf>,
    /// Folder of the applications.
    pub(super) usrapp: Utf8PathBuf,
    /// Whether the cell already existed.
    pub(super) exists: bool,
}

impl NewLocation {
    /// Finds the cell in or above `folder`, an absolute path. Without an existing cell, returns a new cell called
    /// `name` in `folder`.
    ///
    /// # Errors
    /// The folder does not exist.
    pub(super) fn find(folder: &Utf8Path, name: &str) -> Result<Self, UserError> {
        let folder = folder.canonicalize_utf8().map_err(|error| UserError::new(format!("`{folder}`: {error}")))?;
        if !folder.is_dir() {
            return Err(UserError::new(format!("`{folder}` is not a folder")).with_help("name a folder: --folder DIR"));
        }
        if let Some(usrapp) = folder.ancestors().find_map(usrapp) {
            let usr = usrapp
                .parent()
                .filter(|parent| parent.file_name().is_some_and(|name| name.eq_ignore_ascii_case("usr")));
            let cell = usr.and_then(Utf8Path::parent).map(Utf8Path::to_owned);
            return Ok(Self { cell, usrapp, exists: true });
        }
        let cell = folder.join(name);
        Ok(Self { usrapp: cell.join("usr").join(USRAPP), cell: Some(cell), exists: false })
    }

    /// Application folder.
    pub(super) fn folder(&self, name: &str) -> Utf8PathBuf {
        self.usrapp.join(name)
    }

    /// Checks that no existing file or folder would be replaced. Controllers ignore the letter case of paths.
    ///
    /// # Errors
    /// One of the folders, or the folder of the new cell, exists.
    pub(super) fn check_absent(&self, folders: &[&Utf8PathBuf], paths: &Paths) -> Result<(), UserError> {
        let new = self.cell.iter().filter(|_| !self.exists);
        let existing = new.chain(folders.iter().copied()).find_map(|folder| existing(folder));
        existing.map_or(Ok(()), |path| {
            Err(UserError::new(format!("`{}` exists", paths.shown(&path))).with_help("write another name"))
        })
    }
}

/// The `usrapp` folder: `folder` itself, or the controller's `usrapp` in `folder`.
fn usrapp(folder: &Utf8Path) -> Option<Utf8PathBuf> {
    if folder.file_name().is_some_and(|name| name.eq_ignore_ascii_case(USRAPP)) {
        return Some(folder.to_owned());
    }
    let within = |folder: &Utf8Path, name: &str| existing(&folder.join(name)).filter(|found| found.is_dir());
    match folder.file_name() {
        Some(name) if name.eq_ignore_ascii_case("usr") => within(folder, USRAPP),
        _ => within(&within(folder, "usr")?, USRAPP),
    }
}

/// Finds the entry with this path, ignoring the name's letter case.
fn existing(path: &Utf8Path) -> Option<Utf8PathBuf> {
    let (folder, name) = (path.parent()?, path.file_name()?);
    let entries = folder.read_dir_utf8().ok()?.filter_map(Result::ok);
    let mut found = entries.filter(|entry| entry.file_name().eq_ignore_ascii_case(name)).map(|entry| entry.into_path());
    found.next()
}
