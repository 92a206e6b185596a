//! Snapshot of the server state, for the thread pool.

use std::cell::RefCell;
use std::sync::Arc;

use camino::Utf8Path;
use rustc_hash::FxHashMap;
use salsa::Database as _;
use tower_lsp::lsp_types::{Location, LocationLink, Position, Range, TextDocumentPositionParams, Url};
use val3_analysis::db::{Database, Db, File, FileRange, Project, Sources};
use val3_analysis::paths::path_key;
use val3_check::diagnostic::Diagnostic;
use val3_config::ConfigError;
use val3_ide::{CheckSettings, FilePosition, FixContext, RefactoringError};
use val3_lines::LineIndex;
use val3_syntax::TextRange;

use crate::detached;
use crate::documents::{Document, Documents};
use crate::lines::{PositionConverter, line_index};
use crate::outbox::Outbox;
use crate::overlay;
use crate::progress::FirstPull;
use crate::session::Session;
use crate::uri;

/// Reason why a request has no result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// The request concerns something outside the workspace; the result is empty.
    Unknown,
    /// The request is impossible, with a sentence for the user.
    Because(String),
    /// The request is based on a text that was edited since.
    Outdated,
}

impl From<RefactoringError> for Refusal {
    fn from(RefactoringError(reason): RefactoringError) -> Self {
        Self::Because(reason)
    }
}

/// Snapshot of the server state.
pub(crate) struct Snapshot {
    /// Database of all files.
    pub(crate) db: Database,
    /// Information from the client about itself.
    pub(crate) session: Arc<Session>,
    /// Open documents.
    pub(crate) documents: Arc<Documents>,
    /// Checked projects.
    pub(crate) projects: Arc<Vec<Project>>,
    /// Check settings; `None` before any project was read.
    pub(crate) settings: Option<CheckSettings>,
    /// Configuration faults.
    pub(crate) faults: Arc<Vec<ConfigError>>,
    /// Sender of messages to the client.
    pub(crate) outbox: Outbox,
    /// The executable that executes tests.
    pub(crate) executable: Arc<str>,
    /// Reports to the main loop that the client pulls configuration faults.
    pub(crate) pulls_configurations: Arc<dyn Fn() + Send + Sync>,
    /// Progress token for the first pull of workspace findings.
    pub(crate) first_pull: FirstPull,
    /// Cached URIs, because findings name the same files repeatedly.
    pub(crate) uris: RefCell<FxHashMap<File, Url>>,
    /// Marks the database as read. It must be the last field, so that `db` is dropped before it.
    #[expect(dead_code, reason = "it is counted, not read")]
    pub(crate) reader: Arc<()>,
}

impl Snapshot {
    /// The database in the form that features accept.
    pub(crate) fn db(&self) -> &dyn Db {
        &self.db
    }

    /// File of a document. Fails for a document that does not determine its file's text, because its positions belong
    /// to another text.
    pub(crate) fn file(&self, uri: &Url) -> Result<File, Refusal> {
        let path = match self.documents.get(uri) {
            Some(document) if !self.documents.is_effective(document) => return Err(Refusal::Unknown),
            Some(document) => document.path.clone(),
            None => uri::path(uri, None).ok_or(Refusal::Unknown)?,
        };
        let sources = Sources::try_get(&self.db).ok_or(Refusal::Unknown)?;
        sources.files(&self.db).get(&path_key(path.as_str())).copied().ok_or(Refusal::Unknown)
    }

    /// Position of a request.
    pub(crate) fn position(&self, at: &TextDocumentPositionParams) -> Result<FilePosition, Refusal> {
        self.position_in(&at.text_document.uri, at.position)
    }

    /// Like [`position`](Self::position).
    pub(crate) fn position_in(&self, uri: &Url, position: Position) -> Result<FilePosition, Refusal> {
        let file = self.file(uri)?;
        Ok(FilePosition { file, offset: self.lines(file).offset(position) })
    }

    /// Lines of a file.
    pub(crate) fn lines(&self, file: File) -> PositionConverter<'_> {
        self.lines_of(file, file.text(&self.db), line_index(&self.db, file))
    }

    /// Lines of a text that replaces the file's text.
    pub(crate) fn lines_of<'a>(&self, file: File, text: &'a str, index: &'a LineIndex) -> PositionConverter<'a> {
        let is_open = self.documents.at(file.path(&self.db)).is_some();
        PositionConverter::new(text, index, self.session.encoding, !is_open)
    }

    /// Range in the client's units.
    pub(crate) fn range(&self, file: File, range: TextRange) -> Range {
        self.lines(file).range(range)
    }

    /// Location in the client's units.
    pub(crate) fn location(&self, place: FileRange) -> Location {
        Location { uri: self.uri(place.file), range: self.range(place.file, place.range) }
    }

    /// Location link from a name to a range.
    pub(crate) fn link(&self, origin: Range, place: FileRange) -> LocationLink {
        let range = self.range(place.file, place.range);
        LocationLink {
            origin_selection_range: Some(origin),
            target_uri: self.uri(place.file),
            target_range: range,
            target_selection_range: range,
        }
    }

    /// URI of a file, in the client's spelling if the file is open.
    pub(crate) fn uri(&self, file: File) -> Url {
        self.uris.borrow_mut().entry(file).or_insert_with(|| self.uri_of(file.path(&self.db))).clone()
    }

    /// Like [`uri`](Self::uri), for any path.
    pub(crate) fn uri_of(&self, path: &Utf8Path) -> Url {
        self.documents.at(path).map_or_else(|| uri::of(path), |document| document.uri.clone())
    }

    /// Whether clients can open the file. They cannot open the generated project file of a detached document.
    pub(crate) fn is_shown(&self, file: File) -> bool {
        !detached::is_manifest(file.path(&self.db))
    }

    /// Whether a document is a file of the project.
    pub(crate) fn is_part(&self, document: &Document, project: Project) -> bool {
        let sources = Sources::try_get(&self.db);
        let file = sources.and_then(|it| it.files(&self.db).get(&path_key(document.path.as_str())));
        file.is_some_and(|file| val3_ide::projects_of(&self.db, *file).contains(&project))
    }

    /// Findings in each project that contains the file.
    pub(crate) fn findings(&self, file: File) -> impl Iterator<Item = Vec<Diagnostic>> {
        let judged = val3_ide::projects_of(&self.db, file).iter().filter(|it| self.projects.contains(it));
        self.settings.into_iter().flat_map(move |settings| {
            judged.clone().map(move |it| val3_ide::project_diagnostics(&self.db, settings, &self.projects, *it))
        })
    }

    /// Calls `ask` with the context in which changes are tried.
    pub(crate) fn with_fixes<T>(&self, ask: impl FnOnce(FixContext<'_>) -> T) -> T {
        let system = overlay::files_of(self);
        let check_cancelled = || self.db.unwind_if_revision_cancelled();
        ask(FixContext { db: self.db(), system: &system, check_cancelled: &check_cancelled })
    }

    /// Version of the open document that determines the file's text.
    pub(crate) fn version(&self, file: File) -> Option<i32> {
        self.documents.at(file.path(&self.db)).map(|document| document.version)
    }
}
