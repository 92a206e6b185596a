//! All operations of the interface.

use crate::document::SoapElement;
use crate::error::SoapError;
use crate::server::SoapServer;
use crate::v0::{
    FindServer, GetControllerParameters, GetCs8Compatibility, GetCs8Versions, GetRobotJntCartPos, GetRobotJointPos,
    GetRobots, GetSoapServerVersion, Login, Logout, Ping, SetRobotJointPos,
};
use crate::v1::{GetApplicationDatas, GetApplications, GetJointRange, GetRecord, GetRecords};
use crate::v2::{
    ClearAllBreakpoints, ClearBreakpoints, ExecVal3, GetAllPhysicalIos, GetBreakpoints, GetCallStack, GetProject,
    GetRobotDhParameters, GetStackFrame, GetTasks, GetWatches, LoadProjectAsync, LockAllIos, LockIos, ReadIos,
    ReplaceLine, SetBreakpoints, SetCurrentInstruction, SetProjectAsModified, StartApplication, StopAndUnloadAll,
    StopApplication, SubscribeToControllerEvents, TaskKill, TaskResume, TaskStep, TaskSuspend, UnlockAllIos, UnlockIos,
    UnsubscribeToControllerEvents, WriteIos,
};
use crate::v3::{
    ForwardKin, MoveC, MoveJc, MoveJj, MoveL, ResetMotion, RestartMotion, ReverseKin, SchedulerRefresh, SetPower,
    SetSchedulingMode, StopMotion,
};
use crate::value::{Operation, SoapValue};

/// Declares the enumerations of all requests and answers.
macro_rules! operations {
    ($($request:ident,)*) => {
        /// Request of any operation.
        #[derive(Debug, Clone, PartialEq)]
        pub enum SoapRequest { $(#[allow(missing_docs, reason = "the operation has its page")] $request($request),)* }

        /// Answer of any operation.
        #[derive(Debug, Clone, PartialEq)]
        pub enum SoapAnswer {
            $(#[allow(missing_docs, reason = "the operation has its page")] $request(<$request as Operation>::Answer),)*
        }

        /// All operations: server and name.
        pub const OPERATIONS: &[(SoapServer, &str)] = &[$(($request::SERVER, $request::NAME),)*];

        impl SoapRequest {
            /// Reads the body of a request to a server.
            ///
            /// # Errors
            /// The server has no such operation, or a field is missing or has another type.
            pub fn read(server: SoapServer, body: &SoapElement) -> Result<Self, SoapError> {
                if body.namespace == server.namespace() {
                    $(if server == $request::SERVER && body.name == $request::NAME {
                        return $request::read(body).map(Self::$request);
                    })*
                }
                Err(SoapError::UnknownOperation { name: body.name.clone(), namespace: body.namespace.clone() })
            }

            /// Body of a message with this request.
            #[must_use]
            pub fn write(&self) -> SoapElement {
                match self { $(Self::$request(request) => request_body(request),)* }
            }

            /// Whether the operation requires a session.
            #[must_use]
            pub const fn needs_session(&self) -> bool {
                match self { $(Self::$request(_) => $request::NEEDS_SESSION,)* }
            }

            /// Name of the operation.
            #[must_use]
            pub const fn name(&self) -> &'static str {
                match self { $(Self::$request(_) => $request::NAME,)* }
            }
        }

        impl SoapAnswer {
            /// Reads the body of the answer to an operation of a server.
            ///
            /// # Errors
            /// The body is another answer, or a field is missing or has another type.
            pub fn read(server: SoapServer, operation: &str, body: &SoapElement) -> Result<Self, SoapError> {
                $(if server == $request::SERVER && operation == $request::NAME {
                    return read_answer::<$request>(body).map(Self::$request);
                })*
                Err(SoapError::UnknownOperation { name: operation.to_owned(), namespace: server.namespace().to_owned() })
            }

            /// Body of a message with this answer.
            #[must_use]
            pub fn write(&self) -> SoapElement {
                match self { $(Self::$request(answer) => written::<$request, _>($request::ANSWER, answer),)* }
            }
        }
    };
}

operations! {
    GetSoapServerVersion,
    FindServer,
    Ping,
    Login,
    Logout,
    GetCs8Versions,
    GetControllerParameters,
    GetCs8Compatibility,
    GetRobots,
    GetRobotJointPos,
    GetRobotJntCartPos,
    SetRobotJointPos,
    GetApplications,
    GetApplicationDatas,
    GetRecords,
    GetRecord,
    GetJointRange,
    GetTasks,
    TaskSuspend,
    TaskResume,
    TaskKill,
    TaskStep,
    SetBreakpoints,
    ClearBreakpoints,
    GetBreakpoints,
    ClearAllBreakpoints,
    GetCallStack,
    GetStackFrame,
    GetWatches,
    ExecVal3,
    SetCurrentInstruction,
    ReplaceLine,
    SetProjectAsModified,
    GetProject,
    SubscribeToControllerEvents,
    UnsubscribeToControllerEvents,
    ReadIos,
    WriteIos,
    LockIos,
    UnlockIos,
    LockAllIos,
    UnlockAllIos,
    GetAllPhysicalIos,
    GetRobotDhParameters,
    LoadProjectAsync,
    StartApplication,
    StopApplication,
    StopAndUnloadAll,
    ForwardKin,
    ReverseKin,
    MoveJj,
    MoveJc,
    MoveL,
    MoveC,
    ResetMotion,
    StopMotion,
    RestartMotion,
    SetSchedulingMode,
    SchedulerRefresh,
    SetPower,
}

/// Returns a message body with the request.
#[must_use]
pub fn request_body<O: Operation>(request: &O) -> SoapElement {
    written::<O, _>(O::NAME, request)
}

/// Returns a request or answer as an element in the operation's name space.
fn written<O: Operation, V: SoapValue>(name: &str, value: &V) -> SoapElement {
    let mut element = SoapElement::qualified(O::SERVER.namespace(), name);
    value.write(&mut element);
    element
}

/// Reads the body of the answer to a request.
///
/// # Errors
/// The body is another answer, or a field is missing or has another type.
pub fn read_answer<O: Operation>(body: &SoapElement) -> Result<O::Answer, SoapError> {
    if body.is(O::SERVER.namespace(), O::ANSWER) {
        return O::Answer::read(body);
    }
    Err(SoapError::Missing { name: O::ANSWER, parent: "Body".to_owned() })
}
