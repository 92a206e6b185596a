//! The outline of a file, and the symbol search in the workspace.

mod outline;
mod workspace;

pub(crate) use outline::datum_detail;
pub use outline::outline;
pub use workspace::workspace_symbols;

use smol_str::SmolStr;
use val3_analysis::db::FileRange;
use val3_syntax::TextRange;

/// Kind of a symbol.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SymbolKind {
    /// A project.
    Project,
    /// A program.
    Program,
    /// Global data, or a field of a user type.
    Data,
    /// A parameter.
    Parameter,
    /// A local variable.
    Local,
    /// A library identifier.
    Library,
    /// A user type.
    Type,
}

/// An item of the outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutlineItem {
    /// Name.
    pub name: SmolStr,
    /// Type or signature in short form; may be empty.
    pub detail: String,
    /// Kind.
    pub kind: SymbolKind,
    /// Range of the entire declaration.
    pub range: TextRange,
    /// Range of the name.
    pub name_range: TextRange,
    /// Nested items.
    pub children: Vec<OutlineItem>,
}

/// A symbol of the workspace.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WorkspaceSymbol {
    /// Name.
    pub name: SmolStr,
    /// Project to which it belongs.
    pub container: String,
    /// Kind.
    pub kind: SymbolKind,
    /// Location of the name in its declaration.
    pub place: FileRange,
}
