//! Definition of a session's request: command, arguments, body and execution.

use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::session::DebugSession;

/// A request of the specification or of this adapter.
pub(crate) trait DebugRequest {
    /// Value of `command` in the message.
    const COMMAND: &'static str;
    /// Type of the arguments.
    type Arguments: DeserializeOwned;
    /// Body of the response; `()` if the response has none.
    type Body: Serialize;

    /// Executes the request.
    ///
    /// # Errors
    /// The arguments do not suit the state of the run, or the run rejects the change.
    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: Self::Arguments,
    ) -> Result<Self::Body, RequestFailure>;

    /// Returns the body in a run that is not debugged (`noDebug`); `None` if [`answer`](Self::answer) computes it.
    fn in_plain_run(_: &Self::Arguments) -> Option<Self::Body> {
        None
    }
}

/// Arguments of a request that has none.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct NoArguments {}

/// Arguments of a request about a task.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct ThreadArguments {
    /// Thread of the task.
    pub(crate) thread_id: i32,
}

/// Body without properties.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
pub(crate) struct Empty {}
