//! Queue of the recorded moves, and execution events.

use std::collections::VecDeque;

use val3_geometry::{IsometryMatrix3, Vector3};
use val3_kinematics::Joints;
use val3_moves::{Millimetres, MoveStage, PathShape, Seconds};

use crate::request::Move;
use crate::span::SpanPart;

/// Recorded move that is not done.
#[derive(Clone, Debug, PartialEq)]
pub struct QueuedMove {
    /// Serial number of the move, unique, in the order of recording.
    pub serial: u64,
    /// Id that `getMoveId` returns during the move.
    pub id: f64,
    /// Shape of the path.
    pub shape: PathShape,
    /// Tool centre point at the destination, in `world`.
    pub target: IsometryMatrix3<f64>,
    /// Intermediate point of a circle in `world`, in mm; `None` for other shapes.
    pub intermediate: Option<Vector3<f64>>,
    /// Joint position at the destination.
    pub joints: Joints,
    /// Start of the blend around the destination; `None` without a blend.
    pub leave: Option<BlendCorner>,
    /// End of the blend, on the path of the next move; `None` before the next move is recorded.
    pub reach: Option<BlendCorner>,
    /// Requested leave and reach of a blend that [`Motion::close`](crate::Motion::close) has cancelled.
    pub cancelled: Option<[Millimetres; 2]>,
    /// Stage of the execution.
    pub stage: MoveStage,
}

/// End of a blend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlendCorner {
    /// Requested distance to the destination.
    pub requested: Millimetres,
    /// Effective distance to the destination; 0 for a pure rotation.
    pub distance: Millimetres,
    /// Reason for a shorter distance than requested; `None` for the requested distance.
    pub shortening: Option<Shortening>,
    /// Tool centre point at this end, in `world`.
    pub position: Vector3<f64>,
}

impl BlendCorner {
    /// Distance to the destination from which the arm rounds the corner; 0 if the arm stops at the corner.
    #[must_use]
    pub fn effective(&self) -> Millimetres {
        match self.shortening {
            Some(Shortening::StopAtCorner) => Millimetres(0.0),
            _ => self.distance,
        }
    }
}

/// Reason for a shorter blend distance than requested. Moves are identified by their serial numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shortening {
    /// The move is too short for its leave and the reach of this previous move.
    SharedWithPrevious(u64),
    /// The next move is too short for the reach and its own leave.
    SharedWithNext(u64),
    /// The path of this move is shorter than the distance.
    ShortMove(u64),
    /// The other distance of the blend is 0, so the arm stops at the destination.
    StopAtCorner,
}

impl Shortening {
    /// Serial number of the move that causes the shortening.
    #[must_use]
    pub const fn cause(self) -> Option<u64> {
        match self {
            Self::SharedWithPrevious(serial) | Self::SharedWithNext(serial) | Self::ShortMove(serial) => Some(serial),
            Self::StopAtCorner => None,
        }
    }
}

/// Stage change of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoveEvent {
    /// Serial number of the move.
    pub serial: u64,
    /// Id of the move.
    pub id: f64,
    /// Kind of change.
    pub kind: MoveEventKind,
    /// Time since the start of the cycle.
    pub at: Seconds,
    /// Blend ends of the move, as in [`QueuedMove`].
    pub leave: Option<BlendCorner>,
    /// See `leave`.
    pub reach: Option<BlendCorner>,
    /// See [`QueuedMove::cancelled`].
    pub cancelled: Option<[Millimetres; 2]>,
}

/// Kind of a [`MoveEvent`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MoveEventKind {
    /// The arm begins to follow the path of the move.
    Started,
    /// The arm is at the leave point and begins the blend.
    Blend,
    /// The arm is at the reach point, on the path of the next move.
    Reached,
    /// The move is executed completely.
    Done,
}

impl MoveEventKind {
    /// Name in the event record.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Started => "started",
            Self::Blend => "blend",
            Self::Reached => "reached",
            Self::Done => "done",
        }
    }
}

/// Queue of the recorded moves.
#[derive(Clone, Debug, Default)]
pub(crate) struct Queue {
    moves: VecDeque<QueuedMove>,
    recorded: u64,
    events: Vec<MoveEvent>,
}

impl Queue {
    /// Serial number of the next move.
    pub(crate) fn next_serial(&self) -> u64 {
        self.recorded
    }

    /// Adds a move.
    pub(crate) fn record(&mut self, request: &Move, target: IsometryMatrix3<f64>, joints: Joints) {
        let (serial, id) = (self.recorded, request.id);
        self.recorded += 1;
        self.moves.push_back(QueuedMove {
            serial,
            id,
            shape: request.path.shape(),
            target,
            intermediate: request.path.intermediate().map(|pose| pose.translation.vector),
            joints,
            leave: None,
            reach: None,
            cancelled: None,
            stage: MoveStage::Recorded,
        });
    }

    /// Sets the previous blend's end and the blend start of a move whose path was determined.
    pub(crate) fn lay_out(&mut self, serial: u64, reach: Option<BlendCorner>, leave: Option<BlendCorner>) {
        if let (Some(reach), Some(before)) = (reach, self.open()) {
            before.reach = Some(reach);
        }
        if let Some(queued) = self.at(serial) {
            queued.leave = leave;
        }
    }

    /// Removes the blend of the last move; `requested` are its leave and reach.
    pub(crate) fn close(&mut self, requested: Option<[Millimetres; 2]>) {
        if let Some(last) = self.open() {
            last.leave = None;
            last.cancelled = requested;
        }
    }

    /// Move whose blend requires the next move. Moves of length 0 may follow it.
    fn open(&mut self) -> Option<&mut QueuedMove> {
        self.moves.iter_mut().rev().find(|queued| queued.leave.is_some()).filter(|queued| queued.reach.is_none())
    }

    pub(crate) fn moves(&self) -> impl ExactSizeIterator<Item = &QueuedMove> {
        self.moves.iter()
    }

    /// Removes all moves.
    pub(crate) fn forget(&mut self) {
        self.moves.clear();
    }

    pub(crate) fn take_events(&mut self) -> Vec<MoveEvent> {
        std::mem::take(&mut self.events)
    }

    /// Records that the arm has begun a part of the path.
    pub(crate) fn begin(&mut self, part: &SpanPart, at: Seconds) {
        match part {
            SpanPart::Nominal { serial, .. } => self.advance(*serial, MoveStage::Started, MoveEventKind::Started, at),
            SpanPart::Blend { from, .. } => {
                self.advance(from.serial, MoveStage::Started, MoveEventKind::Started, at);
                self.advance(from.serial, MoveStage::Blending, MoveEventKind::Blend, at);
            }
        }
    }

    /// Records that the arm has completed a part of the path. A nominal part ends at the move's destination.
    pub(crate) fn end(&mut self, part: &SpanPart, at: Seconds) {
        match part {
            SpanPart::Nominal { serial, .. } => self.finish(*serial, at),
            SpanPart::Blend { from, to } => {
                self.emit(from.serial, MoveEventKind::Reached, at);
                self.finish(from.serial, at);
                self.advance(to.serial, MoveStage::Started, MoveEventKind::Started, at);
            }
        }
    }

    /// Removes all moves as done, also moves of length 0, which have no part of the path.
    pub(crate) fn finish_all(&mut self, at: Seconds) {
        if let Some(last) = self.moves.back().map(|last| last.serial) {
            self.finish(last, at);
        }
    }

    /// Sets the stage of a move, and removes the moves before it as done.
    fn advance(&mut self, serial: u64, stage: MoveStage, kind: MoveEventKind, at: Seconds) {
        if let Some(before) = serial.checked_sub(1) {
            self.finish(before, at);
        }
        if let Some(queued) = self.at(serial).filter(|queued| queued.stage < stage) {
            queued.stage = stage;
            self.emit(serial, kind, at);
        }
    }

    /// Removes a move and the moves before it as done.
    fn finish(&mut self, serial: u64, at: Seconds) {
        while let Some(first) = self.moves.front().filter(|first| first.serial <= serial).map(|first| first.serial) {
            self.advance(first, MoveStage::Started, MoveEventKind::Started, at);
            self.emit(first, MoveEventKind::Done, at);
            self.moves.pop_front();
        }
    }

    fn emit(&mut self, serial: u64, kind: MoveEventKind, at: Seconds) {
        if let Some(&mut QueuedMove { id, leave, reach, cancelled, .. }) = self.at(serial) {
            self.events.push(MoveEvent { serial, id, kind, at, leave, reach, cancelled });
        }
    }

    /// Move with this serial number. Serial numbers are consecutive.
    fn at(&mut self, serial: u64) -> Option<&mut QueuedMove> {
        let first = self.moves.front()?.serial;
        self.moves.get_mut(usize::try_from(serial.checked_sub(first)?).ok()?)
    }
}
