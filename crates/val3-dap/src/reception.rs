//! Clients that attach to a run and leave it again, one at a time.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use crate::client::Client;
use crate::debugged_run::DebuggedRun;
use crate::greeting::{Greeting, Wish};
use crate::secret::Secret;
use crate::session::{DebugSession, Demand, RunState};
use crate::session_start::SessionStart;

/// Accepts the clients of a run. Without a client the run continues.
#[derive(Debug)]
pub struct Reception {
    /// The way in, which stays open.
    entrance: Sender<Client>,
    arrivals: Receiver<Client>,
    /// Clients that have not attached yet.
    arriving: Vec<Greeting>,
    session: Option<DebugSession>,
    /// The state of the run for the next client.
    run: RunState,
    /// Secret that each client has to send.
    secret: Secret,
}

impl Reception {
    /// A reception of a run in this state. A `Fresh` run waits for the first client.
    #[must_use]
    pub fn new(run: RunState, secret: Secret) -> Self {
        let (entrance, arrivals) = channel();
        Self { entrance, arrivals, arriving: Vec::new(), session: None, run, secret }
    }

    /// The way in for clients.
    #[must_use]
    pub fn entrance(&self) -> Sender<Client> {
        self.entrance.clone()
    }

    /// Handles the messages that have arrived.
    pub fn attend(&mut self, run: &mut DebuggedRun<'_>) -> Demand {
        let demand = self.session.as_mut().map(|session| session.attend(run));
        if let Some(Demand::Leave { is_suspended }) = demand {
            run.debugger.let_go();
            self.session = None;
            self.run = if is_suspended { RunState::Suspended } else { RunState::Running };
        }
        self.receive(run);
        match demand {
            Some(demand @ (Demand::Run | Demand::Wait | Demand::Restart | Demand::End)) => demand,
            _ if self.run == RunState::Running => Demand::Run,
            _ => Demand::Wait,
        }
    }

    /// Attends to clients that have not attached yet.
    fn receive(&mut self, run: &mut DebuggedRun<'_>) {
        let secret = &self.secret;
        self.arriving.extend(self.arrivals.try_iter().map(|client| Greeting::through_port(client, secret.clone())));
        for mut greeting in std::mem::take(&mut self.arriving) {
            match greeting.attend() {
                Wish::None => self.arriving.push(greeting),
                Wish::Left => {}
                Wish::Launch(start) => {
                    greeting.refuse(&start, "this port belongs to a run: use `attach`");
                    self.arriving.push(greeting);
                }
                Wish::Attach(start) => self.attach(greeting, &start, run),
            }
        }
    }

    fn attach(&mut self, mut greeting: Greeting, start: &SessionStart, run: &mut DebuggedRun<'_>) {
        if self.session.is_some() {
            greeting.refuse(start, "another client debugs this run");
            self.arriving.push(greeting);
            return;
        }
        start.settings.apply(run.debugger);
        self.session = Some(greeting.accept(start, self.run));
    }

    /// The session of the client that has attached.
    pub fn session(&mut self) -> Option<&mut DebugSession> {
        self.session.as_mut()
    }

    /// Waits for a message, at most for this time.
    pub fn wait(&mut self, time: Duration) {
        if let Some(session) = &mut self.session {
            session.wait(time);
        } else if let Some(greeting) = self.arriving.first_mut() {
            greeting.wait(time);
        } else if let Ok(client) = self.arrivals.recv_timeout(time) {
            self.arriving.push(Greeting::through_port(client, self.secret.clone()));
        }
    }
}
