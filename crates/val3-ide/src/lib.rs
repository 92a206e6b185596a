//! Editor features for VAL 3, one a file: plain data in, plain data out.
//!
//! Positions are byte offsets of the file as the editor shows it, XML and all. Nothing here knows lines, URIs or a
//! protocol, and no tree leaves this crate.

mod completion;
mod diagnostics;
mod edit;
mod folding;
mod fuzzy;
mod highlight;
mod hover;
mod navigate;
mod owner;
mod references;
mod rename;
mod selection;
mod semantic_tokens;
mod signature_help;
mod symbols;

pub use completion::{Completion, CompletionKind, completions, documentation};
pub use diagnostics::{CheckSettings, project_diagnostics};
pub use edit::{FileEdit, SourceChange};
pub use folding::{Fold, FoldKind, folds};
pub use highlight::{Highlight, highlights};
pub use hover::{Hover, hover, type_at};
pub use navigate::{Target, definition, implementations, type_definition};
pub use owner::{owner, projects_of};
pub use references::references;
pub use rename::{RenameError, prepare_rename, rename};
pub use selection::selections;
pub use semantic_tokens::{SemanticToken, TokenKind, TokenModifier, semantic_tokens};
pub use signature_help::{Form, SignatureHelp, signature_help};
pub use symbols::{OutlineItem, SymbolKind, WorkspaceSymbol, outline, workspace_symbols};

use val3_analysis::db::File;
use val3_syntax::{TextRange, TextSize};

/// A place in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct FilePosition {
    /// The file.
    pub file: File,
    /// Bytes from its start.
    pub offset: TextSize,
}

/// A stretch of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct FileRange {
    /// The file.
    pub file: File,
    /// From where to where, in bytes.
    pub range: TextRange,
}

#[cfg(test)]
mod testing;
