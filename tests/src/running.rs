//! Listings as applications on a controller.

use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_analysis::system::Memory;
use val3_bytecode::Image;
use val3_lang::ports::{SECOND, Time};
use val3_machine::controller::{Controller, RunStatus};
use val3_machine::devices::{Devices, Libraries};
use val3_machine::event::{Event, EventKind};
use val3_machine::files::{ControllerPath, LibraryFiles, Roots};
use val3_motion::Sample;
use val3_session::{Application, CodeForm, Pace};
use val3_test::{Fixture, ROOT};

/// Duration of a line, in ns.
const LINE: Time = 2000;

/// Longest run: one hour.
const LIMIT: Time = 3600 * SECOND;

/// An application on a controller, with its events.
pub struct Running {
    /// Controller.
    pub controller: Controller,
    /// Events so far.
    pub events: Vec<Event>,
}

/// No media: libraries cannot be loaded while an application runs.
struct NoLibraries;

impl Libraries for NoLibraries {
    fn image(&mut self, path: &ControllerPath, _: LibraryFiles) -> Result<Arc<Image>, String> {
        Err(format!("no library {path}"))
    }
}

impl Running {
    /// Creates a controller with the application of a listing at its beginning.
    ///
    /// # Panics
    /// The listing has faults.
    #[track_caller]
    pub fn start(listing: &str) -> Self {
        Self::on(Devices::new(Roots::default(), Box::new(NoLibraries)), listing)
    }

    /// Creates a controller with the application of a listing at its beginning.
    ///
    /// # Errors
    /// The first faults of the listing, as one text.
    pub fn try_start(listing: &str) -> Result<Self, String> {
        let image = application(listing).compile().map_err(|error| error.to_string())?;
        let mut controller = Controller::new(Self::devices(), image, "Disk://main".to_owned(), LINE)
            .map_err(|fault| format!("the controller has no memory for the application: {fault:?}"))?;
        controller.start("start").map_err(|fault| format!("{fault:?}"))?;
        Ok(Self { controller, events: Vec::new() })
    }

    /// Creates a controller with the application of a listing, on these devices.
    ///
    /// # Panics
    /// The listing has faults.
    #[track_caller]
    pub fn on(devices: Devices, listing: &str) -> Self {
        Self::with(devices, image(listing, CodeForm::Plain))
    }

    /// Like [`on`](Self::on), with the code for a debugger.
    ///
    /// # Panics
    /// The listing has faults.
    #[track_caller]
    pub fn debugged_on(devices: Devices, listing: &str) -> Self {
        Self::with(devices, image(listing, CodeForm::Debugged))
    }

    #[track_caller]
    fn with(devices: Devices, image: Arc<Image>) -> Self {
        let mut controller = Controller::new(devices, image, "Disk://main".to_owned(), LINE)
            .unwrap_or_else(|fault| panic!("the controller has no memory for the application: {fault:?}"));
        let started = controller.start("start");
        assert!(started.is_ok(), "{started:?}");
        Self { controller, events: Vec::new() }
    }

    /// Creates devices without media.
    pub fn devices() -> Devices {
        Devices::new(Roots::default(), Box::new(NoLibraries))
    }

    /// Runs until the application has ended or cannot continue.
    ///
    /// # Panics
    /// The application does not end within an hour.
    #[track_caller]
    pub fn to_the_end(mut self) -> Self {
        while self.step() {
            assert!(self.controller.now() < LIMIT, "the application does not end");
        }
        self
    }

    /// Like [`Running::to_the_end`]; also returns the state of the arm after each cycle.
    ///
    /// # Panics
    /// The application does not end within an hour.
    #[track_caller]
    pub fn sampled(mut self) -> (Self, Vec<Sample>) {
        let mut samples = Vec::new();
        let mut runs = true;
        while runs {
            runs = self.step();
            samples.push(*self.controller.arm().sample());
            assert!(self.controller.now() < LIMIT, "the application does not end");
        }
        (self, samples)
    }

    /// Runs for a time, in seconds.
    pub fn for_seconds(mut self, seconds: u32) -> Self {
        let until = self.controller.now() + Time::from(seconds) * SECOND;
        while self.controller.now() < until && self.step() {}
        self
    }

    /// Runs a cycle, and skips the time without activity. Returns whether the application can continue.
    fn step(&mut self) -> bool {
        let status = self.controller.step();
        self.events.append(&mut self.controller.devices.take_events());
        match status {
            RunStatus::Waiting(wake) => Pace::default().wait(&mut self.controller, wake).is_some(),
            RunStatus::Stuck => Pace::default().wait(&mut self.controller, None).is_some(),
            status => !status.is_final(),
        }
    }

    /// Returns the output of `?` in lines, and the numbers of run-time errors.
    #[must_use]
    pub fn printed(&self) -> String {
        self.events.iter().filter_map(|event| printed_line(&event.kind)).collect()
    }

    /// Returns the record without events of tasks and `?`, in lines.
    ///
    /// # Panics
    /// An event cannot be written.
    #[must_use]
    pub fn record(&self) -> String {
        let told =
            self.events.iter().filter(|event| !matches!(event.kind, EventKind::Task { .. } | EventKind::Print { .. }));
        let line = |event| serde_json::to_string(event).unwrap_or_else(|error| panic!("{error}"));
        told.map(|event| line(event) + "\n").collect()
    }

    /// Returns the lines of the page on the pendant, without empty lines at the end.
    #[must_use]
    pub fn page(&self) -> String {
        let pendant = &self.controller.devices.state.pendant;
        let lines: Vec<String> = pendant.page(pendant.shown()).into_iter().flat_map(|page| page.lines()).collect();
        lines.join("\n").trim_end().to_owned()
    }
}

/// Opens the application of a listing.
///
/// # Panics
/// The application cannot be opened.
#[track_caller]
pub fn application(listing: &str) -> Application {
    let fixture = Fixture::parse(listing);
    let path = |file: &str| Utf8PathBuf::from(format!("{ROOT}/{file}"));
    let files = fixture.files.iter().map(|(file, text)| (path(file), text.clone().into_bytes()));
    let application = Application::open(&Memory::new(files), &path("usrapp/main/main.pjx"), None);
    application.unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn image(listing: &str, form: CodeForm) -> Arc<Image> {
    application(listing).compile_as(form).unwrap_or_else(|error| panic!("{error}"))
}

/// Line for the output of `?`, a run-time error or a missing instruction.
fn printed_line(event: &EventKind) -> Option<String> {
    match event {
        EventKind::Print { text } => Some(format!("{text}\n")),
        EventKind::Error { code, .. } => Some(format!("error {code}\n")),
        EventKind::Lacking { instruction, line, .. } => Some(format!("line {line}: no {instruction}\n")),
        _ => None,
    }
}
