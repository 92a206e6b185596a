//! The state at one moment, for the threads that compute.

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
use val3_ide::{CheckSettings, FilePosition, FixContext};
use val3_lines::LineIndex;
use val3_syntax::TextRange;

use crate::detached;
use crate::documents::{Document, Documents};
use crate::lines::{Lines, line_index};
use crate::outbox::Outbox;
use crate::overlay;
use crate::progress::FirstPull;
use crate::session::Session;
use crate::uri;

/// Why a request has no result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Refusal {
    /// It asks about something that is no part of the workspace; there is nothing to say.
    Unknown,
    /// The request is impossible, with a sentence for the user.
    Because(String),
    /// It asks about a text that was edited since.
    Outdated,
}

/// The state at one moment.
pub(crate) struct Snapshot {
    /// Every file.
    pub(crate) db: Database,
    /// Information that the client has given about itself.
    pub(crate) session: Arc<Session>,
    /// The open documents.
    pub(crate) documents: Arc<Documents>,
    /// The projects that are judged.
    pub(crate) projects: Arc<Vec<Project>>,
    /// The settings of their check; `None` before the first of them was read.
    pub(crate) settings: Option<CheckSettings>,
    /// The faults of configurations.
    pub(crate) faults: Arc<Vec<ConfigError>>,
    /// The way to the client.
    pub(crate) outbox: Outbox,
    /// The program that executes tests.
    pub(crate) executable: Arc<str>,
    /// Reports to the main loop that the client asks for the faults of configurations.
    pub(crate) pulls_configurations: Arc<dyn Fn() + Send + Sync>,
    /// The token of the first answer about the whole workspace.
    pub(crate) first_pull: FirstPull,
    /// The URIs that were asked for: findings name the same files again and again.
    pub(crate) uris: RefCell<FxHashMap<File, Url>>,
    /// Marks the database as read. It is the last field: when it is dropped, `db` has been dropped.
    #[expect(dead_code, reason = "it is counted, not read")]
    pub(crate) reader: Arc<()>,
}

impl Snapshot {
    /// The database as the features ask it.
    pub(crate) fn db(&self) -> &dyn Db {
        &self.db
    }

    /// The file of a document. A document whose text does not count has none: its places mean something else.
    pub(crate) fn file(&self, uri: &Url) -> Result<File, Refusal> {
        let path = match self.documents.get(uri) {
            Some(document) if !self.documents.is_effective(document) => return Err(Refusal::Unknown),
            Some(document) => document.path.clone(),
            None => uri::path(uri, None).ok_or(Refusal::Unknown)?,
        };
        let sources = Sources::try_get(&self.db).ok_or(Refusal::Unknown)?;
        sources.files(&self.db).get(&path_key(path.as_str())).copied().ok_or(Refusal::Unknown)
    }

    /// The place that a client means.
    pub(crate) fn position(&self, at: &TextDocumentPositionParams) -> Result<FilePosition, Refusal> {
        self.position_in(&at.text_document.uri, at.position)
    }

    /// As [`position`](Self::position).
    pub(crate) fn position_in(&self, uri: &Url, position: Position) -> Result<FilePosition, Refusal> {
        let file = self.file(uri)?;
        Ok(FilePosition { file, offset: self.lines(file).offset(position) })
    }

    /// The lines of a file.
    pub(crate) fn lines(&self, file: File) -> Lines<'_> {
        self.lines_of(file, file.text(&self.db), line_index(&self.db, file))
    }

    /// The positions of another text of the file.
    pub(crate) fn lines_of<'a>(&self, file: File, text: &'a str, index: &'a LineIndex) -> Lines<'a> {
        let is_open = self.documents.at(file.path(&self.db)).is_some();
        Lines::new(text, index, self.session.encoding, !is_open)
    }

    /// A range of a file as the client counts.
    pub(crate) fn range(&self, file: File, range: TextRange) -> Range {
        self.lines(file).range(range)
    }

    /// A place as the client names it.
    pub(crate) fn location(&self, place: FileRange) -> Location {
        Location { uri: self.uri(place.file), range: self.range(place.file, place.range) }
    }

    /// A jump from a name to a place.
    pub(crate) fn link(&self, origin: Range, place: FileRange) -> LocationLink {
        let range = self.range(place.file, place.range);
        LocationLink {
            origin_selection_range: Some(origin),
            target_uri: self.uri(place.file),
            target_range: range,
            target_selection_range: range,
        }
    }

    /// The URI of a file, as the client spells it where it has the file open.
    pub(crate) fn uri(&self, file: File) -> Url {
        self.uris.borrow_mut().entry(file).or_insert_with(|| self.uri_of(file.path(&self.db))).clone()
    }

    /// As [`uri`](Self::uri), for any path.
    pub(crate) fn uri_of(&self, path: &Utf8Path) -> Url {
        self.documents.at(path).map_or_else(|| uri::of(path), |document| document.uri.clone())
    }

    /// Clients can open the file; the project file that a document without a project gets, they cannot.
    pub(crate) fn is_shown(&self, file: File) -> bool {
        !detached::is_manifest(file.path(&self.db))
    }

    /// Whether a document is a file of a project.
    pub(crate) fn is_part(&self, document: &Document, project: Project) -> bool {
        let sources = Sources::try_get(&self.db);
        let file = sources.and_then(|it| it.files(&self.db).get(&path_key(document.path.as_str())));
        file.is_some_and(|file| val3_ide::projects_of(&self.db, *file).contains(&project))
    }

    /// The findings of each project that has a file.
    pub(crate) fn findings(&self, file: File) -> impl Iterator<Item = Vec<Diagnostic>> {
        let judged = val3_ide::projects_of(&self.db, file).iter().filter(|it| self.projects.contains(it));
        let found = move |settings: CheckSettings| {
            judged.clone().map(move |it| val3_ide::project_diagnostics(&self.db, settings, &self.projects, *it))
        };
        self.settings.into_iter().flat_map(found)
    }

    /// Calls `ask` with the environment in which changes are tried.
    pub(crate) fn with_fixes<T>(&self, ask: impl FnOnce(FixContext<'_>) -> T) -> T {
        let system = overlay::files_of(self);
        let check_cancelled = || self.db.unwind_if_revision_cancelled();
        ask(FixContext { db: self.db(), system: &system, check_cancelled: &check_cancelled })
    }

    /// The version of the document that a file is open as.
    pub(crate) fn version(&self, file: File) -> Option<i32> {
        self.documents.at(file.path(&self.db)).map(|document| document.version)
    }
}
