//! An entry of a log.

use val3_lang::log_messages::{LogLevel, log_message_of};

use super::subject::{Subject, code_of_text};
use crate::DateTime;

/// An entry of a log: one line that is not blank.
#[derive(Debug, Clone, PartialEq)]
pub struct LogEntry {
    /// Line number in the file, from 1.
    pub line: usize,
    /// Form of the line.
    pub form: LineForm,
    /// Time on the controller's clock; `None` if the line has none.
    pub time: Option<DateTime>,
    /// Seconds since the start of the controller (CS9).
    pub uptime: Option<f64>,
    /// Level as written in the line (CS9).
    pub level: Option<LogLevel>,
    /// Code as written in the line, for example `0x5405`.
    pub code: Option<String>,
    /// Text of the message, with its values inserted; the entire line if its form is unknown.
    pub text: String,
}

/// Form of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineForm {
    /// A message.
    Message,
    /// The controller or its logger was started.
    Start,
    /// The log continues an older file.
    Continuation,
    /// The controller has stored its state: inputs, outputs and the arm.
    State,
    /// No known form.
    Unknown,
}

impl LineForm {
    /// Name in JSON documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Message => "message",
            Self::Start => "start",
            Self::Continuation => "continuation",
            Self::State => "state",
            Self::Unknown => "unknown",
        }
    }
}

impl LogEntry {
    /// Level of the message: as written in the line, otherwise as usual for the code; `None` if neither is known.
    #[must_use]
    pub fn known_level(&self) -> Option<LogLevel> {
        self.level.or_else(|| log_message_of(self.known_code()?)?.level)
    }

    /// Code of the message: as written in the line, otherwise by its text; `None` if neither is known.
    #[must_use]
    pub fn known_code(&self) -> Option<&str> {
        let of_text = || (self.form == LineForm::Message).then(|| code_of_text(&self.text))?;
        self.code.as_deref().or_else(of_text)
    }

    /// Subject of the message.
    #[must_use]
    pub fn subject(&self) -> Subject {
        Subject::of(self.known_code(), &self.text)
    }
}
