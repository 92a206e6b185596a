//! Progress reports shown by the client.

use std::cell::Cell;
use std::sync::{Arc, Mutex, PoisonError};

use tower_lsp::lsp_types::notification::Progress as Notification;
use tower_lsp::lsp_types::{
    ProgressParams, ProgressParamsValue, ProgressToken, WorkDoneProgress, WorkDoneProgressBegin, WorkDoneProgressEnd,
    WorkDoneProgressReport,
};

use crate::outbox::Outbox;

/// Progress report that the client shows until it is dropped.
pub(crate) struct WorkProgress {
    outbox: Outbox,
    token: ProgressToken,
    percentage: Cell<u32>,
}

impl WorkProgress {
    /// Begins a progress report. The client has created or accepted the token.
    pub(crate) fn begin(outbox: Outbox, token: ProgressToken, message: &str) -> Self {
        let progress = Self { outbox, token, percentage: Cell::new(0) };
        progress.tell(WorkDoneProgress::Begin(WorkDoneProgressBegin {
            title: "VAL 3".to_owned(),
            message: Some(message.to_owned()),
            percentage: Some(0),
            ..WorkDoneProgressBegin::default()
        }));
        progress
    }

    /// Reports the number of checked projects. Changes below one per cent are not sent.
    pub(crate) fn checked(&self, done: usize, all: usize) {
        let percentage = u32::try_from(100 * done / all.max(1)).unwrap_or(100);
        if self.percentage.replace(percentage) != percentage {
            self.tell(WorkDoneProgress::Report(WorkDoneProgressReport {
                message: Some(format!("checked {done} of {all} projects")),
                percentage: Some(percentage),
                cancellable: None,
            }));
        }
    }

    fn tell(&self, progress: WorkDoneProgress) {
        let value = ProgressParamsValue::WorkDone(progress);
        self.outbox.notify::<Notification>(ProgressParams { token: self.token.clone(), value });
    }
}

impl Drop for WorkProgress {
    fn drop(&mut self) {
        self.tell(WorkDoneProgress::End(WorkDoneProgressEnd { message: None }));
    }
}

/// Progress of the first scan: files are read, and also checked if the server pushes findings.
#[derive(Default)]
pub(crate) enum ScanProgress {
    /// Not begun.
    #[default]
    Before,
    /// The client was requested to create the token.
    Asked,
    /// The client shows the progress.
    Shown(WorkProgress),
    /// Complete, or not supported by the client.
    Over,
}

/// Token accepted by the client, for its first pull of workspace findings. Later pulls are fast and need no progress
/// report.
#[derive(Clone, Default)]
pub(crate) struct FirstPull(Arc<Mutex<Option<ProgressToken>>>);

impl FirstPull {
    /// Stores the accepted token.
    pub(crate) fn agreed(&self, token: ProgressToken) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(token);
    }

    /// Removes and returns the token.
    pub(crate) fn take(&self) -> Option<ProgressToken> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}
