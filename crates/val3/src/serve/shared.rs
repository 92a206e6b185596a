//! State shared by the connections of a server.

use std::sync::mpsc::SyncSender;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::{Semaphore, watch};

use super::access::Access;
use super::command::PendingCommand;
use super::limits::ServerLimits;
use super::log::MessageLog;
use super::page::ServedPage;

/// State shared by the connections of a server.
pub(super) struct Shared {
    pub(super) access: Access,
    pub(super) page: ServedPage,
    pub(super) limits: ServerLimits,
    pub(super) log: Arc<SharedLog>,
    /// Channel to the run loop.
    pub(super) commands: SyncSender<PendingCommand>,
    /// One permit per viewer.
    pub(super) places: Arc<Semaphore>,
    /// Whether the server ends.
    pub(super) is_over: watch::Receiver<bool>,
}

/// Log that the run extends and viewers read.
pub(super) struct SharedLog {
    log: Mutex<MessageLog>,
    /// Notification that the log has grown.
    news: watch::Sender<()>,
}

impl SharedLog {
    pub(super) fn new(log: MessageLog) -> Self {
        Self { log: Mutex::new(log), news: watch::Sender::new(()) }
    }

    /// Locks the log. The lock must be short.
    pub(super) fn lock(&self) -> MutexGuard<'_, MessageLog> {
        self.log.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Wakes the viewers that have read all messages.
    pub(super) fn announce(&self) {
        self.news.send_replace(());
    }

    /// Subscribes to notifications from now on.
    pub(super) fn subscribe(&self) -> watch::Receiver<()> {
        self.news.subscribe()
    }
}
