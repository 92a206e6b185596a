//! Moves of clients, such as those of the SOAP interface.
//!
//! Clients have a queue of their own, and so have programs. The arm executes one queue at a time, until its moves are
//! done. Meanwhile, a move of a program waits, and a move of a client is rejected. All other motion instructions of
//! programs act on the programs' queue, which is empty while the arm executes moves of clients.

use std::fmt;

use val3_kinematics::Joints;
use val3_lang::fault::Fault;
use val3_lang::ports::MoveRequest;
use val3_lang::runtime_errors;
use val3_motion::Cause;

use super::{Drive, RobotArm};

/// State of the queue of clients.
#[derive(Debug, Clone, Default)]
pub(super) struct ClientQueue {
    /// Id of the last move.
    last_id: i32,
    /// Whether a move was rejected since the last reset.
    is_blocked: bool,
    /// State of the queue of programs while the arm executes moves of clients.
    programs: Option<ProgramQueue>,
}

/// State of the queue of programs, which is empty.
#[derive(Debug, Clone)]
pub(super) struct ProgramQueue {
    /// Result of `getMoveId`.
    pub(super) move_id: f64,
    /// Whether `stopMove` holds the next moves.
    pub(super) is_stopped: bool,
    /// Start of the next move, set by `resetMotion`; `None` for the position of the arm.
    start: Option<Joints>,
}

impl ProgramQueue {
    /// `resetMotion`.
    pub(super) fn reset(&mut self, start: Option<Joints>) {
        *self = Self { move_id: 0.0, is_stopped: false, start };
    }
}

impl ClientQueue {
    /// State of the queue of programs; `None` if the arm executes this queue.
    pub(super) const fn programs(&self) -> Option<&ProgramQueue> {
        self.programs.as_ref()
    }

    /// Like [`Self::programs`], for a change.
    pub(super) const fn programs_mut(&mut self) -> Option<&mut ProgramQueue> {
        self.programs.as_mut()
    }
}

/// Command of a client for all its moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ClientCommand {
    /// Brakes on the path and discards the moves.
    Reset,
    /// Brakes on the path and holds the arm.
    Stop,
    /// Continues after a stop.
    Restart,
}

/// Reason why a request of a client for a motion is rejected.
#[derive(Debug, Clone, PartialEq)]
pub enum ClientMoveError {
    /// The working mode is not remote.
    NotRemote,
    /// The arm has no power.
    NoPower,
    /// The arm has moves of programs.
    OwnedByPrograms,
    /// A move was rejected, and the moves were not reset since.
    NotReset,
    /// The queue is full.
    Full,
    /// A field of the motion descriptor is invalid.
    Descriptor(Fault),
    /// The arm cannot execute the move or an earlier move.
    Impossible(Cause),
    /// Any other parameter is invalid; the text is the reason.
    Parameter(String),
}

impl fmt::Display for ClientMoveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotRemote => f.write_str("clients move the arm only in the remote mode"),
            Self::NoPower => f.write_str("the arm has no power"),
            Self::OwnedByPrograms => f.write_str("the arm has moves of the application that are not done"),
            Self::NotReset => f.write_str("a move was rejected before; reset the motion first"),
            Self::Full => f.write_str("too many moves are recorded; wait until one is done"),
            Self::Descriptor(Fault(code)) => {
                let error = runtime_errors::find(*code);
                f.write_str(error.map_or("the motion descriptor is invalid", |error| error.short))
            }
            Self::Impossible(cause) => cause.fmt(f),
            Self::Parameter(reason) => f.write_str(reason),
        }
    }
}

impl RobotArm {
    /// Whether the arm executes moves of clients.
    pub(crate) const fn has_client_moves(&self) -> bool {
        self.clients.programs.is_some()
    }

    /// Whether all recorded moves of programs are done (`isEmpty`).
    pub(crate) fn is_done_for_programs(&self) -> bool {
        self.has_client_moves() || self.motion.is_empty()
    }

    /// Whether programs have moves that are not done, or the arm has to return to their path.
    fn is_owned_by_programs(&self) -> bool {
        !self.has_client_moves() && (!self.motion.is_empty() || self.motion.connection().is_some())
    }

    /// Joint position at which the next move begins, in degrees or mm.
    #[must_use]
    pub fn next_start(&self) -> Joints {
        self.motion.destination()
    }

    /// Checks that clients may record a move.
    pub(crate) fn check_client_queue(&self) -> Result<(), ClientMoveError> {
        match () {
            () if self.is_owned_by_programs() => Err(ClientMoveError::OwnedByPrograms),
            () if self.clients.is_blocked => Err(ClientMoveError::NotReset),
            () if self.is_full() => Err(ClientMoveError::Full),
            () => Ok(()),
        }
    }

    /// Records a move of a client. Returns its id, from 1.
    ///
    /// # Errors
    /// The arm cannot execute the move or an earlier move. All further moves are rejected until the reset.
    pub(crate) fn record_client_move(&mut self, request: &MoveRequest) -> Result<i32, ClientMoveError> {
        self.begin_client_moves();
        let id = self.clients.last_id.checked_add(1).unwrap_or(1);
        if let Err(cause) = self.append(request, f64::from(id), None) {
            self.end_client_moves();
            return Err(ClientMoveError::Impossible(cause));
        }
        self.clients.last_id = id;
        Ok(id)
    }

    /// Rejects all moves of clients until the reset.
    pub(crate) const fn block_clients(&mut self) {
        self.clients.is_blocked = true;
    }

    /// Executes a command of a client. The moves of an application without tasks are reset too, because nothing else
    /// would release the arm. Returns whether the command had an effect.
    ///
    /// # Errors
    /// The arm has moves of programs.
    pub(crate) fn command_by_client(
        &mut self,
        command: ClientCommand,
        has_tasks: bool,
    ) -> Result<bool, ClientMoveError> {
        let is_owned = self.is_owned_by_programs();
        if is_owned && (has_tasks || command != ClientCommand::Reset) {
            return Err(ClientMoveError::OwnedByPrograms);
        }
        let (has_moves, is_stopped) = (self.has_client_moves() || is_owned, self.motion.is_stopped());
        let has_effect = match command {
            ClientCommand::Reset => has_moves,
            ClientCommand::Stop => has_moves && !is_stopped,
            ClientCommand::Restart => has_moves && is_stopped,
        };
        match command {
            ClientCommand::Reset => {
                self.clients.is_blocked = false;
                if has_moves {
                    self.motion.reset();
                    self.origins.clear();
                }
                self.end_client_moves();
            }
            ClientCommand::Stop if has_effect => self.motion.stop(),
            ClientCommand::Restart if has_effect => self.motion.restart(),
            ClientCommand::Stop | ClientCommand::Restart => {}
        }
        Ok(has_effect)
    }

    /// Drive for the queue that the arm executes: moves of clients need the remote mode.
    pub(super) const fn drive_of_queue(&self, drive: Drive) -> Drive {
        let may_move = drive.may_move && !(self.has_client_moves() && drive.is_attended);
        Drive { may_move, ..drive }
    }

    /// Sets the queue of programs aside.
    fn begin_client_moves(&mut self) {
        if self.has_client_moves() {
            return;
        }
        let (move_id, is_stopped) = (self.motion.move_id(), self.motion.is_stopped());
        self.clients.programs = Some(ProgramQueue { move_id, is_stopped, start: None });
        self.motion.restart();
    }

    /// Continues with the queue of programs if the moves of clients are done.
    pub(super) fn end_client_moves(&mut self) {
        let Some(ProgramQueue { move_id, is_stopped, start }) =
            self.clients.programs.take_if(|_| self.motion.is_empty())
        else {
            return;
        };
        self.motion.restart();
        if let Some(start) = start {
            self.motion.reset_to(start);
        }
        self.motion.set_done_id(move_id);
        if is_stopped {
            self.motion.stop();
        }
    }
}

#[cfg(test)]
mod tests;
