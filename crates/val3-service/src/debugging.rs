//! Debugging by a client: the owner of the debugger, and breakpoints.

use val3_debug::{Breakpoint, BreakpointId, Debugger};
use val3_soap::v2::{BreakpointResponse, ProgramLine};
use val3_soap::{ExceptionCode, SoapFault};

use crate::context::{Context, refused};
use crate::inferred::BREAKPOINT_SET;
use crate::lines::FileLine;

/// Debugging state of a service.
#[derive(Debug, Default)]
pub(crate) struct Debugging {
    /// Session that debugs.
    pub(crate) owner: Option<i32>,
    pub(crate) breakpoints: Vec<ClientBreakpoint>,
    last: u32,
}

/// Breakpoint of a client.
#[derive(Debug, Clone)]
pub(crate) struct ClientBreakpoint {
    id: BreakpointId,
    pub(crate) at: FileLine,
    /// Line as the client has named it.
    pub(crate) line: ProgramLine,
}

impl Debugging {
    /// Sets a breakpoint. A second breakpoint at a line has no effect.
    ///
    /// # Errors
    /// No task can stop at the line.
    pub(crate) fn set(&mut self, at: FileLine, line: ProgramLine, debugger: &mut Debugger) -> Result<(), SoapFault> {
        if self.breakpoints.iter().any(|breakpoint| breakpoint.at == at) {
            return Ok(());
        }
        self.last = self.last.wrapping_add(1);
        let id = BreakpointId(self.last);
        let (file, row) = (at.file.clone(), at.row);
        self.breakpoints.push(ClientBreakpoint { id, at, line });
        if self.apply(&file, debugger).contains(&(id, Some(row))) {
            debugger.stop_tasks_alone(true);
            return Ok(());
        }
        self.breakpoints.pop();
        self.apply(&file, debugger);
        Err(refused(ExceptionCode::ProgramLineNotFound, "no task can stop at the line, because it has no instruction"))
    }

    /// Removes the breakpoint at a line. Returns whether there was one.
    pub(crate) fn clear(&mut self, at: &FileLine, debugger: &mut Debugger) -> bool {
        let before = self.breakpoints.len();
        self.breakpoints.retain(|breakpoint| breakpoint.at != *at);
        self.apply(&at.file, debugger);
        self.breakpoints.len() < before
    }

    /// Removes all breakpoints.
    pub(crate) fn clear_all(&mut self, debugger: &mut Debugger) {
        for breakpoint in std::mem::take(&mut self.breakpoints) {
            self.apply(&breakpoint.at.file, debugger);
        }
    }

    /// Passes the breakpoints of a file to the debugger. Returns their rows in memory.
    fn apply(&self, file: &str, debugger: &mut Debugger) -> Vec<(BreakpointId, Option<u32>)> {
        let of_file = self.breakpoints.iter().filter(|breakpoint| breakpoint.at.file == file);
        let breakpoints = of_file.map(|breakpoint| Breakpoint::new(breakpoint.id, breakpoint.at.row)).collect();
        debugger.set_breakpoints(file, breakpoints).into_iter().map(|placed| (placed.id, placed.row)).collect()
    }
}

/// Responses for changed breakpoints, in the order of the request.
pub(crate) fn breakpoint_responses(results: Vec<Result<(), SoapFault>>) -> Vec<BreakpointResponse> {
    let codes = results.into_iter().map(breakpoint_code);
    codes.zip(0..).map(|(code, index)| BreakpointResponse { index, code }).collect()
}

/// Code of the response for a changed breakpoint.
fn breakpoint_code(result: Result<(), SoapFault>) -> ExceptionCode {
    result.err().and_then(|fault| fault.exception).map_or(BREAKPOINT_SET, |exception| exception.code)
}

impl Context<'_, '_> {
    /// Makes the session the only session that debugs.
    ///
    /// # Errors
    /// Another session debugs.
    pub(crate) fn debug(&mut self) -> Result<(), SoapFault> {
        let session = self.session.map(|(id, _)| id);
        let state = &mut *self.state;
        match state.debugging.owner {
            Some(owner) if Some(owner) != session && state.sessions.is_open(owner, self.now) => {
                Err(refused(ExceptionCode::ClientAlreadyConnected, "another session debugs"))
            }
            _ => {
                state.debugging.owner = session;
                Ok(())
            }
        }
    }
}
