//! The media of a controller for an application: the folder of `Disk`, and where the application is on it.

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::add_on_programs::AddOnLibrary;
use val3_analysis::db::{Database, Project};
use val3_analysis::items::project::folder;
use val3_analysis::paths::inside;
use val3_machine::devices::StandIns;
use val3_machine::files::Roots;

use crate::error::SessionError;
use crate::settings::Root;
use crate::stand_ins::StandIn;

/// The root of the folder with the applications.
const DISK: &str = "Disk";

/// The media of a controller.
pub(crate) struct Media {
    /// The folders of the roots of paths.
    pub(crate) roots: Roots,
    /// The folder of `Disk`.
    pub(crate) disk: Utf8PathBuf,
    /// The path of the application: `Disk://app`.
    pub(crate) application: String,
    /// The roots of an application and of stand-ins that lie outside of `Disk`.
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
        let (roots, outside) = (Roots::default(), Vec::new());
        let mut media = Self { roots, disk: disk.clone(), application: String::new(), outside };
        if disk.is_dir() {
            media.mount(DISK, &disk)?;
        }
        media.application = media.place(application, application)?;
        Ok(media)
    }

    /// Makes stand-ins available.
    ///
    /// # Errors
    /// A folder cannot be opened.
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

    /// Makes libraries with programs in place of instructions of add-ons available.
    ///
    /// # Errors
    /// A folder cannot be opened.
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

    /// The path of the folder of an application or library, or of its project file, as the controller knows it. The folder
    /// around one outside of `Disk` becomes a root.
    fn place(&mut self, folder: &Utf8Path, path: &Utf8Path) -> Result<String, SessionError> {
        let (root, around) = match inside(folder, &self.disk) {
            Some(_) => (DISK.to_owned(), self.disk.clone()),
            None => self.root_around(folder)?,
        };
        let path = inside(path, &around).unwrap_or(path);
        Ok(format!("{root}://{}", path.as_str().replace('\\', "/")))
    }

    /// The root of the folder that a library lies in.
    fn root_around(&mut self, library: &Utf8Path) -> Result<(String, Utf8PathBuf), SessionError> {
        let folder = library.parent().unwrap_or(library).to_owned();
        if let Some(known) = self.outside.iter().find(|known| known.folder == folder) {
            return Ok((known.name.clone(), folder));
        }
        let name = format!("Outside{}", self.outside.len());
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
