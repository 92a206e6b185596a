//! Signals that end a run from outside. Resources such as the terminal and the record are released first, and reports are
//! written.

use std::sync::Arc;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::atomic::{AtomicBool, AtomicUsize};

use crate::user_error::UserError;

/// Base of the exit codes of processes that a signal ends, as in shells. The number of the signal is added.
const EXIT_SIGNAL: u8 = 128;

/// The signal that was caught, or 0.
#[derive(Debug, Default)]
pub(crate) struct Signals {
    caught: Arc<AtomicUsize>,
    /// Set with the first signal.
    seen: Arc<AtomicBool>,
}

impl Signals {
    /// Set with the first signal. Long operations check it.
    pub(crate) fn flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.seen)
    }

    /// The exit code that a signal asks for, if one was caught.
    pub(crate) fn exit_code(&self) -> Option<u8> {
        let signal = u8::try_from(self.caught.load(Relaxed)).ok().filter(|signal| *signal != 0)?;
        Some(EXIT_SIGNAL.saturating_add(signal))
    }

    /// Catches Ctrl-C, the end of the terminal and the request to end. The second signal has its usual effect.
    ///
    /// # Errors
    /// The system refuses.
    #[cfg(unix)]
    pub(crate) fn catch() -> Result<Self, UserError> {
        use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
        use signal_hook::flag::{register, register_conditional_default, register_usize};

        let signals = Self::default();
        let seen = &signals.seen;
        for signal in [SIGHUP, SIGINT, SIGTERM] {
            let number = usize::try_from(signal).unwrap_or_default();
            register_conditional_default(signal, Arc::clone(seen))
                .and_then(|_| register(signal, Arc::clone(seen)))
                .and_then(|_| register_usize(signal, Arc::clone(&signals.caught), number))
                .map_err(|error| UserError::new(format!("cannot catch signals: {error}")))?;
        }
        Ok(signals)
    }

    /// Signals have their usual effect.
    #[cfg(not(unix))]
    pub(crate) fn catch() -> Result<Self, UserError> {
        Ok(Self::default())
    }
}
