//! Differences of a program.

use serde::Serialize;

use super::change::{Change, Pair};
use super::text::Hunk;

/// A program that differs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ProgramChange {
    /// The name.
    pub name: String,
    /// The name in the old tree, if it was another one.
    pub renamed_from: Option<String>,
    /// The path of the file.
    pub file: String,
    /// What happened to it.
    pub change: Change,
    /// The line of its name and parameters, in the new tree if it is there.
    pub signature: String,
    /// Name and parameters of both trees, if the parameters differ.
    pub signatures: Option<Pair<String>>,
    /// `public` or `private`, if it differs.
    pub access: Option<Pair<String>>,
    /// Whether the project file lists it, if that differs. A program that is not listed is not part of the application.
    pub listed: Option<Pair<bool>>,
    /// The program is public in the old tree, in the new tree.
    #[serde(skip)]
    pub public: Pair<bool>,
    /// Local variables.
    pub locals: Vec<VariableChange>,
    /// The code.
    pub code: CodeChange,
    /// The description of the program differs.
    pub description_changed: bool,
}

impl ProgramChange {
    /// Whether nothing of a program of both trees differs.
    pub(crate) fn is_same(&self) -> bool {
        self.code.kind == CodeKind::Same && self.has_same_head()
    }

    /// Whether nothing but the code differs.
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
    /// The name.
    pub name: String,
    /// What happened to it.
    pub change: Change,
    /// The old declaration: `num l_nA[3]`.
    pub old: Option<String>,
    /// The new declaration.
    pub new: Option<String>,
}

/// How the code of a program differs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum CodeKind {
    /// It is the same.
    Same,
    /// Blanks, blank lines or the letter case of keywords differ.
    Layout,
    /// Only names of renamed programs and data differ, and comments and the layout may.
    Renames,
    /// Comments differ, and the layout may.
    Comments,
    /// The statements differ.
    Code,
}

/// The code of a program.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CodeChange {
    /// How it differs.
    pub kind: CodeKind,
    /// Lines that only the new version has. For an added program the number of its lines.
    pub added: usize,
    /// Lines that only the old version has. For a removed program the number of its lines.
    pub removed: usize,
    /// The lines that differ with their surroundings. Line 1 is the line of `begin`. Empty for an added or removed program.
    pub hunks: Vec<Hunk>,
    /// The old code has syntax errors, the new code has.
    pub syntax_errors: Pair<bool>,
}
