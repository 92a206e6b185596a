//! Password of a profile: `VAL3_PASSWORD`, `~/.netrc`, or a prompt.

use std::env;
use std::io::IsTerminal as _;

use camino::Utf8PathBuf;
use val3_controller::{Password, ServerAddress};
use val3_files::{FileClass, Unreadable};

use super::netrc;
use crate::user_error::UserError;

/// Environment variable with the password.
const VARIABLE: &str = "VAL3_PASSWORD";

/// Reads the password. Without a source and a terminal, the password is empty, as that of the profile `default` may be.
///
/// # Errors
/// `VAL3_PASSWORD` or `~/.netrc` is not UTF-8, or the prompt fails.
pub(crate) fn read(server: &ServerAddress) -> Result<Password, UserError> {
    let ServerAddress { user, host, .. } = server;
    if let Some(text) = env::var_os(VARIABLE) {
        let text = text.into_string().map_err(|_| UserError::new(format!("`{VARIABLE}` is not UTF-8")))?;
        return Ok(Password::new(text));
    }
    if let Some(password) = stored(user, host)? {
        return Ok(Password::new(password));
    }
    if !std::io::stdin().is_terminal() {
        return Ok(Password::new(String::new()));
    }
    let typed = rpassword::prompt_password(format!("Password of the profile {user} at {host}: "));
    typed.map(Password::new).map_err(|error| {
        UserError::new(format!("cannot read the password: {error}"))
            .with_help(format!("set {VARIABLE}, or add the host to ~/.netrc"))
    })
}

/// Password in `~/.netrc`.
fn stored(user: &str, host: &str) -> Result<Option<String>, UserError> {
    let Some(home) = env::var_os("HOME").or_else(|| env::var_os("USERPROFILE")) else { return Ok(None) };
    let Some(path) = home.to_str().map(|home| Utf8PathBuf::from(home).join(".netrc")) else { return Ok(None) };
    match val3_files::read_text(&path, FileClass::Settings) {
        Ok(text) => Ok(netrc::password(&text, host, user)),
        Err(Unreadable::Missing) => Ok(None),
        Err(reason) => Err(UserError::new(format!("cannot read `{path}`: {reason}"))),
    }
}
