//! The parts of a server that its connections share.

use std::sync::mpsc::SyncSender;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::{Semaphore, watch};

use super::access::Access;
use super::command::PendingCommand;
use super::limits::ServerLimits;
use super::log::MessageLog;
use super::page::ServedPage;

/// The parts of a server that its connections share.
pub(super) struct Shared {
    pub(super) access: Access,
    pub(super) page: ServedPage,
    pub(super) limits: ServerLimits,
    pub(super) log: Arc<SharedLog>,
    /// The way to the loop of the run.
    pub(super) commands: SyncSender<PendingCommand>,
    /// A place for each viewer.
    pub(super) places: Arc<Semaphore>,
    /// True when the server ends.
    pub(super) is_over: watch::Receiver<bool>,
}

/// The log of a run, which the run extends and viewers read.
pub(super) struct SharedLog {
    log: Mutex<MessageLog>,
    /// Announces that the log has grown.
    news: watch::Sender<()>,
}

impl SharedLog {
    pub(super) fn new(log: MessageLog) -> Self {
        Self { log: Mutex::new(log), news: watch::Sender::new(()) }
    }

    /// The log, for a short time.
    pub(super) fn lock(&self) -> MutexGuard<'_, MessageLog> {
        self.log.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Wakes the viewers that have read everything.
    pub(super) fn announce(&self) {
        self.news.send_replace(());
    }

    /// Announcements from now on.
    pub(super) fn subscribe(&self) -> watch::Receiver<()> {
        self.news.subscribe()
    }
}
