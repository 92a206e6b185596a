//! A finding with its message and location, independent of output formats.

use val3_analysis::db::{File, FileEdit, FileRange};

use crate::rule::{Rule, Severity};

/// A finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// Rule that found it.
    pub rule: &'static Rule,
    /// Level.
    pub severity: Severity,
    /// Message: one sentence without a final full stop.
    pub message: String,
    /// Location.
    pub place: FileRange,
    /// A few words about the location ("this is a `string`"); may be empty.
    pub label: String,
    /// Other locations of the finding.
    pub related: Vec<RelatedNote>,
    /// Advice for a correction; may be empty.
    pub help: String,
    /// Program that contains the location, for findings in code or in a program's header.
    pub program: Option<String>,
    /// The `.pjx` of the application.
    pub application: Option<File>,
    /// A correction.
    pub fix: Option<Fix>,
}

impl Diagnostic {
    /// Creates a finding at the rule's level, without program and application.
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
    /// Change as an imperative: "write `endIf`".
    pub title: String,
    /// Whether the fix may be applied without confirmation, because it keeps the behaviour of the program or is
    /// certainly intended.
    pub safe: bool,
    /// Edits, which do not overlap.
    pub edits: Vec<FileEdit>,
}

impl Fix {
    /// A fix that may be applied without confirmation.
    pub(crate) fn safe(title: impl Into<String>, edits: Vec<FileEdit>) -> Self {
        Self { title: title.into(), safe: true, edits }
    }

    /// A fix that may not be intended.
    pub(crate) fn guess(title: impl Into<String>, edits: Vec<FileEdit>) -> Self {
        Self { title: title.into(), safe: false, edits }
    }
}

/// Maximum number of uses that a finding lists when it represents many.
pub(crate) const MOST_RELATED: usize = 10;

/// Another location of a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RelatedNote {
    /// Location.
    pub place: FileRange,
    /// Description of the location, a few words.
    pub message: String,
}

/// Wording of a fault; its location comes from the analysis.
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
    /// Creates a wording from its three parts, in reading order.
    pub(crate) fn new(message: impl Into<String>, label: impl Into<String>, help: impl Into<String>) -> Self {
        Self { message: message.into(), label: label.into(), help: help.into() }
    }
}

/// Formats one part per line, without empty parts, for snapshots.
#[cfg(test)]
impl std::fmt::Display for Wording {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "{}", self.message)?;
        let parts = [("|", &self.label), ("?", &self.help)];
        parts.iter().filter(|(_, part)| !part.is_empty()).try_for_each(|(sign, part)| writeln!(f, "{sign} {part}"))
    }
}
