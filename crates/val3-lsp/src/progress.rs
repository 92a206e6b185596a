//! Work whose progress the client shows.

use std::cell::Cell;
use std::sync::{Arc, Mutex, PoisonError};

use tower_lsp::lsp_types::notification::Progress as Notification;
use tower_lsp::lsp_types::{
    ProgressParams, ProgressParamsValue, ProgressToken, WorkDoneProgress, WorkDoneProgressBegin, WorkDoneProgressEnd,
    WorkDoneProgressReport,
};

use crate::outbox::Outbox;

/// Work that the client shows until this is dropped.
pub(crate) struct Progress {
    outbox: Outbox,
    token: ProgressToken,
    percentage: Cell<u32>,
}

impl Progress {
    /// The work begins. The client has made the token or agreed to it.
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

    /// Another project is checked. Steps below one per cent are not worth a message.
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

impl Drop for Progress {
    fn drop(&mut self) {
        self.tell(WorkDoneProgress::End(WorkDoneProgressEnd { message: None }));
    }
}

/// The progress of the first scan: the files are read, and checked unless the client asks for findings.
#[derive(Default)]
pub(crate) enum ScanProgress {
    /// Not begun.
    #[default]
    Before,
    /// The client was asked whether it shows it.
    Asked,
    /// The client shows it.
    Shown(Progress),
    /// It is over, or the client does not show it.
    Over,
}

/// A token that the client agreed to, for the first time that it asks for the findings of the workspace. They come at
/// once later.
#[derive(Clone, Default)]
pub(crate) struct FirstPull(Arc<Mutex<Option<ProgressToken>>>);

impl FirstPull {
    /// The client agreed to the token.
    pub(crate) fn agreed(&self, token: ProgressToken) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(token);
    }

    /// Takes the token.
    pub(crate) fn take(&self) -> Option<ProgressToken> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}
