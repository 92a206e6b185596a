//! Ctrl-C during an evaluation at the prompt ends the evaluation, not the session.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::user_error::UserError;

/// Makes Ctrl-C set `flag` and have no other effect.
///
/// # Errors
/// The signal handler cannot be installed.
#[cfg(unix)]
pub(super) fn catch(flag: &Arc<AtomicBool>) -> Result<(), UserError> {
    let caught = signal_hook::flag::register(signal_hook::consts::SIGINT, Arc::clone(flag));
    caught.map(drop).map_err(|error| UserError::new(format!("cannot catch Ctrl-C: {error}")))
}

/// Does nothing: Ctrl-C keeps its default effect.
#[cfg(not(unix))]
pub(super) fn catch(_: &Arc<AtomicBool>) -> Result<(), UserError> {
    Ok(())
}
