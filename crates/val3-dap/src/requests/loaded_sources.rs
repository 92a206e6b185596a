//! `loadedSources`: files of the loaded application and its libraries.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{LoadedSourcesArguments, LoadedSourcesResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `loadedSources`.
pub(crate) enum LoadedSources {}

impl DebugRequest for LoadedSources {
    const COMMAND: &'static str = "loadedSources";
    type Arguments = LoadedSourcesArguments;
    type Body = LoadedSourcesResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: LoadedSourcesArguments,
    ) -> Result<LoadedSourcesResponse, RequestFailure> {
        let images = run.debugger.controller.vm.space.loaded().map(|(_, instance)| &instance.image);
        let sources = images.flat_map(|image| &image.files).map(|file| session.conventions.source(file)).collect();
        Ok(LoadedSourcesResponse { sources })
    }
}
