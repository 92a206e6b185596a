//! The main loop and everything that only it may change.

use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError};

use camino::{Utf8Path, Utf8PathBuf};
use rustc_hash::FxHashSet;
use salsa::{Cancelled, Database as _, Setter as _};
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::lsp_types::notification::LogTrace;
use tower_lsp::lsp_types::{LogTraceParams, MessageType};
use val3_analysis::db::{Database, File, FileStatus, Project, Sources, path_key};
use val3_analysis::load::Workspace;
use val3_check::settings::WorkspaceSettings;
use val3_config::ConfigError;
use val3_ide::CheckSettings;

use crate::checks::Checks;
use crate::convert;
use crate::documents::Documents;
use crate::inbox::{Inbox, Message};
use crate::log::Log;
use crate::loose;
use crate::outbox::Outbox;
use crate::overlay::Overlay;
use crate::panics::{self, contained};
use crate::parent::project_above;
use crate::pool::{Lane, Pool};
use crate::published::Published;
use crate::reply::Reply;
use crate::router::OnEdit;
use crate::scan_progress::ScanProgress;
use crate::session::{Session, Trace};
use crate::snapshot::Snapshot;

/// A request, read and ready to be computed; more than once, if edits come in between.
#[derive(Clone)]
pub(crate) struct Job {
    /// Its method, for messages.
    pub(crate) method: &'static str,
    /// Where it is computed.
    pub(crate) lane: Lane,
    /// What happens when the text changes meanwhile.
    pub(crate) on_edit: OnEdit,
    /// Gives the answer.
    pub(crate) compute: Compute,
}

/// The computation of an answer, which is JSON.
pub(crate) type Compute = Arc<dyn Fn(&Snapshot) -> Result<String> + Send + Sync>;

/// The state of the server. One thread owns it; all others see snapshots.
pub(crate) struct World {
    /// What the client said about itself.
    pub(crate) session: Arc<Session>,
    /// The open documents.
    pub(crate) documents: Arc<Documents>,
    /// The way to the client.
    pub(crate) outbox: Outbox,
    /// The way to this loop.
    pub(crate) inbox: Inbox,
    /// What was told to the client about files.
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
    /// Documents outside of every project have a project of their own.
    loose: Vec<Utf8PathBuf>,
    /// What is wrong with configurations.
    faults: Vec<ConfigError>,
    /// What the user was told about already.
    complained: FxHashSet<String>,
    log: Log,
}

/// What has to be read again.
enum Stale {
    Paths(FxHashSet<Utf8PathBuf>),
    Everything,
}

impl World {
    /// A world in which nothing is open.
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
            loose: Vec::new(),
            faults: Vec::new(),
            complained: FxHashSet::default(),
            log,
        }
    }

    /// Does what the inbox says, until nobody can post to it any more.
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
        });
        if let Err(reason) = settled {
            self.complain("reading the workspace", &reason);
        }
    }

    /// Computes a request on the state as it is at this place in the order of messages.
    pub(crate) fn ask(&mut self, job: Job, reply: Reply) {
        self.bring_up_to_date();
        self.trace(job.method);
        let snapshot = self.snapshot();
        if !reply.begins(snapshot.db.cancellation_token()) {
            return;
        }
        let (inbox, edits) = (self.inbox.clone(), self.edits);
        self.pool.spawn(job.lane, move || {
            let outcome = contained(|| Cancelled::catch(std::panic::AssertUnwindSafe(|| (job.compute)(&snapshot))));
            // Before anything else, so that no writer waits for it.
            drop(snapshot);
            match outcome {
                Ok(Ok(answer)) => reply.give(answer),
                Ok(Err(Cancelled::Local)) => reply.give(Err(Error::request_cancelled())),
                Ok(Err(_)) => inbox.post(move |world| world.ask_again(job, reply, edits)),
                Err(reason) => {
                    reply.give(Err(panics::internal_error(job.method, &reason)));
                    inbox.post(move |world| world.complain(job.method, &reason));
                }
            }
        });
    }

    /// A write stopped a request. If it was an edit of a document, positions mean something else now.
    fn ask_again(&mut self, job: Job, reply: Reply, edits: u64) {
        if job.on_edit == OnEdit::Refuse && edits != self.edits {
            reply.give(Err(Error::content_modified()));
        } else {
            self.ask(job, reply);
        }
    }

    /// The state as it is now. The writer waits until it is dropped.
    pub(crate) fn snapshot(&self) -> Snapshot {
        Snapshot {
            db: self.workspace.db.clone(),
            session: Arc::clone(&self.session),
            documents: Arc::clone(&self.documents),
            projects: Arc::clone(&self.projects),
            settings: self.settings,
            inbox: self.inbox.clone(),
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

    /// The user changed the settings.
    pub(crate) fn settings_are_stale(&mut self) {
        self.stale.get_or_insert_with(|| Stale::Paths(FxHashSet::default()));
    }

    /// The file at a path, if it is part of a project.
    pub(crate) fn file(&self, path: &Utf8Path) -> Option<File> {
        Sources::try_get(&self.workspace.db)?.files(&self.workspace.db).get(&path_key(path.as_str())).copied()
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
            file.set_text(&mut self.workspace.db).to(Arc::clone(text));
            self.checks.edited(file);
        }
    }

    /// A file has to be read again.
    pub(crate) fn is_stale(&mut self, path: Utf8PathBuf) {
        match &mut self.stale {
            Some(Stale::Everything) => {}
            Some(Stale::Paths(paths)) => drop(paths.insert(path)),
            None => self.stale = Some(Stale::Paths(FxHashSet::from_iter([path]))),
        }
    }

    /// Everything has to be read again.
    pub(crate) fn all_is_stale(&mut self) {
        self.stale = Some(Stale::Everything);
    }

    /// Reads what has to be read again.
    pub(crate) fn bring_up_to_date(&mut self) {
        let Some(stale) = self.stale.take() else { return };
        let is_stale = |path: &Utf8Path| match &stale {
            Stale::Paths(paths) => paths.contains(path),
            Stale::Everything => true,
        };
        match contained(|| self.read_again(&is_stale)) {
            Ok(faults) => self.faults = faults,
            Err(reason) => {
                self.forget_everything();
                self.complain("reading the workspace", &reason);
            }
        }
        self.checks.all();
    }

    fn read_again(&mut self, is_stale: &dyn Fn(&Utf8Path) -> bool) -> Vec<ConfigError> {
        let mut errors = self.refresh(is_stale);
        let loose = loose::documents(&self.documents, &self.workspace.db, &self.loose);
        if loose != self.loose {
            self.loose = loose;
            errors = self.refresh(is_stale);
        }
        self.projects = Arc::new(self.workspace.projects.clone());
        errors.extend(self.configure());
        errors
    }

    /// A database that was left half changed cannot be asked. The next change begins with a new one.
    fn forget_everything(&mut self) {
        self.workspace = Workspace::empty();
        self.projects = Arc::default();
        self.settings = None;
        self.loose.clear();
        self.checks.forget();
    }

    fn refresh(&mut self, is_stale: &dyn Fn(&Utf8Path) -> bool) -> Vec<ConfigError> {
        let overlay = Overlay::new(&self.documents, &self.loose);
        let folders = &self.session.folders;
        let above = self.documents.iter().filter_map(|document| project_above(&overlay, document, folders));
        let given = self.loose.iter().map(|path| loose::manifest_path(path));
        let asked: Vec<Utf8PathBuf> = folders.iter().cloned().chain(above).chain(given).collect();
        self.workspace.refresh(&overlay, &asked, is_stale)
    }

    /// The settings that configurations and the client come to; faulty ones count as they were before.
    fn configure(&mut self) -> Vec<ConfigError> {
        let db = &mut self.workspace.db;
        let found = WorkspaceSettings::new(db, &self.projects, &self.session.options.selection());
        let (settings, errors) = match found {
            Ok(settings) => (settings, Vec::new()),
            Err(errors) if self.settings.is_some() => return errors,
            Err(errors) => (WorkspaceSettings::default(), errors),
        };
        match self.settings {
            None => self.settings = Some(CheckSettings::new(db, settings)),
            Some(known) if *known.settings(db) != settings => _ = known.set_settings(db).to(settings),
            Some(_) => {}
        }
        errors
    }

    /// Sends what needs no check: faults of configurations, and that projects which are gone have no findings.
    pub(crate) fn publish_what_is_known(&mut self) {
        self.published.keep(&self.projects, &self.documents, &self.outbox);
        let faults = convert::configuration_faults(&self.snapshot(), &self.faults);
        self.published.project(faults, &self.documents, &self.outbox);
    }

    /// Frees trees that nobody needs at the moment.
    pub(crate) fn forget_trees(&mut self) {
        self.workspace.db.trigger_lru_eviction();
    }

    /// Tells the user that something went wrong in the server, which goes on; once is enough.
    pub(crate) fn complain(&mut self, what: &str, reason: &str) {
        self.log(&format!("{what} failed: {reason}"));
        if !self.complained.insert(what.to_owned()) {
            return;
        }
        let message = format!("val3: {what} failed because of a fault in the language server, which goes on");
        self.outbox.show(MessageType::ERROR, &message);
    }

    /// Tells a client that wants to know it what is computed.
    fn trace(&mut self, method: &str) {
        if self.session.trace == Trace::On {
            self.outbox.notify::<LogTrace>(LogTraceParams { message: format!("computes {method}"), verbose: None });
        }
    }

    /// Writes a line for whoever looks for the cause of something.
    pub(crate) fn log(&mut self, line: &str) {
        self.log.write(line);
        self.outbox.log(MessageType::LOG, line);
    }
}
