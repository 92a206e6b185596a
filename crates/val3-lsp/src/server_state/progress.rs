//! Progress report of the first scan.

use tower_lsp::lsp_types::request::WorkDoneProgressCreate;
use tower_lsp::lsp_types::{ProgressToken, WorkDoneProgressCreateParams};

use super::ServerState;
use crate::progress::{ScanProgress, WorkProgress};

const SCAN: &str = "val3/scan";
const PULL: &str = "val3/pull";

impl ServerState {
    /// Requests progress reports for the first scan and for the first pull.
    pub(super) fn ask_for_progress(&mut self) {
        self.progress = ScanProgress::Over;
        if !self.session.client.shows_progress {
            return;
        }
        self.progress = ScanProgress::Asked;
        self.create_progress(SCAN, |server, token| match (&server.progress, token) {
            (ScanProgress::Asked, Some(token)) => {
                let shown = WorkProgress::begin(server.outbox.clone(), token, "reading the projects");
                server.progress = ScanProgress::Shown(shown);
            }
            _ => server.progress = ScanProgress::Over,
        });
        if self.session.is_asked_for_findings() {
            self.create_progress(PULL, |server, token| {
                if let Some(token) = token {
                    server.first_pull.agreed(token);
                }
            });
        }
    }

    fn create_progress(&mut self, name: &str, agreed: impl FnOnce(&mut Self, Option<ProgressToken>) + Send + 'static) {
        let token = ProgressToken::String(name.to_owned());
        let params = WorkDoneProgressCreateParams { token: token.clone() };
        self.ask_client::<WorkDoneProgressCreate>(params, |server, answer| agreed(server, answer.map(|()| token)));
    }

    /// Whether the client has not yet responded to the progress request of the first scan.
    pub(super) fn awaits_progress(&self) -> bool {
        matches!(self.progress, ScanProgress::Asked)
    }

    /// Ends the progress report, or stops waiting for the client's response.
    pub(super) fn end_progress(&mut self) {
        self.progress = ScanProgress::Over;
    }

    /// Reports the number of checked projects.
    pub(super) fn report_progress(&self) {
        if let ScanProgress::Shown(shown) = &self.progress {
            let all = self.projects().len();
            shown.checked(all.saturating_sub(self.checks.left()), all);
        }
    }
}
