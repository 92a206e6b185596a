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

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::test_client::{CALLER, EMPTY, TestClient, source};

    #[test]
    fn the_files_of_all_programs_are_returned() {
        let mut client = TestClient::stopped(CALLER);
        let expected = json!({ "sources": [source("start"), source("work")] });
        assert_eq!(client.body("loadedSources", json!({})), expected);
    }

    #[test]
    fn arguments_are_optional() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.body("loadedSources", Value::Null), json!({ "sources": [source("start")] }));
    }

    #[test]
    fn files_are_uris_for_a_client_with_uris() {
        let mut client = TestClient::stopped(EMPTY).counting_from_0();
        let uri = "file:///cell/usr/usrapp/main/start.pgx";
        let expected = json!({ "sources": [{ "name": "start.pgx", "path": uri }] });
        assert_eq!(client.body("loadedSources", json!({})), expected);
    }
}
