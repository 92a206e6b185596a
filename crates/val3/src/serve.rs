//! `--serve`: server that shows successive runs in browsers, in a separate thread.
//!
//! The run loop appends messages to a log and polls commands, and never waits for the server. Each viewer has a cursor
//! in the log, so a viewer that does not read costs nothing.

mod access;
pub(crate) mod address;
mod block;
pub(crate) mod browser;
mod command;
mod connections;
pub(crate) mod frames;
mod limits;
mod log;
mod page;
pub(crate) mod quota;
mod shared;
#[cfg(test)]
mod tests {
    //! Attacks on a server, and viewers that receive the same messages.

    mod attacks;
    mod client;
    mod viewers;
}
mod viewer;

use std::io;
use std::net::{SocketAddr, TcpListener};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread::JoinHandle;
use std::time::Duration;

use tokio::runtime;
use tokio::sync::{Semaphore, watch};

use crate::user_error::UserError;
use access::{Access, ViewerRole};
pub(crate) use address::{ServeAddress, socket_address};
pub(crate) use command::PendingCommand;
use limits::ServerLimits;
use log::MessageLog;
pub(crate) use log::StoredMessage;
pub(crate) use page::PAGE;
use page::ServedPage;
use shared::{Shared, SharedLog};

/// Maximum number of pending commands from all viewers.
const WAITING_COMMANDS: usize = 256;

/// Server for the viewers of a run. Dropping the value ends the server.
pub(crate) struct Server {
    /// Page addresses for operators and guests.
    pages: [String; 2],
    log: Arc<SharedLog>,
    commands: Receiver<PendingCommand>,
    is_over: watch::Sender<bool>,
    thread: Option<JoinHandle<io::Result<()>>>,
}

impl Server {
    /// Starts a server that listens on an address.
    ///
    /// # Errors
    /// The address is in use, or a system resource for the server is not available.
    pub(crate) fn start(address: ServeAddress) -> Result<Self, UserError> {
        Self::with_limits(address, ServerLimits::default())
    }

    fn with_limits(address: ServeAddress, limits: ServerLimits) -> Result<Self, UserError> {
        let listener = address.listen()?;
        let address = own_address(&listener).map_err(|error| failed(&error))?;
        let access = Access::new(address)?;
        let reached = address::reachable(address);
        let pages =
            [ViewerRole::Operator, ViewerRole::Guest].map(|role| format!("http://{reached}/{}/", access.secret(role)));
        let (sender, commands) = sync_channel(WAITING_COMMANDS);
        let (is_over, watched) = watch::channel(false);
        let log = Arc::new(SharedLog::new(MessageLog::new(limits.log_bytes)));
        let places = Arc::new(Semaphore::new(limits.viewers));
        let shared = Shared {
            access,
            page: ServedPage::new(),
            limits,
            log: Arc::clone(&log),
            commands: sender,
            places,
            is_over: watched,
        };
        let runtime = runtime::Builder::new_current_thread().enable_all().build().map_err(|error| failed(&error))?;
        let thread = std::thread::spawn(move || runtime.block_on(connections::accept(listener, Arc::new(shared))));
        Ok(Self { pages, log, commands, is_over, thread: Some(thread) })
    }

    /// Page address for operators.
    pub(crate) fn operator_page(&self) -> &str {
        let [operator, _] = &self.pages;
        operator
    }

    /// Page address for guests, who cannot operate the run.
    pub(crate) fn guest_page(&self) -> &str {
        let [_, guest] = &self.pages;
        guest
    }

    /// Begins a new run: viewers receive no more messages of the previous run.
    pub(crate) fn begin_run(&self) {
        self.log.lock().begin_run();
    }

    /// Begins a part of the run at a time in seconds with the complete state. Viewers that have received all messages up
    /// to now do not receive this state.
    pub(crate) fn begin_part(&self, start: f64, state: Vec<StoredMessage>) {
        self.log.lock().begin_part(start, state);
    }

    /// Adds messages to the log.
    pub(crate) fn publish(&self, messages: impl IntoIterator<Item = StoredMessage>) {
        let mut log = self.log.lock();
        let before = log.end();
        messages.into_iter().for_each(|message| log.append(message));
        let has_grown = log.end() > before;
        drop(log);
        if has_grown {
            self.log.announce();
        }
    }

    /// Size of the messages in the log, in bytes.
    #[cfg(test)]
    fn log_bytes(&self) -> usize {
        self.log.lock().bytes()
    }

    /// Removes and returns the next command; `None` if no command is pending.
    pub(crate) fn next_command(&self) -> Option<PendingCommand> {
        self.commands.try_recv().ok()
    }

    /// Waits for the next command, at most for this time.
    pub(crate) fn wait_for_command(&self, time: Duration) -> Option<PendingCommand> {
        self.commands.recv_timeout(time).ok()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.is_over.send_replace(true);
        // The thread may have ended already with a system error.
        self.thread.take().map(JoinHandle::join);
    }
}

fn own_address(listener: &TcpListener) -> io::Result<SocketAddr> {
    listener.set_nonblocking(true)?;
    listener.local_addr()
}

fn failed(error: &io::Error) -> UserError {
    UserError::new(format!("cannot serve: {error}"))
}
