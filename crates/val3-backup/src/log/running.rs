//! The applications that run at a place of a log.

use val3_lang::log_messages::{APPLICATION_STARTED, APPLICATION_STOPPED};

use super::entry::{LineForm, LogEntry};

/// Applications that run after the entries so far.
#[derive(Debug, Clone, Default)]
pub struct RunningApplications {
    running: Vec<String>,
    /// Application that an entry has named last.
    latest: Option<String>,
}

impl RunningApplications {
    /// Updates the applications by the next entry.
    pub fn advance(&mut self, entry: &LogEntry) {
        let has = |known: &str| entry.known_code().is_some_and(|code| code.eq_ignore_ascii_case(known));
        let named = entry.subject().application;
        if entry.form == LineForm::Start {
            self.running.clear();
        } else if has(APPLICATION_STARTED) {
            self.running.extend(named.clone());
        } else if has(APPLICATION_STOPPED) {
            self.running.retain(|running| Some(running) != named.as_ref());
        }
        self.latest = named.or_else(|| self.latest.take());
    }

    /// Returns the running application; `None` if none or several run.
    #[must_use]
    pub fn only(&self) -> Option<&str> {
        let (first, others) = self.running.split_first()?;
        others.iter().all(|other| other == first).then_some(first)
    }

    /// Returns the application that an entry has named last. The controller rejects an application in one message and
    /// its lines in others.
    #[must_use]
    pub fn latest(&self) -> Option<&str> {
        self.latest.as_deref()
    }
}
