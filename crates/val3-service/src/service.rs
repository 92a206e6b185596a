//! The service: requests of clients, executed between the cycles of a run.

use std::time::Duration;

use val3_soap::{ExceptionCode, SoapAnswer, SoapFault, SoapRequest};

use crate::accounts::Accounts;
use crate::context::{Context, ServiceState, ServiceTarget, refused};
use crate::requests;

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

/// Answers clients of a controller. The state outlives runs.
#[derive(Debug)]
pub struct Service {
    pub(crate) state: ServiceState,
}

impl Service {
    /// Service without sessions.
    #[must_use]
    pub fn new(accounts: Accounts) -> Self {
        Self { state: ServiceState::new(accounts) }
    }

    /// Answers a request. `now` is the time since the start of the service.
    pub fn answer(&mut self, call: &ServiceCall, target: &mut ServiceTarget<'_>, now: Duration) -> ServiceAnswer {
        let session = call.request.needs_session().then(|| self.state.sessions.resume(call.session, now));
        if session == Some(None) {
            let explanation = "log in, and send the number in the header of each request";
            let result = Err(refused(ExceptionCode::InvalidSessionId, explanation));
            return ServiceAnswer { session: call.session, result };
        }
        let session = session.flatten();
        let mut context = Context { state: &mut self.state, target, session, now };
        let result = requests::answer(&call.request, &mut context);
        let new = match &result {
            Ok(SoapAnswer::Login(login)) => Some(login.session),
            _ => None,
        };
        let session = new.or(call.session).or(session.map(|(id, _)| id)).or_else(|| self.state.sessions.only());
        ServiceAnswer { session, result }
    }
}
