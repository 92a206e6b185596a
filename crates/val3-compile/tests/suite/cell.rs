//! Listings as applications on the disk of a controller, which are run to their end.

use std::sync::Arc;

use camino::{Utf8Path, Utf8PathBuf};
use tempfile::TempDir;
use val3_analysis::infer;
use val3_analysis::items::project::{folder, program_files};
use val3_analysis::load::load;
use val3_analysis::problem::ProblemKind;
use val3_analysis::system::Memory;
use val3_bytecode::Image;
use val3_lang::ports::Time;
use val3_machine::controller::{Controller, RunStatus};
use val3_machine::devices::{Devices, Libraries};
use val3_machine::event::{Event, EventKind};
use val3_machine::files::{ControllerPath, LibraryFiles, Roots};
use val3_test::Fixture;

use crate::text_form;

const LINE_COST: Time = 2_000;
const LONGEST: Time = 10_000_000_000;

/// A cell in a temporary folder.
pub(crate) struct Cell {
    dir: TempDir,
}

/// Compiles the present files on the disk.
struct OnDisk(Utf8PathBuf);

impl Libraries for OnDisk {
    fn image(&mut self, path: &ControllerPath, _: LibraryFiles) -> Result<Arc<Image>, String> {
        let mut files = Vec::new();
        collect(&self.0, &mut files);
        let workspace = load(&Memory::new(files), std::slice::from_ref(&self.0)).map_err(|error| error.to_string())?;
        let wanted = path.parts().iter().fold(self.0.join("usrapp"), |folder, part| folder.join(part.as_str()));
        let db = &workspace.db;
        let is_it = |project: &&val3_analysis::db::Project| *folder(db, **project) == wanted;
        let project = *workspace.projects.iter().find(is_it).ok_or("no such project")?;
        let problems = program_files(db, project).iter().flat_map(|file| infer::problems(db, project, *file));
        // The virtual controller supports the add-ons that no table declares.
        let mut problems = problems.filter(|problem| !matches!(problem.kind, ProblemKind::MissingAddOn { .. }));
        if let Some(problem) = problems.next() {
            return Err(format!("{problem:?}"));
        }
        let image = val3_compile::compile(db, project).map_err(|error| format!("{error:?}"))?;
        text_form::check(&image);
        Ok(Arc::new(image))
    }
}

fn collect(folder: &Utf8Path, files: &mut Vec<(Utf8PathBuf, Vec<u8>)>) {
    for entry in folder.read_dir_utf8().unwrap() {
        let path = entry.unwrap().into_path();
        if path.is_dir() {
            collect(&path, files);
        } else {
            files.push((path.clone(), std::fs::read(&path).unwrap()));
        }
    }
}

impl Cell {
    /// Writes the applications of a listing to the disk.
    pub(crate) fn new(listing: &str) -> Self {
        let cell = Self { dir: tempfile::tempdir().unwrap() };
        for (path, text) in Fixture::parse(listing).files {
            cell.write(&path, text);
        }
        std::fs::create_dir(cell.path("usb")).unwrap();
        cell
    }

    /// Returns a path below `usr`.
    pub(crate) fn path(&self, path: &str) -> Utf8PathBuf {
        Utf8Path::from_path(self.dir.path()).unwrap().join("usr").join(path)
    }

    pub(crate) fn write(&self, path: &str, text: impl AsRef<[u8]>) {
        let path = self.path(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }

    pub(crate) fn read(&self, path: &str) -> String {
        std::fs::read_to_string(self.path(path)).unwrap()
    }

    /// Creates a controller with the application `main` at its beginning.
    pub(crate) fn controller(&self) -> Controller {
        self.controller_with(|_| {})
    }

    /// Like [`controller`](Self::controller), after `prepare` has changed the devices.
    pub(crate) fn controller_with(&self, prepare: impl FnOnce(&mut Devices)) -> Controller {
        let mut roots = Roots::default();
        roots.mount("Disk", &self.path("usrapp")).unwrap();
        roots.mount("USB0", &self.path("usb")).unwrap();
        let mut devices = Devices::new(roots, Box::new(OnDisk(self.path(""))));
        prepare(&mut devices);
        let main = ControllerPath::root("Disk").join("main").unwrap();
        let image = OnDisk(self.path("")).image(&main, LibraryFiles { files: Vec::new(), encrypted: false }).unwrap();
        let mut controller = Controller::new(devices, image, main.to_string(), LINE_COST).unwrap();
        controller.start("start").unwrap();
        controller
    }

    /// Runs `main`, and returns its output and the errors that stop its tasks.
    pub(crate) fn run(&self) -> String {
        shown(&run(&mut self.controller(), |_| {}))
    }

    /// Runs `main`, and returns the events about libraries.
    pub(crate) fn library_events(&self) -> String {
        let events = run(&mut self.controller(), |_| {}).into_iter();
        let lines = events.filter_map(|event| match event.kind {
            EventKind::Lib { op, alias, path, code } => Some(format!("{op} {alias}:{path} {code}\n")),
            _ => None,
        });
        lines.collect()
    }
}

/// Runs a controller to its end, and calls `outside` before each cycle.
pub(crate) fn run(controller: &mut Controller, mut outside: impl FnMut(&mut Controller)) -> Vec<Event> {
    let mut events = Vec::new();
    while controller.now() < LONGEST {
        outside(controller);
        let step = controller.step();
        events.extend(controller.devices.take_events());
        match step {
            status if status.is_final() => return events,
            RunStatus::Waiting(Some(wake)) if !controller.devices.lines.are_in_use() => controller.jump(wake),
            _ => {}
        }
    }
    panic!("goes on: {}", shown(&events));
}

/// Returns the printed lines and the errors.
pub(crate) fn shown(events: &[Event]) -> String {
    let lines = events.iter().filter_map(|event| match &event.kind {
        EventKind::Print { text } => Some(format!("{text}\n")),
        EventKind::Error { code, program, .. } => Some(format!("error {code} in {program}\n")),
        _ => None,
    });
    lines.collect()
}
