//! Ctrl-C while a text is evaluated at the prompt: it ends the text, not the scope.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::sync::atomic::Ordering::Relaxed;

use crate::user_error::UserError;

/// Whether Ctrl-C was pressed. Nobody looks unless it is [caught](Self::catch).
#[derive(Debug, Clone, Default)]
pub(super) struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Ctrl-C was pressed since this was asked before.
    pub(super) fn take(&self) -> bool {
        self.0.swap(false, Relaxed)
    }

    /// Set from a Ctrl-C until [`take`](Self::take). Long operations check it.
    pub(super) fn flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.0)
    }

    /// Ends the text as Ctrl-C does.
    pub(super) fn ask(&self) {
        self.0.store(true, Relaxed);
    }

    /// Lets Ctrl-C have no other effect from now on.
    ///
    /// # Errors
    /// The system refuses.
    #[cfg(unix)]
    pub(super) fn catch(&self) -> Result<(), UserError> {
        let caught = signal_hook::flag::register(signal_hook::consts::SIGINT, Arc::clone(&self.0));
        caught.map(drop).map_err(|error| UserError::new(format!("cannot catch Ctrl-C: {error}")))
    }

    /// Ctrl-C has its usual effect.
    #[cfg(not(unix))]
    pub(super) fn catch(&self) -> Result<(), UserError> {
        Ok(())
    }
}
