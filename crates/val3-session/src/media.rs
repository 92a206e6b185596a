//! The media of a controller for an application: the folder of `Disk`, and where the application is on it.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::folder;
use val3_machine::files::Roots;

use crate::error::SessionError;

/// The media of a controller.
pub(crate) struct Media {
    /// The folders of the roots of paths.
    pub(crate) roots: Roots,
    /// The folder of `Disk`.
    pub(crate) disk: Utf8PathBuf,
    /// The application on it: `Disk://app`.
    pub(crate) application: String,
}

impl Media {
    /// `Disk` as the analysis knows it, otherwise the folder around the application. A missing folder holds nothing.
    ///
    /// # Errors
    /// The folder cannot be opened.
    pub(crate) fn of(db: &Database, project: Project) -> Result<Self, SessionError> {
        let application = folder(db, project);
        let disk = project.disk(db).or(application.parent()).unwrap_or(application).to_owned();
        let inside = application.strip_prefix(&disk).unwrap_or(Utf8Path::new(""));
        let application = format!("Disk://{inside}");
        let mut media = Self { roots: Roots::default(), disk: disk.clone(), application };
        if disk.is_dir() {
            media.mount("Disk", &disk)?;
        }
        Ok(media)
    }

    /// Makes a folder the root `name` of paths.
    ///
    /// # Errors
    /// The folder cannot be opened.
    pub(crate) fn mount(&mut self, name: &str, folder: &Utf8Path) -> Result<(), SessionError> {
        self.roots.mount(name, folder).map_err(|error| SessionError::Folder {
            root: name.to_owned(),
            folder: folder.to_owned(),
            reason: error.to_string(),
        })
    }
}
