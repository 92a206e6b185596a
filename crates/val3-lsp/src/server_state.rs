//! Server state, which only the main loop may change. The modules below contain the steps of the main loop.

mod checking;
mod client_requests;
mod main_loop;
mod messages;
mod progress;
mod publishing;
mod reading;
mod refresh;
mod settings;
mod stale;

use std::cell::RefCell;
use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::{FxHashMap, FxHashSet};
use salsa::{Database as _, Durability, Setter as _};
use serde_json::Value;
use val3_analysis::db::{Database, Db as _, File, FileStatus, Project, Sources};
use val3_analysis::load::Workspace;
use val3_analysis::paths::{inside, path_key};

use val3_config::ConfigError;
use val3_ide::CheckSettings;

use self::stale::Stale;
use crate::checks::Checks;
use crate::documents::Documents;
use crate::inbox::Inbox;
use crate::log::ServerLog;
use crate::outbox::Outbox;
use crate::pool::Pool;
use crate::progress::{FirstPull, ScanProgress};
use crate::published::Published;
use crate::session::Session;
use crate::snapshot::Snapshot;

/// Handler of a client's response; it receives `None` if the client returned an error.
type AnswerHandler = Box<dyn FnOnce(&mut ServerState, Option<Value>) + Send>;

/// Limit of cached syntax trees, which are cheap to parse again.
pub(crate) const TREES: usize = 64;

/// Number of syntax trees above which cached query results are freed after a request, because their number grows in
/// proportion.
pub(crate) const MANY_TREES: usize = 512;

/// Server state. One thread owns it; all other threads read snapshots.
pub(crate) struct ServerState {
    /// Information from the client's `initialize` and its settings.
    pub(crate) session: Arc<Session>,
    /// Open documents.
    pub(crate) documents: Arc<Documents>,
    /// Sender of messages to the client.
    pub(crate) outbox: Outbox,
    /// Sender of messages to the main loop.
    pub(crate) inbox: Inbox,
    /// Latest diagnostics by origin, and the diagnostics that the client has.
    pub(crate) published: Published,
    /// Pending checks.
    pub(crate) checks: Checks,
    /// Thread pool.
    pub(crate) pool: Pool,
    /// Progress of the first scan.
    pub(crate) progress: ScanProgress,
    /// Progress token for the client's first pull of workspace findings.
    first_pull: FirstPull,
    /// Watcher of the disk, used if the client does not watch files.
    pub(crate) watcher: Option<notify::RecommendedWatcher>,
    /// Whether the client is initialized, so that the server may send requests.
    pub(crate) is_ready: bool,
    workspace: Workspace,
    projects: Arc<Vec<Project>>,
    settings: Option<CheckSettings>,
    /// Files to be read again before anything is computed.
    stale: Option<Stale>,
    /// Number of document edits since the start.
    edits: u64,
    /// Shared by all readers of the database, so that its reference count is their number plus one.
    readers: Arc<()>,
    /// Whether the database still holds results of earlier revisions.
    has_surplus: bool,
    /// Documents that no project lists; each belongs to its own generated project.
    detached: Vec<Utf8PathBuf>,
    /// Configuration faults.
    faults: Arc<Vec<ConfigError>>,
    /// Whether the client pulls configuration faults, which are then not pushed.
    asks_for_configurations: bool,
    /// Posts to the main loop that the client pulls configuration faults.
    pulls_configurations: Arc<dyn Fn() + Send + Sync>,
    /// Handlers of pending responses, by request id.
    answer_handlers: FxHashMap<i64, AnswerHandler>,
    /// Messages already shown to the user.
    complained: FxHashSet<String>,
    log: ServerLog,
    /// The executable that executes tests.
    executable: Arc<str>,
}

impl ServerState {
    /// Creates a server without open folders and documents.
    pub(crate) fn new(inbox: Inbox, outbox: Outbox, pool: Pool, log: ServerLog, executable: &str) -> Self {
        let own = inbox.clone();
        Self {
            session: Arc::default(),
            documents: Arc::default(),
            outbox,
            inbox,
            published: Published::default(),
            checks: Checks::default(),
            pool,
            progress: ScanProgress::default(),
            first_pull: FirstPull::default(),
            watcher: None,
            is_ready: false,
            workspace: Workspace::empty(),
            projects: Arc::default(),
            settings: None,
            stale: None,
            edits: 0,
            readers: Arc::default(),
            has_surplus: false,
            detached: Vec::new(),
            faults: Arc::default(),
            asks_for_configurations: false,
            pulls_configurations: Arc::new(move || own.post(Self::configurations_are_asked_for)),
            answer_handlers: FxHashMap::default(),
            complained: FxHashSet::default(),
            log,
            executable: executable.into(),
        }
    }

    /// Snapshot of the current state. A write blocks until all snapshots are dropped.
    pub(crate) fn snapshot(&self) -> Snapshot {
        Snapshot {
            db: self.workspace.db.clone(),
            session: Arc::clone(&self.session),
            documents: Arc::clone(&self.documents),
            projects: Arc::clone(&self.projects),
            settings: self.settings,
            faults: Arc::clone(&self.faults),
            outbox: self.outbox.clone(),
            executable: Arc::clone(&self.executable),
            pulls_configurations: Arc::clone(&self.pulls_configurations),
            first_pull: self.first_pull.clone(),
            uris: RefCell::default(),
            reader: Arc::clone(&self.readers),
        }
    }

    /// Starts the session: the client's folders are marked to be read.
    pub(crate) fn begin(&mut self, session: Session) {
        self.session = Arc::new(session);
        self.mark_all_stale();
    }

    /// Marks the client as initialized, so that the server may send requests.
    pub(crate) fn ready(&mut self) {
        self.is_ready = true;
        self.ask_for_progress();
    }

    /// The database, for reading.
    pub(crate) fn database(&self) -> &Database {
        &self.workspace.db
    }

    /// Checked projects.
    pub(crate) fn projects(&self) -> &[Project] {
        &self.projects
    }

    /// File at a path; `None` if no project contains it.
    pub(crate) fn file(&self, path: &Utf8Path) -> Option<File> {
        Sources::try_get(&self.workspace.db)?.files(&self.workspace.db).get(&path_key(path.as_str())).copied()
    }

    /// Whether the folder contains files of a project that were read.
    pub(crate) fn has_files_in(&self, folder: &Utf8Path) -> bool {
        let Some(sources) = Sources::try_get(&self.workspace.db) else { return false };
        let mut files = sources.files(&self.workspace.db).values();
        files.any(|file| inside(file.path(&self.workspace.db), folder).is_some())
    }

    /// Whether the file could not be read.
    pub(crate) fn is_unreadable(&self, file: File) -> bool {
        matches!(file.status(&self.workspace.db), FileStatus::Unreadable(_))
    }

    /// Marks a file, or all files in a folder, to be read again.
    pub(crate) fn mark_stale(&mut self, path: &Utf8Path) {
        self.stale.get_or_insert_with(Stale::settings).add(path);
    }

    /// Marks all files to be read again.
    pub(crate) fn mark_all_stale(&mut self) {
        self.stale = Some(Stale::Everything);
    }

    /// Marks the settings to be read again.
    pub(crate) fn settings_are_stale(&mut self) {
        self.stale.get_or_insert_with(Stale::settings);
    }

    /// Applies an edit of a document and cancels all running computations.
    pub(crate) fn edited(&mut self, file: Option<File>, text: &Arc<str>) {
        self.edits += 1;
        if let Some(file) = file
            && **file.text(&self.workspace.db) != **text
        {
            self.workspace.db.trigger_cancellation();
            self.has_surplus = true;
            // An edited file is likely to be edited again. The low durability keeps later edits from invalidating
            // results that depend on stored files only.
            file.set_text(&mut self.workspace.db).with_durability(Durability::LOW).to(Arc::clone(text));
            self.checks.edited(file);
        }
    }

    /// Whether requests have left results of many files.
    pub(crate) fn has_many_trees(db: &Database) -> bool {
        db.trees().count() > MANY_TREES
    }

    /// Frees cached data.
    pub(crate) fn forget_surplus(&mut self) {
        self.has_surplus = false;
        self.workspace.db.trees().keep_latest(TREES);
        self.workspace.db.trigger_lru_eviction();
    }
}
