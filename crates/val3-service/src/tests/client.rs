//! Client of a service on the palletiser of the examples.

use std::path::PathBuf;
use std::time::Duration;

use camino::{Utf8Path, Utf8PathBuf};
use tempfile::TempDir;
use val3_analysis::system::Disk;
use val3_debug::Debugger;
use val3_lang::ports::SECOND;
use val3_machine::controller::Controller;
use val3_session::CellProfile;
use val3_session::{Application, CodeForm, ControllerSettings, FrameEvaluator, ProfileRights, Tape};
use val3_soap::v0::Login;
use val3_soap::{ExceptionCode, SoapAnswer, SoapFault, SoapRequest};
use val3_test::Fixture;

use crate::{Accounts, Service, ServiceAnswer, ServiceCall, ServiceTarget};

/// Service with a client that sends its last session with each request.
pub(super) struct Client {
    pub(super) debugger: Debugger,
    evaluator: FrameEvaluator,
    pub(super) service: Service,
    pub(super) session: Option<i32>,
    /// Time of the next request.
    pub(super) now: Duration,
    /// Temporary folder with the test's own application.
    folder: Option<TempDir>,
}

impl Client {
    /// Client that is logged in as `default`, with all rights.
    pub(super) fn logged_in() -> Self {
        let mut client = Self::with(Vec::new());
        assert_eq!(client.login("default", ""), 1);
        client
    }

    /// Client of a cell with these profiles, without a session.
    pub(super) fn with(profiles: Vec<CellProfile>) -> Self {
        let path =
            Utf8PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/palletiser/usr/usrapp/palletiser"));
        Self::open(&path.canonicalize_utf8().unwrap(), profiles, None)
    }

    /// Client of the application in a listing, in a folder, that is logged in as `default`.
    pub(super) fn of_listing(listing: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let root = Utf8PathBuf::from_path_buf(folder.path().to_owned()).unwrap();
        for (path, text) in &Fixture::parse(listing).files {
            let path = root.join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        let mut client = Self::open(&root.join("usrapp/main"), Vec::new(), Some(folder));
        assert_eq!(client.login("default", ""), 1);
        client
    }

    /// Folder that is `Disk` for the listing's projects.
    pub(super) fn disk(&self) -> PathBuf {
        self.folder.as_ref().unwrap().path().join("usrapp")
    }

    fn open(path: &Utf8Path, profiles: Vec<CellProfile>, folder: Option<TempDir>) -> Self {
        let application = Application::open(&Disk, path, None).unwrap();
        let settings = ControllerSettings { form: CodeForm::Debugged, ..ControllerSettings::default() };
        let image = application.compile_as(settings.form).unwrap();
        let tape = Tape { records: false, replays: None };
        let mut controller = application.controller(&settings, tape, image).unwrap();
        controller.start("start").unwrap();
        let accounts = Accounts::new(controller.devices.state.profiles.known(), profiles);
        Self {
            debugger: Debugger::new(controller),
            evaluator: FrameEvaluator::new(application),
            service: Service::new(accounts),
            session: None,
            now: Duration::ZERO,
            folder,
        }
    }

    pub(super) fn controller(&mut self) -> &mut Controller {
        &mut self.debugger.controller
    }

    /// Runs for a time, in seconds.
    pub(super) fn run(&mut self, seconds: u64) {
        let until = self.debugger.controller.now() + seconds * SECOND;
        while self.debugger.controller.now() < until {
            self.debugger.advance();
        }
    }

    pub(super) fn send(&mut self, request: SoapRequest) -> ServiceAnswer {
        let mut target = ServiceTarget { debugger: &mut self.debugger, evaluator: &mut self.evaluator };
        self.service.answer(&ServiceCall { session: self.session, request }, &mut target, self.now)
    }

    /// Answer to a request that succeeds. As clients do, the session of the answer is kept.
    #[track_caller]
    pub(super) fn ask(&mut self, request: SoapRequest) -> SoapAnswer {
        let answer = self.send(request);
        self.session = answer.session;
        answer.result.unwrap()
    }

    /// Fault of a request that fails.
    #[track_caller]
    pub(super) fn fault(&mut self, request: SoapRequest) -> SoapFault {
        self.send(request).result.unwrap_err()
    }

    /// Code of a request that fails.
    #[track_caller]
    pub(super) fn code(&mut self, request: SoapRequest) -> ExceptionCode {
        self.fault(request).exception.unwrap().code
    }

    /// Logs in. Returns the session; 0 for a rejection.
    #[track_caller]
    pub(super) fn login(&mut self, user: &str, password: &str) -> i32 {
        let [user, password] = [user, password].map(|text| Some(text.to_owned()));
        match self.ask(SoapRequest::Login(Login { user, password })) {
            SoapAnswer::Login(login) => login.session,
            other => panic!("{other:?}"),
        }
    }
}

/// Profile of a cell.
pub(super) fn profile(name: &str, rights: ProfileRights) -> CellProfile {
    CellProfile { name: name.to_owned(), rights }
}
