//! The session: information from the client about itself.

use camino::Utf8PathBuf;
use serde_json::Value;
use tower_lsp::lsp_types::{
    InitializeParams, MarkupKind, PositionEncodingKind, ResourceOperationKind, TextDocumentClientCapabilities,
    WorkspaceEditClientCapabilities,
};
use val3_analysis::paths::normalise;
use val3_lines::ColumnUnit;

use crate::options::{Delivery, Options, SECTION};
use crate::uri;

/// A client and the parameters agreed with it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Session {
    /// Unit of columns.
    pub(crate) encoding: ColumnUnit,
    /// Open folders.
    pub(crate) folders: Vec<Utf8PathBuf>,
    /// User's settings.
    pub(crate) options: Options,
    /// Client capabilities.
    pub(crate) client: ClientAbilities,
    /// Commands of this server that the client implements.
    pub(crate) commands: ClientCommands,
    /// Trace level.
    pub(crate) trace: TraceLevel,
}

/// Client capabilities; each field is true if the client supports the feature.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct ClientAbilities {
    /// Registration of file watchers.
    pub(crate) watches_files: bool,
    /// Pull of diagnostics.
    pub(crate) pulls: bool,
    /// `workspace/diagnostic/refresh`.
    pub(crate) pulls_again: bool,
    /// `workspace/configuration`.
    pub(crate) has_settings: bool,
    /// Registration for `workspace/didChangeConfiguration`.
    pub(crate) reports_settings: bool,
    /// Progress reports started by the server.
    pub(crate) shows_progress: bool,
    /// Location links with an origin range.
    pub(crate) has_links: bool,
    /// Snippets.
    pub(crate) has_snippets: bool,
    /// Commit characters of completion items.
    pub(crate) has_commit_characters: bool,
    /// Text formats.
    pub(crate) formats: Formats,
    /// `workspace/applyEdit`.
    pub(crate) applies_edits: bool,
    /// File operations within an edit.
    pub(crate) changes_files: FileChanges,
    /// `CodeAction` literals; other clients accept only `Command`.
    pub(crate) has_code_actions: bool,
    /// Resolving code action edits when an action is chosen.
    pub(crate) resolves_edits: bool,
    /// Disabled code actions with a reason.
    pub(crate) shows_disabled: bool,
    /// Resolving workspace symbol ranges when a symbol is chosen.
    pub(crate) resolves_symbols: bool,
    /// Resolving inlay hint locations when the pointer is on the hint.
    pub(crate) resolves_hints: bool,
    /// `workspace/inlayHint/refresh`.
    pub(crate) refreshes_hints: bool,
    /// `workspace/codeLens/refresh`.
    pub(crate) refreshes_lenses: bool,
    /// Edits with document versions.
    pub(crate) has_document_changes: bool,
    /// Nested document symbols.
    pub(crate) has_nested_symbols: bool,
    /// Only entire lines are folded.
    pub(crate) folds_lines: bool,
}

/// Text formats for hovers and for the documentation of completions and signatures.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Formats {
    pub(crate) hovers: TextFormat,
    pub(crate) completions: TextFormat,
    pub(crate) signatures: TextFormat,
}

/// Text format of a client.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum TextFormat {
    /// Markdown, sent as `MarkupContent`.
    Markdown,
    /// Plain text, sent as `MarkupContent`.
    PlainMarkup,
    /// The client states no format: a plain string is sent.
    #[default]
    Plain,
}

/// File operations that a client supports within edits.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct FileChanges {
    pub(crate) creates: bool,
    pub(crate) renames: bool,
    pub(crate) deletes: bool,
}

/// Commands that a client implements in addition to the protocol, listed in `initializationOptions.commands`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct ClientCommands {
    /// [`RUN`](Self::RUN)
    pub(crate) runs: bool,
    /// [`DEBUG`](Self::DEBUG)
    pub(crate) debugs: bool,
    /// [`RUN_TEST`](Self::RUN_TEST)
    pub(crate) runs_tests: bool,
    /// [`DEBUG_TEST`](Self::DEBUG_TEST)
    pub(crate) debugs_tests: bool,
    /// [`SHOW_REFERENCES`](Self::SHOW_REFERENCES)
    pub(crate) shows_references: bool,
    /// [`RENAME`](Self::RENAME)
    pub(crate) renames: bool,
    /// [`SELECT`](Self::SELECT)
    pub(crate) selects: bool,
}

impl ClientCommands {
    /// Runs the application of a `.pjx`. Argument: the URI of the `.pjx`.
    pub(crate) const RUN: &str = "val3.run";
    /// Debugs the application of a `.pjx`. Argument: the URI of the `.pjx`.
    pub(crate) const DEBUG: &str = "val3.debug";
    /// Executes a test. Arguments: the URI of the `.pjx` and the program name.
    pub(crate) const RUN_TEST: &str = "val3.runTest";
    /// Debugs a test. Arguments: the URI of the `.pjx` and the program name.
    pub(crate) const DEBUG_TEST: &str = "val3.debugTest";
    /// Shows references. Arguments: the URI and position of the request, and the locations.
    pub(crate) const SHOW_REFERENCES: &str = "val3.showReferences";
    /// Starts a rename. Arguments: the URI and the range of the name.
    pub(crate) const RENAME: &str = "val3.rename";
    /// Selects a text, which the user replaces. Arguments: the URI and the range of the text.
    pub(crate) const SELECT: &str = "val3.select";

    fn read(options: Option<&Value>) -> Self {
        let named = options.and_then(|options| options.get(SECTION).unwrap_or(options).get("commands"));
        let named = named.and_then(Value::as_array).map(Vec::as_slice).unwrap_or_default();
        let has = |command: &str| named.iter().any(|named| named == command);
        Self {
            runs: has(Self::RUN),
            debugs: has(Self::DEBUG),
            runs_tests: has(Self::RUN_TEST),
            debugs_tests: has(Self::DEBUG_TEST),
            shows_references: has(Self::SHOW_REFERENCES),
            renames: has(Self::RENAME),
            selects: has(Self::SELECT),
        }
    }
}

/// Trace level of a client.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum TraceLevel {
    /// No trace.
    #[default]
    Off,
    /// Computed requests.
    On,
}

impl Session {
    /// Reads the `initialize` parameters. The second value contains the error messages for invalid settings.
    pub(crate) fn new(params: &InitializeParams) -> (Self, Vec<String>) {
        let (options, faults) = Options::read(params.initialization_options.as_ref().unwrap_or(&Value::Null));
        let session = Self {
            encoding: encoding(params),
            folders: folders(params),
            options,
            client: ClientAbilities::of(params),
            commands: ClientCommands::read(params.initialization_options.as_ref()),
            trace: if params.trace.is_some_and(|trace| trace != tower_lsp::lsp_types::TraceValue::Off) {
                TraceLevel::On
            } else {
                TraceLevel::Off
            },
        };
        (session, faults)
    }

    /// Whether the client pulls findings, so that the server pushes none.
    pub(crate) fn is_asked_for_findings(&self) -> bool {
        match self.options.check.delivery {
            Delivery::Auto => self.client.pulls,
            Delivery::Push => false,
            Delivery::Pull => true,
        }
    }
}

/// Position encoding: UTF-8 if the client supports it, because texts are stored in UTF-8; otherwise UTF-16, which all
/// clients support.
fn encoding(params: &InitializeParams) -> ColumnUnit {
    let general = params.capabilities.general.as_ref();
    let offered = general.and_then(|general| general.position_encodings.as_deref()).unwrap_or_default();
    let wanted = [
        (PositionEncodingKind::UTF8, ColumnUnit::Utf8),
        (PositionEncodingKind::UTF16, ColumnUnit::Utf16),
        (PositionEncodingKind::UTF32, ColumnUnit::Utf32),
    ];
    let agreed = wanted.iter().find(|(kind, _)| offered.contains(kind));
    agreed.map_or(ColumnUnit::Utf16, |(_, encoding)| *encoding)
}

#[allow(deprecated, reason = "older clients name one folder only")]
fn folders(params: &InitializeParams) -> Vec<Utf8PathBuf> {
    let named = params.workspace_folders.iter().flatten().map(|folder| folder.uri.clone());
    let mut folders: Vec<Utf8PathBuf> = named.filter_map(|uri| uri::path(&uri, None)).collect();
    if params.workspace_folders.is_none() {
        let root = params.root_uri.as_ref().and_then(|uri| uri::path(uri, None));
        folders.extend(root.or_else(|| params.root_path.as_ref().map(Utf8PathBuf::from)));
    }
    folders.iter().map(|folder| normalise(folder)).collect()
}

impl ClientAbilities {
    fn of(params: &InitializeParams) -> Self {
        let workspace = params.capabilities.workspace.as_ref();
        let document = params.capabilities.text_document.as_ref();
        let window = params.capabilities.window.as_ref();
        let edit = workspace.and_then(|it| it.workspace_edit.as_ref());
        let folding = document.and_then(|it| it.folding_range.as_ref());
        let symbols = document.and_then(|it| it.document_symbol.as_ref());
        let item = document.and_then(|it| it.completion.as_ref()?.completion_item.as_ref());
        let action = document.and_then(|it| it.code_action.as_ref());
        let hint = document.and_then(|it| it.inlay_hint.as_ref()?.resolve_support.as_ref());
        let found = workspace.and_then(|it| it.symbol.as_ref()?.resolve_support.as_ref());
        let has_document_changes = yes(edit.and_then(|it| it.document_changes));
        Self {
            watches_files: yes(workspace.and_then(|it| it.did_change_watched_files?.dynamic_registration)),
            pulls: document.is_some_and(|it| it.diagnostic.is_some()),
            pulls_again: yes(workspace.and_then(|it| it.diagnostic.as_ref()?.refresh_support)),
            has_settings: yes(workspace.and_then(|it| it.configuration)),
            reports_settings: yes(workspace.and_then(|it| it.did_change_configuration?.dynamic_registration)),
            shows_progress: yes(window.and_then(|it| it.work_done_progress)),
            has_links: yes(document.and_then(|it| it.definition?.link_support)),
            has_snippets: yes(item.and_then(|it| it.snippet_support)),
            has_commit_characters: yes(item.and_then(|it| it.commit_characters_support)),
            formats: Formats::of(document),
            applies_edits: yes(workspace.and_then(|it| it.apply_edit)),
            changes_files: edit.filter(|_| has_document_changes).map(FileChanges::of).unwrap_or_default(),
            has_code_actions: action.is_some_and(|it| it.code_action_literal_support.is_some()),
            resolves_edits: yes(action.and_then(|it| it.data_support))
                && action.and_then(|it| it.resolve_support.as_ref()).is_some_and(|it| names(&it.properties, "edit")),
            shows_disabled: yes(action.and_then(|it| it.disabled_support)),
            resolves_symbols: found.is_some_and(|it| names(&it.properties, "location.range")),
            resolves_hints: hint.is_some_and(|it| names(&it.properties, "label.location")),
            refreshes_hints: yes(workspace.and_then(|it| it.inlay_hint.as_ref()?.refresh_support)),
            refreshes_lenses: yes(workspace.and_then(|it| it.code_lens.as_ref()?.refresh_support)),
            has_document_changes,
            has_nested_symbols: yes(symbols.and_then(|it| it.hierarchical_document_symbol_support)),
            folds_lines: yes(folding.and_then(|it| it.line_folding_only)),
        }
    }
}

impl TextFormat {
    fn of(formats: Option<&Vec<MarkupKind>>) -> Self {
        match formats {
            Some(formats) if formats.contains(&MarkupKind::Markdown) => Self::Markdown,
            Some(formats) if formats.contains(&MarkupKind::PlainText) => Self::PlainMarkup,
            _ => Self::Plain,
        }
    }
}

impl Formats {
    fn of(document: Option<&TextDocumentClientCapabilities>) -> Self {
        let item = document.and_then(|it| it.completion.as_ref()?.completion_item.as_ref());
        let signature = document.and_then(|it| it.signature_help.as_ref()?.signature_information.as_ref());
        Self {
            hovers: TextFormat::of(document.and_then(|it| it.hover.as_ref()?.content_format.as_ref())),
            completions: TextFormat::of(item.and_then(|it| it.documentation_format.as_ref())),
            signatures: TextFormat::of(signature.and_then(|it| it.documentation_format.as_ref())),
        }
    }
}

impl FileChanges {
    fn of(edit: &WorkspaceEditClientCapabilities) -> Self {
        let can = |kind| edit.resource_operations.as_ref().is_some_and(|operations| operations.contains(&kind));
        Self {
            creates: can(ResourceOperationKind::Create),
            renames: can(ResourceOperationKind::Rename),
            deletes: can(ResourceOperationKind::Delete),
        }
    }
}

fn yes(flag: Option<bool>) -> bool {
    flag == Some(true)
}

fn names(properties: &[String], property: &str) -> bool {
    properties.iter().any(|known| known == property)
}
