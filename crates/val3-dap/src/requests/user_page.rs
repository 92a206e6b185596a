//! `val3/userPage`: the shown user page of the pendant.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::requests::{DebugRequest, NoArguments};
use crate::session::DebugSession;
use crate::user_page::UserPage;

/// The request `val3/userPage`.
pub(crate) enum UserPageRequest {}

impl DebugRequest for UserPageRequest {
    const COMMAND: &'static str = "val3/userPage";
    type Arguments = NoArguments;
    type Body = UserPage;

    fn answer(_: &mut DebugSession, run: &mut DebuggedRun<'_>, _: NoArguments) -> Result<UserPage, RequestFailure> {
        Ok(UserPage::new(&run.debugger.controller))
    }
}
