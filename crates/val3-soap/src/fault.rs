//! Faults: the answer to a request that the controller rejects.

use std::fmt::Display;

use crate::document::{SoapElement, XML};
use crate::error::SoapError;
use crate::server::SoapServer;
use crate::structure::{enumeration, structure};
use crate::value::SoapValue as _;
use crate::version::SoapVersion;

/// Party that has to change something before the request can succeed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Culprit {
    /// The client.
    Client,
    /// The controller.
    Server,
    /// The client, because the controller does not support the SOAP version.
    Version,
    /// The client, because the controller does not support a header.
    Header,
}

impl Culprit {
    /// All parties.
    const ALL: [Self; 4] = [Self::Client, Self::Server, Self::Version, Self::Header];

    /// Code of a fault in a SOAP version.
    const fn code(self, version: SoapVersion) -> &'static str {
        match (self, version) {
            (Self::Client, SoapVersion::V11) => "Client",
            (Self::Client, SoapVersion::V12) => "Sender",
            (Self::Server, SoapVersion::V11) => "Server",
            (Self::Server, SoapVersion::V12) => "Receiver",
            (Self::Version, _) => "VersionMismatch",
            (Self::Header, _) => "MustUnderstand",
        }
    }

    /// Party of a code in a SOAP version. Points refine a code of SOAP 1.1 (`Client.Authentication`, 4.4.1).
    fn of_code(code: &str, version: SoapVersion) -> Option<Self> {
        let code = match version {
            SoapVersion::V11 => code.split('.').next().unwrap_or(code),
            SoapVersion::V12 if code == "DataEncodingUnknown" => return Some(Self::Client),
            SoapVersion::V12 => code,
        };
        Self::ALL.into_iter().find(|culprit| culprit.code(version) == code)
    }
}

/// SOAP fault, which replaces the answer in the body.
#[derive(Debug, Clone, PartialEq)]
pub struct SoapFault {
    /// Party that has to change something.
    pub culprit: Culprit,
    /// Reason, in English.
    pub reason: String,
    /// Code and description of the controller; `None` for a message that is no request.
    pub exception: Option<ServerException>,
}

structure! {
    /// Detail of a fault.
    ServerException {
        /// Code of the controller.
        code: ExceptionCode = "code",
        /// Description for people. Some clients understand the code only without a description.
        description: Option<String> = "description",
    }
}

enumeration! {
    /// Code of a fault, in the order of the numbers in the stubs of clients.
    ExceptionCode {
        /// No other code; also the code of a breakpoint that was set (inferred).
        Unknown = "UNKNOWN-CODE",
        /// The session does not exist.
        InvalidSessionId = "INVALID-SESSION-ID-CODE",
        /// The controller has no robot with this index.
        InvalidRobotId = "INVALID-ROBOT-ID-CODE",
        /// The profile has no right to read.
        ReadAccess = "READ-ACCESS-ERROR-CODE",
        /// The profile has no right to write.
        WriteAccess = "WRITE-ACCESS-ERROR-CODE",
        /// Positions can be set only in simulation.
        SetPosNotSimulated = "SET-POS-NOT-SIMUL-CODE",
        /// Positions can be set only without power.
        SetPosPowerOn = "SET-POS-POWER-ON-CODE",
        /// A file does not exist.
        FileNotFound = "FILE-NOT-FOUND-CODE",
        /// A configuration does not fit the arm.
        InvalidConfig = "INVALID-CONFIG-CODE",
        /// The number of joints does not fit the arm.
        InvalidNumberOfAxis = "INVALID-NUMBER-OF-AXIS-CODE",
        /// A motion descriptor is invalid.
        InvalidMotDesc = "INVALID-MOT-DESC-CODE",
        /// Another client debugs.
        ClientAlreadyConnected = "CLIENT-ALREADY-CONNECTED",
        /// The event service of the client cannot be reached.
        ClientCommunication = "CLIENT-COMMUNICATION-ERROR",
        /// The application does not exist or is not in memory.
        ApplicationNotFound = "APPLICATION-NOT-FOUND",
        /// The program is not in memory.
        ProgramNotFound = "PROGRAM-NOT-FOUND",
        /// The task does not exist.
        TaskNotFound = "TASK-NOT-FOUND",
        /// The task has no such stack frame.
        StackFrameNotFound = "STACK-FRAME-NOT-FOUND",
        /// The pendant debugs the task.
        TaskAlreadyLocked = "TASK-ALREADY-LOCKED",
        /// The controller has no such operation.
        InvalidSoapHandler = "INVALID-SOAP-HANDLER",
        /// The header of the message is invalid.
        InvalidSoapHeader = "INVALID-SOAP-HEADER",
        /// The program has no such line.
        ProgramLineNotFound = "PROGRAM-LINE-NOT-FOUND",
        /// The line in memory differs from the line of the client.
        MismatchedCode = "MISMATCHED-CODE",
        /// The profile has no right to write signals.
        IoWriteAccess = "IOWRITE-ACCESS-ERROR-CODE",
        /// Signals can be written only in the manual mode or in simulation.
        IoWriteWorkingMode = "IOWRITE-ACCESS-ERROR-WORKING-MODE",
        /// The enabling device is not pressed.
        IoWriteValidation = "IOWRITE-ACCESS-ERROR-VALIDATION",
        /// The scheduling mode does not permit the operation.
        SchedulingMode = "SCHEDULING-MODE-ERROR",
        /// A parameter is invalid.
        InvalidParameters = "INVALID-PARAMETERS",
    }
}

/// Element of the detail.
const EXCEPTION: &str = "ServerException";

impl SoapFault {
    /// Fault with a code of the controller. The reason contains the explanation, and the detail only the code, because
    /// some clients compare the text of the entire detail with the codes.
    #[must_use]
    pub fn exception(code: ExceptionCode, explanation: impl Display) -> Self {
        let exception = ServerException { code, description: None };
        Self { culprit: Culprit::Client, reason: format!("{}: {explanation}", code.text()), exception: Some(exception) }
    }

    /// Fault for a message that cannot be read.
    #[must_use]
    pub fn of_error(error: &SoapError) -> Self {
        let culprit = match error {
            SoapError::UnknownOperation { .. } => {
                return Self::exception(ExceptionCode::InvalidSoapHandler, error);
            }
            SoapError::Missing { .. }
            | SoapError::Repeated { .. }
            | SoapError::Qualified { .. }
            | SoapError::WrongValue { .. } => return Self::exception(ExceptionCode::InvalidParameters, error),
            SoapError::OtherVersion { .. } => Culprit::Version,
            SoapError::UnknownHeader(_) => Culprit::Header,
            _ => Culprit::Client,
        };
        Self { culprit, reason: error.to_string(), exception: None }
    }

    /// Whether the body of a message is a fault.
    #[must_use]
    pub fn is_fault(body: &SoapElement, version: SoapVersion) -> bool {
        body.is(version.namespace(), "Fault")
    }

    /// Returns the fault as an element for the body.
    #[must_use]
    pub fn write(&self, version: SoapVersion) -> SoapElement {
        let code = format!("SOAP-ENV:{}", self.culprit.code(version));
        let mut fault = SoapElement::qualified(version.namespace(), "Fault");
        fault.children = match version {
            SoapVersion::V11 => {
                vec![part(version, "faultcode").with_text(code), part(version, "faultstring").with_text(&self.reason)]
            }
            SoapVersion::V12 => {
                let text = part(version, "Text").with_attribute(XML, "lang", "en").with_text(&self.reason);
                let code = part(version, "Value").with_text(code);
                vec![part(version, "Code").with_child(code), part(version, "Reason").with_child(text)]
            }
        };
        if let Some(exception) = &self.exception {
            let mut child = SoapElement::qualified(SoapServer::V0.namespace(), EXCEPTION);
            exception.write(&mut child);
            fault.children.push(part(version, detail(version)).with_child(child));
        }
        fault
    }

    /// Reads the fault in a body.
    ///
    /// # Errors
    /// The body is no fault, or has no code or reason.
    pub fn read(body: &SoapElement, version: SoapVersion) -> Result<Self, SoapError> {
        let missing = |name| SoapError::Missing { name, parent: body.name.clone() };
        if !Self::is_fault(body, version) {
            return Err(missing("Fault"));
        }
        let namespace = match version {
            SoapVersion::V11 => "",
            SoapVersion::V12 => version.namespace(),
        };
        let (code, reason) = match version {
            SoapVersion::V11 => (body.child("", "faultcode"), body.child("", "faultstring")),
            SoapVersion::V12 => (nested(body, namespace, "Code", "Value"), nested(body, namespace, "Reason", "Text")),
        };
        let code = code.ok_or_else(|| missing("faultcode or Code"))?.text.trim();
        let code = code.split_once(':').map_or(code, |(_, name)| name);
        let reason = reason.ok_or_else(|| missing("faultstring or Reason"))?.text.clone();
        let culprit = Culprit::of_code(code, version).ok_or_else(|| {
            SoapError::wrong_value(&body.name, code, format!("a code of SOAP, for the reason `{reason}`"))
        })?;
        let detail = body.child(namespace, detail(version));
        let exception = detail.and_then(|detail| detail.child(SoapServer::V0.namespace(), EXCEPTION));
        Ok(Self { culprit, reason, exception: exception.map(ServerException::read).transpose()? })
    }
}

/// Name of the element with the detail.
const fn detail(version: SoapVersion) -> &'static str {
    match version {
        SoapVersion::V11 => "detail",
        SoapVersion::V12 => "Detail",
    }
}

fn nested<'a>(element: &'a SoapElement, namespace: &str, first: &str, second: &str) -> Option<&'a SoapElement> {
    element.child(namespace, first)?.child(namespace, second)
}

/// Creates a part of a fault. In SOAP 1.1, parts are in no name space.
fn part(version: SoapVersion, name: &str) -> SoapElement {
    match version {
        SoapVersion::V11 => SoapElement::plain(name),
        SoapVersion::V12 => SoapElement::qualified(version.namespace(), name),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reads the fault with another code.
    fn with_code(code: &str, version: SoapVersion) -> Result<Culprit, SoapError> {
        let fault = SoapFault { culprit: Culprit::Client, reason: "no such robot".to_owned(), exception: None };
        let mut body = fault.write(version);
        let first = body.children.first_mut().unwrap();
        match version {
            SoapVersion::V11 => first.text = code.to_owned(),
            SoapVersion::V12 => first.children.first_mut().unwrap().text = code.to_owned(),
        }
        SoapFault::read(&body, version).map(|fault| fault.culprit)
    }

    #[test]
    fn refined_codes_name_the_party() {
        assert_eq!(with_code("SOAP-ENV:Client.Authentication", SoapVersion::V11).unwrap(), Culprit::Client);
        assert_eq!(with_code("Server", SoapVersion::V11).unwrap(), Culprit::Server);
        assert_eq!(with_code("env:DataEncodingUnknown", SoapVersion::V12).unwrap(), Culprit::Client);
    }

    #[test]
    fn an_unknown_code_does_not_hide_the_reason() {
        for version in [SoapVersion::V11, SoapVersion::V12] {
            let error = with_code("Busy", version).unwrap_err().to_string();
            assert!(error.contains("Busy") && error.contains("no such robot"), "{error}");
        }
    }
}
