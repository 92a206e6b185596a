//! Debug control of a run: by no debugger, by the client that has launched it, or by clients that attach to it.

use std::time::Duration;

use val3_dap::{AttachServer, DebugSession, DebuggedRun, NextAction};

/// Polling interval for signals while only a client can continue the run.
pub(super) const ATTENTION: Duration = Duration::from_millis(100);

/// Debug control of a run, polled by its main loop between two cycles.
pub(super) trait Guide {
    /// Handles the requests that have arrived.
    fn attend(&mut self, target: &mut DebuggedRun<'_>) -> NextAction;

    /// Session of the client to which events are reported, if any.
    fn session(&mut self) -> Option<&mut DebugSession>;

    /// Waits for this time or until a request arrives.
    fn wait(&mut self, time: Duration);
}

/// Control without stops.
pub(super) struct NoDebugger;

impl Guide for NoDebugger {
    fn attend(&mut self, _target: &mut DebuggedRun<'_>) -> NextAction {
        NextAction::Run
    }

    fn session(&mut self) -> Option<&mut DebugSession> {
        None
    }

    fn wait(&mut self, time: Duration) {
        std::thread::sleep(time);
    }
}

impl Guide for DebugSession {
    fn attend(&mut self, target: &mut DebuggedRun<'_>) -> NextAction {
        self.attend(target)
    }

    fn session(&mut self) -> Option<&mut DebugSession> {
        Some(self)
    }

    fn wait(&mut self, time: Duration) {
        self.wait(time);
    }
}

impl Guide for AttachServer {
    fn attend(&mut self, target: &mut DebuggedRun<'_>) -> NextAction {
        self.attend(target)
    }

    fn session(&mut self) -> Option<&mut DebugSession> {
        self.session()
    }

    fn wait(&mut self, time: Duration) {
        self.wait(time);
    }
}
