//! Media and libraries: the access of the devices to the outside, apart from lines.

use std::rc::Rc;
use std::sync::Arc;

use val3_bytecode::Image;
use val3_vm::LoadedLibrary;

use super::media_cost::MediaCost;
use crate::files::{ControllerPath, FileFault, LibraryFiles, LibraryPath, OpenFiles, Overlay, Roots};
use crate::inputs::{Answer, Inputs};

/// Finds and compiles libraries: connects the run time to the analysis.
pub trait Libraries {
    /// Compiles the library with these files to an image.
    ///
    /// # Errors
    /// A fault in the data or programs, as a line of the event log (code 12 of `libLoad`).
    fn image(&mut self, path: &ControllerPath, files: LibraryFiles) -> Result<Arc<Image>, String>;
}

/// Media and libraries outside. While external input is recorded, an overlay covers the media: changes are state, and
/// each result of the disk below passes through the recorder, as do results for libraries.
pub(super) struct Outside {
    media: OutsideMedia,
    inputs: Inputs,
}

/// The media and libraries outside.
pub(super) struct OutsideMedia {
    /// The media that paths name.
    pub(super) roots: Roots,
    /// The files that programs have open.
    pub(super) files: OpenFiles,
    /// Finds and compiles libraries.
    pub(super) libraries: Box<dyn Libraries>,
}

/// File changes of programs, in memory. Contents are shared.
#[derive(Debug, Clone)]
pub struct MediaState {
    overlay: Option<Overlay>,
    files: Rc<OpenFiles>,
}

impl MediaState {
    /// Size of the memory that is not shared with an earlier state, in bytes.
    pub(crate) fn bytes(&self) -> u64 {
        self.overlay.as_ref().map_or(0, Overlay::fresh)
    }
}

impl Outside {
    pub(super) fn new(roots: Roots, libraries: Box<dyn Libraries>, inputs: Inputs) -> Self {
        Self { media: OutsideMedia { roots, files: OpenFiles::default(), libraries }, inputs }
    }

    /// Returns the file changes of programs. From the first call on, they stay in memory, limited to this number of
    /// bytes.
    pub(super) fn state(&mut self, limit: u64) -> MediaState {
        let OutsideMedia { roots, files, .. } = &mut self.media;
        if roots.cover(&self.inputs, limit) {
            files.follow(roots);
        }
        MediaState { overlay: roots.overlay(), files: Rc::new(files.copy()) }
    }

    pub(super) fn restore(&mut self, state: &MediaState) {
        self.media.roots.restore(state.overlay.clone());
        self.media.files = state.files.copy();
    }

    /// Writes the changes in memory to the media.
    pub(super) fn write(&self) -> Vec<String> {
        self.media.roots.write()
    }

    /// Uncovers the media: changes go to the media again.
    pub(super) fn uncover(&mut self) {
        let OutsideMedia { roots, files, .. } = &mut self.media;
        roots.uncover();
        files.follow(roots);
    }

    /// Whether a change was rejected since the last call, because changes in memory would exceed the limit.
    pub(super) fn take_overflow(&self) -> bool {
        self.media.roots.take_overflow()
    }

    /// Calls the media, or returns the recorded result.
    pub(super) fn ask<T>(&mut self, question: impl FnOnce(&mut OutsideMedia) -> T) -> T {
        question(&mut self.media)
    }

    /// Accesses an open file; returns the default value if the number belongs to no file.
    pub(super) fn of_file<T: Default>(&mut self, file: f64, act: impl FnOnce(&mut OpenFiles, usize) -> T) -> T {
        number(file).map(|file| self.ask(|media| act(&mut media.files, file))).unwrap_or_default()
    }

    /// Reads an application's or library's files.
    pub(super) fn files(&mut self, path: &str) -> Result<LibraryFiles, FileFault> {
        let library = LibraryPath::new(&controller_path("", path)?)?;
        self.ask(|media| library.read(&media.roots, ""))
    }

    /// Finds and compiles the library that a program of `from` names. Returns it with its files.
    pub(super) fn load(
        &mut self,
        time: &mut MediaCost,
        from: &str,
        path: &str,
        password: &str,
    ) -> Result<(LoadedLibrary, LibraryFiles), LoadFault> {
        let path = controller_path(from, path)?;
        let library = LibraryPath::new(&self.ask(|media| media.roots.spelled(&path))?)?;
        time.access(0);
        let files = self.ask(|media| library.read(&media.roots, password))?;
        time.access(files.size());
        let Self { media, inputs } = self;
        let compiled = inputs.ask(|| {
            let image = media.libraries.image(library.folder(), files.clone())?;
            Ok(Compiled { image, source_bytes: files.size() })
        });
        let Compiled { image, .. } = compiled.map_err(LoadFault::Program)?;
        Ok((LoadedLibrary { image, path: library.path().to_string() }, files))
    }
}

/// Compiled library. The image has about the same size as the files.
#[derive(Clone)]
struct Compiled {
    image: Arc<Image>,
    source_bytes: usize,
}

impl Answer for Compiled {
    fn held_bytes(&self) -> usize {
        self.source_bytes
    }
}

/// Reason why a library cannot be loaded.
pub(super) enum LoadFault {
    File(FileFault),
    /// A fault in the data or programs, as a line of the event log.
    Program(String),
}

impl From<FileFault> for LoadFault {
    fn from(fault: FileFault) -> Self {
        Self::File(fault)
    }
}

/// Resolves a path in a program of the application or library at `from`.
pub(super) fn controller_path(from: &str, path: &str) -> Result<ControllerPath, FileFault> {
    let from = ControllerPath::parse(from, &ControllerPath::root("Disk"))?;
    let is_file = from.has_extension("pjx") || from.has_extension("zip");
    ControllerPath::parse(path, &if is_file { from.parent() } else { from })
}

/// Converts a number to a file number; an invalid number belongs to no file.
fn number(file: f64) -> Option<usize> {
    let rounded = (file + 0.5).floor();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    let number = (0.0..256.0).contains(&rounded).then_some(rounded as usize);
    number
}
