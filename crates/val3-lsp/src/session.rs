//! The session: information that the client gives about itself.

use camino::Utf8PathBuf;
use serde_json::Value;
use tower_lsp::lsp_types::{
    InitializeParams, MarkupKind, PositionEncodingKind, ResourceOperationKind, TextDocumentClientCapabilities,
    WorkspaceEditClientCapabilities,
};
use val3_analysis::paths::normalise;
use val3_lines::Unit;

use crate::options::{Delivery, Options, SECTION};
use crate::uri;

/// One client and what was agreed with it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Session {
    /// The unit of columns.
    pub(crate) encoding: Unit,
    /// The folders it has open.
    pub(crate) folders: Vec<Utf8PathBuf>,
    /// The user's settings.
    pub(crate) options: Options,
    /// Its capabilities.
    pub(crate) client: ClientAbilities,
    /// The commands of ours that it brings.
    pub(crate) commands: ClientCommands,
    /// The trace level that it wants.
    pub(crate) trace: Trace,
}

/// The capabilities of a client that make a difference here.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct ClientAbilities {
    /// It reports files that change on the disk if it is asked to.
    pub(crate) watches_files: bool,
    /// It asks for findings.
    pub(crate) pulls: bool,
    /// It asks for findings again on request.
    pub(crate) pulls_again: bool,
    /// It can be asked for settings.
    pub(crate) has_settings: bool,
    /// It reports changed settings if it is asked to.
    pub(crate) reports_settings: bool,
    /// It shows how far work has come.
    pub(crate) shows_progress: bool,
    /// It can jump to links with an origin.
    pub(crate) has_links: bool,
    /// It fills in snippets.
    pub(crate) has_snippets: bool,
    /// It takes a completion when one of the named characters is typed.
    pub(crate) has_commit_characters: bool,
    /// How it wants longer texts.
    pub(crate) formats: Formats,
    /// It makes edits that the server asks for.
    pub(crate) applies_edits: bool,
    /// It creates, renames and deletes files as part of an edit.
    pub(crate) changes_files: FileChanges,
    /// It knows code actions with a kind; others know commands alone.
    pub(crate) has_code_actions: bool,
    /// It asks for the edit of a code action when that is chosen.
    pub(crate) resolves_edits: bool,
    /// It shows code actions that cannot be done, with the reason.
    pub(crate) shows_disabled: bool,
    /// It asks for the range of a symbol of the workspace when that is chosen.
    pub(crate) resolves_symbols: bool,
    /// It asks for the locations of an inlay hint when the pointer is on it.
    pub(crate) resolves_hints: bool,
    /// It asks for inlay hints again on request.
    pub(crate) refreshes_hints: bool,
    /// It asks for code lenses again on request.
    pub(crate) refreshes_lenses: bool,
    /// It knows edits that name the version they are made for.
    pub(crate) has_document_changes: bool,
    /// It shows an outline with levels.
    pub(crate) has_nested_symbols: bool,
    /// It folds whole lines only.
    pub(crate) folds_lines: bool,
}

/// How a client wants the texts of hovers, and of the documentation of completions and signatures.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Formats {
    pub(crate) hovers: TextFormat,
    pub(crate) completions: TextFormat,
    pub(crate) signatures: TextFormat,
}

/// How a client wants a text.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum TextFormat {
    /// As Markdown, which is said of it.
    Markdown,
    /// As plain text, which is said of it.
    PlainMarkup,
    /// It names no format: a string alone.
    #[default]
    Plain,
}

/// The file operations that a client can perform as part of an edit.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct FileChanges {
    pub(crate) creates: bool,
    pub(crate) renames: bool,
    pub(crate) deletes: bool,
}

/// The commands that a client brings for what the protocol does not know, named in `initializationOptions.commands`.
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
    /// Runs the application of a `.pjx`. Argument: its URI.
    pub(crate) const RUN: &str = "val3.run";
    /// Debugs it. Argument: its URI.
    pub(crate) const DEBUG: &str = "val3.debug";
    /// Executes a test of the application of a `.pjx`. Arguments: its URI and the name of the program.
    pub(crate) const RUN_TEST: &str = "val3.runTest";
    /// Debugs it. Arguments: the same.
    pub(crate) const DEBUG_TEST: &str = "val3.debugTest";
    /// Shows places. Arguments: the URI and the position they are asked for at, and the locations.
    pub(crate) const SHOW_REFERENCES: &str = "val3.showReferences";
    /// Starts the renaming of a name. Arguments: the URI and the range of the name.
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

/// How much a client wants to know.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Trace {
    /// Nothing.
    #[default]
    Off,
    /// Which requests are computed.
    On,
}

impl Session {
    /// Reads the first message of a client; the second value says what is wrong with its settings.
    pub(crate) fn new(params: &InitializeParams) -> (Self, Vec<String>) {
        let (options, faults) = Options::read(params.initialization_options.as_ref().unwrap_or(&Value::Null));
        let session = Self {
            encoding: encoding(params),
            folders: folders(params),
            options,
            client: ClientAbilities::of(params),
            commands: ClientCommands::read(params.initialization_options.as_ref()),
            trace: if params.trace.is_some_and(|trace| trace != tower_lsp::lsp_types::TraceValue::Off) {
                Trace::On
            } else {
                Trace::Off
            },
        };
        (session, faults)
    }

    /// The client asks for findings; the server sends none.
    pub(crate) fn is_asked_for_findings(&self) -> bool {
        match self.options.check.delivery {
            Delivery::Auto => self.client.pulls,
            Delivery::Push => false,
            Delivery::Pull => true,
        }
    }
}

/// UTF-8 where the client knows it, since texts are kept in it; otherwise what every client knows.
fn encoding(params: &InitializeParams) -> Unit {
    let general = params.capabilities.general.as_ref();
    let offered = general.and_then(|general| general.position_encodings.as_deref()).unwrap_or_default();
    let wanted = [
        (PositionEncodingKind::UTF8, Unit::Utf8),
        (PositionEncodingKind::UTF16, Unit::Utf16),
        (PositionEncodingKind::UTF32, Unit::Utf32),
    ];
    let agreed = wanted.iter().find(|(kind, _)| offered.contains(kind));
    agreed.map_or(Unit::Utf16, |(_, encoding)| *encoding)
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
