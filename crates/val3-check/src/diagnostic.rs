//! A finding with its message and location, independent of output formats.

use val3_analysis::db::{File, FileRange};

use crate::rule::{Rule, Severity};

/// One finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// The rule that found it.
    pub rule: &'static Rule,
    /// Its level.
    pub severity: Severity,
    /// The message: one sentence without a final full stop.
    pub message: String,
    /// The location.
    pub place: FileRange,
    /// A few words about the location ("this is a `string`"); may be empty.
    pub label: String,
    /// The other locations that the finding involves.
    pub related: Vec<RelatedNote>,
    /// Advice for a correction; may be empty.
    pub help: String,
    /// The program that contains the location, for findings in code or in a program's header.
    pub program: Option<String>,
    /// The `.pjx` of the application.
    pub application: Option<File>,
    /// A correction.
    pub fix: Option<Fix>,
}

impl Diagnostic {
    /// A finding of a rule at its own level, in no program and no application.
    pub(crate) fn new(rule: &'static Rule, wording: Wording, place: FileRange) -> Self {
        let Wording { message, label, help } = wording;
        Self {
            rule,
            severity: rule.severity,
            message,
            place,
            label,
            related: Vec::new(),
            help,
            program: None,
            application: None,
            fix: None,
        }
    }
}

/// A change that corrects a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fix {
    /// The change as an imperative: "write `endIf`".
    pub title: String,
    /// The change keeps the behaviour of the program or is certainly what was meant. It may be applied without
    /// confirmation.
    pub safe: bool,
    /// The edits, which do not overlap.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// A fix that may be applied without confirmation.
    pub(crate) fn safe(title: impl Into<String>, edits: Vec<Edit>) -> Self {
        Self { title: title.into(), safe: true, edits }
    }

    /// A fix that may not be what was meant.
    pub(crate) fn guess(title: impl Into<String>, edits: Vec<Edit>) -> Self {
        Self { title: title.into(), safe: false, edits }
    }
}

/// Replaces a range of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// The replaced range.
    pub place: FileRange,
    /// The new text, in the form of the file (escaped where the code is).
    pub text: String,
}

/// Maximum number of uses that a finding lists when it represents many.
pub(crate) const MOST_RELATED: usize = 10;

/// Another location that a finding involves.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RelatedNote {
    /// The location.
    pub place: FileRange,
    /// A few words about it.
    pub message: String,
}

/// The wording of a fault; its location comes from the analysis.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Wording {
    /// See [`Diagnostic::message`].
    pub message: String,
    /// See [`Diagnostic::label`].
    pub label: String,
    /// See [`Diagnostic::help`].
    pub help: String,
}

impl Wording {
    /// The three parts in the order in which they are read.
    pub(crate) fn new(message: impl Into<String>, label: impl Into<String>, help: impl Into<String>) -> Self {
        Self { message: message.into(), label: label.into(), help: help.into() }
    }
}

/// One part per line, without the empty ones, for snapshots.
#[cfg(test)]
impl std::fmt::Display for Wording {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "{}", self.message)?;
        let parts = [("|", &self.label), ("?", &self.help)];
        parts.iter().filter(|(_, part)| !part.is_empty()).try_for_each(|(sign, part)| writeln!(f, "{sign} {part}"))
    }
}
