//! Differences of a program.

use serde::Serialize;

use super::change::{Change, ValuePair};
use super::text::Hunk;

/// A program that differs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ProgramChange {
    /// Program name.
    pub name: String,
    /// Name in the old tree, if it differs.
    pub renamed_from: Option<String>,
    /// Path of the file.
    pub file: String,
    /// Change of the program.
    pub change: Change,
    /// Name and parameters in the new tree; in the old tree if the program was removed.
    pub signature: String,
    /// Name and parameters in both trees, if the parameters differ.
    pub signatures: Option<ValuePair<String>>,
    /// Access `public` or `private`, if it differs.
    pub access: Option<ValuePair<String>>,
    /// Whether the project file lists the program, if that differs. An unlisted program is no part of the application.
    pub listed: Option<ValuePair<bool>>,
    /// Whether the program is public in each tree.
    #[serde(skip)]
    pub public: ValuePair<bool>,
    /// Local variables that differ.
    pub locals: Vec<VariableChange>,
    /// Change of the code.
    pub code: CodeChange,
    /// Whether the description of the program differs.
    pub description_changed: bool,
}

impl ProgramChange {
    /// Whether a program in both trees has no difference.
    pub(crate) fn is_same(&self) -> bool {
        self.code.kind == CodeKind::Same && self.has_same_head()
    }

    /// Whether a program has no difference except in its code.
    pub(crate) fn has_same_head(&self) -> bool {
        self.renamed_from.is_none()
            && self.signatures.is_none()
            && self.access.is_none()
            && self.listed.is_none()
            && self.locals.is_empty()
            && !self.description_changed
    }
}

/// A local variable that differs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct VariableChange {
    /// Variable name.
    pub name: String,
    /// Change of the variable.
    pub change: Change,
    /// Old declaration, for example `num l_nA[3]`.
    pub old: Option<String>,
    /// New declaration.
    pub new: Option<String>,
}

/// Kind of difference in the code of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum CodeKind {
    /// No difference.
    Same,
    /// Only blanks, blank lines or the letter case of keywords differ.
    Layout,
    /// Only names of renamed programs and data differ, and possibly comments and layout.
    Renames,
    /// Only comments differ, and possibly layout.
    Comments,
    /// The statements differ.
    Code,
}

/// Difference in the code of a program.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CodeChange {
    /// Kind of difference.
    pub kind: CodeKind,
    /// Number of lines that are only in the new version; for an added program, all lines.
    pub added: usize,
    /// Number of lines that are only in the old version; for a removed program, all lines.
    pub removed: usize,
    /// Lines that differ with context. Line 1 is the line of `begin`. Empty for an added or removed program.
    pub hunks: Vec<Hunk>,
    /// Whether the code has syntax errors in each tree.
    pub syntax_errors: ValuePair<bool>,
}
