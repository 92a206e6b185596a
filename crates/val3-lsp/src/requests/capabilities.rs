//! Server capabilities.

use serde_json::{Map, Value, json};
use tower_lsp::lsp_types::*;
use val3_ide::{TokenKind, TokenModifier};
use val3_lines::ColumnUnit;

use super::{code_action, execute_command, file_operations, text_document_content};
use crate::session::Session;

/// Capabilities in the response to `initialize`.
pub(crate) fn capabilities(session: &Session) -> ServerCapabilities {
    ServerCapabilities {
        position_encoding: Some(position_encoding(session.encoding)),
        text_document_sync: Some(TextDocumentSyncCapability::Options(TextDocumentSyncOptions {
            open_close: Some(true),
            change: Some(TextDocumentSyncKind::INCREMENTAL),
            save: Some(TextDocumentSyncSaveOptions::Supported(true)),
            ..TextDocumentSyncOptions::default()
        })),
        diagnostic_provider: session.is_asked_for_findings().then(diagnostics),
        workspace: Some(WorkspaceServerCapabilities {
            workspace_folders: Some(WorkspaceFoldersServerCapabilities {
                supported: Some(true),
                change_notifications: Some(OneOf::Left(true)),
            }),
            file_operations: Some(file_operations::capabilities()),
        }),
        ..showing(navigation(writing(ServerCapabilities::default())))
    }
}

/// Features that show information in or next to the text.
fn showing(others: ServerCapabilities) -> ServerCapabilities {
    ServerCapabilities {
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        document_highlight_provider: Some(OneOf::Left(true)),
        document_symbol_provider: Some(OneOf::Left(true)),
        folding_range_provider: Some(FoldingRangeProviderCapability::Simple(true)),
        selection_range_provider: Some(SelectionRangeProviderCapability::Simple(true)),
        semantic_tokens_provider: Some(semantic_tokens().into()),
        code_lens_provider: Some(CodeLensOptions { resolve_provider: Some(true) }),
        inlay_hint_provider: Some(OneOf::Right(inlay_hints())),
        inline_value_provider: Some(OneOf::Left(true)),
        ..others
    }
}

/// Navigation features.
fn navigation(others: ServerCapabilities) -> ServerCapabilities {
    ServerCapabilities {
        definition_provider: Some(OneOf::Left(true)),
        declaration_provider: Some(DeclarationCapability::Simple(true)),
        type_definition_provider: Some(TypeDefinitionProviderCapability::Simple(true)),
        implementation_provider: Some(ImplementationProviderCapability::Simple(true)),
        references_provider: Some(OneOf::Left(true)),
        workspace_symbol_provider: Some(OneOf::Right(WorkspaceSymbolOptions {
            resolve_provider: Some(true),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        })),
        call_hierarchy_provider: Some(CallHierarchyServerCapability::Simple(true)),
        document_link_provider: Some(DocumentLinkOptions {
            resolve_provider: Some(false),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        }),
        ..others
    }
}

/// Features that change text.
fn writing(others: ServerCapabilities) -> ServerCapabilities {
    ServerCapabilities {
        completion_provider: Some(completion()),
        signature_help_provider: Some(signature_help()),
        rename_provider: Some(OneOf::Right(RenameOptions {
            prepare_provider: Some(true),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        })),
        linked_editing_range_provider: Some(LinkedEditingRangeServerCapabilities::Simple(true)),
        code_action_provider: Some(CodeActionProviderCapability::Options(CodeActionOptions {
            code_action_kinds: Some(code_action::KINDS.to_vec()),
            resolve_provider: Some(true),
            ..CodeActionOptions::default()
        })),
        execute_command_provider: Some(ExecuteCommandOptions {
            commands: execute_command::COMMANDS.map(str::to_owned).to_vec(),
            ..ExecuteCommandOptions::default()
        }),
        document_formatting_provider: Some(OneOf::Left(true)),
        document_range_formatting_provider: Some(OneOf::Left(true)),
        document_on_type_formatting_provider: Some(on_type_formatting()),
        ..others
    }
}

fn completion() -> CompletionOptions {
    CompletionOptions {
        resolve_provider: Some(true),
        trigger_characters: Some([".", ":", "\"", "/", "\\", "{", "[", "<", " "].map(str::to_owned).to_vec()),
        ..CompletionOptions::default()
    }
}

fn signature_help() -> SignatureHelpOptions {
    SignatureHelpOptions {
        trigger_characters: Some(["(", ",", "{", "["].map(str::to_owned).to_vec()),
        retrigger_characters: Some([")", "}", "]"].map(str::to_owned).to_vec()),
        ..SignatureHelpOptions::default()
    }
}

/// Adds the capabilities that have no field in lsp-types.
pub(crate) fn add_capabilities_without_type(capabilities: &mut Map<String, Value>) {
    capabilities.insert("typeHierarchyProvider".to_owned(), Value::Bool(true));
    if let Some(workspace) = capabilities.get_mut("workspace").and_then(Value::as_object_mut) {
        let schemes = json!({ "schemes": [text_document_content::SCHEME] });
        workspace.insert("textDocumentContent".to_owned(), schemes);
    }
}

fn on_type_formatting() -> DocumentOnTypeFormattingOptions {
    let [first, more @ ..] = val3_ide::FORMATTING_TRIGGERS;
    DocumentOnTypeFormattingOptions {
        first_trigger_character: first.to_string(),
        more_trigger_character: Some(more.iter().map(char::to_string).collect()),
    }
}

fn inlay_hints() -> InlayHintServerCapabilities {
    InlayHintServerCapabilities::Options(InlayHintOptions {
        resolve_provider: Some(true),
        work_done_progress_options: WorkDoneProgressOptions::default(),
    })
}

fn position_encoding(encoding: ColumnUnit) -> PositionEncodingKind {
    match encoding {
        ColumnUnit::Utf8 => PositionEncodingKind::UTF8,
        ColumnUnit::Utf16 => PositionEncodingKind::UTF16,
        ColumnUnit::Utf32 => PositionEncodingKind::UTF32,
    }
}

fn semantic_tokens() -> SemanticTokensOptions {
    let names = |names: &[&'static str]| names.to_vec();
    SemanticTokensOptions {
        legend: SemanticTokensLegend {
            token_types: names(TokenKind::NAMES).into_iter().map(SemanticTokenType::new).collect(),
            token_modifiers: names(TokenModifier::NAMES).into_iter().map(SemanticTokenModifier::new).collect(),
        },
        range: Some(true),
        full: Some(SemanticTokensFullOptions::Delta { delta: Some(true) }),
        ..SemanticTokensOptions::default()
    }
}

fn diagnostics() -> DiagnosticServerCapabilities {
    DiagnosticServerCapabilities::Options(DiagnosticOptions {
        identifier: Some("val3".to_owned()),
        inter_file_dependencies: true,
        workspace_diagnostics: true,
        work_done_progress_options: WorkDoneProgressOptions { work_done_progress: Some(true) },
    })
}
