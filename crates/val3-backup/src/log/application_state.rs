//! Statements of a controller's logs about running applications.
//!
//! A wrong "none runs" would let a push replace the files of a moving robot. Everything that the logs do not prove is
//! therefore [`ApplicationState::Unknown`].

use std::collections::BTreeSet;
use std::fmt::{self, Display};

use val3_lang::log_messages::{APPLICATION_STARTED, APPLICATION_STOPPED};

use super::entry::{LineForm, LogEntry};

/// Statement about running applications.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ApplicationState {
    /// These applications have started, and have not stopped.
    Running(BTreeSet<String>),
    /// Every application that has started since the start of the controller has stopped.
    NoneRuns,
    /// The logs do not prove that none runs.
    Unknown(UnknownCause),
}

/// Reason why logs do not prove that no application runs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum UnknownCause {
    /// No log contains a message about a start or stop.
    NoMessages,
    /// The logs do not reach back to a start of the controller: an application may have started before the first entry.
    NoStart,
    /// A line mentions a start or stop, and its code or the name of the application cannot be read.
    UnreadLine(String),
}

/// Running applications according to a log's entries, which are added oldest first.
#[derive(Debug, Clone, Default)]
pub struct ApplicationHistory {
    running: BTreeSet<String>,
    /// First line since the last start of the controller that could not be read.
    unread: Option<String>,
    /// Whether the log contains a start of the controller, after which no application ran.
    has_start: bool,
    /// Whether the log contains messages about applications.
    has_messages: bool,
}

impl ApplicationHistory {
    /// Updates the history by the next entry.
    pub fn advance(&mut self, entry: &LogEntry) {
        if entry.form == LineForm::Start {
            self.running.clear();
            self.unread = None;
            self.has_start = true;
            return;
        }
        let code = entry.known_code();
        let has = |known: &str| code.is_some_and(|code| code.eq_ignore_ascii_case(known));
        let (is_start, is_stop) = (has(APPLICATION_STARTED), has(APPLICATION_STOPPED));
        if !is_start && !is_stop {
            if code.is_none() && mentions_applications(&entry.text) {
                self.unread.get_or_insert_with(|| entry.text.clone());
            }
            return;
        }
        self.has_messages = true;
        match entry.subject().application.filter(|name| is_name(name)) {
            Some(name) if is_start => _ = self.running.insert(name),
            Some(name) => _ = self.running.remove(&name),
            None => _ = self.unread.get_or_insert_with(|| entry.text.clone()),
        }
    }

    /// Combines the histories of all logs of a controller.
    #[must_use]
    pub fn state(logs: Vec<Self>) -> ApplicationState {
        let is_complete = logs.iter().any(|log| log.has_start && log.has_messages);
        let has_messages = logs.iter().any(|log| log.has_messages);
        let unread = logs.iter().find_map(|log| log.unread.clone());
        let running: BTreeSet<String> = logs.into_iter().flat_map(|log| log.running).collect();
        match unread {
            _ if !running.is_empty() => ApplicationState::Running(running),
            Some(line) => ApplicationState::Unknown(UnknownCause::UnreadLine(line)),
            None if is_complete => ApplicationState::NoneRuns,
            None if has_messages => ApplicationState::Unknown(UnknownCause::NoStart),
            None => ApplicationState::Unknown(UnknownCause::NoMessages),
        }
    }
}

impl Display for UnknownCause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoMessages => f.write_str("no log has a message about a started or stopped application"),
            Self::NoStart => f.write_str("the logs do not reach back to the start of the controller"),
            Self::UnreadLine(line) => write!(f, "this line names no application that can be read: {line}"),
        }
    }
}

/// Whether a line without a readable code may state that an application has started or stopped.
fn mentions_applications(text: &str) -> bool {
    let text = text.to_ascii_lowercase();
    let has_code = [APPLICATION_STARTED, APPLICATION_STOPPED].iter().any(|code| text.contains(*code));
    has_code || text.contains("application") && (text.contains("started") || text.contains("stopped"))
}

/// Whether the text can be an application name. `%s` remains in entries without values.
fn is_name(text: &str) -> bool {
    !text.trim().is_empty() && !text.contains(['%', '\''])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::log::entries;

    fn state(logs: &[&str]) -> String {
        let history = |log: &&str| {
            let mut history = ApplicationHistory::default();
            entries(log.as_bytes()).for_each(|entry| history.advance(&entry));
            history
        };
        match ApplicationHistory::state(logs.iter().map(history).collect()) {
            ApplicationState::Running(names) => format!("runs: {}", Vec::from_iter(names).join(", ")),
            ApplicationState::NoneRuns => "none runs".to_owned(),
            ApplicationState::Unknown(cause) => format!("unknown: {cause}"),
        }
    }

    const RUN: &str = "{\"entry\":{\"type\":\"run\",\"version\":\"3.0.0\"}}\n";
    const SWAP: &str = "{\"entry\":{\"type\":\"swap\",\"version\":\"3.0.0\"}}\n";

    fn s8(code: &str, text: &str) -> String {
        format!("{{\"entry\":{{\"type\":\"msg\",\"id\":\"{code}\",\"val\":\"{text}\"}}}}\n")
    }

    fn started(name: &str) -> String {
        s8("0x5402", &format!("Application '{name}' started."))
    }

    fn stopped(name: &str) -> String {
        s8("0x5403", &format!("Application '{name}' stopped."))
    }

    #[test]
    fn the_last_entry_of_each_application_counts() {
        let log = [RUN, &started("a"), &started("b"), &s8("0x5464", "'c' is a message"), &stopped("a")].concat();
        assert_eq!(state(&[&log]), "runs: b");
        assert_eq!(state(&[&(log + &stopped("b"))]), "none runs");
    }

    #[test]
    fn text_logs_name_applications_without_quotes() {
        let start = "[01/05/21 08:00:00]: Logger started\n";
        let run = "[01/05/21 08:00:30]: <0x5402> palletiser application started {1a2b3c4d}\n";
        let end = "[01/05/21 08:01:30]: <0x5403> palletiser application stopped {1a2b3c4d}\n";
        let s6 = "[01/05/21 08:00:30]: palletiser application started\n";
        for run in [run, s6] {
            assert_eq!(state(&[&[start, run].concat()]), "runs: palletiser");
            assert_eq!(state(&[run]), "runs: palletiser");
            assert_eq!(state(&[&[start, run, end].concat()]), "none runs");
        }
    }

    #[test]
    fn an_older_file_belongs_to_the_log() {
        let log = [&started("palletiser"), &started("tool"), SWAP, &stopped("tool")].concat();
        assert_eq!(state(&[&log]), "runs: palletiser");
    }

    #[test]
    fn a_log_without_a_start_of_the_controller_proves_nothing() {
        let no_start = "unknown: the logs do not reach back to the start of the controller";
        assert_eq!(state(&[&[SWAP, &started("tool"), &stopped("tool")].concat()]), no_start);
        assert_eq!(state(&[&[RUN, "\n"].concat(), &stopped("tool")]), no_start);
        let nothing = "unknown: no log has a message about a started or stopped application";
        assert_eq!((state(&[]).as_str(), state(&[RUN]).as_str()), (nothing, nothing));
        assert_eq!(state(&[&[&started("a"), RUN].concat()]), "none runs");
    }

    #[test]
    fn a_pattern_needs_its_values() {
        let entry = |data: &str| {
            format!(
                "{{\"entry\":{{\"type\":\"key\",\"id\":\"0x5402\",\"val\":\"Application '%s' started.\"{data}}}}}\n"
            )
        };
        assert_eq!(state(&[&[RUN, &entry(",\"data\":[\"demo\"]")].concat()]), "runs: demo");
        assert_eq!(
            state(&[&[RUN, &entry(""), &s8("0x5403", "Application '%s' stopped.")].concat()]),
            "unknown: this line names no application that can be read: Application '%s' started."
        );
    }

    #[test]
    fn a_line_that_cannot_be_read_leads_to_unknown_until_the_controller_starts() {
        for line in [
            s8("0x5402", "demo has begun"),
            s8("0x5403", "Application '' stopped."),
            "[01/05/21 08:00:30]: <0x5402> started\n".to_owned(),
            "{\"entry\":{\"id\":\"0x5402\",\"val\":\"Application 'demo' sta\n".to_owned(),
            "[broken: <0x5402> demo application started\n".to_owned(),
            "Application 'demo' started.\n".to_owned(),
        ] {
            let log = [RUN, &line, &started("a"), &stopped("a")].concat();
            assert!(state(&[&log]).starts_with("unknown: this line"), "{line}: {}", state(&[&log]));
            assert_eq!(state(&[&[&log, RUN].concat()]), "none runs", "{line}");
        }
        let other = s8("0x5401", "Application has ended, pending motion was cancelled.");
        assert_eq!(state(&[&[RUN, &started("a"), &other, "USR: started\n", &stopped("a")].concat()]), "none runs");
    }

    proptest! {
        /// No loss or damage of a line turns a running application into "none runs", unless the line is its start and
        /// no trace of it remains.
        #[test]
        fn damage_never_hides_a_running_application(other in "[a-z]{1,3}", cut in 0..200_usize, removed in 0..4_usize) {
            let run = started("palletiser");
            let mut damaged = run.clone();
            damaged.truncate(cut.clamp(run.find("Application").unwrap() + 12, run.len() - 1));
            let end = "\n";
            let mut lines = vec![started(&other), stopped(&other), s8("0x5464", "text"), stopped("tool")];
            lines.remove(removed);
            for run in [run.as_str(), &[damaged.as_str(), end].concat()] {
                let log = [RUN, &lines.concat(), run, &lines.concat()].concat();
                prop_assert_ne!(state(&[&log]), "none runs");
            }
        }
    }
}
