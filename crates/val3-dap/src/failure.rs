//! Reasons why a request fails.

use std::fmt;

use crate::error::RequestError;

/// Reason why a request fails.
#[derive(Debug)]
pub(crate) enum RequestFailure {
    /// The client has cancelled the request.
    Cancelled,
    /// The request needs a stopped run.
    NotStopped,
    /// The command is unknown, or the arguments have another type.
    Malformed(RequestError),
    /// The command is a request of the handshake.
    SessionHasBegun(String),
    /// The specification has the command, but this adapter does not.
    Unsupported(String),
    /// No task has the thread id.
    NoSuchTask,
    /// No run-time error has stopped the task.
    NoError,
    /// A handle of a previous stop.
    Stale,
    /// No loaded application has the file.
    NotLoaded,
    /// No application is loaded.
    NoApplication,
    /// The property with this name is no data of a program.
    NoData(String),
    /// The run belongs to another client.
    AttachedRestart,
    /// The debug console has called no program in the task.
    NoCall,
    /// The run has no history.
    NotRecorded,
    /// The motion is not in step mode.
    NoStepMode,
    /// The next motion depends on the next line.
    NoMotion,
    /// A page cannot pause the run, because the debugger does.
    DebuggerPaces,
    /// The next line has no target with this id.
    NoStepInTarget(i32),
    /// No argument is set. Contains the argument names.
    NoArgument(&'static str),
    /// Another reason, as a sentence without a full stop.
    Rejected(String),
}

impl RequestFailure {
    /// Converts an error from a different crate.
    pub(crate) fn rejected(error: impl fmt::Display) -> Self {
        Self::Rejected(error.to_string())
    }

    /// Returns the word that the protocol predefines for `Response.message`. Clients do not show it to users.
    const fn word(&self) -> Option<&'static str> {
        match self {
            Self::Cancelled => Some("cancelled"),
            Self::NotStopped => Some("notStopped"),
            _ => None,
        }
    }
}

impl fmt::Display for RequestFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(word) = self.word() {
            return f.write_str(word);
        }
        f.write_str(match self {
            Self::Malformed(error) => return error.fmt(f),
            Self::SessionHasBegun(command) => {
                return write!(f, "the session has begun, so that `{command}` comes too late");
            }
            Self::Unsupported(command) => return write!(f, "this adapter does not have the request `{command}`"),
            Self::NoData(name) => return write!(f, "`{name}` is not data of a program; use `val3/operate`"),
            Self::NoStepInTarget(id) => {
                return write!(f, "the next line has no step-in target {id}: request `stepInTargets` again");
            }
            Self::NoArgument(names) => return write!(f, "set {names}"),
            Self::Rejected(reason) => reason,
            Self::Cancelled | Self::NotStopped => "",
            Self::NoSuchTask => "there is no such task any more",
            Self::NoError => "no run-time error has stopped this task",
            Self::Stale => "this belongs to a stop that is over",
            Self::NotLoaded => "the application has loaded no program of this file",
            Self::NoApplication => "no application is in memory",
            Self::AttachedRestart => "a run that a client has attached to cannot be restarted: start it again",
            Self::NoCall => "the debug console has called no program in this task",
            Self::NotRecorded => "the run is not recorded",
            Self::NoStepMode => "the motion is not in step mode: change it with `val3/motionMode`",
            Self::NoMotion => "no further motion is determined: execute the next line",
            Self::DebuggerPaces => "the debugger stops and continues the run",
        })
    }
}

impl From<RequestError> for RequestFailure {
    fn from(error: RequestError) -> Self {
        Self::Malformed(error)
    }
}
