//! Client requests and notifications: one file for each request, one line here.

mod call_hierarchy;
mod capabilities;
mod code_action;
pub(crate) mod code_lens;
mod completion;
pub(crate) mod data;
mod definition;
mod delete_item;
pub(crate) mod diagnostics;
mod document_highlight;
mod document_link;
mod document_symbol;
mod edit_variables;
mod execute_command;
mod file_operations;
mod folding_range;
mod formatting;
mod hover;
pub(crate) mod inlay_hint;
mod inline_value;
mod libraries;
mod linked_editing_range;
mod page;
mod references;
mod rename;
mod selection_range;
mod semantic_tokens;
mod signature_help;
mod test_list;
pub(crate) mod text_document_content;
mod type_hierarchy;
mod variables;
mod workspace_symbol;
mod workspace_tree;

pub(crate) use capabilities::{add_capabilities_without_type, capabilities};

use serde_json::Value;
use tower_lsp::lsp_types::notification as n;
use tower_lsp::lsp_types::request as r;
use val3_schema::NameConflict;

use crate::job::OnEdit::{Refuse, Retry};
use crate::pool::Priority::{Background, Latency};
use crate::routes::Routes;
use crate::schema::{WORDS, described, of, protocol};
use crate::{initialize, sync, watching, workspace_folders};

/// All handlers by method.
pub(crate) fn routes() -> Routes {
    let mut routes = Routes::default();
    notifications(&mut routes);
    showing(&mut routes);
    navigation(&mut routes);
    writing(&mut routes);
    routes
}

/// Returns the JSON schema of all requests `val3/…`: parameters and results, by method.
///
/// # Errors
/// Two types have the same name and different schemas.
pub fn server_requests_schema() -> Result<Value, NameConflict> {
    WORDS.schema([
        // The parameters are ignored.
        described::<workspace_tree::WorkspaceTree, (), Vec<workspace_tree::TreeProject>>(),
        of::<libraries::Libraries>(),
        described::<libraries::AddLibrary, libraries::AddLibraryParams, protocol::WorkspaceEditSchema>(),
        described::<delete_item::Delete, protocol::DocumentPositionSchema, delete_item::Deletion>(),
        of::<page::DocPage>(),
        of::<variables::VariablesOfProgram>(),
        of::<edit_variables::EditVariables>(),
        of::<data::DataRequest>(),
        of::<data::EditData>(),
        of::<data::DataPoses>(),
    ])
}

/// Features that show information in or next to the text.
fn showing(routes: &mut Routes) {
    routes.on::<r::HoverRequest>(Latency, Refuse, hover::hover);
    routes.on::<r::DocumentHighlightRequest>(Latency, Refuse, document_highlight::document_highlight);
    routes.on::<r::DocumentSymbolRequest>(Latency, Retry, document_symbol::document_symbol);
    routes.on::<r::CodeLensRequest>(Latency, Retry, code_lens::code_lens);
    routes.on::<r::CodeLensResolve>(Latency, Refuse, code_lens::resolve);
    routes.on::<r::InlayHintRequest>(Latency, Refuse, inlay_hint::inlay_hint);
    routes.on::<r::InlayHintResolveRequest>(Latency, Refuse, inlay_hint::resolve);
    routes.on::<inline_value::InlineValues>(Latency, Refuse, inline_value::inline_value);
    routes.on::<r::FoldingRangeRequest>(Latency, Retry, folding_range::folding_range);
    routes.on::<r::SelectionRangeRequest>(Latency, Refuse, selection_range::selection_range);
    routes.on::<r::SemanticTokensFullRequest>(Latency, Retry, semantic_tokens::full);
    routes.on::<r::SemanticTokensFullDeltaRequest>(Latency, Retry, semantic_tokens::delta);
    routes.on::<r::SemanticTokensRangeRequest>(Latency, Refuse, semantic_tokens::range);
    routes.on::<r::DocumentDiagnosticRequest>(Latency, Retry, diagnostics::document);
    routes.on_in_parts::<r::WorkspaceDiagnosticRequest, _>(Background, Retry, diagnostics::workspace);
    routes.on::<workspace_tree::WorkspaceTree>(Background, Retry, workspace_tree::workspace_tree);
    routes.on::<variables::VariablesOfProgram>(Latency, Retry, variables::variables);
    routes.on::<libraries::Libraries>(Latency, Retry, libraries::libraries);
    routes.on::<page::DocPage>(Latency, Retry, page::page);
    routes.on::<text_document_content::TextDocumentContent>(
        Latency,
        Retry,
        text_document_content::text_document_content,
    );
    routes.on::<data::DataRequest>(Latency, Retry, data::data);
    routes.on::<data::DataPoses>(Latency, Retry, data::data_poses);
}

/// Navigation features.
fn navigation(routes: &mut Routes) {
    routes.on::<r::GotoDefinition>(Latency, Refuse, definition::definition);
    routes.on::<r::GotoDeclaration>(Latency, Refuse, definition::declaration);
    routes.on::<r::GotoTypeDefinition>(Latency, Refuse, definition::type_definition);
    routes.on::<r::GotoImplementation>(Latency, Refuse, definition::implementation);
    routes.on::<r::References>(Latency, Refuse, references::references);
    routes.on::<r::WorkspaceSymbolRequest>(Latency, Retry, workspace_symbol::workspace_symbol);
    routes.on::<r::WorkspaceSymbolResolve>(Latency, Retry, workspace_symbol::resolve);
    routes.on::<r::CallHierarchyPrepare>(Latency, Refuse, call_hierarchy::prepare);
    routes.on::<r::CallHierarchyIncomingCalls>(Latency, Retry, call_hierarchy::incoming);
    routes.on::<r::CallHierarchyOutgoingCalls>(Latency, Retry, call_hierarchy::outgoing);
    routes.on::<r::TypeHierarchyPrepare>(Latency, Refuse, type_hierarchy::prepare);
    routes.on::<r::TypeHierarchySupertypes>(Latency, Retry, type_hierarchy::supertypes);
    routes.on::<r::TypeHierarchySubtypes>(Latency, Retry, type_hierarchy::subtypes);
    routes.on::<r::DocumentLinkRequest>(Latency, Retry, document_link::document_link);
}

/// Features that change text.
fn writing(routes: &mut Routes) {
    routes.on::<r::Completion>(Latency, Refuse, completion::completion);
    routes.on::<r::ResolveCompletionItem>(Latency, Retry, completion::resolve);
    routes.on::<r::SignatureHelpRequest>(Latency, Refuse, signature_help::signature_help);
    routes.on::<r::CodeActionRequest>(Latency, Refuse, code_action::code_action);
    routes.on::<r::CodeActionResolveRequest>(Latency, Refuse, code_action::resolve);
    routes.on::<r::LinkedEditingRange>(Latency, Refuse, linked_editing_range::linked_editing_range);
    routes.on::<r::PrepareRenameRequest>(Latency, Refuse, rename::prepare);
    routes.on::<r::Rename>(Latency, Refuse, rename::rename);
    routes.on::<edit_variables::EditVariables>(Latency, Refuse, edit_variables::edit_variables);
    routes.on::<r::Formatting>(Latency, Refuse, formatting::whole);
    routes.on::<r::RangeFormatting>(Latency, Refuse, formatting::range);
    routes.on::<r::OnTypeFormatting>(Latency, Refuse, formatting::on_type);
    routes.on::<data::EditData>(Latency, Refuse, data::edit_data);
    routes.on::<r::WillRenameFiles>(Latency, Retry, file_operations::will_rename);
    routes.on::<r::WillCreateFiles>(Latency, Retry, file_operations::will_create);
    routes.on::<r::WillDeleteFiles>(Latency, Retry, file_operations::will_delete);
    routes.on::<libraries::AddLibrary>(Latency, Refuse, libraries::add_library);
    routes.on::<delete_item::Delete>(Latency, Refuse, delete_item::delete);
    routes.on::<r::ExecuteCommand>(Latency, Retry, execute_command::execute_command);
}

fn notifications(routes: &mut Routes) {
    routes.notify::<n::Initialized>(initialize::initialized);
    routes.notify::<n::DidOpenTextDocument>(sync::opened);
    routes.notify::<n::DidChangeTextDocument>(sync::changed);
    routes.notify::<n::DidSaveTextDocument>(sync::saved);
    routes.notify::<n::DidCloseTextDocument>(sync::closed);
    routes.notify::<n::DidChangeWatchedFiles>(watching::changed);
    routes.notify::<n::DidRenameFiles>(file_operations::renamed);
    routes.notify::<n::DidCreateFiles>(file_operations::created);
    routes.notify::<n::DidDeleteFiles>(file_operations::deleted);
    routes.notify::<n::DidChangeWorkspaceFolders>(workspace_folders::folders_changed);
    routes.notify::<n::DidChangeConfiguration>(workspace_folders::settings_changed);
    routes.notify::<n::SetTrace>(workspace_folders::trace_set);
}
