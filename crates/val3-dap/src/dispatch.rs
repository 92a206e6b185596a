//! Dispatch of a session's messages to its requests.

use serde_json::Value;

use crate::client::Incoming;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::message::{MessageContent, ProtocolMessage};
use crate::requests;
use crate::session::{DebugSession, NextAction};

impl DebugSession {
    /// Handles the received messages.
    pub fn attend(&mut self, run: &mut DebuggedRun<'_>) -> NextAction {
        while let Some(incoming) = self.client.poll() {
            match incoming {
                Incoming::Message(ProtocolMessage { seq, content: MessageContent::Request { command, arguments } }) => {
                    self.handle(seq, &command, arguments, run);
                }
                Incoming::Message(_) => {}
                Incoming::Garbage(error) => self.client.say(&format!("{error}\n")),
                Incoming::End(fault) => self.client.disconnect(fault),
            }
            if let Some(action) = self.action.take() {
                return action;
            }
        }
        self.note_repetition(run);
        match () {
            () if !self.client.is_connected() => self.action_after_disconnect(false),
            () if self.is_running() => NextAction::Run,
            () => NextAction::Wait,
        }
    }

    fn handle(&mut self, seq: i64, command: &str, arguments: Option<Value>, run: &mut DebuggedRun<'_>) {
        if command != "cancel" && self.client.withdraws(seq) {
            self.client.refuse(seq, command, &RequestFailure::Cancelled);
            return;
        }
        self.request = seq;
        let answer = match requests::find(command) {
            Some(handler) => handler.answer(self, run, arguments),
            None => Err(requests::unsupported(command, arguments)),
        };
        match answer {
            Ok(body) => self.client.send(Ok(MessageContent::answer(seq, command, body))),
            Err(RequestFailure::Malformed(error)) => {
                self.client.send(error.response(seq));
                return;
            }
            Err(failure) => self.client.refuse(seq, command, &failure),
        }
        self.send_following();
        if let Some(goal) = self.goal.take() {
            self.go_back(goal, run);
            self.send_following();
        }
        self.refresh_view(run);
    }

    fn send_following(&mut self) {
        for event in std::mem::take(&mut self.following) {
            self.client.event(&event);
        }
    }
}
