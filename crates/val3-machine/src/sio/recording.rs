//! Recorded results of lines, for the replay of a run without the lines.
//!
//! The calls to a line are numbered. Only an unusual result is recorded: a connection that opens or ends, received
//! bytes, an incomplete send. A line that is polled a million times and stays silent therefore produces no entry, and a
//! program with the same calls in the same order receives the same results.

use std::cell::Cell;
use std::collections::{BTreeMap, VecDeque};
use std::rc::Rc;

use serde::{Deserialize, Serialize};

use super::{ByteStream, Connection, LineKind, LineSetting, Received, SendResult, SettingRefusal};
use crate::inputs::{Answer, Inputs};

/// Unusual result of a line.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RecordedReply {
    /// The number of the call, from 0.
    pub call: u64,
    /// Result of the call.
    pub answer: LineAnswer,
}

/// Result of a call.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LineAnswer {
    /// The connection has changed since the last call.
    Connection(Connection),
    /// Bytes were received, or the peer has disconnected.
    Received(Received),
    /// Not all bytes were sent.
    Sent(SendResult),
    /// An open connection was closed.
    Closed,
    /// A setting was rejected.
    Refused(SettingRefusal),
}

/// Recorder state: number of the next call, and the connection at the last call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RecorderState {
    call: u64,
    connection: Connection,
}

impl Answer for Connection {}

impl Answer for SendResult {}

impl Answer for Received {
    fn held_bytes(&self) -> usize {
        match self {
            Self::Bytes(bytes) => bytes.len(),
            Self::Nothing | Self::Ended => 0,
        }
    }
}

/// Line whose calls pass through a recorder of external input. Unusual results are passed to `tell`.
pub struct LineRecorder<L, F> {
    line: L,
    inputs: Inputs,
    tell: F,
    state: Rc<Cell<RecorderState>>,
}

impl<L: ByteStream, F: FnMut(RecordedReply)> LineRecorder<L, F> {
    /// Records `line` from its first call on.
    pub fn new(line: L, inputs: Inputs, tell: F) -> Self {
        let state = RecorderState { call: 0, connection: Connection::Closed };
        Self { line, inputs, tell, state: Rc::new(Cell::new(state)) }
    }

    /// Shared state, which its owner can save and restore.
    #[must_use]
    pub fn state(&self) -> Rc<Cell<RecorderState>> {
        Rc::clone(&self.state)
    }

    /// Ends a call. `answer` is the result if it is unusual.
    fn ended(&mut self, answer: Option<LineAnswer>) {
        let RecorderState { call, connection } = self.state.get();
        if let Some(answer) = answer {
            (self.tell)(RecordedReply { call, answer });
        }
        self.state.set(RecorderState { call: call + 1, connection });
    }
}

impl<L: ByteStream, F: FnMut(RecordedReply)> ByteStream for LineRecorder<L, F> {
    fn kind(&self) -> LineKind {
        self.line.kind()
    }

    fn open(&mut self) -> Connection {
        let RecorderState { call, connection: before } = self.state.get();
        let connection = self.inputs.ask_usual(&before, || self.line.open());
        self.state.set(RecorderState { call, connection });
        self.ended((connection != before).then_some(LineAnswer::Connection(connection)));
        connection
    }

    fn receive(&mut self, room: usize, fresh: bool) -> Received {
        let received = self.inputs.ask_usual(&Received::Nothing, || self.line.receive(room, fresh));
        self.ended((received != Received::Nothing).then(|| LineAnswer::Received(received.clone())));
        received
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        let usual = SendResult::Taken(bytes.len());
        let sent = self.inputs.ask_usual(&usual, || self.line.send(bytes));
        self.ended((sent != usual).then_some(LineAnswer::Sent(sent)));
        sent
    }

    fn close(&mut self) -> bool {
        let closed = self.inputs.ask_usual(&false, || self.line.close());
        self.ended(closed.then_some(LineAnswer::Closed));
        closed
    }

    fn shut_down(&mut self) {
        self.inputs.ask_usual(&(), || self.line.shut_down());
        self.ended(None);
    }

    fn apply(&mut self, setting: &LineSetting) -> Result<(), SettingRefusal> {
        let applied = self.inputs.ask_usual(&Ok(()), || self.line.apply(setting));
        self.ended(applied.err().map(LineAnswer::Refused));
        applied
    }
}

/// Reads the results of lines, by link, from the record of a run (one event a line). The last line is incomplete if the
/// run was killed.
///
/// # Errors
/// Number and fault of the first line that is no event.
pub fn replay(record: &str) -> Result<BTreeMap<String, Vec<RecordedReply>>, (usize, serde_json::Error)> {
    #[derive(Deserialize)]
    #[serde(tag = "kind", rename_all = "lowercase")]
    enum RecordedEvent {
        Line {
            link: String,
            #[serde(flatten)]
            entry: RecordedReply,
        },
        #[serde(other)]
        Else,
    }
    let mut answers: BTreeMap<String, Vec<RecordedReply>> = BTreeMap::new();
    for (number, line) in (1..).zip(record.split_inclusive('\n')).filter(|(_, line)| !line.trim().is_empty()) {
        match serde_json::from_str(line) {
            Ok(RecordedEvent::Line { link, entry }) => answers.entry(link).or_default().push(entry),
            Err(error) if line.ends_with('\n') || !error.is_eof() => return Err((number, error)),
            Ok(RecordedEvent::Else) | Err(_) => {}
        }
    }
    Ok(answers)
}

/// Line that repeats recorded results.
#[derive(Debug)]
pub struct Replay {
    kind: LineKind,
    entries: VecDeque<RecordedReply>,
    call: u64,
    connection: Connection,
}

impl Replay {
    /// Creates a line that returns the results of `entries`, in the order of the calls.
    #[must_use]
    pub fn new(kind: LineKind, entries: impl IntoIterator<Item = RecordedReply>) -> Self {
        Self { kind, entries: entries.into_iter().collect(), call: 0, connection: Connection::Closed }
    }

    /// Returns the unusual result of this call. A run with other calls than the recorded run receives usual results.
    fn answer(&mut self) -> Option<LineAnswer> {
        let call = self.call;
        self.call += 1;
        self.entries.pop_front_if(|entry| entry.call <= call).map(|entry| entry.answer)
    }
}

impl ByteStream for Replay {
    fn kind(&self) -> LineKind {
        self.kind
    }

    fn open(&mut self) -> Connection {
        if let Some(LineAnswer::Connection(connection)) = self.answer() {
            self.connection = connection;
        }
        self.connection
    }

    fn receive(&mut self, _room: usize, _fresh: bool) -> Received {
        match self.answer() {
            Some(LineAnswer::Received(received)) => received,
            _ => Received::Nothing,
        }
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        match self.answer() {
            Some(LineAnswer::Sent(sent)) => sent,
            _ => SendResult::Taken(bytes.len()),
        }
    }

    fn close(&mut self) -> bool {
        self.answer() == Some(LineAnswer::Closed)
    }

    fn shut_down(&mut self) {
        self.answer();
    }

    fn apply(&mut self, _setting: &LineSetting) -> Result<(), SettingRefusal> {
        match self.answer() {
            Some(LineAnswer::Refused(refused)) => Err(refused),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::*;
    use crate::sio::{Channel, MemoryLine, Peer, SettingValue};

    /// Executes a program and returns its result in each turn.
    fn run(channel: &mut Channel, mut outside: impl FnMut(u32)) -> Vec<String> {
        (0..12)
            .map(|turn| {
                outside(turn);
                match turn {
                    0 => format!("{:?}", channel.control("port", SettingValue::Num(2000.0))),
                    4 => format!("{:?}", channel.control("port", SettingValue::Num(2001.0))),
                    5 | 6 => format!("{:?}", channel.send(&mut channel.text("answer"), 0.0)),
                    9 | 10 => format!("{:?}", channel.clear()),
                    _ => format!("{:?}", channel.read_text(0.0)),
                }
            })
            .collect()
    }

    fn outside(peer: &Peer, turn: u32) {
        match turn {
            2 => peer.connect(),
            3 => peer.send("hello\rhalf"),
            6 => peer.stall_after(2),
            7 => peer.send("\r"),
            8 => peer.disconnect(),
            9 => peer.connect(),
            _ => {}
        }
    }

    #[test]
    fn a_replay_is_the_same_without_the_line() {
        let (line, peer) = MemoryLine::pair(LineKind::Server);
        let log = Rc::new(RefCell::new(Vec::new()));
        let sink = Rc::clone(&log);
        let recorder = LineRecorder::new(line, Inputs::default(), move |entry| sink.borrow_mut().push(entry));
        let seen = run(&mut Channel::new(Box::new(recorder)), |turn| outside(&peer, turn));
        let entries = log.borrow().clone();
        assert_eq!(entries.len(), 9, "{entries:#?}");
        let replayed = run(&mut Channel::new(Box::new(Replay::new(LineKind::Server, entries))), |_| {});
        assert_eq!(seen, replayed);
        assert!(seen.iter().any(|seen| seen == r#"Done(Ok("hello"))"#), "{seen:#?}");
    }

    #[test]
    fn unchanged_answers_are_not_recorded() {
        let (line, _peer) = MemoryLine::pair(LineKind::Client);
        let log = Rc::new(RefCell::new(Vec::new()));
        let sink = Rc::clone(&log);
        let mut channel =
            Channel::new(Box::new(LineRecorder::new(line, Inputs::default(), move |entry: RecordedReply| {
                sink.borrow_mut().push(entry)
            })));
        for _ in 0..100 {
            assert_eq!(channel.read_text(1.0), crate::sio::Attempt::Wait);
        }
        assert_eq!(log.borrow().len(), 0);
    }
}
