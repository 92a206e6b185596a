//! Signals that end a run. The run first releases resources such as the terminal and the record, and writes its
//! reports.

use std::sync::Arc;
use std::sync::atomic::Ordering::Relaxed;
use std::sync::atomic::{AtomicBool, AtomicUsize};

use crate::user_error::UserError;

/// Base of the exit code of a process that a signal ends, as in shells; the signal number is added.
const EXIT_SIGNAL: u8 = 128;

/// The caught signal, or 0.
#[derive(Debug, Default)]
pub(crate) struct Signals {
    caught: Arc<AtomicUsize>,
    /// Whether a signal was caught.
    seen: Arc<AtomicBool>,
}

impl Signals {
    /// Flag that the first signal sets. Long operations poll it.
    pub(crate) fn flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.seen)
    }

    /// Exit code for the caught signal, if any.
    pub(crate) fn exit_code(&self) -> Option<u8> {
        let signal = u8::try_from(self.caught.load(Relaxed)).ok().filter(|signal| *signal != 0)?;
        Some(EXIT_SIGNAL.saturating_add(signal))
    }

    /// Catches SIGINT (Ctrl-C), SIGHUP (closed terminal) and SIGTERM. The second signal has its default effect.
    ///
    /// # Errors
    /// The signal handlers cannot be installed.
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

    /// Does nothing: signals keep their default effect.
    #[cfg(not(unix))]
    pub(crate) fn catch() -> Result<Self, UserError> {
        Ok(Self::default())
    }
}
