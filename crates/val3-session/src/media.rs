//! The media of a controller for an application: the folder of `Disk`, and where the application is on it.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::folder;
use val3_analysis::paths::inside;
use val3_machine::devices::StandIns;
use val3_machine::files::Roots;

use crate::error::SessionError;
use crate::settings::Root;
use crate::stand_ins::StandIn;

/// The media of a controller.
pub(crate) struct Media {
    /// The folders of the roots of paths.
    pub(crate) roots: Roots,
    /// The folder of `Disk`.
    pub(crate) disk: Utf8PathBuf,
    /// The application on it: `Disk://app`.
    pub(crate) application: String,
    /// The roots of stand-ins that lie outside of `Disk`.
    pub(crate) outside: Vec<Root>,
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
        let mut media = Self { roots: Roots::default(), disk: disk.clone(), application, outside: Vec::new() };
        if disk.is_dir() {
            media.mount("Disk", &disk)?;
        }
        Ok(media)
    }

    /// Makes stand-ins available.
    ///
    /// # Errors
    /// A folder cannot be opened.
    pub(crate) fn place_stand_ins(&mut self, db: &Database, stand_ins: &[StandIn]) -> Result<StandIns, SessionError> {
        let mut placed = StandIns::default();
        for StandIn { identifier, project, .. } in stand_ins {
            placed.insert(identifier.to_string(), self.place(project.manifest(db).path(db))?);
        }
        Ok(placed)
    }

    /// The path of a library as the controller knows it. A folder outside of `Disk` with libraries becomes a root.
    fn place(&mut self, manifest: &Utf8Path) -> Result<String, SessionError> {
        let library = manifest.parent().unwrap_or(manifest);
        let (root, folder) = match inside(library, &self.disk) {
            Some(_) => ("Disk".to_owned(), self.disk.clone()),
            None => self.root_around(library)?,
        };
        let is_usual = manifest.file_stem() == library.file_name();
        let path = inside(if is_usual { library } else { manifest }, &folder).unwrap_or(library);
        Ok(format!("{root}://{}", path.as_str().replace('\\', "/")))
    }

    /// The root of the folder that a library lies in.
    fn root_around(&mut self, library: &Utf8Path) -> Result<(String, Utf8PathBuf), SessionError> {
        let folder = library.parent().unwrap_or(library).to_owned();
        if let Some(known) = self.outside.iter().find(|known| known.folder == folder) {
            return Ok((known.name.clone(), folder));
        }
        let name = format!("StandIns{}", self.outside.len());
        self.mount(&name, &folder)?;
        self.outside.push(Root { name: name.clone(), folder: folder.clone() });
        Ok((name, folder))
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
