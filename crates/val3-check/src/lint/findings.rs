//! Collects the findings of lints.

use val3_analysis::db::{File, FileEdit, FileRange};
use val3_syntax::TextRange;

use crate::diagnostic::{Diagnostic, Fix, RelatedNote, Wording};
use crate::rule::{Rule, Severity};

/// Findings in one file.
pub(crate) struct Findings {
    file: File,
    program: Option<String>,
    application: File,
    found: Vec<Diagnostic>,
}

impl Findings {
    /// Creates an empty list for `file`, which contains a program named `program` or no program, in the application
    /// with the project file `application`.
    pub(crate) fn new(file: File, program: Option<String>, application: File) -> Self {
        Self { file, program, application, found: Vec::new() }
    }

    /// Reports a finding. The result can add optional parts to it.
    pub(crate) fn report(&mut self, rule: &'static Rule, range: TextRange, wording: Wording) -> ReportedFinding<'_> {
        let (program, application) = (self.program.clone(), Some(self.application));
        let place = FileRange { file: self.file, range };
        self.found.push(Diagnostic { program, application, ..Diagnostic::new(rule, wording, place) });
        ReportedFinding { diagnostic: self.found.last_mut(), file: self.file }
    }

    /// All findings.
    pub(crate) fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.found
    }
}

/// A finding that was just reported.
pub(crate) struct ReportedFinding<'f> {
    diagnostic: Option<&'f mut Diagnostic>,
    file: File,
}

impl ReportedFinding<'_> {
    /// Adds another location in the same file.
    pub(crate) fn related(self, range: TextRange, message: impl Into<String>) -> Self {
        let place = FileRange { file: self.file, range };
        self.related_in(place, message)
    }

    /// Adds another location in any file.
    pub(crate) fn related_in(mut self, place: FileRange, message: impl Into<String>) -> Self {
        if let Some(diagnostic) = &mut self.diagnostic {
            diagnostic.related.push(RelatedNote { place, message: message.into() });
        }
        self
    }

    /// Adds another location if it is known.
    pub(crate) fn related_at(self, place: Option<FileRange>, message: impl Into<String>) -> Self {
        match place {
            Some(place) => self.related_in(place, message),
            None => self,
        }
    }

    /// Sets a level that differs from the rule's level.
    pub(crate) fn level(mut self, severity: Severity) -> Self {
        if let Some(diagnostic) = &mut self.diagnostic {
            diagnostic.severity = severity;
        }
        self
    }

    /// Adds a fix if there are edits for it.
    pub(crate) fn fix(
        mut self,
        title: impl Into<String>,
        safe: bool,
        edits: impl IntoIterator<Item = FileEdit>,
    ) -> Self {
        let edits: Vec<FileEdit> = edits.into_iter().collect();
        if let Some(diagnostic) = self.diagnostic.as_mut().filter(|_| !edits.is_empty()) {
            diagnostic.fix = Some(Fix { title: title.into(), safe, edits });
        }
        self
    }
}
