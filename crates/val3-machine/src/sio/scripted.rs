//! Line whose other end is a script: it accepts all output, and its input is sent by the script.

use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

use super::{ByteStream, Connection, LineKind, LineSetting, Received, SendResult, SettingRefusal};

/// Controller's end of the line, which is always open.
#[derive(Debug)]
pub struct ScriptedLine {
    kind: LineKind,
    input: Rc<RefCell<VecDeque<u8>>>,
}

/// Script's end of the line.
#[derive(Debug)]
pub struct ScriptedPeer {
    input: Rc<RefCell<VecDeque<u8>>>,
}

impl ScriptedLine {
    /// Creates both ends.
    #[must_use]
    pub fn pair(kind: LineKind) -> (Self, ScriptedPeer) {
        let input = Rc::<RefCell<VecDeque<u8>>>::default();
        (Self { kind, input: Rc::clone(&input) }, ScriptedPeer { input })
    }
}

impl ScriptedPeer {
    /// Sends bytes to the controller.
    pub fn send(&self, bytes: &[u8]) {
        self.input.borrow_mut().extend(bytes);
    }
}

impl ByteStream for ScriptedLine {
    fn kind(&self) -> LineKind {
        self.kind
    }

    fn open(&mut self) -> Connection {
        Connection::Open
    }

    fn receive(&mut self, room: usize, _fresh: bool) -> Received {
        let mut input = self.input.borrow_mut();
        let count = room.min(input.len());
        match count {
            0 => Received::Nothing,
            _ => Received::Bytes(input.drain(..count).collect()),
        }
    }

    fn send(&mut self, bytes: &[u8]) -> SendResult {
        SendResult::Taken(bytes.len())
    }

    fn close(&mut self) -> bool {
        self.input.borrow_mut().clear();
        true
    }

    fn shut_down(&mut self) {
        self.close();
    }

    fn apply(&mut self, _setting: &LineSetting) -> Result<(), SettingRefusal> {
        Ok(())
    }
}
