//! Secret of a port. Any program on this machine can connect, and a debugger has all rights of the run.

use std::fmt;

use constant_time_eq::constant_time_eq;
use serde_json::{Map, Value};

use crate::failure::RequestFailure;

/// Key of the secret in the arguments of `launch` and `attach`.
pub const SECRET: &str = "secret";

/// A text that a client has to send before it may run or debug anything.
#[derive(Clone, PartialEq, Eq)]
pub struct Secret(String);

impl Secret {
    /// A secret with this text.
    pub fn new(text: impl Into<String>) -> Self {
        Self(text.into())
    }

    /// Checks that the arguments of `launch` or `attach` contain the secret, in a time that does not depend on the
    /// bytes.
    ///
    /// # Errors
    /// The secret is missing or wrong.
    pub(crate) fn check(&self, arguments: &Map<String, Value>) -> Result<(), RequestFailure> {
        let reason = match arguments.get(SECRET) {
            Some(Value::String(text)) if constant_time_eq(text.as_bytes(), self.0.as_bytes()) => return Ok(()),
            None | Some(Value::Null) => "is missing",
            Some(_) => "is another one",
        };
        let text = format!("`{SECRET}` {reason}: the process that listens on this port has printed it with the port");
        Err(RequestFailure::Rejected(text))
    }
}

impl fmt::Debug for Secret {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Secret")
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn check(arguments: Value) -> Result<(), String> {
        Secret::new("0123456789abcdef").check(arguments.as_object().unwrap()).map_err(|failure| failure.to_string())
    }

    #[test]
    fn the_whole_text_is_compared() {
        assert_eq!(check(json!({ "secret": "0123456789abcdef", "port": 1 })), Ok(()));
        for secret in
            [json!(""), json!("0123456789abcde"), json!("0123456789abcdef0"), json!(0), json!(["0123456789abcdef"])]
        {
            assert!(check(json!({ "secret": secret })).unwrap_err().contains("another one"), "{secret}");
        }
    }

    #[test]
    fn a_missing_secret_is_reported() {
        for arguments in [json!({}), json!({ "secret": null }), json!({ "Secret": "0123456789abcdef" })] {
            assert!(check(arguments).unwrap_err().contains("missing"));
        }
    }

    #[test]
    fn a_secret_is_not_part_of_debug_output() {
        assert_eq!(format!("{:?}", Secret::new("0123456789abcdef")), "Secret");
    }
}
