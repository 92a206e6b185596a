//! Shows the progress of the first check.

use tower_lsp::lsp_types::notification::Progress;
use tower_lsp::lsp_types::request::WorkDoneProgressCreate;
use tower_lsp::lsp_types::{
    NumberOrString, ProgressParams, ProgressParamsValue, WorkDoneProgress, WorkDoneProgressBegin,
    WorkDoneProgressCreateParams, WorkDoneProgressEnd, WorkDoneProgressReport,
};

use super::ServerState;
use crate::scan_progress::ScanProgress;

const TOKEN: &str = "val3/check";

impl ServerState {
    /// The first check begins.
    pub(super) fn begin_progress(&mut self) {
        if self.progress != ScanProgress::Before || self.projects().is_empty() {
            return;
        }
        if !self.session.client.shows_progress {
            self.progress = ScanProgress::Over;
            return;
        }
        self.progress = ScanProgress::Asked;
        let params = WorkDoneProgressCreateParams { token: token() };
        self.ask_client::<WorkDoneProgressCreate>(params, |server, agreed| {
            if agreed.is_some() && server.progress == ScanProgress::Asked {
                server.progress = ScanProgress::Shown;
                let begin = WorkDoneProgressBegin {
                    title: "Checking VAL 3".to_owned(),
                    percentage: Some(0),
                    ..Default::default()
                };
                server.tell(WorkDoneProgress::Begin(begin));
            }
        });
    }

    /// Another part of it is done.
    pub(super) fn report_progress(&self) {
        let all = self.projects().len();
        let done = all.saturating_sub(self.checks.left());
        if self.progress == ScanProgress::Shown {
            self.tell(WorkDoneProgress::Report(WorkDoneProgressReport {
                message: Some(format!("{done} of {all} projects")),
                percentage: u32::try_from(100 * done / all.max(1)).ok(),
                cancellable: None,
            }));
        }
    }

    /// It is over.
    pub(super) fn end_progress(&mut self) {
        if self.progress == ScanProgress::Shown {
            self.tell(WorkDoneProgress::End(WorkDoneProgressEnd { message: None }));
        }
        if self.progress != ScanProgress::Before {
            self.progress = ScanProgress::Over;
        }
    }

    fn tell(&self, progress: WorkDoneProgress) {
        self.outbox
            .notify::<Progress>(ProgressParams { token: token(), value: ProgressParamsValue::WorkDone(progress) });
    }
}

fn token() -> NumberOrString {
    NumberOrString::String(TOKEN.to_owned())
}
