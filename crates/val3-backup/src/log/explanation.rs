//! Explanation of a message, from the tables of the language.

use val3_lang::log_messages::{COMPILE_ERROR, Explanation, RUNTIME_ERROR, compile_fault_in, log_message_of};
use val3_lang::runtime_errors::{self, RuntimeError};

use super::entry::{LineForm, LogEntry};

/// First words of a run-time error's message without a number. s8 writes it in addition to the message with the number.
const S8_DUPLICATE: &str = "VAL3 runtime error";

/// Explanation of a message.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct EntryExplanation {
    /// Word for `val3 explain`: a code, the number of a run-time error, or a text of the compiler.
    pub topic: Topic,
    /// Meaning in a few words, without a full stop.
    pub meaning: &'static str,
    /// Cause; empty if the remedy contains it.
    pub cause: &'static str,
    /// Remedy; empty if nothing needs to be done.
    pub remedy: &'static str,
}

/// Page that `val3 explain` prints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Topic {
    /// Code of a message, or text of the compiler.
    Name(&'static str),
    /// Number of a run-time error.
    RuntimeError(u16),
}

/// Returns the explanation of a message; `None` if its code is unknown, or if the next message is
/// the same with more information.
#[must_use]
pub fn explanation(entry: &LogEntry) -> Option<EntryExplanation> {
    if entry.form != LineForm::Message {
        return None;
    }
    let subject = entry.subject();
    if let Some(error) = subject.error.and_then(runtime_errors::find) {
        return Some(of_error(error));
    }
    let code = entry.known_code()?;
    if code.eq_ignore_ascii_case(RUNTIME_ERROR) && entry.text.starts_with(S8_DUPLICATE) {
        return None;
    }
    if code.eq_ignore_ascii_case(COMPILE_ERROR)
        && let Some(fault) = compile_fault_in(&entry.text)
    {
        return Some(of_table(fault.text, fault.explanation));
    }
    log_message_of(code).map(|message| of_table(message.code, message.explanation))
}

fn of_error(error: &'static RuntimeError) -> EntryExplanation {
    EntryExplanation { topic: Topic::RuntimeError(error.number), meaning: error.short, cause: "", remedy: error.long }
}

fn of_table(name: &'static str, explanation: Explanation) -> EntryExplanation {
    let Explanation { meaning, cause, remedy } = explanation;
    EntryExplanation { topic: Topic::Name(name), meaning, cause, remedy }
}
