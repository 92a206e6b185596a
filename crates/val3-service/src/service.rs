//! The service: requests of clients, executed between the cycles of a run.

use std::time::Duration;

use val3_debug::Debugger;
use val3_machine::controller::Controller;
use val3_session::{FrameEvaluator, ProfileRights};
use val3_soap::{ExceptionCode, SoapAnswer, SoapFault, SoapRequest};

use crate::accounts::Accounts;
use crate::debugging::Debugging;
use crate::requests;
use crate::sessions::Sessions;

/// Request of a client.
#[derive(Debug, Clone, PartialEq)]
pub struct ServiceCall {
    /// Session in the header; `None` without.
    pub session: Option<i32>,
    /// Request.
    pub request: SoapRequest,
}

/// Answer to a client.
#[derive(Debug, Clone, PartialEq)]
pub struct ServiceAnswer {
    /// Session for the header. Clients take the header of the last answer for their next request.
    pub session: Option<i32>,
    /// Answer, or the reason of a rejection.
    pub result: Result<SoapAnswer, SoapFault>,
}

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

/// Answers clients of a controller. The state outlives runs.
#[derive(Debug)]
pub struct Service {
    pub(crate) accounts: Accounts,
    pub(crate) sessions: Sessions,
    pub(crate) debugging: Debugging,
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

/// Request in execution: the service, the run and the session.
pub(crate) struct Context<'s, 't> {
    pub(crate) service: &'s mut Service,
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

impl Service {
    /// Service without sessions.
    #[must_use]
    pub fn new(accounts: Accounts) -> Self {
        Self { accounts, sessions: Sessions::default(), debugging: Debugging::default() }
    }

    /// Answers a request. `now` is the time since the start of the service.
    pub fn answer(&mut self, call: &ServiceCall, target: &mut ServiceTarget<'_>, now: Duration) -> ServiceAnswer {
        let session = call.request.needs_session().then(|| self.sessions.resume(call.session, now));
        if session == Some(None) {
            let explanation = "log in, and send the number in the header of each request";
            let result = Err(refused(ExceptionCode::InvalidSessionId, explanation));
            return ServiceAnswer { session: call.session, result };
        }
        let session = session.flatten();
        let mut context = Context { service: self, target, session, now };
        let result = requests::answer(&call.request, &mut context);
        let new = match &result {
            Ok(SoapAnswer::Login(login)) => Some(login.session),
            _ => None,
        };
        let session = new.or(call.session).or(session.map(|(id, _)| id)).or_else(|| self.sessions.only());
        ServiceAnswer { session, result }
    }
}
