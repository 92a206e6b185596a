//! A project and its controller's server.

use std::collections::BTreeMap;
use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use tempfile::TempDir;
use val3_controller::{
    ConnectionSettings, ControllerAddress, ControllerError, ControllerFiles, ControllerIdentity, ControllerPath,
    ControllerProject, LockOwner, ProjectStatus, PullDecisions, PullRequest, PullResult, PushFailure, PushPlan,
    PushRequest, RecoveredPush, SilentObserver, TransferObserver, check_identity, pull, push, recover,
};

use crate::memory::MemoryFiles;
use crate::server::{Behaviour, Server, Tree};

/// Time of the tests, in seconds since 1970.
pub(crate) const NOW: u64 = 1_764_414_000;

/// Files of the controller: an application, its library and its settings.
pub(crate) const FILES: [(&str, &str); 6] = [
    ("/usr/configs/controller.cfx", "<controller><String name=\"serialNumber\" value=\"F10-1\"/></controller>"),
    ("/usr/usrapp/demo/demo.pjx", "<Project><Library path=\"Disk://tools/tools.pjx\"/></Project>"),
    ("/usr/usrapp/demo/demo.dtx", "<Database>1</Database>"),
    ("/usr/usrapp/demo/start.pgx", "start"),
    ("/usr/usrapp/tools/tools.pjx", "<Project/>"),
    ("/usr/usrapp/tools/grip.pgx", "grip"),
];

/// Tree of the controller before each test.
pub(crate) fn tree() -> Tree {
    let files: BTreeMap<String, Vec<u8>> =
        FILES.iter().map(|(path, text)| ((*path).to_owned(), text.as_bytes().to_vec())).collect();
    let folders = ["", "/usr", "/usr/configs", "/usr/usrapp", "/usr/usrapp/demo", "/usr/usrapp/tools"];
    Tree { files, folders: folders.iter().map(|folder| (*folder).to_owned()).collect() }
}

pub(crate) fn path(text: &str) -> ControllerPath {
    ControllerPath::parse(text).unwrap()
}

pub(crate) fn applications() -> Vec<ControllerPath> {
    vec![ControllerPath::applications()]
}

/// A project in a temporary folder.
pub(crate) struct Bench<C = Server> {
    _kept: TempDir,
    pub(crate) folder: Utf8PathBuf,
    pub(crate) server: C,
}

/// A controller of the tests.
pub(crate) trait Controller {
    fn files(&self) -> Box<dyn ControllerFiles>;
}

impl Controller for Server {
    fn files(&self) -> Box<dyn ControllerFiles> {
        Box::new(self.connect())
    }
}

impl Controller for MemoryFiles {
    fn files(&self) -> Box<dyn ControllerFiles> {
        Box::new(self.clone())
    }
}

impl Bench {
    /// Starts a server, and pulls its applications.
    pub(crate) fn pulled(behaviour: Behaviour) -> Self {
        let bench = Self::empty(behaviour);
        bench.pull().unwrap();
        bench
    }

    /// Starts a server.
    pub(crate) fn empty(behaviour: Behaviour) -> Self {
        Self::with(Server::start(tree(), behaviour))
    }
}

impl<C: Controller> Bench<C> {
    /// An empty project for a controller.
    pub(crate) fn with(server: C) -> Self {
        // In memory if possible, because the writes of a project wait for the disk.
        let memory = std::path::Path::new("/dev/shm");
        let kept = if memory.is_dir() { TempDir::new_in(memory) } else { TempDir::new() }.unwrap();
        let folder = Utf8PathBuf::from_path_buf(kept.path().to_owned()).unwrap();
        Self { _kept: kept, folder, server }
    }

    pub(crate) fn project(&self) -> ControllerProject {
        ControllerProject::open(&self.folder).unwrap()
    }

    pub(crate) fn pull(&self) -> Result<PullResult, ControllerError> {
        pull_from(&self.folder, &mut *self.server.files())
    }

    pub(crate) fn status(&self) -> Result<ProjectStatus, ControllerError> {
        ProjectStatus::read(&self.project(), &mut *self.server.files(), &applications(), &mut SilentObserver)
    }

    pub(crate) fn plan(&self) -> Result<PushPlan, ControllerError> {
        PushPlan::new(&self.project(), &self.status()?, &applications())
    }

    /// Plans a push, then pushes on a new connection.
    pub(crate) fn push(&self) -> Result<(), PushFailure> {
        let plan = self.plan().unwrap();
        self.push_plan(&plan)
    }

    pub(crate) fn push_plan(&self, plan: &PushPlan) -> Result<(), PushFailure> {
        self.push_observed(plan, &mut SilentObserver)
    }

    pub(crate) fn push_observed(
        &self,
        plan: &PushPlan,
        observer: &mut dyn TransferObserver,
    ) -> Result<(), PushFailure> {
        let owner = LockOwner { user: "me".into(), host: "desk".into() };
        // All pushes are in the same second.
        let request = PushRequest { plan, owner: &owner, now: NOW, backup: "push" };
        push(&mut self.project(), &mut *self.server.files(), request, observer)
    }

    pub(crate) fn recover(&self) -> Result<Vec<RecoveredPush>, ControllerError> {
        let (mut project, mut files) = (self.project(), self.server.files());
        let identity = check_identity(&project, &address(), &mut *files, false)?;
        recover(&mut project, &mut *files, &identity, NOW, &mut SilentObserver)
    }

    pub(crate) fn write(&self, path: &str, text: &str) {
        let path = self.folder.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    pub(crate) fn text(&self, path: &str) -> String {
        fs::read_to_string(self.folder.join(path)).unwrap()
    }

    /// Changes the local files in every way: a change in each file kind, a new application, and a removed file.
    pub(crate) fn edit(&self) {
        self.write("usr/usrapp/demo/demo.pjx", "<Project version=\"2\"/>");
        self.write("usr/usrapp/demo/demo.dtx", "<Database>2</Database>");
        self.write("usr/usrapp/demo/start.pgx", "start 2");
        self.write("usr/usrapp/new/inner/new.pjx", "<Project/>");
        fs::remove_file(self.folder.join("usr/usrapp/tools/grip.pgx")).unwrap();
    }
}

/// Address that the projects remember.
pub(crate) fn address() -> ControllerAddress {
    ControllerAddress::parse("ftp://robot").unwrap()
}

/// Pull of the applications that stops at conflicts and removals of applications.
pub(crate) fn request<'a>(identity: ControllerIdentity) -> PullRequest<'a> {
    PullRequest {
        address: address().to_string(),
        connection: ConnectionSettings::default(),
        identity,
        folders: applications(),
        merge: None,
        decisions: PullDecisions::default(),
        accepts_removals: false,
    }
}

/// Pulls the applications to a folder.
pub(crate) fn pull_from(folder: &Utf8Path, files: &mut dyn ControllerFiles) -> Result<PullResult, ControllerError> {
    let mut project = ControllerProject::open(folder)?;
    let identity: ControllerIdentity = check_identity(&project, &address(), files, false)?;
    pull(&mut project, files, request(identity), &mut SilentObserver)
}

/// The files of a tree as text.
pub(crate) fn shown(tree: &Tree) -> String {
    let line = |(path, bytes): (&String, &Vec<u8>)| format!("{path}: {}\n", String::from_utf8_lossy(bytes));
    tree.files.iter().map(line).collect()
}
