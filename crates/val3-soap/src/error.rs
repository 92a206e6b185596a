//! Errors of messages that cannot be read.

use std::fmt;

/// Reason why a message cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SoapError {
    /// The bytes are not UTF-8.
    NotUtf8,
    /// The text is not a well-formed XML document.
    NotXml(String),
    /// The document exceeds a limit, for example "1 MiB".
    TooLarge(&'static str),
    /// The root is not a SOAP envelope.
    NotAnEnvelope {
        /// Name of the root.
        root: String,
    },
    /// The envelope's name space belongs to an unsupported SOAP version.
    OtherVersion {
        /// Name space of the envelope.
        namespace: String,
    },
    /// A header entry that has to be understood is unknown.
    UnknownHeader(String),
    /// An element that must occur is missing.
    Missing {
        /// Name of the missing element.
        name: &'static str,
        /// Name of the element that must contain it.
        parent: String,
    },
    /// An element occurs more than once.
    Repeated {
        /// Name of the repeated element.
        name: &'static str,
    },
    /// An element has a name space, but must have none.
    Qualified {
        /// Name of the element.
        name: &'static str,
        /// Name space of the element.
        namespace: String,
    },
    /// The element's content is not a value of the expected type.
    WrongValue {
        /// Name of the element.
        name: String,
        /// Found text, abbreviated.
        text: String,
        /// Expected values, for example "a whole number".
        expected: String,
    },
    /// The server has no such operation.
    UnknownOperation {
        /// Name of the element in the body.
        name: String,
        /// Name space of the element.
        namespace: String,
    },
    /// The content type is not one of SOAP, or a message of several parts is not complete.
    Transport(&'static str),
}

impl fmt::Display for SoapError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotUtf8 => f.write_str("the message is not UTF-8"),
            Self::NotXml(reason) => write!(f, "the message is not XML: {reason}"),
            Self::TooLarge(limit) => write!(f, "the message exceeds the limit of {limit}"),
            Self::NotAnEnvelope { root } => write!(f, "the root is `{root}`, not a SOAP envelope"),
            Self::OtherVersion { namespace } => {
                write!(f, "the envelope has the name space `{namespace}`, which is neither SOAP 1.1 nor SOAP 1.2")
            }
            Self::UnknownHeader(name) => write!(f, "the header `{name}` must be understood, but is unknown"),
            Self::Missing { name, parent } => write!(f, "`{parent}` has no element `{name}`"),
            Self::Repeated { name } => write!(f, "the element `{name}` occurs more than once"),
            Self::Qualified { name, namespace } => {
                write!(f, "the element `{name}` must have no name space, but has `{namespace}`")
            }
            Self::WrongValue { name, text, expected } => {
                write!(f, "the element `{name}` must contain {expected}, not `{text}`")
            }
            Self::UnknownOperation { name, namespace } => {
                write!(f, "there is no operation `{name}` of the name space `{namespace}` at this address")
            }
            Self::Transport(reason) => f.write_str(reason),
        }
    }
}

impl std::error::Error for SoapError {}

/// Length limit for element texts in messages for people, in characters.
const SHOWN_CHARACTERS: usize = 40;

impl SoapError {
    /// Creates [`WrongValue`](Self::WrongValue), with the beginning of the text.
    pub(crate) fn wrong_value(name: &str, text: &str, expected: impl Into<String>) -> Self {
        let mut shown: String = text.chars().take(SHOWN_CHARACTERS).collect();
        if shown.len() < text.len() {
            shown.push('…');
        }
        Self::WrongValue { name: name.to_owned(), text: shown, expected: expected.into() }
    }
}
