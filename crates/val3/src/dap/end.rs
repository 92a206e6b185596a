//! End of a session, with the error of a client that breaks the protocol.

use std::process::ExitCode;

use val3_dap::ReadError;

use crate::user_error::UserError;

/// Returns the exit code of a session that has ended.
///
/// # Errors
/// Bytes from the client were no message, and the next message could not be found.
pub(crate) fn ended(code: ExitCode, fault: Option<&ReadError>) -> Result<ExitCode, UserError> {
    match fault {
        None => Ok(code),
        Some(error) => {
            Err(UserError::new(format!("the session has ended, because the client sent no message: {error}")))
        }
    }
}
