//! Secrets for ports: for the page of `--serve`, and for debuggers.

use std::env;
use std::fmt::{self, Display, Write as _};

use sha2::{Digest, Sha256};
use val3_dap::Secret;

use crate::user_error::UserError;

/// Number of random bytes in a secret.
const SECRET_BYTES: usize = 16;

/// Environment variable with a secret for debuggers. Other users can read the arguments of a process, but not its
/// environment.
const VARIABLE: &str = "VAL3_DEBUG_SECRET";

/// Environment variable with the secret of the page, so that its addresses stay valid after a restart of the server.
const PAGE_VARIABLE: &str = "VAL3_SERVE_SECRET";

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
    Ok(hexadecimal(&bytes))
}

fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        // Writing to a string cannot fail.
        let _ = write!(text, "{byte:02x}");
        text
    })
}

/// Returns the secrets of a page for each role: random, or derived from the secret of the environment variable.
///
/// # Errors
/// The secret in the variable is too short, or the system has no random numbers.
pub(crate) fn for_page<const COUNT: usize>(roles: [&str; COUNT]) -> Result<[String; COUNT], UserError> {
    let chosen = chosen(PAGE_VARIABLE)?;
    let mut secrets = [const { String::new() }; COUNT];
    for (secret, role) in secrets.iter_mut().zip(roles) {
        *secret = chosen.as_deref().map_or_else(random, |chosen| Ok(derived(chosen, role)))?;
    }
    Ok(secrets)
}

/// Derives the secret of a role, from which neither the chosen secret nor the secret of another role can be computed.
fn derived(chosen: &str, role: &str) -> String {
    let hash = Sha256::digest(format!("val3 page {role} {chosen}"));
    hexadecimal(hash.get(..SECRET_BYTES).unwrap_or_default())
}

/// Returns the secret of an environment variable; `None` if the variable is not set.
///
/// # Errors
/// The secret is too short.
fn chosen(variable: &str) -> Result<Option<String>, UserError> {
    let Some(text) = env::var_os(variable) else { return Ok(None) };
    match text.to_str().filter(|text| text.chars().count() >= MINIMUM) {
        Some(text) => Ok(Some(text.to_owned())),
        None => Err(UserError::new(format!("`{variable}` is no text of at least {MINIMUM} characters"))
            .with_help("choose a longer secret, or unset the variable for a random one")),
    }
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
        match chosen(VARIABLE)? {
            None => random().map(|text| Self { secret: Secret::new(text.clone()), shown: Some(text) }),
            Some(text) => Ok(Self { secret: Secret::new(text), shown: None }),
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

    #[test]
    fn each_role_has_its_own_lasting_secret() {
        let chosen = "correct horse battery";
        let [operator, guest] = ["operator", "guest"].map(|role| derived(chosen, role));
        assert_eq!((operator.len(), &operator), (32, &derived(chosen, "operator")));
        assert_ne!(operator, guest);
        assert_ne!(operator, derived("correct horse batterY", "operator"));
    }
}
