//! A finding, worded and placed, free of any output format.

use val3_analysis::db::{File, FileRange};

use crate::rule::{Rule, Severity};

/// One finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// The rule that found it.
    pub rule: &'static Rule,
    /// Its level.
    pub severity: Severity,
    /// What is wrong, in one sentence without a final full stop.
    pub message: String,
    /// Where.
    pub place: FileRange,
    /// A few words under the place ("this is a `string`"); may be empty.
    pub label: String,
    /// The other sides of the fault.
    pub related: Vec<RelatedNote>,
    /// What to write instead; may be empty.
    pub help: String,
    /// The program the place lies in, for findings in code or in a program's header.
    pub program: Option<String>,
    /// The `.pjx` of the application.
    pub application: Option<File>,
    /// How to mend it.
    pub fix: Option<Fix>,
}

/// A change that mends a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fix {
    /// What it does, as an order: "write `endIf`".
    pub title: String,
    /// The program does the same as before, or what was plainly meant: applied without asking.
    pub safe: bool,
    /// What changes; the edits do not overlap.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// A fix that is applied without asking.
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
    /// Where.
    pub place: FileRange,
    /// What stands there afterwards, as it is written in the file (escaped where the code is).
    pub text: String,
}

/// Maximum number of uses that a finding lists when it represents many.
pub(crate) const MOST_RELATED: usize = 10;

/// Another side of a finding.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RelatedNote {
    /// Where.
    pub place: FileRange,
    /// What stands there, in a few words.
    pub message: String,
}

/// What a rule says about one fault; the place comes from the analysis.
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

/// One part a line, without the empty ones, for snapshots.
#[cfg(test)]
impl std::fmt::Display for Wording {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        writeln!(f, "{}", self.message)?;
        let parts = [("|", &self.label), ("?", &self.help)];
        parts.iter().filter(|(_, part)| !part.is_empty()).try_for_each(|(sign, part)| writeln!(f, "{sign} {part}"))
    }
}
