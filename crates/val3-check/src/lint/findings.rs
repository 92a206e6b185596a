//! Where lints put what they find.

use val3_analysis::db::{File, FileRange};
use val3_syntax::TextRange;

use crate::diagnostic::{Diagnostic, Edit, Fix, RelatedNote, Wording};
use crate::rule::{Rule, Severity};

/// The findings in one file.
pub(crate) struct Findings {
    file: File,
    program: Option<String>,
    application: File,
    found: Vec<Diagnostic>,
}

impl Findings {
    /// Findings in `file`, a program called `program` or another file, of the application with the project file
    /// `application`.
    pub(crate) fn new(file: File, program: Option<String>, application: File) -> Self {
        Self { file, program, application, found: Vec::new() }
    }

    /// Reports a finding; what it returns may be filled with what else there is to say.
    pub(crate) fn report(&mut self, rule: &'static Rule, range: TextRange, wording: Wording) -> Reported<'_> {
        self.found.push(Diagnostic {
            rule,
            severity: rule.severity,
            message: wording.message,
            place: FileRange { file: self.file, range },
            label: wording.label,
            related: Vec::new(),
            help: wording.help,
            program: self.program.clone(),
            application: Some(self.application),
            fix: None,
        });
        Reported { diagnostic: self.found.last_mut(), file: self.file }
    }

    /// Everything that was found.
    pub(crate) fn into_diagnostics(self) -> Vec<Diagnostic> {
        self.found
    }
}

/// A finding that was just reported.
pub(crate) struct Reported<'f> {
    diagnostic: Option<&'f mut Diagnostic>,
    file: File,
}

impl Reported<'_> {
    /// Names another side of the finding, in the same file.
    pub(crate) fn related(self, range: TextRange, message: impl Into<String>) -> Self {
        let place = FileRange { file: self.file, range };
        self.related_in(place, message)
    }

    /// Names another side of the finding, in any file.
    pub(crate) fn related_in(mut self, place: FileRange, message: impl Into<String>) -> Self {
        if let Some(diagnostic) = &mut self.diagnostic {
            diagnostic.related.push(RelatedNote { place, message: message.into() });
        }
        self
    }

    /// Names another side of the finding, if its place is known.
    pub(crate) fn related_at(self, place: Option<FileRange>, message: impl Into<String>) -> Self {
        match place {
            Some(place) => self.related_in(place, message),
            None => self,
        }
    }

    /// Gives the finding another level than that of its rule.
    pub(crate) fn level(mut self, severity: Severity) -> Self {
        if let Some(diagnostic) = &mut self.diagnostic {
            diagnostic.severity = severity;
        }
        self
    }

    /// Offers a change, if there are edits for it.
    pub(crate) fn fix(mut self, title: impl Into<String>, safe: bool, edits: impl IntoIterator<Item = Edit>) -> Self {
        let edits: Vec<Edit> = edits.into_iter().collect();
        if let Some(diagnostic) = self.diagnostic.as_mut().filter(|_| !edits.is_empty()) {
            diagnostic.fix = Some(Fix { title: title.into(), safe, edits });
        }
        self
    }
}
