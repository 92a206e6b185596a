//! SOAP envelopes: the version, the session and the body of a message.

use crate::document::SoapElement;
use crate::error::SoapError;
use crate::server::SoapServer;
use crate::value::SoapValue as _;
use crate::version::{SOAP_11, SOAP_12, SoapVersion};

/// Name of the header entry with the session.
const SESSION: &str = "sessionId";

/// Attribute that forbids the receiver to ignore a header entry.
const MUST_UNDERSTAND: &str = "mustUnderstand";

/// Header entry with the session of a message.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SessionHeader {
    /// Number of the session.
    pub id: i32,
    /// Whether the receiver must reject the message if it does not know sessions.
    pub must_understand: bool,
}

/// Message: a request, an answer or a fault.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Envelope {
    /// SOAP version.
    pub version: SoapVersion,
    /// Session; `None` without the header.
    pub session: Option<SessionHeader>,
    /// Element in the body.
    pub body: SoapElement,
}

impl Envelope {
    /// Reads a message from its bytes.
    ///
    /// # Errors
    /// The bytes are no SOAP message with one element in its body, or exceed a limit.
    pub fn read(bytes: &[u8]) -> Result<Self, SoapError> {
        Self::of(SoapElement::read(bytes)?)
    }

    fn of(root: SoapElement) -> Result<Self, SoapError> {
        let version = match root.namespace.as_str() {
            _ if root.name != "Envelope" => return Err(SoapError::NotAnEnvelope { root: root.name }),
            SOAP_11 => SoapVersion::V11,
            SOAP_12 => SoapVersion::V12,
            _ => return Err(SoapError::OtherVersion { namespace: root.namespace }),
        };
        let namespace = version.namespace();
        let session = root.child(namespace, "Header").map(|header| session(header, namespace)).transpose()?.flatten();
        let missing = |name, parent: &str| SoapError::Missing { name, parent: parent.to_owned() };
        let mut bodies = root.children.into_iter().filter(|child| child.is(namespace, "Body"));
        let body = bodies.next().ok_or_else(|| missing("Body", "Envelope"))?;
        if bodies.next().is_some() {
            return Err(SoapError::Repeated { name: "Body" });
        }
        let body = body.children.into_iter().next().ok_or_else(|| missing("of an operation", "Body"))?;
        Ok(Self { version, session, body })
    }

    /// Text of the message.
    #[must_use]
    pub fn write(&self) -> String {
        let namespace = self.version.namespace();
        let mut root = SoapElement::qualified(namespace, "Envelope");
        if let Some(session) = self.session {
            let mut entry = SoapElement::qualified(SoapServer::V0.namespace(), SESSION);
            session.id.write(&mut entry);
            if session.must_understand {
                entry = entry.with_attribute(namespace, MUST_UNDERSTAND, "true");
            }
            root = root.with_child(SoapElement::qualified(namespace, "Header").with_child(entry));
        }
        root.with_child(SoapElement::qualified(namespace, "Body").with_child(self.body.clone())).write()
    }
}

/// Reads the session of a header.
fn session(header: &SoapElement, namespace: &str) -> Result<Option<SessionHeader>, SoapError> {
    let mut session = None;
    for entry in &header.children {
        let must_understand = matches!(entry.attribute(namespace, MUST_UNDERSTAND), Some("true" | "1"));
        if !entry.is(SoapServer::V0.namespace(), SESSION) {
            if must_understand {
                return Err(SoapError::UnknownHeader(entry.name.clone()));
            }
            continue;
        }
        let header = SessionHeader { id: i32::read(entry)?, must_understand };
        if session.replace(header).is_some() {
            return Err(SoapError::Repeated { name: SESSION });
        }
    }
    Ok(session)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(header: &str, body: &str) -> String {
        let text = format!(
            "<s:Envelope xmlns:s='{SOAP_12}' xmlns='CS8ServerV0'><s:Header>{header}</s:Header>{body}</s:Envelope>"
        );
        Envelope::read(text.as_bytes()).unwrap_err().to_string()
    }

    #[test]
    fn wrong_envelopes_are_explained() {
        let body = "<s:Body><ping/></s:Body>";
        assert_eq!(
            error("<other s:mustUnderstand='1'/>", body),
            "the header `other` must be understood, but is unknown"
        );
        assert_eq!(
            error("<sessionId>x</sessionId>", body),
            "the element `sessionId` must contain a whole number, not `x`"
        );
        assert_eq!(
            error("<sessionId>1</sessionId><sessionId>2</sessionId>", body),
            "the element `sessionId` occurs more than once"
        );
        assert_eq!(error("", ""), "`Envelope` has no element `Body`");
        assert_eq!(error("", "<s:Body/>"), "`Body` has no element `of an operation`");
        let other = Envelope::read(b"<Envelope xmlns='x'/>").unwrap_err().to_string();
        assert_eq!(other, "the envelope has the name space `x`, which is neither SOAP 1.1 nor SOAP 1.2");
        assert_eq!(Envelope::read(b"<a/>").unwrap_err().to_string(), "the root is `a`, not a SOAP envelope");
    }

    #[test]
    fn an_unknown_header_may_be_ignored() {
        let text =
            format!("<s:Envelope xmlns:s='{SOAP_11}'><s:Header><x/></s:Header><s:Body><p/></s:Body></s:Envelope>");
        let envelope = Envelope::read(text.as_bytes()).unwrap();
        assert_eq!((envelope.version, envelope.session), (SoapVersion::V11, None));
    }
}
