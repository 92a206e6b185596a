//! The smallest host: a virtual clock, and a record of the tasks' output.

use std::fmt::Write as _;
use std::sync::Arc;

use expect_test::Expect;
use val3_bytecode::{Image, assemble};
use val3_lang::library_errors::NO_LIBRARY;
use val3_lang::memory::StoreId;
use val3_lang::ports::{CodePlace, Origin, Ports, TaskChange, TaskNumber, Time};
use val3_lang::types::BaseType;
use val3_vm::{CycleEnd, InstanceId, LibraryOp, LibraryRequest, LoadedLibrary, ProgramId, Schedule, Space, Vm};

/// Duration of a line, in ns. A cycle has 2,000 lines.
pub(crate) const LINE: Time = 2_000;

/// Time by which every test has to end, in ns.
const LONGEST: Time = 1_000_000_000_000;

/// Host of the tests.
#[derive(Default)]
pub(crate) struct Host {
    /// Output of `?`, and run-time errors with their rows.
    pub(crate) record: String,
    /// Creation, end and other changes of tasks.
    pub(crate) changes: String,
    /// Whether the cycle has to stop after the current instruction.
    pub(crate) is_interrupted: bool,
    /// Libraries on the medium.
    libraries: Vec<Arc<Image>>,
    /// Images in memory, by number.
    images: Vec<Arc<Image>>,
    origin: Origin,
}

impl Host {
    fn row(&self, at: CodePlace) -> u32 {
        let program = &self.images[usize::from(at.instance)].programs[usize::from(at.program)];
        program.line_of(at.line).map_or(0, |line| program.lines[line].row)
    }
}

impl Ports for Host {
    fn origin(&mut self, origin: Origin) {
        self.origin = origin;
    }

    fn task(&mut self, _: TaskNumber, name: &str, change: TaskChange, _: Option<CodePlace>) {
        if let TaskChange::Failed(fault) = change {
            let row = self.row(self.origin.at);
            writeln!(self.record, "error {} at row {row}", fault.0).unwrap();
        }
        writeln!(self.changes, "{name} {change:?}").unwrap();
    }

    fn port(&mut self, _: BaseType, _: &str) -> Option<u32> {
        None
    }
}

impl val3_vm::Host for Host {
    fn take_elapsed(&mut self) -> Time {
        0
    }

    fn is_interrupted(&self) -> bool {
        self.is_interrupted
    }

    fn lacking(&mut self, instruction: &str) {
        writeln!(self.record, "no {instruction}").unwrap();
    }

    fn loaded(&mut self, number: u16, image: &Arc<Image>, _: &Arc<[StoreId]>) {
        self.images.truncate(number.into());
        self.images.push(Arc::clone(image));
    }

    fn library(&mut self, _: LibraryOp, alias: &str, path: &str, code: u16) {
        writeln!(self.changes, "{alias} loads {path}: {code}").unwrap();
    }

    fn no_memory_for(&mut self, _: &str) {}

    fn load(&mut self, _: &str, LibraryRequest { path, .. }: LibraryRequest<'_>) -> Result<LoadedLibrary, u16> {
        let found = self.libraries.iter().find(|image| image.name == path).ok_or(NO_LIBRARY)?;
        Ok(LoadedLibrary { image: Arc::clone(found), path: path.to_owned() })
    }

    fn save(&mut self, _: &Space, _: InstanceId, _: InstanceId, _: Option<&str>) -> u16 {
        0
    }
}

#[track_caller]
pub(crate) fn image_of(text: &str) -> Arc<Image> {
    Arc::new(assemble(text).unwrap_or_else(|error| panic!("{error}\n{text}")))
}

/// An application whose program `start` is a task.
pub(crate) struct Bench {
    pub(crate) vm: Vm,
    pub(crate) schedule: Schedule,
    pub(crate) host: Host,
    pub(crate) start: TaskNumber,
}

impl Bench {
    /// Assembles an application, and creates the task `start` with priority 10.
    #[track_caller]
    pub(crate) fn new(text: &str) -> Self {
        Self::with_libraries(text, &[])
    }

    /// Like [`new`](Self::new), with libraries that it can load.
    #[track_caller]
    pub(crate) fn with_libraries(text: &str, libraries: &[&str]) -> Self {
        let image = image_of(text);
        let libraries = libraries.iter().map(|text| image_of(text)).collect();
        let (mut vm, mut host) = (Vm::default(), Host { libraries, ..Host::default() });
        let program = image.program("start").unwrap();
        let application = vm.space.load(image, String::new(), &mut host).unwrap();
        vm.space.load_with(application, &mut host);
        let start = vm.start("start", ProgramId { instance: application, number: program }, 10, &mut host).unwrap();
        Self { vm, schedule: Schedule::new(LINE), host, start }
    }

    /// Runs one cycle, or the rest of a cycle.
    pub(crate) fn cycle(&mut self) -> CycleEnd {
        self.schedule.cycle(&mut self.vm, &mut self.host)
    }

    /// Runs cycles until no task runs.
    #[track_caller]
    pub(crate) fn run(mut self) -> Self {
        while self.vm.tasks().iter().any(|task| task.state == val3_vm::TaskState::Running) {
            assert!(self.schedule.now < LONGEST, "it does not end: {}", self.host.record);
            if let CycleEnd::Waiting(wake) = self.cycle() {
                let wake = wake.unwrap_or_else(|| panic!("all tasks wait: {}", self.host.record));
                self.schedule.now = self.schedule.now.max(wake / val3_vm::CYCLE * val3_vm::CYCLE);
            }
        }
        self
    }
}

/// Checks an application's record.
#[track_caller]
pub(crate) fn check(text: &str, expected: Expect) {
    expected.assert_eq(&Bench::new(text).run().host.record);
}
