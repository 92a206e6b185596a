//! `variables`: contents of a scope or a value.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{VariablesArguments, VariablesResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `variables`.
pub(crate) enum Variables {}

impl DebugRequest for Variables {
    const COMMAND: &'static str = "variables";
    type Arguments = VariablesArguments;
    type Body = VariablesResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: VariablesArguments,
    ) -> Result<VariablesResponse, RequestFailure> {
        let format = session.format(arguments.format.as_ref());
        let variables = session.handles.variables(&arguments, &mut run.debugger.controller, format);
        Ok(VariablesResponse { variables: variables.ok_or(RequestFailure::Stale)? })
    }
}
