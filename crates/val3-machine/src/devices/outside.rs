//! Media and libraries: what the devices reach outside the controller, apart from lines.

use std::sync::Arc;

use val3_bytecode::Image;

use crate::files::{ControllerPath, LibraryFiles, OpenFiles, Roots};
use crate::inputs::Inputs;

/// Finds and compiles libraries: the way from the run time to the analysis.
pub trait Libraries {
    /// The image of the library with these files.
    ///
    /// # Errors
    /// A fault of its data or programs, as a line of the event log (code 12 of `libLoad`).
    fn image(&mut self, path: &ControllerPath, files: LibraryFiles) -> Result<Arc<Image>, String>;
}

/// The media and libraries outside. Every answer of theirs passes through the recorder of inputs.
pub(super) struct Outside {
    media: Media,
    inputs: Inputs,
}

/// The media and libraries outside.
pub(super) struct Media {
    /// The media that paths name.
    pub(super) roots: Roots,
    /// The files that programs have open.
    pub(super) files: OpenFiles,
    /// Finds and compiles libraries.
    pub(super) libraries: Box<dyn Libraries>,
}

impl Outside {
    pub(super) fn new(roots: Roots, libraries: Box<dyn Libraries>, inputs: Inputs) -> Self {
        Self { media: Media { roots, files: OpenFiles::default(), libraries }, inputs }
    }

    /// Reads or changes something outside, unless the recording has the answer.
    pub(super) fn ask<T: Clone + 'static>(&mut self, question: impl FnOnce(&mut Media) -> T) -> T {
        let Self { media, inputs } = self;
        inputs.ask(|| question(media))
    }
}
