//! Editor features for VAL 3, one per file. Input and output are plain data.
//!
//! Positions are byte offsets in the file as the editor displays it, including XML. The crate has no concept of lines,
//! URIs or protocols, and does not return syntax trees.

mod access;
mod add_reference;
mod assists;
mod call_hierarchy;
mod change_signature;
mod code_lens;
mod code_text;
mod completion;
mod data_edits;
mod data_poses;
mod data_tables;
mod declare;
mod delete_item;
mod diagnostics;
mod document_links;
mod edit;
mod father_paths;
mod file_operations;
mod folding;
mod formatting;
mod fuzzy;
mod highlight;
mod hover;
mod inlay_hints;
mod inline_values;
mod io_links;
mod line;
mod linked_editing;
mod markdown;
mod navigate;
mod new_test;
mod owner;
mod placement;
mod program_text;
mod project_tree;
mod reachable_projects;
mod reached;
mod refactoring_error;
mod references;
mod rename;
mod selection;
mod semantic_tokens;
mod signature_help;
mod symbols;
mod test_programs;
mod trial;
mod type_hierarchy;
mod variables;
mod xml_context;
mod xml_cursor;
mod xml_list;

pub use add_reference::{ReferenceCandidate, ReferenceKind, add_reference, reference_candidates, takes_types};
pub use assists::{Assist, AssistKind, FixContext, QuickFix, assists, fix_all, quick_fixes, resolve_assist};
pub use call_hierarchy::{Call, CallItem, call_item, incoming_calls, outgoing_calls};
pub use change_signature::{NewLocal, NewParameter, NewVariables, change_signature};
pub use code_lens::{CodeLens, LensKind, code_lenses, lens_references};
pub use code_text::code_text;
pub use completion::{
    Completion, CompletionKind, completes_after_blank, completion_documentation, completions, completions_in,
    documentation, mesh_completions,
};
pub use data_edits::{CellEdit, DataEdit, NewDatum, added_data_findings, data_edits};
pub use data_poses::{DataPose, PoseReach, data_poses};
pub use data_tables::{
    ColumnKind, DataColumn, DataFinding, DataOutline, DataPlace, DataProblem, DataTables, DataType, DatumSource,
    DatumValue, Dialect, FieldStep, TableVariable, TypeField, data_findings, data_outline, data_rows, data_tables,
};
pub use delete_item::{Deletion, delete_item};
pub use diagnostics::{CheckSettings, check_project, program_diagnostics, project_diagnostics};
pub use document_links::{DocumentLink, document_links};
pub use edit::{FileEdit, SourceChange};
pub use file_operations::{will_create_files, will_delete_files, will_rename_files};
pub use folding::{Fold, FoldKind, folds};
pub use formatting::{FORMATTING_TRIGGERS, UnreadableStyle, format_file, format_on_type, format_range, style};
pub use highlight::{Highlight, highlights};
pub use hover::{Hover, hover, type_at};
pub use inlay_hints::{InlayHint, InlayHintKind, InlayHintSettings, inlay_hint_target, inlay_hints};
pub use inline_values::{InlineValue, inline_values};
pub use linked_editing::linked_names;
pub use navigate::{NavigationTarget, declarations, definition, implementations, type_definition};
pub use new_test::new_test;
pub use owner::{owner, projects_of};
pub use program_text::{program_text, write_program};
pub use project_tree::{
    ProjectContent, ProjectKind, TreeData, TreeItem, TreeProgram, TreeReference, project_content, project_kinds,
};
pub use refactoring_error::RefactoringError;
pub use references::references;
pub use rename::{prepare_rename, rename};
pub use selection::selections;
pub use semantic_tokens::{SemanticToken, TokenKind, TokenModifier, semantic_tokens};
pub use signature_help::{CallForm, SignatureHelp, signature_help};
pub use symbols::{OutlineItem, SymbolKind, WorkspaceSymbol, outline, workspace_symbols};
pub use test_programs::{TestProgram, test_programs};
pub use type_hierarchy::{TypeItem, subtypes, supertypes, type_item};
pub use val3_fmt::CodeStyle;
pub use variables::{ProgramVariable, Variables, edit_variables, variables};

use val3_analysis::db::File;
use val3_syntax::TextSize;

/// An offset in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct FilePosition {
    /// The file.
    pub file: File,
    /// Offset in bytes.
    pub offset: TextSize,
}

#[cfg(test)]
mod testing;
