//! The outline of a file, and the search for names in the whole workspace.

mod outline;
mod workspace;

pub(crate) use outline::datum_detail;
pub use outline::outline;
pub use workspace::workspace_symbols;

use smol_str::SmolStr;
use val3_analysis::db::FileRange;
use val3_syntax::TextRange;

/// The kind of an entry of the outline.
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

/// An entry of the outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutlineItem {
    /// The name.
    pub name: SmolStr,
    /// The type or signature, in a few words; may be empty.
    pub detail: String,
    /// Its kind.
    pub kind: SymbolKind,
    /// The whole declaration.
    pub range: TextRange,
    /// The name alone.
    pub name_range: TextRange,
    /// Entries inside of it.
    pub children: Vec<OutlineItem>,
}

/// A name of the workspace.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WorkspaceSymbol {
    /// The name.
    pub name: SmolStr,
    /// The project it belongs to.
    pub container: String,
    /// Its kind.
    pub kind: SymbolKind,
    /// Where its name is declared.
    pub place: FileRange,
}
