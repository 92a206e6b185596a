//! Lossless syntax trees of VAL 3 files.
//!
//! One tree contains an entire `.pjx`, `.dtx` or `.pgx` file, XML and code together, so that a range in the tree is a
//! range in the file. Parsing never fails and omits no byte: the text of the tree equals the input.

pub mod arm_file;
pub mod ast;
pub mod characters;
pub mod conflict;
pub mod document;
mod edit;
pub mod encoding;
pub mod error;
pub mod foreign;
mod grammar;
mod joined;
pub mod kind;
mod lexer;
mod never;
mod parse;
mod parser;
mod tree;
pub mod version_file;
pub mod view;
pub mod xml;

pub use edit::{TextEdit, apply_edits};
pub use joined::joined;
pub use kind::{SyntaxElement, SyntaxKind, SyntaxNode, SyntaxToken};
pub use lexer::{decode_entities, resolve_entity};
pub use never::{Bug, BugHook, TextSlice, report as report_bug, set_bug_hook, text_at, text_size};
pub use parse::{Parse, parse, parse_shared};
pub use rowan::{TextRange, TextSize};
