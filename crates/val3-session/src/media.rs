//! Media of a controller for an application: the folder of `Disk`, and the application's path on it.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::add_on_programs::AddOnLibrary;
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::folder;
use val3_analysis::paths::inside;
use val3_machine::devices::StandIns;
use val3_machine::files::Roots;

use crate::error::SessionError;
use crate::settings::PathRoot;
use crate::stand_ins::StandIn;

/// Root of the folder with the applications.
const DISK: &str = "Disk";

/// Media of a controller.
pub(crate) struct CellMedia {
    /// Folders of the path roots.
    pub(crate) roots: Roots,
    /// Folder of `Disk`.
    pub(crate) disk: Utf8PathBuf,
    /// Path of the application, for example `Disk://app`.
    pub(crate) application: String,
    /// Roots for an application and stand-ins outside `Disk`.
    pub(crate) outside: Vec<PathRoot>,
}

impl CellMedia {
    /// Opens the media. `Disk` is the folder that the analysis uses, otherwise the folder around the application. A
    /// missing folder counts as empty.
    ///
    /// # Errors
    /// If the folder cannot be opened.
    pub(crate) fn of(db: &Database, project: Project) -> Result<Self, SessionError> {
        let application = folder(db, project);
        let disk = project.disk(db).or(application.parent()).unwrap_or(application).to_owned();
        let (roots, outside) = (Roots::default(), Vec::new());
        let mut media = Self { roots, disk: disk.clone(), application: String::new(), outside };
        if disk.is_dir() {
            media.mount(DISK, &disk)?;
        }
        media.application = media.place(application, application)?;
        Ok(media)
    }

    /// Makes the folders of stand-ins available.
    ///
    /// # Errors
    /// If a folder cannot be opened.
    pub(crate) fn place_stand_ins(&mut self, db: &Database, stand_ins: &[StandIn]) -> Result<StandIns, SessionError> {
        let mut placed = StandIns::default();
        for StandIn { identifier, project, .. } in stand_ins {
            let manifest = project.manifest(db).path(db);
            let library = folder(db, *project);
            let is_usual = manifest.file_stem() == library.file_name();
            placed.insert(identifier.to_string(), self.place(library, if is_usual { library } else { manifest })?);
        }
        Ok(placed)
    }

    /// Makes the folders of libraries available whose programs replace add-on instructions.
    ///
    /// # Errors
    /// If a folder cannot be opened.
    pub(crate) fn place_add_ons(
        &mut self,
        db: &Database,
        libraries: &[AddOnLibrary],
        placed: &mut StandIns,
    ) -> Result<(), SessionError> {
        for AddOnLibrary { alias, project } in libraries {
            let library = folder(db, *project);
            placed.insert(alias.to_string(), self.place(library, library)?);
        }
        Ok(())
    }

    /// Controller path for an application's or library's folder or project file. If it is outside `Disk`, the
    /// surrounding folder becomes a root.
    fn place(&mut self, folder: &Utf8Path, path: &Utf8Path) -> Result<String, SessionError> {
        let (root, around) = match inside(folder, &self.disk) {
            Some(_) => (DISK.to_owned(), self.disk.clone()),
            None => self.root_around(folder)?,
        };
        let path = inside(path, &around).unwrap_or(path);
        Ok(format!("{root}://{}", path.as_str().replace('\\', "/")))
    }

    /// Root of the folder that contains a library.
    fn root_around(&mut self, library: &Utf8Path) -> Result<(String, Utf8PathBuf), SessionError> {
        let folder = library.parent().unwrap_or(library).to_owned();
        if let Some(known) = self.outside.iter().find(|known| known.folder == folder) {
            return Ok((known.name.clone(), folder));
        }
        let name = format!("Outside{}", self.outside.len());
        self.mount(&name, &folder)?;
        self.outside.push(PathRoot { name: name.clone(), folder: folder.clone() });
        Ok((name, folder))
    }

    /// Makes a folder available as the path root `name`.
    ///
    /// # Errors
    /// If the folder cannot be opened.
    pub(crate) fn mount(&mut self, name: &str, folder: &Utf8Path) -> Result<(), SessionError> {
        self.roots.mount(name, folder).map_err(|error| SessionError::Folder {
            root: name.to_owned(),
            folder: folder.to_owned(),
            reason: error.to_string(),
        })
    }
}
