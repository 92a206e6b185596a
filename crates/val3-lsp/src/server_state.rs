//! The main loop and everything that only it may change.

mod messages;
mod reading;

use std::cell::RefCell;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError};

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use salsa::{Cancelled, Database as _, Durability, Setter as _};
use tower_lsp::jsonrpc::{Error, Result};
use val3_analysis::db::{Database, Db as _, File, FileStatus, Project, Sources, path_key};
use val3_analysis::load::Workspace;
use val3_analysis::paths::inside;
use val3_config::ConfigError;
use val3_ide::CheckSettings;

use self::reading::Stale;
use crate::checks::Checks;
use crate::documents::Documents;
use crate::inbox::{Inbox, Message};
use crate::log::Log;
use crate::outbox::Outbox;
use crate::panics::{self, contained};
use crate::pool::{Pool, Priority};
use crate::published::Published;
use crate::reply::Reply;
use crate::router::OnEdit;
use crate::scan_progress::ScanProgress;
use crate::session::Session;
use crate::snapshot::Snapshot;

/// A request, read and ready to be computed; more than once, if edits come in between.
#[derive(Clone)]
pub(crate) struct Job {
    /// Its method, for messages.
    pub(crate) method: &'static str,
    /// Where it is computed.
    pub(crate) priority: Priority,
    /// Handling of a change of the text meanwhile.
    pub(crate) on_edit: OnEdit,
    /// Gives the answer.
    pub(crate) compute: Compute,
}

/// The computation of an answer, which is JSON.
pub(crate) type Compute = Arc<dyn Fn(&Snapshot) -> Result<String> + Send + Sync>;

/// Trees that are kept; they are cheap to make again.
const TREES: usize = 64;

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
    /// How far the first check has come.
    pub(crate) progress: ScanProgress,
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
    /// The client asks for that, so that it is not sent as well.
    asks_for_configurations: bool,
    /// The messages that the user has already received.
    complained: FxHashSet<String>,
    log: Log,
}

impl ServerState {
    /// A server in which nothing is open.
    pub(crate) fn new(inbox: Inbox, outbox: Outbox, pool: Pool, log: Log) -> Self {
        Self {
            session: Arc::default(),
            documents: Arc::default(),
            outbox,
            inbox,
            published: Published::default(),
            checks: Checks::default(),
            pool,
            progress: ScanProgress::default(),
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
            complained: FxHashSet::default(),
            log,
        }
    }

    /// Processes messages until the inbox is closed.
    pub(crate) fn run(mut self, inbox: &Receiver<Message>) {
        loop {
            let message = match inbox.try_recv() {
                Ok(message) => message,
                Err(TryRecvError::Disconnected) => break,
                Err(TryRecvError::Empty) => {
                    self.settle();
                    let Ok(message) = inbox.recv() else { break };
                    message
                }
            };
            if let Err(reason) = contained(|| message(&mut self)) {
                self.complain("an event", &reason);
            }
        }
        // The process ends: taking the database apart piece by piece would only cost time.
        std::mem::forget(self.workspace);
    }

    /// Nothing waits: what was put off is done.
    fn settle(&mut self) {
        let settled = contained(|| {
            self.bring_up_to_date();
            self.check();
            self.tidy();
        });
        if let Err(reason) = settled {
            self.complain("reading the workspace", &reason);
        }
    }

    /// Computes a request on the state at its position in the order of messages.
    pub(crate) fn ask(&mut self, job: Job, reply: Reply) {
        self.bring_up_to_date();
        self.trace(job.method);
        let snapshot = self.snapshot();
        if !reply.begins(snapshot.db.cancellation_token()) {
            return;
        }
        let (inbox, edits) = (self.inbox.clone(), self.edits);
        self.pool.spawn(job.priority, move || {
            let outcome = contained(|| Cancelled::catch(std::panic::AssertUnwindSafe(|| (job.compute)(&snapshot))));
            // Before anything else, so that no writer waits for it.
            drop(snapshot);
            match outcome {
                Ok(Ok(answer)) => reply.give(answer),
                Ok(Err(Cancelled::Local)) => reply.give(Err(Error::request_cancelled())),
                Ok(Err(_)) => inbox.post(move |server| server.retry(job, reply, edits)),
                Err(reason) => {
                    reply.give(Err(panics::internal_error(job.method, &reason)));
                    inbox.post(move |server| server.complain(job.method, &reason));
                }
            }
        });
    }

    /// A write stopped a request. If it was an edit of a document, positions mean something else now.
    fn retry(&mut self, job: Job, reply: Reply, edits: u64) {
        if job.on_edit == OnEdit::Refuse && edits != self.edits {
            reply.give(Err(Error::content_modified()));
        } else {
            self.ask(job, reply);
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
            inbox: self.inbox.clone(),
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

    /// Frees data of earlier states while no thread computes, so that the next edit is faster.
    fn tidy(&mut self) {
        if self.has_surplus && Arc::strong_count(&self.readers) == 1 {
            self.forget_surplus();
        }
    }

    /// Frees data that is not needed at the moment.
    pub(crate) fn forget_surplus(&mut self) {
        self.has_surplus = false;
        self.workspace.db.trees().keep_latest(TREES);
        self.workspace.db.trigger_lru_eviction();
    }
}
