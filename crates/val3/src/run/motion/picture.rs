//! Picture of a run (`--plot`).

use std::fmt::Display;
use std::io::Write as _;

use camino::{Utf8Path, Utf8PathBuf};
use val3_files::OutputFile;
use val3_machine::controller::Controller;
use val3_trace::PictureObserver;

use crate::output::file;
use crate::output::file_kind::OutputFileKind;
use crate::user_error::UserError;

/// A picture and its output file.
pub(super) struct PictureFile {
    file: OutputFile,
    path: Utf8PathBuf,
    observer: PictureObserver,
    /// Whether accelerations are drawn (`--plot-accelerations`).
    has_accelerations: bool,
}

impl PictureFile {
    pub(super) fn open(path: &Utf8Path, has_accelerations: bool, controller: &Controller) -> Result<Self, UserError> {
        let file = file::create(path, OutputFileKind::Svg, "picture")?;
        Ok(Self { file, path: path.to_owned(), observer: PictureObserver::new(controller), has_accelerations })
    }

    /// Adds the current state.
    pub(super) fn see(&mut self, t: f64, controller: &Controller) {
        self.observer.see(t, controller);
    }

    pub(super) fn close(mut self) -> Result<(), UserError> {
        let mut picture = self.observer.finish();
        picture.has_accelerations = self.has_accelerations;
        let refused = |reason: &dyn Display| file::refused(&self.path, "picture", reason);
        self.file.write_all(picture.to_svg().as_bytes()).map_err(|error| refused(&error))?;
        self.file.commit().map_err(|reason| refused(&reason))
    }
}
