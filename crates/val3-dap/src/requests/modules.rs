//! `modules`: the loaded application and its libraries, page by page.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::notices::module;
use crate::protocol::{ModulesArguments, ModulesResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `modules`.
pub(crate) enum Modules {}

impl DebugRequest for Modules {
    const COMMAND: &'static str = "modules";
    type Arguments = ModulesArguments;
    type Body = ModulesResponse;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: ModulesArguments,
    ) -> Result<ModulesResponse, RequestFailure> {
        let images = run.debugger.controller.vm.space.loaded().map(|(_, instance)| &instance.image);
        let all: Vec<_> = images.map(|image| module(&image.name, &image.path)).collect();
        let start = arguments.start_module.and_then(|start| usize::try_from(start).ok()).unwrap_or_default();
        let most = arguments.module_count.filter(|count| *count > 0).map_or(usize::MAX, |count| count as usize);
        let total_modules = u64::try_from(all.len()).ok();
        Ok(ModulesResponse { modules: all.into_iter().skip(start).take(most).collect(), total_modules })
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, MODULE, TestClient};

    #[test]
    fn the_application_is_a_module() {
        let mut client = TestClient::stopped(EMPTY);
        let module = json!({ "id": MODULE, "name": "main", "path": MODULE, "isUserCode": true });
        assert_eq!(client.body("modules", json!({})), json!({ "modules": [module], "totalModules": 1 }));
    }

    #[test]
    fn a_count_of_0_means_all_modules() {
        let mut client = TestClient::stopped(EMPTY);
        let body = client.body("modules", json!({ "moduleCount": 0 }));
        assert_eq!(body["modules"][0]["name"], "main");
    }

    #[test]
    fn a_page_after_the_last_module_is_empty() {
        let mut client = TestClient::stopped(EMPTY);
        let body = client.body("modules", json!({ "startModule": 1 }));
        assert_eq!(body, json!({ "modules": [], "totalModules": 1 }));
    }

    #[test]
    fn a_start_is_a_number() {
        let mut client = TestClient::stopped(EMPTY);
        let reason = client.failure("modules", json!({ "startModule": "main" }));
        assert_eq!(reason, "the arguments of `modules` are wrong: invalid type: string \"main\", expected i32");
    }
}
