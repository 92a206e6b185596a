//! The picture of a run (`--plot`).

use std::fs::File;
use std::io::Write as _;

use camino::{Utf8Path, Utf8PathBuf};
use val3_machine::controller::Controller;
use val3_trace::PictureObserver;

use crate::run::file;
use crate::user_error::UserError;

/// A picture and its file.
pub(super) struct PictureFile {
    file: File,
    path: Utf8PathBuf,
    observer: PictureObserver,
    /// Whether accelerations are drawn (`--plot-accelerations`).
    has_accelerations: bool,
}

impl PictureFile {
    pub(super) fn open(path: &Utf8Path, has_accelerations: bool, controller: &Controller) -> Result<Self, UserError> {
        let file = file::create(path, "picture")?;
        Ok(Self { file, path: path.to_owned(), observer: PictureObserver::new(controller), has_accelerations })
    }

    /// Adds what is new.
    pub(super) fn see(&mut self, t: f64, controller: &Controller) {
        self.observer.see(t, controller);
    }

    pub(super) fn close(mut self) -> Result<(), UserError> {
        let mut picture = self.observer.finish();
        picture.has_accelerations = self.has_accelerations;
        let written = self.file.write_all(picture.to_svg().as_bytes());
        written.map_err(|error| file::refused(&self.path, "picture", &error))
    }
}
