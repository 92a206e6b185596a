//! The libraries that a run loads: read, checked and compiled like the application.

use std::collections::BTreeMap;
use std::io;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::load;
use val3_analysis::system::{Disk, Kind, System};
use val3_bytecode::Image;
use val3_check::rule::Severity;
use val3_check::settings::{Selection, WorkspaceSettings};
use val3_machine::devices::Libraries;
use val3_machine::files::{ControllerPath, LibraryFiles};

/// Compiles libraries.
pub(crate) struct Images {
    /// The folder of `Disk`.
    disk: Utf8PathBuf,
    /// What was compiled, with the files it was compiled from.
    known: Vec<(String, LibraryFiles, Arc<Image>)>,
}

impl Images {
    pub(crate) fn new(disk: Utf8PathBuf) -> Self {
        Self { disk, known: Vec::new() }
    }
}

impl Libraries for Images {
    fn image(&mut self, path: &ControllerPath, files: LibraryFiles) -> Result<Arc<Image>, String> {
        let shown = path.to_string();
        let known = self.known.iter().find(|(known, held, _)| *known == shown && *held == files);
        if let Some((_, _, image)) = known {
            return Ok(Arc::clone(image));
        }
        let image = Arc::new(self.compile(path, &files)?);
        self.known.retain(|(known, ..)| *known != shown);
        self.known.push((shown, files, Arc::clone(&image)));
        Ok(image)
    }
}

impl Images {
    fn compile(&self, path: &ControllerPath, files: &LibraryFiles) -> Result<Image, String> {
        let folder = path.parts().iter().fold(self.disk.clone(), |folder, part| folder.join(part.as_str()));
        let manifest = files.files.first().map(|file| folder.join(&file.path)).ok_or("the library has no files")?;
        let files = files.files.iter().map(|file| (folder.join(&file.path), file.bytes.clone())).collect();
        let system = Laid { files };
        let workspace = load::load(&system, &[manifest]).map_err(|error| format!("{error:?}"))?;
        let [project] = workspace.projects.as_slice() else { return Err(format!("`{path}` is no library")) };
        let db = &workspace.db;
        let settings = WorkspaceSettings::new(db, &[*project], &Selection::default())
            .map_err(|errors| errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))?;
        let units = val3_check::units(db, &[*project]);
        let checked = units.iter().map(|unit| val3_check::check_unit(db, *unit, &settings)).sum();
        let checked = val3_check::finish(db, &units, &settings, checked);
        let wrong = checked.findings.iter().find(|finding| finding.severity == Severity::Error);
        if let Some(wrong) = wrong {
            return Err(format!("`{path}`: {}", wrong.message));
        }
        val3_compile::compile(db, *project).map_err(|error| error.to_string())
    }
}

/// The disk, with the files of a library laid over it: an encrypted library is nowhere else.
#[derive(Debug)]
pub(crate) struct Laid {
    pub(crate) files: BTreeMap<Utf8PathBuf, Vec<u8>>,
}

impl System for Laid {
    fn read(&self, path: &Utf8Path) -> io::Result<Vec<u8>> {
        self.files.get(path).map_or_else(|| Disk.read(path), |bytes| Ok(bytes.clone()))
    }

    fn list(&self, path: &Utf8Path) -> io::Result<Vec<String>> {
        let inside = self.files.keys().filter_map(|file| file.strip_prefix(path).ok()?.components().next());
        let mut names: Vec<String> = inside.map(|part| part.as_str().to_owned()).collect();
        match Disk.list(path) {
            Ok(found) => names.extend(found),
            Err(error) if names.is_empty() => return Err(error),
            Err(_) => {}
        }
        names.sort_unstable();
        names.dedup();
        Ok(names)
    }

    fn kind(&self, path: &Utf8Path) -> Option<Kind> {
        if self.files.contains_key(path) {
            return Some(Kind::File);
        }
        let is_folder = self.files.keys().any(|file| file.starts_with(path));
        if is_folder { Some(Kind::Folder) } else { Disk.kind(path) }
    }

    fn identity(&self, path: &Utf8Path) -> Utf8PathBuf {
        if self.files.contains_key(path) { path.to_owned() } else { Disk.identity(path) }
    }
}
