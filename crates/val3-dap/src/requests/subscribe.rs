//! `val3/subscribe`: selects the events `val3/…` that are sent. Omitted properties are unchanged.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::live::SubscribeArguments;
use crate::requests::{DebugRequest, Empty};
use crate::session::DebugSession;

/// The request `val3/subscribe`.
pub(crate) enum Subscribe {}

impl DebugRequest for Subscribe {
    const COMMAND: &'static str = "val3/subscribe";
    type Arguments = SubscribeArguments;
    type Body = Empty;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: SubscribeArguments,
    ) -> Result<Empty, RequestFailure> {
        session.subscriptions.subscribe(&arguments, &run.debugger.controller)?;
        Ok(Empty {})
    }
}
