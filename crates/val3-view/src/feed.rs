//! Messages of a run, cycle by cycle.

use std::collections::BTreeMap;

use serde_json::{Value, json};
use val3_geometry::{IsometryMatrix3, Trsf};
use val3_lang::ports::Time;
use val3_lang::types::BaseType;
use val3_machine::controller::{CodeSource, Controller, RecordedMove};
use val3_machine::event::{EndReason, Event, EventKind, seconds};
use val3_motion::{MotionPhase, Sample, SpeedLimit};
use val3_vm::CYCLE;

use crate::commands::tool_of_last_move;
use crate::lines::{FileReader, Lines};
use crate::motion::{self, MotionKey};
use crate::positions::{GlobalValue, PositionComputer};
use crate::programs::Programs;
use crate::reach::ReachState;
use crate::samples::{self, Batch, NO_SOURCE, SampleOrigin};
use crate::signals::SignalStates;
use crate::wire::{
    CellPoint, DataMessage, End, EventsMessage, JointValue, MotionMessage, PageMessage, PartsMessage, Rewind, Role,
    Source, StateMessage, Tool,
};
use crate::{cell, numbers, positions, scene, state, user_page, wire};

/// Polling interval for the state, in nanoseconds on the controller's clock.
const LOOK: Time = 25 * CYCLE;

/// Number of state polls between two comparisons of the positions in memory.
const POSITIONS: u32 = 10;

/// Tolerance within which two tools are equal, in mm and degrees.
const SAME_TOOL: f64 = 1e-6;

/// Tool number that all tools after the first 255 share.
const OTHER_TOOL: u8 = u8::MAX;

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
    state: Option<StateMessage>,
    motion: Option<(MotionKey, MotionMessage)>,
    page: Option<PageMessage>,
    parts: Option<PartsMessage>,
    points: Vec<CellPoint>,
    joints: Vec<JointValue>,
    frames: Vec<CellPoint>,
    cell_tools: Vec<CellPoint>,
    reach: ReachState,
    signals: SignalStates,
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
            state: None,
            motion: None,
            page: None,
            parts: None,
            points: Vec::new(),
            joints: Vec::new(),
            frames: Vec::new(),
            cell_tools: Vec::new(),
            reach: ReachState::default(),
            signals: SignalStates::default(),
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
        let moves_parts = |event: &Event| {
            matches!(event.kind, EventKind::Grip { .. } | EventKind::Release { .. } | EventKind::Part { .. })
        };
        if events.iter().any(moves_parts) {
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
        let motion = self.motion.take();
        self.forget();
        if let Some((_, message)) = &motion {
            // A new message would contain the path from the present place on only.
            self.tell(&wire::Message::Motion(MotionMessage { t: seconds(now), ..message.clone() }));
        }
        self.motion = motion;
        self.look(now, controller);
        self.see_positions(now, controller);
        let mut batch = Batch::new(arm.model().axes(), false);
        batch.add(now, &sample, origin);
        let mut state = std::mem::replace(&mut self.messages, pending);
        state.extend(batch.take().map(ViewerMessage::Samples));
        state
    }

    fn forget(&mut self) {
        (self.state, self.page, self.motion, self.parts) = (None, None, None, None);
        (self.points, self.joints) = (Vec::new(), Vec::new());
        (self.frames, self.cell_tools) = (Vec::new(), Vec::new());
        self.reach = ReachState::default();
        self.signals = SignalStates::default();
    }

    /// Sends the changes of the complete state immediately: after a command, at a stop, or after stepping back.
    pub fn refresh(&mut self, controller: &Controller) {
        let now = controller.now();
        if now < self.seen {
            self.flush_samples();
            self.tell(&wire::Message::Rewind(Rewind { t: seconds(now) }));
            self.forget();
            self.last = None;
        }
        self.sample(now, controller);
        self.look(now, controller);
        self.see_positions(now, controller);
        self.seen = now;
    }

    /// Sends the end of the run.
    pub fn end(&mut self, reason: EndReason, exit_code: u8, controller: &Controller) {
        let now = controller.now();
        self.look(now, controller);
        self.flush_samples();
        self.tell(&wire::Message::End(End { t: seconds(now), reason, exit_code }));
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
        let programs = self.programs.as_mut().map(|programs| programs.news(&controller.vm.space, &mut self.lines));
        for programs in programs.into_iter().flatten() {
            self.tell(&wire::Message::Programs(programs));
        }
    }

    fn see_state(&mut self, t: f64, controller: &Controller) {
        let state = state::message(t, controller, &mut self.lines);
        let is_known = self.state.as_ref().is_some_and(|known| StateMessage { t, ..known.clone() } == state);
        if !is_known {
            self.tell(&wire::Message::State(state.clone()));
            self.state = Some(state);
        }
    }

    fn see_page(&mut self, t: f64, controller: &Controller) {
        let page = user_page::message(t, controller);
        let is_known = self.page.as_ref().is_some_and(|known| PageMessage { t, ..known.clone() } == page);
        if !is_known {
            self.tell(&wire::Message::Page(page.clone()));
            self.page = Some(page);
        }
    }

    fn see_parts(&mut self, controller: &Controller) {
        let Some(parts) = cell::places(seconds(controller.now()), controller) else { return };
        if self.parts.as_ref().is_none_or(|known| known.parts != parts.parts) {
            self.tell(&wire::Message::Parts(parts.clone()));
            self.parts = Some(parts);
        }
    }

    fn see_motion(&mut self, time: Time, controller: &Controller) {
        let key = MotionKey::of(controller);
        if self.motion.as_ref().is_none_or(|(known, _)| *known != key) {
            let number = |queued: &RecordedMove| self.number_of(queued.source.as_ref());
            let motion = motion::message(seconds(time), controller, number);
            self.tell(&wire::Message::Motion(motion.clone()));
            self.motion = Some((key, motion));
        }
    }

    fn see_positions(&mut self, time: Time, controller: &Controller) {
        let data = positions::data(controller);
        let memory = &controller.vm.space.memory;
        let mut computer = PositionComputer::new(&data, controller);
        let [points, frames, tools] = [BaseType::Point, BaseType::Frame, BaseType::Tool].map(|of| computer.of_type(of));
        let joints = positions::joints(&data, memory);
        let has_changed = points != self.points || joints != self.joints;
        // The scene contains the initial positions, so the first comparison sends nothing.
        if self.looks > 0 {
            let message = DataMessage {
                t: seconds(time),
                points: changed(&points, &self.points),
                joints: changed(&joints, &self.joints),
                frames: changed(&frames, &self.frames),
                tools: changed(&tools, &self.cell_tools),
            };
            if !message.is_empty() {
                self.tell(&wire::Message::Data(message));
            }
        }
        (self.points, self.joints, self.frames, self.cell_tools) = (points, joints, frames, tools);
        self.see_reach(time, has_changed, &data, controller);
    }

    fn see_reach(&mut self, time: Time, has_changed: bool, data: &[GlobalValue], controller: &Controller) {
        let tool = self.tool(&tool_of_last_move(controller), controller);
        if let Some(message) = self.reach.changes(seconds(time), tool, has_changed, data, controller) {
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
        if let Some(changes) = self.signals.changes(seconds(time), &controller.devices.state.io) {
            self.tell(&wire::Message::Io(changes));
        }
    }

    /// Before other messages, sends the pending samples of a live run. In a recording, samples wait for a full batch.
    fn release_samples(&mut self) {
        if !self.is_recorded {
            self.flush_samples();
        }
    }

    fn flush_samples(&mut self) {
        self.messages.extend(self.batch.take().map(ViewerMessage::Samples));
    }

    /// Adds a sample of the arm, unless the arm is stopped and has not moved.
    fn sample(&mut self, time: Time, controller: &Controller) {
        if self.last.is_some_and(|(last, ..)| time < last + CYCLE) {
            return;
        }
        let arm = controller.arm();
        let (sample, limit) = (*arm.sample(), arm.speed_limit());
        let is_new = self.last.is_none_or(|(_, (last, _), _)| last.joints != sample.joints || last.pose != sample.pose);
        if is_new {
            if let Some((resting, before, false)) = self.last {
                self.add(resting, &before, controller);
            }
            self.add(time, &(sample, limit), controller);
        }
        let ends_motion =
            !is_new && self.last.is_some_and(|(_, (last, _), is_known)| is_known && last.phase != sample.phase);
        if ends_motion {
            self.add(time, &(sample, limit), controller);
        }
        self.last = Some((time, (sample, limit), is_new || ends_motion));
    }

    fn add(&mut self, time: Time, (sample, limit): &(Sample, SpeedLimit), controller: &Controller) {
        if self.batch.is_full(time) {
            self.flush_samples();
        }
        let origin = self.origin(sample, *limit, controller);
        self.batch.add(time, sample, origin);
    }

    /// Returns the origin of a sample. Its tool and its line are sent to the pages if they are new.
    fn origin(&mut self, sample: &Sample, limit: SpeedLimit, controller: &Controller) -> SampleOrigin {
        let tool = controller.arm().model().flange(&sample.joints).inverse() * sample.pose;
        let tool = self.tool(&tool, controller);
        let source = match sample.phase {
            MotionPhase::Waiting => NO_SOURCE,
            _ => {
                let piece = controller.motion_status().piece;
                self.number_of(piece.and_then(|piece| piece.source).as_ref())
            }
        };
        SampleOrigin { phase: sample.phase as u8, tool, source, limit: samples::number_of(limit) }
    }

    /// Number of a tool. A new tool is sent to the pages.
    fn tool(&mut self, tool: &IsometryMatrix3<f64>, controller: &Controller) -> u8 {
        let pose = numbers(&Trsf::from(*tool));
        if let Some(number) = self.tools.iter().position(|known| is_same(known, &pose)) {
            return u8::try_from(number).unwrap_or(OTHER_TOOL);
        }
        let number = u8::try_from(self.tools.len()).unwrap_or(OTHER_TOOL);
        if number != OTHER_TOOL {
            self.tools.push(pose);
            let name = positions::tool_at(controller, |known| is_same(known, &pose));
            self.tell(&wire::Message::Tool(Tool { index: number, name, pose }));
        }
        number
    }

    /// Number of a program line that requests moves. A new line is sent to the pages.
    fn number_of(&mut self, source: Option<&CodeSource>) -> u16 {
        let Some(source) = source else { return NO_SOURCE };
        let key = (source.file.clone(), source.line, source.program.clone());
        if let Some(number) = self.sources.get(&key) {
            return *number;
        }
        let Some(number) = u16::try_from(self.sources.len()).ok().filter(|number| *number < NO_SOURCE) else {
            return NO_SOURCE;
        };
        self.sources.insert(key, number);
        self.tell(&wire::Message::Source(Source {
            index: number,
            instruction: source.instruction.to_owned(),
            program: source.program.clone(),
            line: source.line,
            file: source.file.clone(),
        }));
        number
    }
}

/// Values that differ from all known values. A value includes its name.
fn changed<T: PartialEq + Clone>(values: &[T], known: &[T]) -> Vec<T> {
    // A value is nearly always at its previous index.
    let is_known = |(index, value): &(usize, &T)| known.get(*index) == Some(*value) || known.contains(value);
    values.iter().enumerate().filter(|value| !is_known(value)).map(|(_, value)| value.clone()).collect()
}

fn is_same(known: &[f64; 6], tool: &[f64; 6]) -> bool {
    known.iter().zip(tool).all(|(known, number)| (known - number).abs() < SAME_TOOL)
}

#[cfg(test)]
mod tests;
