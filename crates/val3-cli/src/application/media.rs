//! The media of a controller for an application: `Disk`, and where the application is on it.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::folder;
use val3_machine::files::Roots;

use crate::user_error::UserError;

/// The media of a controller.
pub(crate) struct Media {
    /// The folders that paths lead to.
    pub(crate) roots: Roots,
    /// The folder of `Disk`.
    pub(crate) disk: Utf8PathBuf,
    /// The application on it: `Disk://app`.
    pub(crate) application: String,
}

impl Media {
    /// `Disk` as the analysis knows it, else the folder around the application. One that is not there holds nothing.
    ///
    /// # Errors
    /// The folder cannot be opened.
    pub(crate) fn of(db: &Database, project: Project) -> Result<Self, UserError> {
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

    /// Lets a root of paths stand for a folder.
    ///
    /// # Errors
    /// The folder cannot be opened.
    pub(crate) fn mount(&mut self, name: &str, folder: &Utf8Path) -> Result<(), UserError> {
        self.roots.mount(name, folder).map_err(|error| {
            UserError::new(format!("cannot open the folder `{folder}` for `{name}://`: {error}"))
                .with_help("name a folder that you may read")
        })
    }
}
