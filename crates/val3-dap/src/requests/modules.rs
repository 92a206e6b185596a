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
