//! The things around the arm, from `cell.toml`.

use std::convert::Infallible;
use std::str::FromStr;

use camino::{Utf8Path, Utf8PathBuf};
use val3_cell::{ArmBase, Cell, CellFile, DataKind, KnownSignal, Mesh, Surroundings};
use val3_config::{ConfigError, ConfigFile, TableFile};
use val3_files::FileClass;
use val3_lang::suggest::nearest;
use val3_machine::controller::Controller;
use val3_machine::event::EventKind;

use crate::error::{SessionError, refused};
use crate::shapes;

/// Name of the file that is used without a setting, beside `val3.toml` or in the folder of the application.
const FILE_NAME: &str = "cell.toml";

/// Choice of the things around the arm.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CellChoice {
    /// The arm stands in an empty room.
    Without,
    /// A file describes them.
    File(Utf8PathBuf),
}

impl CellChoice {
    /// Returns the choice of a path, or of the word `none`.
    #[must_use]
    pub fn of_text(text: &str) -> Self {
        if text == "none" { Self::Without } else { Self::File(text.into()) }
    }
}

impl FromStr for CellChoice {
    type Err = Infallible;

    fn from_str(text: &str) -> Result<Self, Infallible> {
        Ok(Self::of_text(text))
    }
}

/// Places the things of the chosen file around the arm; of the file `cell.toml` without a choice.
///
/// # Errors
/// A file is missing or cannot be used.
pub(crate) fn place(
    controller: &mut Controller,
    choice: Option<&CellChoice>,
    file: Option<&ConfigFile>,
    application: &Utf8Path,
) -> Result<(), SessionError> {
    let Some((path, text)) = chosen(choice, file, application)? else { return Ok(()) };
    // A file that is only beside the settings can be about another application of the same cell.
    let is_named = choice.is_some() || file.is_some_and(|file| file.config.run.cell.is_some());
    let cell = TableFile::<CellFile>::parse(&path, &text).and_then(|file| build(controller, &file, is_named));
    let cell = cell?;
    let arm = controller.arm().model();
    let links = file.map_or(Ok(Vec::new()), |file| shapes::hulls(file, &controller.devices.shapes, arm));
    let cell = cell.with_links(links?);
    if !cell.missing.is_empty() {
        let names = cell.missing.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        let file = path.file_name().unwrap_or(FILE_NAME);
        let text = format!("without {names} of {file}: this application does not have their frames, tools or signals");
        controller.devices.record_outside(0, EventKind::Notice { text });
    }
    controller.surround(cell);
    let has_links = controller.devices.state.watch.as_ref().is_some_and(|watch| watch.scene().has_link_shapes());
    if !has_links {
        let name = controller.arm().model().name();
        let text = format!("links of the arm `{name}` have no shapes: their distances are unknown");
        controller.devices.record_outside(0, EventKind::Notice { text });
    }
    Ok(())
}

/// Returns the chosen file with its text.
fn chosen(
    choice: Option<&CellChoice>,
    file: Option<&ConfigFile>,
    application: &Utf8Path,
) -> Result<Option<(Utf8PathBuf, String)>, SessionError> {
    let of_file = file.and_then(|file| Some((file, file.config.run.cell.as_ref()?)));
    let path = match (choice, of_file) {
        (Some(CellChoice::Without), _) => return Ok(None),
        (Some(CellChoice::File(path)), _) => path.clone(),
        (None, Some((_, name))) if name.as_str() == "none" => return Ok(None),
        (None, Some((file, name))) => file.folder().join(name),
        (None, None) => {
            let path = file.map_or(application, ConfigFile::folder).join(FILE_NAME);
            if !path.exists() {
                return Ok(None);
            }
            path
        }
    };
    let text = val3_files::read_text(&path, FileClass::Settings);
    let text = text.map_err(|reason| {
        let (message, help) = (format!("cannot read `{path}`: {reason}"), "name an existing file, or `none`");
        match of_file.filter(|_| choice.is_none()) {
            Some((file, _)) => refused(file, "run.cell", message, help),
            None => SessionError::Setting { message, help: help.to_owned() },
        }
    })?;
    Ok(Some((path, text)))
}

fn build(controller: &Controller, file: &TableFile<CellFile>, is_named: bool) -> Result<Cell, ConfigError> {
    let arm = controller.arm().model();
    let arm = ArmBase { axes: arm.axes(), height: arm.height() };
    let mut surroundings = OpenApplication { controller, folder: file.folder(), is_named };
    let cell = Cell::build(&file.content, arm, &mut surroundings);
    cell.map_err(|error| file.fault(&error.key, error.message, error.help))
}

/// Whether links lead from a path below a folder to a file elsewhere.
fn leads_out(folder: &Utf8Path, path: &Utf8Path) -> bool {
    let folder = if folder.as_str().is_empty() { Utf8Path::new(".") } else { folder };
    let real = folder.canonicalize().ok().zip(folder.join(path).canonicalize().ok());
    real.is_some_and(|(folder, path)| !path.starts_with(folder))
}

/// The application in memory, and the folder of its cell's file.
struct OpenApplication<'a> {
    controller: &'a Controller,
    folder: &'a Utf8Path,
    /// Whether a setting names the file.
    is_named: bool,
}

impl Surroundings for OpenApplication<'_> {
    fn mesh(&mut self, path: &Utf8Path) -> Result<Mesh, String> {
        let is_below = path.is_relative() && !path.components().any(|part| part.as_str() == "..");
        if !is_below || leads_out(self.folder, path) {
            return Err(format!("`{path}` is not in the folder of this file"));
        }
        let bytes = val3_files::read(&self.folder.join(path), FileClass::Shape);
        let bytes = bytes.map_err(|reason| format!("cannot read `{path}`: {reason}"))?;
        Mesh::read(&bytes).map_err(|error| format!("cannot use `{path}`: {error}"))
    }

    fn carrier(&self, name: &str) -> Result<DataKind, Option<String>> {
        self.controller.carrier_kind(name).ok_or_else(|| {
            let known = self.controller.carrier_names();
            nearest(name, known.iter().map(String::as_str)).map(str::to_owned)
        })
    }

    fn signal(&self, path: &str) -> Result<KnownSignal, Option<String>> {
        self.controller.known_signal(path)
    }

    fn may_lack_data(&self) -> bool {
        !self.is_named
    }
}
