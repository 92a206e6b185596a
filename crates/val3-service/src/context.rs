//! State of a service, and the context in which it executes a request.

use std::collections::BTreeSet;
use std::time::Duration;

use val3_debug::Debugger;
use val3_machine::controller::{Controller, OperatorAction};
use val3_session::{FrameEvaluator, ProfileRights};
use val3_soap::{ExceptionCode, SoapFault};

use crate::accounts::Accounts;
use crate::debugging::Debugging;
use crate::sessions::Sessions;

/// Run on which requests are executed.
pub struct ServiceTarget<'a> {
    /// Controller with its debugger.
    pub debugger: &'a mut Debugger,
    /// Evaluator of code in stack frames.
    pub evaluator: &'a mut FrameEvaluator,
}

impl ServiceTarget<'_> {
    /// The controller.
    pub(crate) fn controller(&mut self) -> &mut Controller {
        &mut self.debugger.controller
    }
}

/// State of a service, which outlives runs.
#[derive(Debug)]
pub(crate) struct ServiceState {
    pub(crate) accounts: Accounts,
    pub(crate) sessions: Sessions,
    pub(crate) debugging: Debugging,
    /// Names of the projects in memory that clients have changed.
    pub(crate) modified: BTreeSet<String>,
}

impl ServiceState {
    /// State without sessions.
    pub(crate) fn new(accounts: Accounts) -> Self {
        Self { accounts, sessions: Sessions::default(), debugging: Debugging::default(), modified: BTreeSet::new() }
    }
}

/// Right that a request requires.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Right {
    /// None.
    None,
    /// Reading.
    Read,
    /// Changing applications and tasks, and placing the arm.
    Write,
    /// Changing signals.
    WriteIo,
}

/// Request in execution: the state of the service, the run and the session.
pub(crate) struct Context<'s, 't> {
    pub(crate) state: &'s mut ServiceState,
    pub(crate) target: &'s mut ServiceTarget<'t>,
    /// Session of the request; `None` for requests that need none.
    pub(crate) session: Option<(i32, ProfileRights)>,
    /// Time since the start of the service.
    pub(crate) now: Duration,
}

impl Context<'_, '_> {
    /// Checks that the profile of the session has a right.
    pub(crate) fn check_right(&self, right: Right) -> Result<(), SoapFault> {
        let rights = self.session.map_or(ProfileRights::ALL, |(_, rights)| rights);
        match right {
            Right::Read if !rights.read => Err(refused(ExceptionCode::ReadAccess, "the profile may not read")),
            Right::Write if !rights.write => Err(refused(ExceptionCode::WriteAccess, "the profile may not write")),
            Right::WriteIo if !rights.write_io => {
                Err(refused(ExceptionCode::IoWriteAccess, "the profile may not write signals"))
            }
            Right::None | Right::Read | Right::Write | Right::WriteIo => Ok(()),
        }
    }

    /// The controller.
    pub(crate) fn controller(&mut self) -> &mut Controller {
        self.target.controller()
    }

    /// Adds actions of the operator before the next cycle. An action that needs a stopped application waits for it.
    pub(crate) fn operate(&mut self, actions: &[OperatorAction]) {
        let controller = self.controller();
        actions.iter().for_each(|action| controller.operate(*action));
    }

    /// Checks the index of a robot. A controller has one.
    pub(crate) fn check_robot(&self, robot: i32) -> Result<(), SoapFault> {
        if robot == 0 {
            return Ok(());
        }
        Err(refused(ExceptionCode::InvalidRobotId, "the controller has only robot 0"))
    }
}

/// Fault with a code and a short explanation.
pub(crate) fn refused(code: ExceptionCode, explanation: &str) -> SoapFault {
    SoapFault::exception(code, explanation)
}
