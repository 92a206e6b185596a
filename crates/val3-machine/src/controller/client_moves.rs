//! Motion by clients, such as those of the SOAP interface: moves in their own queue, in the remote mode.

use serde_json::{Map, Value, json};
use val3_lang::ports::MoveRequest;

use super::Controller;
use crate::arm::{ClientCommand, ClientMoveError};
use crate::blend_ends::BlendEnds;
use crate::controller_state::{MessageSeverity, WorkingMode};
use crate::event::EventKind;

impl Controller {
    /// Checks that a client may record a move now.
    ///
    /// # Errors
    /// The mode, the power or the state of the queues does not permit it.
    pub fn check_client_move(&self) -> Result<(), ClientMoveError> {
        let state = &self.devices.state;
        self.check_remote()?;
        if !state.robot.is_powered() || state.robot.is_power_being_cut() {
            return Err(ClientMoveError::NoPower);
        }
        state.arm.check_client_queue()
    }

    /// Records a move of a client, whose descriptor is checked here. Returns its id, from 1.
    ///
    /// # Errors
    /// The move is not permitted now, or it is impossible. An impossible move is reported in the event log, and all
    /// further moves are rejected until the reset.
    pub fn record_client_move(&mut self, request: MoveRequest) -> Result<i32, ClientMoveError> {
        self.check_client_move()?;
        if let Some(text) = self.devices.state.arm.take_notice() {
            self.devices.record_outside(self.now(), EventKind::Notice { text });
        }
        let instruction = request.instruction;
        let checked = request.descriptor.checked(1.0).map_err(ClientMoveError::Descriptor);
        let arm = &mut self.devices.state.arm;
        let recorded = checked.and_then(|descriptor| arm.record_client_move(&MoveRequest { descriptor, ..request }));
        let id = recorded.map_err(|error| self.reject_client_move(instruction, error))?;
        let arm = &self.devices.state.arm;
        let joints = arm.next_start().get(..arm.model().axes()).map(<[f64]>::to_vec);
        let last = arm.moves().last();
        let blend = last.map(|(queued, origin)| self.devices.blend_of(queued, origin)).unwrap_or_default();
        self.record_client_action(json!({ "type": instruction, "joints": joints }));
        self.record_client_event("recorded", instruction, f64::from(id), blend);
        Ok(id)
    }

    /// Reports an impossible move of a client in the event log, and rejects all moves until the reset. Returns the
    /// reason.
    pub fn reject_client_move(&mut self, instruction: &str, error: ClientMoveError) -> ClientMoveError {
        let text = format!("{instruction} of a client: {error}");
        self.devices.report(&text, MessageSeverity::Warning, self.now());
        self.devices.state.arm.block_clients();
        error
    }

    /// Executes a command of a client for all its moves. `name` is the name of its request.
    ///
    /// # Errors
    /// The working mode is not remote, or the arm has moves of programs.
    pub fn command_client_moves(&mut self, command: ClientCommand, name: &'static str) -> Result<(), ClientMoveError> {
        self.check_remote()?;
        let has_tasks = !self.vm.tasks().is_empty();
        let arm = &mut self.devices.state.arm;
        let id = arm.sample().id;
        if arm.command_by_client(command, has_tasks)? {
            let phase = match command {
                ClientCommand::Reset => "reset",
                ClientCommand::Stop => "stopped",
                ClientCommand::Restart => "restarted",
            };
            self.record_client_action(json!({ "type": name }));
            self.record_client_event(phase, name, id, BlendEnds::default());
        }
        Ok(())
    }

    fn check_remote(&self) -> Result<(), ClientMoveError> {
        match self.devices.state.robot.working_mode() {
            WorkingMode::Remote => Ok(()),
            _ => Err(ClientMoveError::NotRemote),
        }
    }

    fn record_client_action(&mut self, action: Value) {
        let keys = Map::from_iter([("clientMove".to_owned(), action)]);
        self.devices.record_outside(self.now(), EventKind::Act { keys });
    }

    fn record_client_event(&mut self, phase: &'static str, instruction: &'static str, id: f64, blend: BlendEnds) {
        let kind = EventKind::Move { id, phase, instruction, program: String::new(), line: 0, blend, target: None };
        self.devices.record_outside(self.now(), kind);
    }
}
