//! `cancel`: a request that is still in progress when `cancel` is handled does not exist.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::CancelArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `cancel`.
pub(crate) enum Cancel {}

impl DebugRequest for Cancel {
    const COMMAND: &'static str = "cancel";
    type Arguments = CancelArguments;
    type Body = ();

    fn answer(_: &mut DebugSession, _: &mut DebuggedRun<'_>, _: CancelArguments) -> Result<(), RequestFailure> {
        Ok(())
    }
}
