//! `val3/userPage`: the shown user page of the pendant.

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::request::{DebugRequest, NoArguments};
use crate::session::DebugSession;
use crate::user_page::ShownUserPage;

/// The request `val3/userPage`.
pub(crate) enum UserPageRequest {}

impl DebugRequest for UserPageRequest {
    const COMMAND: &'static str = "val3/userPage";
    type Arguments = NoArguments;
    type Body = ShownUserPage;

    fn answer(
        _: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        _: NoArguments,
    ) -> Result<ShownUserPage, RequestFailure> {
        Ok(ShownUserPage::new(&run.debugger.controller))
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{EMPTY, TestClient};

    #[test]
    fn a_page_has_fourteen_lines() {
        let mut client = TestClient::stopped(EMPTY);
        assert_eq!(client.body("val3/userPage", json!({}))["lines"].as_array().unwrap().len(), 14);
    }
}
