//! Page that replays a run (`--export`): the page of `--serve` with the messages of the run embedded.

use std::io::{self, Write};

use base64::prelude::BASE64_STANDARD;
use base64::write::EncoderWriter;
use camino::{Utf8Path, Utf8PathBuf};
use flate2::Compression;
use flate2::write::GzEncoder;
use val3_files::OutputFile;
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::{EndReason, Event};
use val3_view::wire::Role;
use val3_view::{Feed, ViewerMessage};

use super::missing::program_text;
use crate::output::file;
use crate::output::file_kind::OutputFileKind;
use crate::serve::PAGE;
use crate::serve::frames::{FrameKind, write_frame};
use crate::user_error::UserError;

/// Element of the page after which the recording is inserted.
const BODY: &str = "<body>";

/// A page that is written during the run.
pub(super) struct Export {
    feed: Feed,
    path: Utf8PathBuf,
    out: ExportedRecording,
}

/// Messages as frames, compressed and encoded in base64.
type ExportedRecording = GzEncoder<EncoderWriter<'static, base64::engine::GeneralPurpose, io::BufWriter<OutputFile>>>;

impl Export {
    /// Creates the file, which replaces an existing file when it is complete.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(super) fn open(path: &Utf8Path, controller: &Controller) -> Result<Self, UserError> {
        let mut file = io::BufWriter::new(file::create(path, OutputFileKind::Html, "page")?);
        let (head, _) = halves();
        write!(file, "{head}<script id=\"recording\" type=\"text/plain\">").map_err(|error| refused(path, &error))?;
        let out = GzEncoder::new(EncoderWriter::new(file, &BASE64_STANDARD), Compression::best());
        let mut export =
            Self { feed: Feed::new(controller, Role::Recording, program_text), path: path.to_owned(), out };
        export.write()?;
        Ok(export)
    }

    /// Writes the messages of the cycle that began at `start`.
    pub(super) fn see(&mut self, start: Time, events: &[Event], controller: &Controller) -> Result<(), UserError> {
        self.feed.see(start, events, controller);
        self.write()
    }

    /// Writes the end of the run.
    pub(super) fn see_end(
        &mut self,
        events: &[Event],
        reason: EndReason,
        exit_code: u8,
        controller: &Controller,
    ) -> Result<(), UserError> {
        self.feed.see_events(events, controller);
        self.feed.end(reason, exit_code, controller);
        self.write()
    }

    /// Completes the file.
    pub(super) fn close(self) -> Result<(), UserError> {
        let file = completed(self.out).map_err(|error| refused(&self.path, &error))?;
        file.commit().map_err(|reason| file::refused(&self.path, "page", &reason))
    }

    fn write(&mut self) -> Result<(), UserError> {
        let messages = self.feed.take();
        let written = messages.iter().try_for_each(|message| packed(&mut self.out, message));
        written.map_err(|error| refused(&self.path, &error))
    }
}

fn packed(out: &mut ExportedRecording, message: &ViewerMessage) -> io::Result<()> {
    match message {
        ViewerMessage::Object(object) => write_frame(out, FrameKind::Object, object.to_string().as_bytes()),
        ViewerMessage::Samples(bytes) => write_frame(out, FrameKind::Samples, bytes),
    }
}

/// Parts of the page before and after the recording.
fn halves() -> (&'static str, &'static str) {
    let at = PAGE.find(BODY).map_or(0, |at| at + BODY.len());
    PAGE.split_at(at)
}

/// Writes the end of the recording and the rest of the page.
fn completed(recording: ExportedRecording) -> io::Result<OutputFile> {
    let (_, tail) = halves();
    let mut file = recording.finish()?.finish()?;
    write!(file, "</script>{tail}")?;
    Ok(file.into_inner()?)
}

fn refused(path: &Utf8Path, error: &io::Error) -> UserError {
    file::refused(path, "page", error)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_recording_is_the_first_element_of_the_body() {
        assert_eq!(PAGE.matches(BODY).count(), 1);
        assert!(halves().0.ends_with(BODY));
    }
}
