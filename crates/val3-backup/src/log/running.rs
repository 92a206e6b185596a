//! The applications that run at a place of a log.

use val3_lang::log_messages::{APPLICATION_STARTED, APPLICATION_STOPPED};

use super::entry::{LineForm, LogEntry};

/// Applications that run after the entries so far.
#[derive(Debug, Clone, Default)]
pub struct RunningApplications(Vec<String>);

impl RunningApplications {
    /// Updates the applications by the next entry.
    pub fn advance(&mut self, entry: &LogEntry) {
        let has = |known: &str| entry.known_code().is_some_and(|code| code.eq_ignore_ascii_case(known));
        if entry.form == LineForm::Start {
            self.0.clear();
        } else if has(APPLICATION_STARTED) {
            self.0.extend(entry.subject().application);
        } else if has(APPLICATION_STOPPED) {
            let stopped = entry.subject().application;
            self.0.retain(|running| Some(running) != stopped.as_ref());
        }
    }

    /// Returns the running application; `None` if none or several run.
    #[must_use]
    pub fn only(&self) -> Option<&str> {
        let (first, others) = self.0.split_first()?;
        others.iter().all(|other| other == first).then_some(first)
    }
}
