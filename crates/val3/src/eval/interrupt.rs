//! Ctrl-C while a text is evaluated at the prompt: it ends the text, not the session.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::user_error::UserError;

/// Makes Ctrl-C set `flag`, without any other effect.
///
/// # Errors
/// The system refuses.
#[cfg(unix)]
pub(super) fn catch(flag: &Arc<AtomicBool>) -> Result<(), UserError> {
    let caught = signal_hook::flag::register(signal_hook::consts::SIGINT, Arc::clone(flag));
    caught.map(drop).map_err(|error| UserError::new(format!("cannot catch Ctrl-C: {error}")))
}

/// Ctrl-C has its usual effect.
#[cfg(not(unix))]
pub(super) fn catch(_: &Arc<AtomicBool>) -> Result<(), UserError> {
    Ok(())
}
