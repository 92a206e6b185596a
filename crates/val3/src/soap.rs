//! `--controller`: server for clients of a controller's SOAP interface, in a separate thread.
//!
//! Connections read requests, and the run loop answers them between cycles. Neither the size of a message nor the speed
//! of a client affects the run.

mod address;
mod connections;
mod limits;
#[cfg(test)]
mod tests;

use std::io;
use std::net::SocketAddr;
use std::sync::mpsc::{Receiver, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use tokio::runtime;
use tokio::sync::{oneshot, watch};
use val3_service::{ServiceAnswer, ServiceCall};

use crate::serve::address::reachable;
use crate::serve::quota::Quota;
use crate::user_error::UserError;
pub(crate) use address::SoapAddress;
use connections::SoapShared;
use limits::SoapLimits;

/// Server for clients of the SOAP interface. Dropping the value ends the server.
pub(crate) struct SoapPort {
    address: SocketAddr,
    calls: Receiver<PendingCall>,
    is_over: watch::Sender<bool>,
    thread: Option<JoinHandle<io::Result<()>>>,
}

/// Request that waits for the run loop.
#[derive(Debug)]
pub(crate) struct PendingCall {
    /// Request.
    pub(crate) call: ServiceCall,
    answer: oneshot::Sender<ServiceAnswer>,
    /// Time from which the client has the answer that the run is busy.
    end: Instant,
}

impl PendingCall {
    /// Sends the answer to the client, which may have disconnected.
    pub(crate) fn answer(self, answer: ServiceAnswer) {
        let _ = self.answer.send(answer);
    }

    /// Returns the request if the client still waits for the answer. A client repeats a request that was rejected, so
    /// it must not be executed later.
    fn expected(self) -> Option<Self> {
        (Instant::now() < self.end).then_some(self)
    }
}

impl SoapPort {
    /// Starts a server that listens on an address.
    ///
    /// # Errors
    /// The address is in use, or a system resource for the server is not available.
    pub(crate) fn start(address: SoapAddress) -> Result<Self, UserError> {
        Self::with_limits(address, SoapLimits::default())
    }

    fn with_limits(address: SoapAddress, limits: SoapLimits) -> Result<Self, UserError> {
        let listener = address.listen()?;
        let failed = |error: &io::Error| UserError::new(format!("cannot serve clients of the controller: {error}"));
        let address = listener.set_nonblocking(true).and_then(|()| listener.local_addr());
        let address = address.map_err(|error| failed(&error))?;
        let (sender, calls) = sync_channel(limits.waiting_calls);
        let (is_over, watched) = watch::channel(false);
        let quota = Mutex::new(Quota::new(limits.calls, Instant::now()));
        let shared = Arc::new(SoapShared { calls: sender, limits, quota });
        let runtime = runtime::Builder::new_current_thread().enable_all().build().map_err(|error| failed(&error))?;
        let thread = std::thread::spawn(move || runtime.block_on(connections::accept(listener, shared, watched)));
        Ok(Self { address, calls, is_over, thread: Some(thread) })
    }

    /// Address at which clients of this machine reach the server.
    pub(crate) fn address(&self) -> SocketAddr {
        reachable(self.address)
    }

    /// Whether only this machine reaches the server.
    pub(crate) fn is_local(&self) -> bool {
        self.address.ip().is_loopback()
    }

    /// Removes and returns the next request; `None` if no request is pending.
    pub(crate) fn next_call(&self) -> Option<PendingCall> {
        self.calls.try_iter().find_map(PendingCall::expected)
    }

    /// Waits for the next request, at most for this time.
    pub(crate) fn wait_for_call(&self, time: Duration) -> Option<PendingCall> {
        let end = Instant::now() + time;
        loop {
            let call = self.calls.recv_timeout(end.saturating_duration_since(Instant::now())).ok()?;
            if let Some(call) = call.expected() {
                return Some(call);
            }
        }
    }
}

impl Drop for SoapPort {
    fn drop(&mut self) {
        self.is_over.send_replace(true);
        // The thread may have ended already with a system error.
        self.thread.take().map(JoinHandle::join);
    }
}
