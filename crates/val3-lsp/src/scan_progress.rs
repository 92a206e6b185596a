//! How far the first check has come.

use tower_lsp::lsp_types::notification::Progress;
use tower_lsp::lsp_types::request::WorkDoneProgressCreate;
use tower_lsp::lsp_types::{
    NumberOrString, ProgressParams, ProgressParamsValue, WorkDoneProgress, WorkDoneProgressBegin,
    WorkDoneProgressCreateParams, WorkDoneProgressEnd, WorkDoneProgressReport,
};

use crate::server_state::ServerState;

const TOKEN: &str = "val3/check";

/// The progress of the first check.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum ScanProgress {
    /// Not begun.
    #[default]
    Before,
    /// The client was asked whether it shows it.
    Asked,
    /// The client shows it.
    Shown,
    /// It is over, or the client does not show it.
    Over,
}

impl ServerState {
    /// The first check begins.
    pub(crate) fn begin_progress(&mut self) {
        if self.progress != ScanProgress::Before || self.projects().is_empty() {
            return;
        }
        if !self.session.client.shows_progress {
            self.progress = ScanProgress::Over;
            return;
        }
        self.progress = ScanProgress::Asked;
        let params = WorkDoneProgressCreateParams { token: token() };
        self.outbox.ask::<WorkDoneProgressCreate>(params, |server, agreed| {
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
    pub(crate) fn report_progress(&self) {
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
    pub(crate) fn end_progress(&mut self) {
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
