//! Messages in the controller's event log (`log/errors.log` of a CS8, `log/system.log` and `log/user.log` of a CS9).
//!
//! The files `codes.txt` and `compile.txt` are the tables, with one message a line.

use std::sync::LazyLock;

/// Kind of message, identified by its code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LogMessage {
    /// Code as written in the log, for example `0x5405`.
    pub code: &'static str,
    /// Level in logs of a CS9; `None` if the code was only found in logs of a CS8.
    pub level: Option<LogLevel>,
    /// Meaning and remedy.
    pub explanation: Explanation,
}

/// Fault that the controller's compiler reports in a message with the code [`COMPILE_ERROR`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CompileFault {
    /// Part of the message, in lower case.
    pub text: &'static str,
    /// Meaning and remedy.
    pub explanation: Explanation,
}

/// Explanation of a message.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Explanation {
    /// Meaning in a few words, without a full stop.
    pub meaning: &'static str,
    /// Cause in one or more sentences.
    pub cause: &'static str,
    /// Remedy in one or more sentences; empty if nothing needs to be done.
    pub remedy: &'static str,
}

/// Level of a message in logs of a CS9, in ascending order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LogLevel {
    /// `INFO`
    Info,
    /// `WARN`
    Warn,
    /// `ERROR`
    Error,
    /// `CRITICAL`
    Critical,
}

/// Code of a message about a started application.
pub const APPLICATION_STARTED: &str = "0x5402";

/// Code of a message about a stopped application.
pub const APPLICATION_STOPPED: &str = "0x5403";

/// Code of a message about a run-time error.
pub const RUNTIME_ERROR: &str = "0x5404";

/// Code of a message of the compiler.
pub const COMPILE_ERROR: &str = "0x5405";

/// Code of a message about an application that cannot be loaded.
pub const NOT_LOADED: &str = "0x7807";

static LOG_MESSAGES: LazyLock<Vec<LogMessage>> =
    LazyLock::new(|| lines(include_str!("log_messages/codes.txt")).filter_map(log_message).collect());

static COMPILE_FAULTS: LazyLock<Vec<CompileFault>> =
    LazyLock::new(|| lines(include_str!("log_messages/compile.txt")).filter_map(compile_fault).collect());

/// All known messages, sorted by code.
#[must_use]
pub fn log_messages() -> &'static [LogMessage] {
    &LOG_MESSAGES
}

/// All known faults of the controller's compiler, sorted by text.
#[must_use]
pub fn compile_faults() -> &'static [CompileFault] {
    &COMPILE_FAULTS
}

/// Returns the message with this code, in any letter case.
#[must_use]
pub fn log_message_of(code: &str) -> Option<&'static LogMessage> {
    LOG_MESSAGES.iter().find(|message| message.code.eq_ignore_ascii_case(code))
}

/// Returns the compiler's fault in the text of a message.
///
/// ```
/// let fault = val3_lang::log_messages::compile_fault_in("(File start.pgx-line 5) 'pik' : undefined program").unwrap();
/// assert_eq!(fault.text, "undefined program");
/// ```
#[must_use]
pub fn compile_fault_in(message: &str) -> Option<&'static CompileFault> {
    let message = message.to_lowercase();
    COMPILE_FAULTS.iter().find(|fault| message.contains(fault.text))
}

impl LogLevel {
    /// Returns the level with this name in a log, for example `WARN`.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        [Self::Info, Self::Warn, Self::Error, Self::Critical].into_iter().find(|level| level.name() == name)
    }

    /// Name in a log.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Info => "INFO",
            Self::Warn => "WARN",
            Self::Error => "ERROR",
            Self::Critical => "CRITICAL",
        }
    }
}

/// Lines of a table without comments.
fn lines(table: &'static str) -> impl Iterator<Item = &'static str> {
    table.lines().filter(|line| !line.starts_with('#'))
}

fn log_message(line: &'static str) -> Option<LogMessage> {
    let (code, rest) = line.split_once('|')?;
    let (level, rest) = rest.split_once('|')?;
    let level = LogLevel::from_name(&level.trim().to_ascii_uppercase());
    Some(LogMessage { code: code.trim(), level, explanation: explanation(rest)? })
}

fn compile_fault(line: &'static str) -> Option<CompileFault> {
    let (text, rest) = line.split_once('|')?;
    Some(CompileFault { text: text.trim(), explanation: explanation(rest)? })
}

fn explanation(columns: &'static str) -> Option<Explanation> {
    let (meaning, rest) = columns.split_once('|')?;
    let (cause, remedy) = rest.split_once('|')?;
    Some(Explanation { meaning: meaning.trim(), cause: cause.trim(), remedy: remedy.trim() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_of_the_tables_is_a_message() {
        assert_eq!(lines(include_str!("log_messages/codes.txt")).count(), log_messages().len());
        assert_eq!(lines(include_str!("log_messages/compile.txt")).count(), compile_faults().len());
    }

    #[test]
    fn messages_ascend_and_each_exists_once() {
        assert!(log_messages().is_sorted_by(|one, next| one.code < next.code));
        assert!(compile_faults().is_sorted_by(|one, next| one.text < next.text));
    }

    #[test]
    fn codes_have_the_form_of_the_log() {
        for message in log_messages() {
            let digits = message.code.strip_prefix("0x").unwrap();
            assert!(
                digits.len() == 4 && digits.bytes().all(|digit| b"0123456789ABCDEF".contains(&digit)),
                "{message:?}"
            );
        }
    }

    #[test]
    fn explanations_are_sentences() {
        let messages = log_messages().iter().map(|message| message.explanation);
        for explanation in messages.chain(compile_faults().iter().map(|fault| fault.explanation)) {
            let Explanation { meaning, cause, remedy } = explanation;
            assert!(!meaning.is_empty() && !meaning.ends_with('.'), "{explanation:?}");
            assert!(cause.ends_with('.') && (remedy.is_empty() || remedy.ends_with('.')), "{explanation:?}");
            assert!(![meaning, cause, remedy].iter().any(|text| text.contains('|')), "{explanation:?}");
        }
    }

    #[test]
    fn faults_have_a_remedy() {
        for message in log_messages().iter().filter(|message| message.level >= Some(LogLevel::Warn)) {
            assert!(!message.explanation.remedy.is_empty(), "{message:?}");
        }
    }

    #[test]
    fn every_code_with_its_own_meaning_is_in_the_table() {
        for code in [APPLICATION_STARTED, APPLICATION_STOPPED, RUNTIME_ERROR, COMPILE_ERROR, NOT_LOADED] {
            assert!(log_message_of(&code.to_lowercase()).is_some(), "{code}");
        }
    }
}
