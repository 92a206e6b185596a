//! The state of the server, which only the main loop may change. The steps of that loop are the modules below.

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
use crate::log::Log;
use crate::outbox::Outbox;
use crate::pool::Pool;
use crate::progress::{FirstPull, ScanProgress};
use crate::published::Published;
use crate::session::Session;
use crate::snapshot::Snapshot;

/// Takes an answer of the client; `None` if it refused.
type AnswerHandler = Box<dyn FnOnce(&mut ServerState, Option<Value>) + Send>;

/// Trees that are kept; they are cheap to make again.
pub(crate) const TREES: usize = 64;

/// A request that leaves more trees has results of queries in proportion: they are freed after it.
pub(crate) const MANY_TREES: usize = 512;

/// The state of the server. One thread owns it; all others see snapshots.
pub(crate) struct ServerState {
    /// Information that the client has given about itself.
    pub(crate) session: Arc<Session>,
    /// The open documents.
    pub(crate) documents: Arc<Documents>,
    /// The way to the client.
    pub(crate) outbox: Outbox,
    /// The way to this loop.
    pub(crate) inbox: Inbox,
    /// The file events that the client has registered for.
    pub(crate) published: Published,
    /// Which projects are to be checked.
    pub(crate) checks: Checks,
    /// The threads that compute.
    pub(crate) pool: Pool,
    /// How far the first scan has come.
    pub(crate) progress: ScanProgress,
    /// For the first time that the client asks for the findings of the workspace.
    first_pull: FirstPull,
    /// Watches the disk where the client does not.
    pub(crate) watcher: Option<notify::RecommendedWatcher>,
    /// The client can be asked.
    pub(crate) is_ready: bool,
    workspace: Workspace,
    projects: Arc<Vec<Project>>,
    settings: Option<CheckSettings>,
    /// Files that have to be read again before anything is asked.
    stale: Option<Stale>,
    /// Counts the edits of documents.
    edits: u64,
    /// Shared by all readers of the database.
    readers: Arc<()>,
    /// The database keeps results of earlier states.
    has_surplus: bool,
    /// Documents outside of every project have a project of their own.
    detached: Vec<Utf8PathBuf>,
    /// The faults of configurations.
    faults: Arc<Vec<ConfigError>>,
    /// The client asks for them, so that they are not sent as well.
    asks_for_configurations: bool,
    /// Posts to this loop that the client asks for them.
    pulls_configurations: Arc<dyn Fn() + Send + Sync>,
    /// The handlers of answers that the client has not given yet, by the id of the request.
    answer_handlers: FxHashMap<i64, AnswerHandler>,
    /// The messages that the user has already received.
    complained: FxHashSet<String>,
    log: Log,
    /// The program that executes tests.
    executable: Arc<str>,
}

impl ServerState {
    /// A server in which nothing is open.
    pub(crate) fn new(inbox: Inbox, outbox: Outbox, pool: Pool, log: Log, executable: &str) -> Self {
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

    /// The current state. A write waits until it is dropped.
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

    /// The client said what it is: its folders are read.
    pub(crate) fn begin(&mut self, session: Session) {
        self.session = Arc::new(session);
        self.all_is_stale();
    }

    /// The client can be asked from now on.
    pub(crate) fn ready(&mut self) {
        self.is_ready = true;
        self.ask_for_progress();
    }

    /// The database, to be read.
    pub(crate) fn database(&self) -> &Database {
        &self.workspace.db
    }

    /// The projects that are judged.
    pub(crate) fn projects(&self) -> &[Project] {
        &self.projects
    }

    /// The file at a path, if it is part of a project.
    pub(crate) fn file(&self, path: &Utf8Path) -> Option<File> {
        Sources::try_get(&self.workspace.db)?.files(&self.workspace.db).get(&path_key(path.as_str())).copied()
    }

    /// Whether files of projects were read in a folder.
    pub(crate) fn has_files_in(&self, folder: &Utf8Path) -> bool {
        let Some(sources) = Sources::try_get(&self.workspace.db) else { return false };
        let mut files = sources.files(&self.workspace.db).values();
        files.any(|file| inside(file.path(&self.workspace.db), folder).is_some())
    }

    /// A file could not be read.
    pub(crate) fn is_unreadable(&self, file: File) -> bool {
        matches!(file.status(&self.workspace.db), FileStatus::Unreadable(_))
    }

    /// A file, or everything in a folder, has to be read again.
    pub(crate) fn is_stale(&mut self, path: &Utf8Path) {
        self.stale.get_or_insert_with(Stale::settings).add(path);
    }

    /// Everything has to be read again.
    pub(crate) fn all_is_stale(&mut self) {
        self.stale = Some(Stale::Everything);
    }

    /// The user changed the settings.
    pub(crate) fn settings_are_stale(&mut self) {
        self.stale.get_or_insert_with(Stale::settings);
    }

    /// An edit of a document: whatever is being computed stops.
    pub(crate) fn edited(&mut self, file: Option<File>, text: &Arc<str>) {
        self.edits += 1;
        if let Some(file) = file
            && **file.text(&self.workspace.db) != **text
        {
            self.workspace.db.trigger_cancellation();
            self.has_surplus = true;
            // An edited file is likely to be edited again: later edits do not count as changes of stored files.
            file.set_text(&mut self.workspace.db).with_durability(Durability::LOW).to(Arc::clone(text));
            self.checks.edited(file);
        }
    }

    /// Whether requests have left results of many files.
    pub(crate) fn has_many_trees(db: &Database) -> bool {
        db.trees().count() > MANY_TREES
    }

    /// Frees data that is not needed at the moment.
    pub(crate) fn forget_surplus(&mut self) {
        self.has_surplus = false;
        self.workspace.db.trees().keep_latest(TREES);
        self.workspace.db.trigger_lru_eviction();
    }
}
