//! Secrets for ports: for the page of `--serve`, and for debuggers.

use std::env;
use std::fmt::{self, Display, Write as _};

use val3_dap::Secret;

use crate::user_error::UserError;

/// Number of random bytes in a secret.
const SECRET_BYTES: usize = 16;

/// Environment variable with a secret for debuggers. Other users can read the arguments of a process, but not its
/// environment.
const VARIABLE: &str = "VAL3_DEBUG_SECRET";

/// Minimum length of a secret chosen by the user, in characters.
const MINIMUM: usize = 16;

/// Returns a new secret of 128 bits, in hexadecimal digits.
///
/// # Errors
/// The system has no random numbers.
pub(crate) fn random() -> Result<String, UserError> {
    let mut bytes = [0; SECRET_BYTES];
    getrandom::fill(&mut bytes)
        .map_err(|error| UserError::new(format!("the system has no random numbers: {error}")))?;
    Ok(bytes.iter().fold(String::new(), |mut text, byte| {
        // Writing to a string cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    }))
}

/// Secret of a debug port.
pub(crate) struct DebugSecret {
    pub(crate) secret: Secret,
    /// Text of a random secret; `None` if the user has chosen the secret.
    shown: Option<String>,
}

impl DebugSecret {
    /// Returns the secret of the environment variable, or a random secret.
    ///
    /// # Errors
    /// The secret in the variable is too short, or the system has no random numbers.
    pub(crate) fn choose() -> Result<Self, UserError> {
        match env::var_os(VARIABLE) {
            None => random().map(|text| Self { secret: Secret::new(text.clone()), shown: Some(text) }),
            Some(text) => match text.to_str().filter(|text| text.chars().count() >= MINIMUM) {
                Some(text) => Ok(Self { secret: Secret::new(text), shown: None }),
                None => Err(UserError::new(format!("`{VARIABLE}` is no text of at least {MINIMUM} characters"))
                    .with_help("choose a longer secret, or unset the variable for a random one")),
            },
        }
    }
}

/// Text after the address of the port.
impl Display for DebugSecret {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.shown {
            Some(text) => write!(f, "with the secret {text}"),
            None => write!(f, "with the secret of {VARIABLE}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn random_secrets_have_128_bits_and_differ() {
        let [first, second] = [random().unwrap(), random().unwrap()];
        assert_eq!(first.len(), 32);
        assert!(first.bytes().all(|byte| byte.is_ascii_hexdigit()));
        assert_ne!(first, second);
    }
}
