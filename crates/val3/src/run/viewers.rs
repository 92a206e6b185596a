//! Viewers of a run: messages to the viewers, and their commands.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

use serde_json::{Map, Value};
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::{EndReason, Event, EventKind, seconds};
use val3_view::wire::{self, Arguments as _, Role, StartAgain};
use val3_view::{Feed, Operator};

use super::missing::program_text;
use super::recorder::ScenarioRecorder;
use super::standby::{ENDED, Standby};
use super::tempo::Tempo;
use crate::args::{ControllerArgs, RunArgs};
use crate::output::to_stderr;
use crate::printable::one_line;
use crate::serve::{PendingCommand, ServeAddress, Server, StoredMessage, browser};
use crate::user_error::UserError;

/// Kinds of messages to which later messages refer.
const LASTING: [&str; 4] = ["scene", "programs", "source", "tool"];

/// Command that writes a scenario of the run.
const RECORD: &str = "record";

/// Command that starts the application again after its end.
const RUN: &str = "run";

/// Command that acts as the operator of the controller.
const OPERATE: &str = "operate";

/// Other commands that are executed after the end of a run, between which no cycle is required.
const AFTER_END: [&str; 8] = ["save", "setPoint", "teach", "teachFrame", "teachTool", "undo", "solve", "reach"];

/// Real time between two clock messages.
const HEARTBEAT: Duration = Duration::from_secs(1);

/// Maximum number of commands executed between two cycles. Further commands wait for the next cycle.
const COMMANDS_PER_CYCLE: usize = 64;

/// Smallest size of the messages in a part of the run, in bytes, and as a multiple of the complete state with which it
/// begins. Smaller parts would contain the present earlier, but the states would take more memory.
const PART: usize = 256 << 10;
const STATES_IN_PART: usize = 8;

/// Viewers of a run.
pub(super) struct Viewers {
    server: Server,
    feed: Feed,
    operator: Operator,
    recorder: ScenarioRecorder,
    /// Bytes sent in the current part of the run, and the size at which the next part begins.
    sent: usize,
    part: usize,
    /// Commands that have arrived during a wait.
    arrived: VecDeque<PendingCommand>,
    heartbeat: Heartbeat,
    /// End of the run, which later parts repeat.
    end: Option<wire::End>,
}

/// Clock messages in regular intervals, by which viewers recognise a server that works while nothing changes.
struct Heartbeat {
    /// Moment and content of the last clock message.
    last: Option<(Instant, wire::Clock)>,
}

impl Heartbeat {
    /// Returns the clock message that is due now: after an interval, or after a change of the pace.
    fn due(&mut self, now: Instant, clock: wire::Clock) -> Option<wire::Message> {
        let is_due = self.last.as_ref().is_none_or(|(sent, last)| {
            now.duration_since(*sent) >= HEARTBEAT || wire::Clock { t: last.t, ..clock.clone() } != *last
        });
        is_due.then(|| {
            self.last = Some((now, clock.clone()));
            wire::Message::Clock(clock)
        })
    }
}

impl Viewers {
    /// Starts the server before the run begins.
    ///
    /// # Errors
    /// The address is in use, or the current folder cannot be read.
    pub(super) fn open(address: ServeAddress, args: &RunArgs, controller: &Controller) -> Result<Self, UserError> {
        let server = Server::start(address)?;
        let page = server.operator_page();
        to_stderr(|out| {
            writeln!(out, "note: the run is shown on {page}")?;
            writeln!(out, "note: guests, who cannot operate it, see it on {}", server.guest_page())
        });
        if args.open && !browser::open(page) {
            to_stderr(|out| writeln!(out, "note: no browser could be opened"));
        }
        let feed = Feed::new(controller, Role::Operator, program_text);
        let recorder = ScenarioRecorder::new(args)?;
        let (operator, arrived) = (Operator::default(), VecDeque::new());
        let mut viewers = Self {
            server,
            feed,
            operator,
            recorder,
            sent: 0,
            part: PART,
            arrived,
            heartbeat: Heartbeat { last: None },
            end: None,
        };
        viewers.publish();
        Ok(viewers)
    }

    /// Begins another run of the application: viewers receive its scene, its complete state and the note in their event
    /// logs.
    pub(super) fn begin(&mut self, controller: &Controller, args: ControllerArgs, note: String) {
        self.feed = Feed::new(controller, Role::Operator, program_text);
        self.feed.tell(&wire::Message::Unsaved(self.operator.unsaved()));
        let note = Event { t: 0.0, task: None, at: None, kind: EventKind::Notice { text: note } };
        self.feed.see_events(&[note], controller);
        self.recorder.restart(args);
        (self.sent, self.part, self.heartbeat, self.end) = (0, PART, Heartbeat { last: None }, None);
        self.server.begin_run();
        self.publish();
    }

    /// Pace in the last clock message.
    pub(super) fn speed(&self) -> Option<wire::PaceSpeed> {
        self.heartbeat.last.as_ref().map(|(_, clock)| clock.speed)
    }

    /// Publishes a finished cycle that began at `start`.
    pub(super) fn see(&mut self, start: Time, events: &[Event], controller: &Controller) {
        self.recorder.add_events(start, events);
        self.see_standby(start, events, controller);
    }

    /// Publishes a cycle after the end of the run, which belongs to no scenario.
    pub(super) fn see_standby(&mut self, start: Time, events: &[Event], controller: &Controller) {
        self.feed.see(start, events, controller);
        self.publish();
        if self.sent > self.part {
            self.begin_part(controller);
        }
    }

    /// Publishes the present state at which the clock stops. No later cycle publishes it.
    pub(super) fn see_rest(&mut self, controller: &Controller) {
        self.feed.rest(controller);
        self.publish();
    }

    /// Begins a part of the run, at which late viewers begin.
    fn begin_part(&mut self, controller: &Controller) {
        let state = self.feed.complete_state(controller);
        self.publish();
        let now = seconds(controller.now());
        let clock = self.heartbeat.last.as_ref().map(|(_, clock)| wire::Clock { t: now, ..clock.clone() });
        let unsaved = wire::Message::Unsaved(self.operator.unsaved());
        let end = self.end.clone().map(wire::Message::End);
        let more = clock.map(wire::Message::Clock).into_iter().chain([unsaved]).chain(end);
        let more = more.map(|message| val3_view::ViewerMessage::Object(serde_json::json!(message)));
        let state: Vec<StoredMessage> = state.into_iter().chain(more).map(encoded).collect();
        let bytes: usize = state.iter().map(StoredMessage::bytes).sum();
        (self.sent, self.part) = (0, PART.max(STATES_IN_PART * bytes));
        self.server.begin_part(now, state);
    }

    /// Publishes the end of the run.
    pub(super) fn see_end(&mut self, events: &[Event], reason: EndReason, exit_code: u8, controller: &Controller) {
        self.feed.see_events(events, controller);
        self.recorder.add_events(controller.now(), events);
        self.end = Some(self.feed.end(reason, exit_code, controller));
        self.publish();
    }

    /// Executes the pending commands.
    pub(super) fn attend(&mut self, controller: &mut Controller, tempo: &mut Tempo) {
        for command in self.take_commands() {
            if command.name == RECORD {
                self.recorder.record(command, controller.now());
                continue;
            }
            if command.name == RUN {
                command.answer(Err("the application is running".to_owned()));
                continue;
            }
            let (now, arguments) = (controller.now(), &command.message);
            let result = match command.name.as_str() {
                "pace" => wire::Pace::read(arguments).map_err(|error| error.to_string()).map(|pace| {
                    tempo.change(&pace, now);
                    Map::new()
                }),
                "cycle" => tempo.step(arguments, now).map(|()| Map::new()),
                name => self.operate(name, arguments, controller),
            };
            self.beat(controller, tempo);
            command.answer(result);
            self.feed.refresh(controller);
            self.publish();
        }
        if self.feed.is_later_than(controller) {
            // A debugger has gone back, and no cycle follows.
            self.feed.rest(controller);
        }
        self.beat(controller, tempo);
        self.publish();
    }

    /// Adds a clock message if it is due.
    fn beat(&mut self, controller: &Controller, tempo: &Tempo) {
        if let Some(message) = self.heartbeat.due(Instant::now(), tempo.message(seconds(controller.now()))) {
            self.feed.tell(&message);
        }
    }

    fn operate(
        &mut self,
        name: &str,
        arguments: &Map<String, Value>,
        controller: &mut Controller,
    ) -> Result<Map<String, Value>, String> {
        let before = self.operator.unsaved();
        let result = self.operator.execute(name, arguments, controller);
        if self.operator.unsaved() != before {
            self.feed.tell(&wire::Message::Unsaved(self.operator.unsaved()));
        }
        result.map_err(|error| error.to_string())
    }

    /// Waits for the next command, at most for this time.
    pub(super) fn wait(&mut self, time: Duration) {
        self.arrived.extend(self.server.wait_for_command(time));
    }

    /// Executes the pending commands after the end of the run. Returns the command that starts the application again,
    /// and its arguments.
    pub(super) fn attend_end(&mut self, standby: &mut Standby) -> Option<(PendingCommand, StartAgain)> {
        let mut start = None;
        for command in self.take_commands() {
            match command.name.as_str() {
                RECORD => self.recorder.record(command, standby.controller.now()),
                RUN if start.is_none() => match StartAgain::read(&command.message) {
                    Ok(arguments) => start = Some((command, arguments)),
                    Err(error) => command.answer(Err(error.to_string())),
                },
                RUN => command.answer(Err("the application is starting".to_owned())),
                OPERATE => {
                    let prepared = standby.prepare(&command.message);
                    let result =
                        prepared.and_then(|()| self.operate(OPERATE, &command.message, &mut standby.controller));
                    command.answer(result);
                    self.feed.refresh(&standby.controller);
                }
                name if AFTER_END.contains(&name) => {
                    let result = self.operate(name, &command.message, &mut standby.controller);
                    standby.controller.write_files();
                    command.answer(result);
                    self.feed.refresh(&standby.controller);
                }
                _ => command.answer(Err(ENDED.to_owned())),
            }
        }
        self.publish();
        start
    }

    /// Copies the unsaved values to a controller that has loaded the application again.
    pub(super) fn carry(&mut self, from: &Controller, to: &mut Controller) {
        let lost = self.operator.carry(from, to);
        if !lost.is_empty() {
            let names: Vec<String> = lost.into_iter().map(shown_point).collect();
            to_stderr(|out| writeln!(out, "note: unsaved points no longer exist: {}", names.join(", ")));
        }
    }

    /// Writes unsaved points to copies of their files before the server ends.
    pub(super) fn rescue(&self, controller: &mut Controller) {
        if self.operator.unsaved().points.is_empty() {
            return;
        }
        let written = self.operator.save_copies(controller);
        controller.write_files();
        to_stderr(|out| match &written {
            Ok(files) => files.iter().try_for_each(|file| {
                let file = one_line(file);
                writeln!(out, "note: `{file}` contains the unsaved points; it replaces the file without `.unsaved`")
            }),
            Err(error) => writeln!(out, "error: the unsaved points are lost: {error}"),
        });
    }

    fn take_commands(&mut self) -> VecDeque<PendingCommand> {
        let arriving = std::iter::from_fn(|| self.server.next_command());
        self.arrived.extend(arriving.take(COMMANDS_PER_CYCLE));
        std::mem::take(&mut self.arrived)
    }

    /// Publishes the new messages of the feed.
    fn publish(&mut self) {
        let messages: Vec<StoredMessage> = self.feed.take().into_iter().map(encoded).collect();
        self.sent += messages.iter().map(StoredMessage::bytes).sum::<usize>();
        self.server.publish(messages);
    }
}

/// Formats the name as a program writes it.
fn shown_point(point: wire::PointName) -> String {
    match point.key {
        Some(key) => format!("`{}[{key}]`", point.name),
        None => format!("`{}`", point.name),
    }
}

fn encoded(message: val3_view::ViewerMessage) -> StoredMessage {
    match message {
        val3_view::ViewerMessage::Samples(bytes) => StoredMessage::Binary(bytes.into()),
        val3_view::ViewerMessage::Object(object) => {
            let text = object.to_string().into();
            let lasts = object.get("kind").and_then(Value::as_str).is_some_and(|kind| LASTING.contains(&kind));
            if lasts { StoredMessage::Lasting(text) } else { StoredMessage::Text(text) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clock_messages_are_regular_and_follow_changes() {
        let mut heartbeat = Heartbeat { last: None };
        let begin = Instant::now();
        let mut is_due = |milliseconds, t, is_paused| {
            let clock = wire::Clock { t, speed: wire::PaceSpeed::Times(1.0), is_paused, is_stopped: false };
            heartbeat.due(begin + Duration::from_millis(milliseconds), clock).is_some()
        };
        assert!(is_due(0, 0.0, false));
        assert!(!is_due(999, 0.9, false));
        assert!(is_due(999, 0.9, true));
        assert!(!is_due(1998, 0.9, true));
        assert!(is_due(1999, 0.9, true));
    }
}
