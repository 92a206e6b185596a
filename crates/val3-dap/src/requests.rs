//! Requests of a session: one file for each request, one line here.

mod breakpoint_locations;
mod cancel;
mod completions;
mod configuration_done;
mod continue_run;
mod data_breakpoint_info;
mod disconnect;
mod end_call;
mod evaluate;
mod exception_info;
mod goto;
mod goto_targets;
mod history;
mod io;
mod io_force;
mod jog;
mod key;
mod loaded_sources;
mod modules;
mod motion_mode;
mod motion_queue;
mod motion_step;
mod next;
mod operate;
mod past;
mod pause;
mod pose;
mod restart;
mod restart_frame;
mod reverse_continue;
mod scopes;
mod set_breakpoints;
mod set_data_breakpoints;
mod set_exception_breakpoints;
mod set_expression;
mod set_function_breakpoints;
mod set_variable;
mod stack_trace;
mod step_back;
mod step_back_into;
mod step_back_out;
mod step_in;
mod step_in_targets;
mod step_out;
mod subscribe;
mod table;
mod terminate;
mod terminate_threads;
mod threads;
mod user_page;
mod variable_filter;
mod variables;
mod view;

use schemars::JsonSchema;
use serde::de::{DeserializeOwned, Error as _};
use serde_json::{Map, Value};
use val3_schema::{NameConflict, RequestSchema, RequestWords};

use crate::debugged_run::DebuggedRun;
use crate::error::RequestError;
use crate::failure::RequestFailure;
use crate::protocol::{StandardRequest, content};
use crate::request::DebugRequest;
use crate::session::DebugSession;

use Effect::{ChangesRun, Inspects, MayChangeRun, NeedsStop, Steers};

/// Effect of a request on the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Effect {
    /// No effect.
    Inspects,
    /// Stops, resumes or ends the run, or changes where it stops. Data, inputs and the arm are unchanged.
    Steers,
    /// Like `Steers`, and rejected with `notStopped` unless the run is stopped.
    NeedsStop,
    /// Changes data, inputs or the arm if it succeeds. Later recorded events are then discarded.
    ChangesRun,
    /// Changes the run only in some cases, in which the request calls [`DebugSession::run_changed`].
    MayChangeRun,
}

/// Function that executes a request with undecoded arguments. It returns the body, if there is one.
type Answer =
    fn(&mut DebugSession, &mut DebuggedRun<'_>, Option<Value>, Effect) -> Result<Option<Value>, RequestFailure>;

/// Entry in the list of requests.
pub(crate) struct RequestHandler {
    command: &'static str,
    effect: Effect,
    answer: Answer,
    /// Schema of a request `val3/…`.
    schema: Option<fn() -> RequestSchema>,
}

/// All requests. A [`Handshake`](crate::Handshake) handles `initialize`, `launch` and `attach`.
static REQUESTS: &[RequestHandler] = &[
    standard::<breakpoint_locations::BreakpointLocations>(Inspects),
    standard::<threads::Threads>(Inspects),
    standard::<stack_trace::StackTrace>(Inspects),
    standard::<scopes::Scopes>(Inspects),
    standard::<variables::Variables>(Inspects),
    standard::<step_in_targets::StepInTargets>(Inspects),
    standard::<exception_info::ExceptionInfo>(Inspects),
    standard::<loaded_sources::LoadedSources>(Inspects),
    standard::<modules::Modules>(Inspects),
    standard::<completions::Completions>(Inspects),
    standard::<goto_targets::GotoTargets>(Inspects),
    standard::<data_breakpoint_info::DataBreakpointInfo>(Inspects),
    standard::<configuration_done::ConfigurationDone>(Steers),
    standard::<set_breakpoints::SetBreakpoints>(Steers),
    standard::<set_function_breakpoints::SetFunctionBreakpoints>(Steers),
    standard::<set_data_breakpoints::SetDataBreakpoints>(Steers),
    standard::<set_exception_breakpoints::SetExceptionBreakpoints>(Steers),
    standard::<continue_run::Continue>(Steers),
    standard::<next::Next>(Steers),
    standard::<step_in::StepIn>(Steers),
    standard::<step_out::StepOut>(Steers),
    standard::<pause::Pause>(Steers),
    standard::<goto::Goto>(Steers),
    standard::<restart::Restart>(Steers),
    standard::<terminate::Terminate>(Steers),
    standard::<disconnect::Disconnect>(Steers),
    standard::<cancel::Cancel>(Steers),
    standard::<step_back::StepBack>(NeedsStop),
    standard::<reverse_continue::ReverseContinue>(NeedsStop),
    standard::<restart_frame::RestartFrame>(NeedsStop),
    standard::<terminate_threads::TerminateThreads>(ChangesRun),
    standard::<set_variable::SetVariable>(ChangesRun),
    standard::<set_expression::SetExpression>(ChangesRun),
    standard::<evaluate::Evaluate>(MayChangeRun),
    own::<step_back_into::StepBackInto>(NeedsStop),
    own::<step_back_out::StepBackOut>(NeedsStop),
    own::<end_call::EndCall>(Steers),
    own::<motion_mode::MotionModeRequest>(Steers),
    own::<motion_step::MotionStep>(NeedsStop),
    own::<motion_queue::MotionQueue>(Inspects),
    own::<pose::Pose>(Inspects),
    own::<io::Io>(Inspects),
    own::<io_force::IoForce>(ChangesRun),
    own::<jog::Jog>(ChangesRun),
    own::<key::Key>(ChangesRun),
    own::<user_page::UserPageRequest>(Inspects),
    own::<operate::Operate>(ChangesRun),
    own::<past::Past>(Inspects),
    own::<history::History>(NeedsStop),
    own::<table::Table>(Inspects),
    own::<variable_filter::VariableFilterRequest>(Inspects),
    own::<subscribe::Subscribe>(Inspects),
    own::<view::View>(ChangesRun),
];

/// A request of the specification. Unknown arguments are ignored.
const fn standard<R: DebugRequest>(effect: Effect) -> RequestHandler {
    RequestHandler {
        command: R::COMMAND,
        effect,
        answer: |session, run, arguments, effect| answer::<R>(session, run, content(arguments), effect),
        schema: None,
    }
}

/// A request `val3/…`, whose arguments and body have a JSON schema. Unknown arguments are rejected.
const fn own<R: DebugRequest<Arguments: JsonSchema, Body: JsonSchema>>(effect: Effect) -> RequestHandler {
    RequestHandler {
        command: R::COMMAND,
        effect,
        answer: |session, run, arguments, effect| answer::<R>(session, run, own_arguments(arguments), effect),
        schema: Some(|| RequestSchema::of::<R::Arguments, R::Body>(R::COMMAND)),
    }
}

impl RequestHandler {
    /// Executes the request, and reports the change of the run.
    ///
    /// # Errors
    /// The arguments are invalid, the run is not stopped, or the request fails.
    pub(crate) fn answer(
        &self,
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: Option<Value>,
    ) -> Result<Option<Value>, RequestFailure> {
        (self.answer)(session, run, arguments, self.effect)
    }
}

fn answer<R: DebugRequest>(
    session: &mut DebugSession,
    run: &mut DebuggedRun<'_>,
    arguments: serde_json::Result<R::Arguments>,
    effect: Effect,
) -> Result<Option<Value>, RequestFailure> {
    let malformed = |reason| RequestError::Arguments { command: R::COMMAND.to_owned(), reason };
    let arguments = arguments.map_err(malformed)?;
    if effect == NeedsStop {
        session.check_stopped()?;
    }
    let plain = if session.start.is_plain_run { R::in_plain_run(&arguments) } else { None };
    let body = match plain {
        Some(body) => body,
        None => R::answer(session, run, arguments)?,
    };
    if effect == ChangesRun {
        session.run_changed(run);
    }
    let body = serde_json::to_value(body).map_err(RequestFailure::rejected)?;
    Ok(Some(body).filter(|body| !body.is_null()))
}

/// Returns the JSON schema of all requests `val3/…`: arguments and bodies, by command.
///
/// # Errors
/// Two types have the same name and different schemas.
pub fn debug_requests_schema() -> Result<Value, NameConflict> {
    const WORDS: RequestWords = RequestWords {
        requests: "DebugRequests",
        received: "arguments",
        sent: "body",
        description: "Arguments and bodies of the requests `val3/…`, by command.",
    };
    WORDS.schema(REQUESTS.iter().filter_map(|handler| handler.schema).map(|schema| schema()))
}

/// Returns the handler of a command; `None` if no session has the request.
pub(crate) fn find(command: &str) -> Option<&'static RequestHandler> {
    REQUESTS.iter().find(|handler| handler.command == command)
}

/// Returns the reason why a session has no handler of a command.
pub(crate) fn unsupported(command: &str, arguments: Option<Value>) -> RequestFailure {
    match StandardRequest::parse(command, arguments) {
        Err(error) => error.into(),
        Ok(StandardRequest::Initialize(_) | StandardRequest::Launch(_) | StandardRequest::Attach(_)) => {
            RequestFailure::SessionHasBegun(command.to_owned())
        }
        Ok(_) => RequestFailure::Unsupported(command.to_owned()),
    }
}

/// Decodes the arguments of a request `val3/…`.
///
/// # Errors
/// An argument is unknown, missing or has another type. The message contains its name.
fn own_arguments<T: DeserializeOwned>(arguments: Option<Value>) -> serde_json::Result<T> {
    let arguments: Map<String, Value> = content(arguments)?;
    serde_json::from_value(Value::Object(arguments.clone())).map_err(|error| {
        let reason = error.to_string();
        match wrong_argument::<T>(&arguments, &reason) {
            Some(name) if !reason.contains(&format!("`{name}`")) => {
                serde_json::Error::custom(format!("`{name}`: {reason}"))
            }
            _ => error,
        }
    })
}

/// Returns the argument that causes the error: without it, decoding succeeds or fails for another reason.
fn wrong_argument<'a, T: DeserializeOwned>(arguments: &'a Map<String, Value>, reason: &str) -> Option<&'a str> {
    let wrong = arguments.keys().find(|name| {
        let mut others = arguments.clone();
        others.remove(*name);
        serde_json::from_value::<T>(Value::Object(others)).err().is_none_or(|error| error.to_string() != reason)
    });
    wrong.map(String::as_str)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_request_outside_the_specification_has_a_schema() {
        let schema = debug_requests_schema().unwrap();
        let described = schema["$defs"]["DebugRequests"]["properties"].as_object().unwrap();
        let own = || REQUESTS.iter().map(|handler| handler.command).filter(|command| command.starts_with("val3/"));
        assert_eq!(own().count(), described.len());
        assert!(own().all(|command| described.contains_key(command)), "{described:?}");
    }
}
