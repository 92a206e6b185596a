//! Clients that attach to a run and detach from it, one at a time.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use crate::client::Client;
use crate::debugged_run::DebuggedRun;
use crate::handshake::{Handshake, HandshakeResult};
use crate::secret::Secret;
use crate::session::{DebugSession, NextAction, RunState};
use crate::session_start::SessionStart;

/// Accepts the clients of a run. The run continues while no client is attached.
#[derive(Debug)]
pub struct AttachServer {
    /// Sender of connected clients, so that the channel stays open.
    clients: Sender<Client>,
    arrivals: Receiver<Client>,
    /// Clients that have not attached yet.
    handshakes: Vec<Handshake>,
    session: Option<DebugSession>,
    /// State of the run when the next client attaches.
    run: RunState,
    /// Secret that each client has to send.
    secret: Secret,
}

impl AttachServer {
    /// Serves a run in this state. A `Fresh` run waits for the first client.
    #[must_use]
    pub fn new(run: RunState, secret: Secret) -> Self {
        let (clients, arrivals) = channel();
        Self { clients, arrivals, handshakes: Vec::new(), session: None, run, secret }
    }

    /// Sender for connected clients.
    #[must_use]
    pub fn clients(&self) -> Sender<Client> {
        self.clients.clone()
    }

    /// Handles the messages that have arrived.
    pub fn attend(&mut self, run: &mut DebuggedRun<'_>) -> NextAction {
        let action = self.session.as_mut().map(|session| session.attend(run));
        if let Some(NextAction::Detach { is_suspended }) = action {
            run.debugger.detach();
            self.session = None;
            self.run = if is_suspended { RunState::Suspended } else { RunState::Running };
        }
        self.receive(run);
        match action {
            Some(action @ (NextAction::Run | NextAction::Wait | NextAction::Restart | NextAction::End)) => action,
            _ if self.run == RunState::Running => NextAction::Run,
            _ => NextAction::Wait,
        }
    }

    /// Continues the handshakes of clients that have not attached yet.
    fn receive(&mut self, run: &mut DebuggedRun<'_>) {
        let secret = &self.secret;
        self.handshakes.extend(self.arrivals.try_iter().map(|client| Handshake::through_port(client, secret.clone())));
        for mut handshake in std::mem::take(&mut self.handshakes) {
            match handshake.attend() {
                HandshakeResult::None => self.handshakes.push(handshake),
                HandshakeResult::Disconnected => {}
                HandshakeResult::Launch(start) => {
                    handshake.refuse(&start, "this port belongs to a run: use `attach`");
                    self.handshakes.push(handshake);
                }
                HandshakeResult::Attach(start) => self.attach(handshake, &start, run),
            }
        }
    }

    fn attach(&mut self, mut handshake: Handshake, start: &SessionStart, run: &mut DebuggedRun<'_>) {
        if self.session.is_some() {
            handshake.refuse(start, "another client debugs this run");
            self.handshakes.push(handshake);
            return;
        }
        start.settings.apply(run.debugger);
        self.session = Some(handshake.accept(start, self.run));
    }

    /// Returns the session of the attached client.
    pub fn session(&mut self) -> Option<&mut DebugSession> {
        self.session.as_mut()
    }

    /// Disconnects the client at the end of a run. The next run does not wait for a client.
    pub fn end_session(&mut self) {
        (self.session, self.run) = (None, RunState::Running);
    }

    /// Waits for a message, at most for this time.
    pub fn wait(&mut self, time: Duration) {
        if let Some(session) = &mut self.session {
            session.wait(time);
        } else if let Some(handshake) = self.handshakes.first_mut() {
            handshake.wait(time);
        } else if let Ok(client) = self.arrivals.recv_timeout(time) {
            self.handshakes.push(Handshake::through_port(client, self.secret.clone()));
        }
    }
}
