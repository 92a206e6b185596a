//! Picture of a run (`--plot`).

use std::fmt::Display;
use std::io::Write as _;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use val3_cell::{Profile, Proximity};
use val3_files::OutputFile;
use val3_machine::controller::Controller;
use val3_plot::DistanceSample;
use val3_trace::PictureObserver;

use crate::output::file;
use crate::output::file_kind::OutputFileKind;
use crate::user_error::UserError;

/// A picture and its output file.
pub(super) struct PictureFile {
    file: OutputFile,
    path: Utf8PathBuf,
    observer: PictureObserver,
    /// Smallest distances; `None` without things around the arm.
    profile: Option<Profile>,
    distances: Vec<DistanceSample>,
    /// Whether accelerations are drawn (`--plot-accelerations`).
    has_accelerations: bool,
}

impl PictureFile {
    pub(super) fn open(path: &Utf8Path, has_accelerations: bool, controller: &Controller) -> Result<Self, UserError> {
        let file = file::create(path, OutputFileKind::Svg, "picture")?;
        let watch = controller.devices.state.watch.as_ref();
        Ok(Self {
            file,
            path: path.to_owned(),
            observer: PictureObserver::new(controller),
            profile: watch.map(|watch| Profile::new(Arc::clone(watch.scene()))),
            distances: Vec::new(),
            has_accelerations,
        })
    }

    /// Adds the current state.
    pub(super) fn see(&mut self, t: f64, controller: &Controller) {
        self.observer.see(t, controller);
        if let Some(profile) = &mut self.profile {
            let proximity = profile.see(&controller.sight(profile.scene(), t));
            self.distances.push(sample(t, proximity));
        }
    }

    pub(super) fn close(mut self) -> Result<(), UserError> {
        let mut picture = self.observer.finish();
        picture.has_accelerations = self.has_accelerations;
        picture.distances = self.distances;
        let refused = |reason: &dyn Display| file::refused(&self.path, "picture", reason);
        self.file.write_all(picture.to_svg().as_bytes()).map_err(|error| refused(&error))?;
        self.file.commit().map_err(|reason| refused(&reason))
    }
}

fn sample(t: f64, proximity: Option<Proximity>) -> DistanceSample {
    let Some(Proximity { names: [a, b], distance, clearance }) = proximity else {
        return DistanceSample { t, ..DistanceSample::default() };
    };
    DistanceSample { t, distance: Some(distance), clearance, pair: format!("{a} - {b}") }
}
