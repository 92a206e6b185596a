//! Event log of the controller, and the rate limit for programs (`logMsg`, 4.3).

use super::severity::MessageSeverity;

/// Size of the date, the time and the mark of a message, in bytes.
const STAMP: u64 = 32;

/// Maximum number of bytes that wait to be written.
const CAPACITY: u64 = 8192;

/// Nanoseconds to write one byte.
const PER_BYTE: u64 = 31_250;

/// Message in the event log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogEntry {
    /// Time of logging, in nanoseconds.
    pub at: u64,
    /// Kind of the message.
    pub severity: MessageSeverity,
    /// Text of the message.
    pub text: String,
    /// Whether the message is from a program, not from the controller.
    pub from_program: bool,
}

impl LogEntry {
    /// Displayed text: messages of programs are marked `USR`.
    #[must_use]
    pub fn line(&self) -> String {
        if self.from_program { format!("USR {}", self.text) } else { self.text.clone() }
    }
}

/// The event log.
///
/// According to the manual, messages are lost when many are logged at the same time, long messages first. Here 8,192
/// bytes can wait, each message with 32 for its date, and 32 bytes are written a millisecond: some 50 of the longest
/// messages in a burst, then one each 5 ms.
#[derive(Debug, Clone, Default)]
pub struct EventLog {
    waiting: u64,
    since: u64,
    entries: Vec<LogEntry>,
}

impl EventLog {
    /// `logMsg`: returns `false` if the message was lost because too many bytes wait to be written.
    pub fn log(&mut self, text: &str, severity: MessageSeverity, now: u64) -> bool {
        self.write_out(now);
        let size = text.len() as u64 + STAMP;
        let fits = self.waiting + size <= CAPACITY;
        if fits {
            self.waiting += size;
            self.entries.push(LogEntry { at: now, severity, text: text.to_owned(), from_program: true });
        }
        fits
    }

    /// Adds a message of the controller itself, which is never lost.
    pub fn report(&mut self, text: &str, severity: MessageSeverity, now: u64) {
        self.entries.push(LogEntry { at: now, severity, text: text.to_owned(), from_program: false });
    }

    /// The entries since the last call.
    pub fn take_entries(&mut self) -> Vec<LogEntry> {
        std::mem::take(&mut self.entries)
    }

    fn write_out(&mut self, now: u64) {
        let written = now.saturating_sub(self.since) / PER_BYTE;
        self.waiting = self.waiting.saturating_sub(written);
        self.since += written * PER_BYTE;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MILLISECOND: u64 = 1_000_000;

    #[test]
    fn a_message_is_marked_as_one_of_the_user() {
        let mut log = EventLog::default();
        assert!(log.log("gripper lost a part", MessageSeverity::Warning, 5));
        log.report("power refused", MessageSeverity::Information, 6);
        let entries = log.take_entries();
        assert_eq!(entries[0].line(), "USR gripper lost a part");
        assert_eq!((entries[0].at, entries[0].severity), (5, MessageSeverity::Warning));
        assert_eq!(entries[1].line(), "power refused");
        assert!(log.take_entries().is_empty());
    }

    #[test]
    fn too_many_at_once_are_lost_and_can_be_logged_later() {
        let mut log = EventLog::default();
        let long = "x".repeat(128);
        let taken = (0..1000).take_while(|_| log.log(&long, MessageSeverity::Information, 0)).count();
        assert_eq!(taken, 51);
        assert!(!log.log(&long, MessageSeverity::Information, 4 * MILLISECOND - 1));
        assert!(log.log(&long, MessageSeverity::Information, 5 * MILLISECOND));
    }

    #[test]
    fn a_short_message_still_fits_where_a_long_one_is_lost() {
        let mut log = EventLog::default();
        while log.log(&"x".repeat(128), MessageSeverity::Information, 0) {}
        assert!(!log.log(&"x".repeat(128), MessageSeverity::Information, 0));
        assert!(log.log("", MessageSeverity::Information, 0));
    }

    #[test]
    fn the_budget_for_messages_is_limited() {
        let mut log = EventLog::default();
        let an_hour = 3_600_000 * MILLISECOND;
        let taken = (0..1000).take_while(|_| log.log(&"x".repeat(128), MessageSeverity::Information, an_hour)).count();
        assert_eq!(taken, 51);
    }
}
