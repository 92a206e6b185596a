//! Listings as applications on a controller.

use std::sync::Arc;

use camino::Utf8PathBuf;
use val3_analysis::system::Memory;
use val3_bytecode::Image;
use val3_lang::ports::{SECOND, Time};
use val3_machine::controller::{Controller, Outcome};
use val3_machine::devices::{Devices, Libraries};
use val3_machine::event::{Event, EventKind};
use val3_machine::files::{ControllerPath, LibraryFiles, Roots};
use val3_motion::Sample;
use val3_session::{Application, Pace};
use val3_test::{Fixture, ROOT};

/// Microseconds that a line takes here, in nanoseconds.
const LINE: Time = 2000;

/// The longest run: an hour.
const LIMIT: Time = 3600 * SECOND;

/// An application on a controller, and what has happened.
pub struct Running {
    /// The controller.
    pub controller: Controller,
    /// The events so far.
    pub events: Vec<Event>,
}

/// No media: what is loaded while an application runs is not there.
struct NoLibraries;

impl Libraries for NoLibraries {
    fn image(&mut self, path: &ControllerPath, _: LibraryFiles) -> Result<Arc<Image>, String> {
        Err(format!("no library {path}"))
    }
}

impl Running {
    /// The application of a listing, about to begin.
    ///
    /// # Panics
    /// If it has faults.
    #[track_caller]
    pub fn start(listing: &str) -> Self {
        Self::on(Devices::new(Roots::default(), Box::new(NoLibraries)), listing)
    }

    /// The application of a listing, about to begin.
    ///
    /// # Errors
    /// Its first faults, in a text, if it has some.
    pub fn try_start(listing: &str) -> Result<Self, String> {
        let image = application(listing).compile().map_err(|error| error.to_string())?;
        let mut controller = Controller::new(Self::devices(), image, "Disk://main".to_owned(), LINE)
            .map_err(|fault| format!("the controller has no memory for the application: {fault:?}"))?;
        controller.start("start").map_err(|fault| format!("{fault:?}"))?;
        Ok(Self { controller, events: Vec::new() })
    }

    /// The application of a listing on a controller with these signals of the device `Io`.
    ///
    /// # Panics
    /// If it has faults.
    #[track_caller]
    pub fn on(devices: Devices, listing: &str) -> Self {
        let mut controller = Controller::new(devices, image(listing), "Disk://main".to_owned(), LINE)
            .unwrap_or_else(|fault| panic!("the controller has no memory for the application: {fault:?}"));
        let started = controller.start("start");
        assert!(started.is_ok(), "{started:?}");
        Self { controller, events: Vec::new() }
    }

    /// Devices without media.
    pub fn devices() -> Devices {
        Devices::new(Roots::default(), Box::new(NoLibraries))
    }

    /// Runs until the application has ended, or nothing can happen any more.
    ///
    /// # Panics
    /// If it does not end within an hour.
    #[track_caller]
    pub fn to_the_end(mut self) -> Self {
        while self.step() {
            assert!(self.controller.now() < LIMIT, "the application does not end");
        }
        self
    }

    /// As [`Running::to_the_end`]; gives the state of the arm after each cycle.
    ///
    /// # Panics
    /// If it does not end within an hour.
    #[track_caller]
    pub fn sampled(mut self) -> (Self, Vec<Sample>) {
        let mut samples = Vec::new();
        let mut runs = true;
        while runs {
            runs = self.step();
            samples.push(*self.controller.devices.state.arm.sample());
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

    /// A cycle, and the time that nothing happens in. Whether something can still happen.
    fn step(&mut self) -> bool {
        let outcome = self.controller.step();
        self.events.append(&mut self.controller.devices.take_events());
        match outcome {
            Outcome::Waiting(wake) => Pace::default().wait(&mut self.controller, wake).is_some(),
            Outcome::Stuck => Pace::default().wait(&mut self.controller, None).is_some(),
            outcome => !outcome.is_final(),
        }
    }

    /// The output of `?`, one line each, and the numbers of run-time errors.
    #[must_use]
    pub fn printed(&self) -> String {
        let line = |event: &Event| match &event.kind {
            EventKind::Print { text } => Some(format!("{text}\n")),
            EventKind::Error { code, .. } => Some(format!("error {code}\n")),
            EventKind::Lacking { instruction, line, .. } => Some(format!("line {line}: no {instruction}\n")),
            _ => None,
        };
        self.events.iter().filter_map(line).collect()
    }

    /// The record without what tasks do and `?` prints, a line an event.
    ///
    /// # Panics
    /// If an event cannot be written.
    #[must_use]
    pub fn record(&self) -> String {
        let told =
            self.events.iter().filter(|event| !matches!(event.kind, EventKind::Task { .. } | EventKind::Print { .. }));
        let line = |event| serde_json::to_string(event).unwrap_or_else(|error| panic!("{error}"));
        told.map(|event| line(event) + "\n").collect()
    }

    /// The lines of the page that the pendant shows, without those that are empty at its end.
    #[must_use]
    pub fn page(&self) -> String {
        let pendant = &self.controller.devices.state.pendant;
        let lines: Vec<String> = pendant.page(pendant.shown()).into_iter().flat_map(|page| page.lines()).collect();
        lines.join("\n").trim_end().to_owned()
    }
}

/// The application of a listing.
///
/// # Panics
/// If it cannot be opened.
#[track_caller]
pub fn application(listing: &str) -> Application {
    let fixture = Fixture::parse(listing);
    let path = |file: &str| Utf8PathBuf::from(format!("{ROOT}/{file}"));
    let files = fixture.files.iter().map(|(file, text)| (path(file), text.clone().into_bytes()));
    let application = Application::open(&Memory::new(files), &path("usrapp/main/main.pjx"), None);
    application.unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn image(listing: &str) -> Arc<Image> {
    application(listing).compile().unwrap_or_else(|error| panic!("{error}"))
}
