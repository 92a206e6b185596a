//! `configurationDone`: the client has set its breakpoints.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::ConfigurationDoneArguments;
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `configurationDone`.
pub(crate) enum ConfigurationDone {}

impl DebugRequest for ConfigurationDone {
    const COMMAND: &'static str = "configurationDone";
    type Arguments = ConfigurationDoneArguments;
    type Body = ();

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: ConfigurationDoneArguments,
    ) -> Result<(), RequestFailure> {
        session.finish_configuration(run);
        Ok(())
    }
}
