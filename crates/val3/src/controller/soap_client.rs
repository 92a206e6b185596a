//! Client of a controller's SOAP interface. Its users only read.

use std::io::Read as _;
use std::str::FromStr;

use val3_controller::{AddressFault, ServerAddress};
use val3_soap::{
    Envelope, Operation, SessionHeader, SoapFault, SoapVersion, multipart,
    operations::{read_answer, request_body},
    v0::{Login, Logout},
};

use super::password;
use crate::user_error::UserError;

/// Default port: the port of older controllers. Newer controllers have 851.
const PORT: u16 = 5653;

/// Time for one answer, in seconds.
const ANSWER_SECONDS: u64 = 10;

/// Limit of an answer in bytes.
const LIMIT: u64 = 1 << 20;

/// Server of a controller, and the profile of the login.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct SoapTarget(ServerAddress);

impl FromStr for SoapTarget {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let rest = text.strip_prefix("http://").unwrap_or(text).trim_end_matches('/');
        ServerAddress::parse(rest, PORT).map(Self).map_err(|fault| match fault {
            AddressFault::Password => format!("{fault}: set VAL3_PASSWORD"),
            _ => format!("{fault}: write [PROFILE@]HOST[:PORT], for example 192.168.0.254:5653"),
        })
    }
}

impl SoapTarget {
    /// Name or number of the host.
    pub(crate) fn host(&self) -> &str {
        &self.0.host
    }

    /// Host and port, for messages.
    pub(crate) fn place(&self) -> String {
        self.0.place()
    }
}

/// Open session.
#[derive(Debug)]
pub(crate) struct SoapClient {
    place: String,
    session: Option<SessionHeader>,
}

impl SoapClient {
    /// Opens a session.
    ///
    /// # Errors
    /// The controller cannot be reached, or rejects the login.
    pub(crate) fn login(target: &SoapTarget) -> Result<Self, UserError> {
        let mut client = Self { place: target.place(), session: None };
        let password = password::read(&target.0)?;
        let user = &target.0.user;
        let request = Login { user: Some(user.clone()), password: Some(password.text().to_owned()) };
        let id = client.call(&request)?.session;
        if id <= 0 {
            return Err(UserError::new(format!("{} rejects the login of the profile `{user}`", client.place))
                .with_help("name a profile of the controller, PROFILE@HOST, and its password in VAL3_PASSWORD"));
        }
        client.session = Some(SessionHeader { id, must_understand: false });
        Ok(client)
    }

    /// Closes the session.
    ///
    /// # Errors
    /// The controller cannot be reached.
    pub(crate) fn logout(mut self) -> Result<(), UserError> {
        self.call(&Logout {}).map(|_| ())
    }

    /// Sends a request, and returns its answer.
    ///
    /// # Errors
    /// The controller cannot be reached, rejects the request, or its answer is unknown.
    pub(crate) fn call<O: Operation>(&mut self, request: &O) -> Result<O::Answer, UserError> {
        let failed = |reason: &str| UserError::new(format!("{} does not answer `{}`: {reason}", self.place, O::NAME));
        let version = SoapVersion::V12;
        let envelope = Envelope { version, session: self.session, body: request_body(request) };
        let response = minreq::post(format!("http://{}{}", self.place, O::SERVER.path()))
            .with_header("Content-Type", format!("{}; charset=utf-8", version.content_type()))
            .with_body(envelope.write())
            .with_timeout(ANSWER_SECONDS)
            .with_follow_redirects(false)
            .send_lazy()
            .map_err(|error| {
                failed(&error.to_string()).with_help("is this the port of the SOAP interface: 5653 or 851?")
            })?;
        let status = response.status_code;
        let content_type = response.headers.iter().find(|(name, _)| name.eq_ignore_ascii_case("content-type"));
        let content_type = content_type.map(|(_, value)| value.clone()).unwrap_or_default();
        let mut bytes = Vec::new();
        response.take(LIMIT).read_to_end(&mut bytes).map_err(|error| failed(&error.to_string()))?;
        let answer = multipart::envelope(&content_type, &bytes).and_then(Envelope::read);
        let answer = answer.map_err(|error| failed(&format!("{error} (HTTP status {status})")))?;
        if SoapFault::is_fault(&answer.body, answer.version) {
            let fault = SoapFault::read(&answer.body, answer.version).map_err(|error| failed(&error.to_string()))?;
            let code = fault.exception.map(|exception| exception.code.text());
            let reason = match code {
                Some(code) if !fault.reason.contains(code) => format!("{code}: {}", fault.reason),
                _ => fault.reason,
            };
            return Err(failed(&reason));
        }
        read_answer::<O>(&answer.body).map_err(|error| failed(&error.to_string()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_addresses_of_servers_with_a_default_port() {
        let parsed = |text: &str| text.parse().map(|SoapTarget(server)| format!("{} {}", server.user, server.place()));
        assert_eq!(parsed("robot").unwrap(), "default robot:5653");
        assert_eq!(parsed("http://maintenance@192.168.0.254:851/").unwrap(), "maintenance 192.168.0.254:851");
        assert_eq!(parsed("[::1]").unwrap(), "default [::1]:5653");
        assert!(parsed("me:secret@robot").unwrap_err().contains("VAL3_PASSWORD"));
        for wrong in ["", "robot:0", "robot:x", "@robot", "ftp://robot", "a b"] {
            assert!(parsed(wrong).unwrap_err().contains("[PROFILE@]HOST[:PORT]"), "{wrong}");
        }
    }
}
