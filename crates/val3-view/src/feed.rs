//! Messages of a run, cycle by cycle.

mod arm;
mod known;

use std::collections::BTreeMap;

use serde_json::{Value, json};
use val3_lang::ports::Time;
use val3_lang::types::BaseType;
use val3_machine::controller::{Controller, RecordedMove};
use val3_machine::event::{EndReason, Event, EventKind, seconds};
use val3_motion::{Sample, SpeedLimit};
use val3_vm::CYCLE;

use crate::commands::tool_of_last_move;
use crate::lines::{FileReader, Lines};
use crate::motion::{self, MotionKey};
use crate::positions::{GlobalValue, PositionComputer};
use crate::programs::Programs;
use crate::samples::Batch;
use crate::wire::{DataMessage, End, EventsMessage, MotionMessage, PageMessage, Rewind, Role, StateMessage};
use crate::{cell, positions, scene, state, user_page, wire};
use known::Known;

/// Polling interval for the state, in nanoseconds on the controller's clock.
const LOOK: Time = 25 * CYCLE;

/// Number of state polls between two comparisons of the positions in memory.
const POSITIONS: u32 = 10;

/// A message for pages.
#[derive(Debug, Clone, PartialEq)]
pub enum ViewerMessage {
    /// A JSON object; `kind` is its type.
    Object(Value),
    /// A batch of arm samples.
    Samples(Vec<u8>),
}

/// Source of a run's messages.
#[derive(Debug)]
pub struct Feed {
    batch: Batch,
    /// Whether samples may be delayed after other messages, so that their batches are longer.
    is_recorded: bool,
    /// Time of the last sample, the sample, and whether it is in a batch.
    last: Option<(Time, (Sample, SpeedLimit), bool)>,
    tools: Vec<[f64; 6]>,
    sources: BTreeMap<(String, u32, String), u16>,
    next_look: Time,
    looks: u32,
    known: Known,
    lines: Lines,
    /// Programs that readers have; `None` if their editor shows the code itself.
    programs: Option<Programs>,
    /// Latest time in the messages.
    seen: Time,
    messages: Vec<ViewerMessage>,
}

impl Feed {
    /// Starts the messages of a run, at its start or when a viewer begins to observe it. The first messages are its
    /// scene and its complete state. `files` reads the programs, for their code in messages.
    #[must_use]
    pub fn new(controller: &Controller, role: Role, files: FileReader) -> Self {
        let is_recorded = role == Role::Recording;
        let mut feed = Self {
            batch: Batch::new(controller.arm().model().axes(), is_recorded),
            is_recorded,
            last: None,
            tools: Vec::new(),
            sources: BTreeMap::new(),
            next_look: 0,
            looks: 0,
            known: Known::default(),
            lines: Lines::new(files),
            programs: (role != Role::Debugger).then(Programs::default),
            seen: 0,
            messages: Vec::new(),
        };
        feed.tell(&wire::Message::Scene(Box::new(scene(controller, role))));
        feed.sample(controller.now(), controller);
        feed.look(controller.now(), controller);
        feed
    }

    /// Processes a finished cycle that began at `start`, with its events.
    pub fn see(&mut self, start: Time, events: &[Event], controller: &Controller) {
        self.sample(start, controller);
        self.see_events(events, controller);
        if start >= self.next_look {
            self.look(start, controller);
        }
    }

    /// Processes events of the current cycle, or of a command.
    pub fn see_events(&mut self, events: &[Event], controller: &Controller) {
        if !events.is_empty() {
            let events = events.iter().map(|event| self.lines.with_code(event)).collect();
            self.tell(&wire::Message::Events(EventsMessage { events }));
        }
        if events.iter().any(|event| matches!(event.kind, EventKind::Io { .. })) {
            self.see_signals(controller.now(), controller);
        }
        if events.iter().any(|event| moves_part(&event.kind)) {
            self.see_parts(controller);
        }
    }

    /// Sends the pending changes, then returns the complete state at the present time: messages with which a page can
    /// begin that receives only later messages. For other pages, they contain nothing new. A sample of the arm, which
    /// may have been at rest since long, is the last message.
    pub fn complete_state(&mut self, controller: &Controller) -> Vec<ViewerMessage> {
        let now = controller.now();
        self.look(now, controller);
        self.see_positions(now, controller);
        let arm = controller.arm();
        let (sample, limit) = self.last.map_or((*arm.sample(), arm.speed_limit()), |(_, sampled, _)| sampled);
        let origin = self.origin(&sample, limit, controller);
        self.flush_samples();
        let pending = self.take();
        let motion = self.known.motion.take();
        self.known = Known::default();
        if let Some((_, message)) = &motion {
            // A new message would contain the path from the present place on only.
            self.tell(&wire::Message::Motion(MotionMessage { t: seconds(now), ..message.clone() }));
        }
        self.known.motion = motion;
        self.look(now, controller);
        self.see_positions(now, controller);
        let mut batch = Batch::new(arm.model().axes(), false);
        batch.add(now, &sample, origin);
        let mut state = std::mem::replace(&mut self.messages, pending);
        state.extend(batch.take().map(ViewerMessage::Samples));
        state
    }

    /// Whether the run has gone back since the last messages.
    #[must_use]
    pub fn is_later_than(&self, controller: &Controller) -> bool {
        controller.now() < self.seen
    }

    /// Sends the changes of the complete state immediately: after a command, at a stop, or after stepping back.
    pub fn refresh(&mut self, controller: &Controller) {
        let now = controller.now();
        if self.is_later_than(controller) {
            self.flush_samples();
            self.tell(&wire::Message::Rewind(Rewind { t: seconds(now) }));
            self.known = Known::default();
            self.last = None;
        }
        self.sample(now, controller);
        self.look(now, controller);
        self.see_positions(now, controller);
        self.seen = now;
    }

    /// Sends the complete present state, because the clock stops: samples do not wait for a full batch.
    pub fn rest(&mut self, controller: &Controller) {
        self.refresh(controller);
        self.flush_samples();
    }

    /// Sends the end of the run, and returns it.
    pub fn end(&mut self, reason: EndReason, exit_code: u8, controller: &Controller) -> End {
        let now = controller.now();
        self.look(now, controller);
        self.flush_samples();
        let end = End { t: seconds(now), reason, exit_code };
        self.tell(&wire::Message::End(end.clone()));
        end
    }

    fn look(&mut self, time: Time, controller: &Controller) {
        (self.next_look, self.seen) = (time + LOOK, self.seen.max(time));
        self.release_samples();
        self.see_signals(time, controller);
        self.see_motion(time, controller);
        self.see_programs(controller);
        self.see_state(seconds(time), controller);
        self.see_page(seconds(time), controller);
        self.see_parts(controller);
        if self.looks.is_multiple_of(POSITIONS) {
            self.see_positions(time, controller);
        }
        self.looks = self.looks.wrapping_add(1);
    }

    fn see_programs(&mut self, controller: &Controller) {
        let programs = self.programs.as_mut().map(|programs| programs.news(controller, &mut self.lines));
        for programs in programs.into_iter().flatten() {
            self.tell(&wire::Message::Programs(programs));
        }
    }

    fn see_state(&mut self, t: f64, controller: &Controller) {
        let state = state::message(t, controller, &mut self.lines);
        let is_known = self.known.state.as_ref().is_some_and(|known| StateMessage { t, ..known.clone() } == state);
        if !is_known {
            self.tell(&wire::Message::State(state.clone()));
            self.known.state = Some(state);
        }
    }

    fn see_page(&mut self, t: f64, controller: &Controller) {
        let page = user_page::message(t, controller);
        let is_known = self.known.page.as_ref().is_some_and(|known| PageMessage { t, ..known.clone() } == page);
        if !is_known {
            self.tell(&wire::Message::Page(page.clone()));
            self.known.page = Some(page);
        }
    }

    fn see_parts(&mut self, controller: &Controller) {
        let Some(parts) = cell::places(seconds(controller.now()), controller) else { return };
        if self.known.parts.as_ref().is_none_or(|known| known.parts != parts.parts) {
            self.tell(&wire::Message::Parts(parts.clone()));
            self.known.parts = Some(parts);
        }
    }

    fn see_motion(&mut self, time: Time, controller: &Controller) {
        let key = MotionKey::of(controller);
        if self.known.motion.as_ref().is_none_or(|(known, _)| *known != key) {
            let number = |queued: &RecordedMove| self.number_of(queued.source.as_ref());
            let motion = motion::message(seconds(time), controller, number);
            self.tell(&wire::Message::Motion(motion.clone()));
            self.known.motion = Some((key, motion));
        }
    }

    fn see_positions(&mut self, time: Time, controller: &Controller) {
        let data = positions::data(controller);
        let memory = &controller.vm.space.memory;
        let mut computer = PositionComputer::new(&data, controller);
        let [points, frames, tools] = [BaseType::Point, BaseType::Frame, BaseType::Tool].map(|of| computer.of_type(of));
        let joints = positions::joints(&data, memory);
        let has_changed = points != self.known.points || joints != self.known.joints;
        // The scene contains the initial positions, so the first comparison sends nothing.
        if self.looks > 0 {
            let message = DataMessage {
                t: seconds(time),
                points: changed(&points, &self.known.points),
                joints: changed(&joints, &self.known.joints),
                frames: changed(&frames, &self.known.frames),
                tools: changed(&tools, &self.known.cell_tools),
            };
            if !message.is_empty() {
                self.tell(&wire::Message::Data(message));
            }
        }
        (self.known.points, self.known.joints, self.known.frames, self.known.cell_tools) =
            (points, joints, frames, tools);
        self.see_reach(time, has_changed, &data, controller);
    }

    fn see_reach(&mut self, time: Time, has_changed: bool, data: &[GlobalValue], controller: &Controller) {
        let tool = self.tool(&tool_of_last_move(controller), controller);
        if let Some(message) = self.known.reach.changes(seconds(time), tool, has_changed, data, controller) {
            self.tell(&wire::Message::Reach(message));
        }
    }

    /// Removes and returns the pending messages.
    pub fn take(&mut self) -> Vec<ViewerMessage> {
        std::mem::take(&mut self.messages)
    }

    /// Adds a message of the caller, such as the pace of the run.
    pub fn tell(&mut self, message: &wire::Message) {
        self.release_samples();
        self.messages.push(ViewerMessage::Object(json!(message)));
    }

    fn see_signals(&mut self, time: Time, controller: &Controller) {
        if let Some(changes) = self.known.signals.changes(seconds(time), &controller.devices.state.io) {
            self.tell(&wire::Message::Io(changes));
        }
    }
}

/// Whether the event may have moved a part.
fn moves_part(event: &EventKind) -> bool {
    matches!(event, EventKind::Grip { .. } | EventKind::Release { .. } | EventKind::Part { .. })
}

/// Values that differ from all known values. A value includes its name.
fn changed<T: PartialEq + Clone>(values: &[T], known: &[T]) -> Vec<T> {
    // A value is nearly always at its previous index.
    let is_known = |(index, value): &(usize, &T)| known.get(*index) == Some(*value) || known.contains(value);
    values.iter().enumerate().filter(|value| !is_known(value)).map(|(_, value)| value.clone()).collect()
}

#[cfg(test)]
mod tests;
