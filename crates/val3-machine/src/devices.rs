//! What programs reach of the controller: the ports of instructions, each in a file of its own.

mod cell;
mod cycle;
mod instances;
mod io;
mod libraries;
mod limits;
mod lines;
mod media;
mod motion;
mod robot;
mod saving;
mod screen;
mod serial;
mod tasks;

use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use val3_bytecode::Image;
use val3_lang::ports::{Origin, TaskNumber, Time};

use crate::controller_state::{Calendar, Cs9, EventLog, FIRST_ARM, Languages, Profiles, Robot, Versions};
use crate::event::{Event, What, seconds};
use crate::files::{ControllerPath, LibraryFiles, OpenFiles, Roots};
use crate::io::IoTable;
use crate::screen::{Pendant, ReadingId};

pub use io::NoSignal;
pub use limits::Limits;

use instances::Held;
pub use lines::Lines;
pub use motion::StandingArm;

/// Everything of the controller but its programs.
pub struct Devices {
    /// Digital and analog inputs and outputs.
    pub io: IoTable,
    /// Serial lines and sockets.
    pub lines: Lines,
    /// The pendant.
    pub pendant: Pendant,
    /// Power, modes and speed.
    pub robot: Robot,
    /// The arm.
    pub arm: StandingArm,
    /// The event log.
    pub log: EventLog,
    /// Users.
    pub profiles: Profiles,
    /// Languages.
    pub languages: Languages,
    /// Versions and licences.
    pub versions: Versions,
    /// Date and time.
    pub calendar: Calendar,
    /// What CS9 controllers add.
    pub cs9: Cs9,
    /// The media that paths name.
    pub roots: Roots,
    /// The files that programs have open.
    files: OpenFiles,
    /// Finds and compiles libraries.
    pub libraries: Box<dyn Libraries>,
    /// While set, each cycle ends after the current instruction, so that the caller can end the run even in a loop of
    /// slow instructions.
    pub interrupt: Arc<AtomicBool>,
    /// How much the devices hold for programs.
    pub limits: Limits,
    /// What the last instruction has taken outside the program.
    elapsed: Time,
    /// What has happened and was not taken yet.
    events: Vec<Event>,
    /// Bytes of the events, roughly.
    recorded: usize,
    /// A task was at an instruction that is not there.
    pub(crate) lacks: bool,
    /// Where the calls of ports come from.
    origin: Origin,
    /// The names of tasks.
    names: BTreeMap<TaskNumber, String>,
    /// What tasks wait for on the pendant.
    readings: BTreeMap<TaskNumber, ReadingId>,
    /// What is in memory, by the number of the instance.
    instances: Vec<Option<Held>>,
    /// Their files as they were loaded, by the number of their instance.
    sources: BTreeMap<u16, LibraryFiles>,
    /// The library that was read last, until it comes into memory.
    read: Option<(Arc<Image>, LibraryFiles)>,
}

/// Finds and compiles libraries: the way from the run time to the analysis.
pub trait Libraries {
    /// The image of the library with these files.
    ///
    /// # Errors
    /// What is wrong with it, for the event log: its data or programs do not suit (code 12 of `libLoad`).
    fn image(&mut self, path: &ControllerPath, files: LibraryFiles) -> Result<Arc<Image>, String>;
}

impl Devices {
    /// Devices in their state after a start, with these media and this way to libraries.
    #[must_use]
    pub fn new(roots: Roots, libraries: Box<dyn Libraries>) -> Self {
        Self {
            io: IoTable::default(),
            lines: Lines::default(),
            pendant: Pendant::default(),
            robot: Robot::default(),
            arm: StandingArm::new(FIRST_ARM),
            log: EventLog::default(),
            profiles: Profiles::default(),
            languages: Languages::default(),
            versions: Versions::default(),
            calendar: Calendar::default(),
            cs9: Cs9::default(),
            roots,
            files: OpenFiles::default(),
            libraries,
            interrupt: Arc::default(),
            limits: Limits::default(),
            elapsed: 0,
            events: Vec::new(),
            recorded: 0,
            lacks: false,
            origin: Origin::default(),
            names: BTreeMap::new(),
            readings: BTreeMap::new(),
            instances: Vec::new(),
            sources: BTreeMap::new(),
            read: None,
        }
    }

    /// Records what the task that runs has done.
    fn record(&mut self, what: What) {
        let task = self.names.get(&self.origin.task).cloned();
        self.push_event(Event { t: seconds(self.origin.time), task, what });
    }

    /// Records what lines have answered.
    pub(crate) fn record_lines(&mut self, now: Time) {
        if let Some(wall) = self.lines.take_use() {
            self.record_outside(now, What::Clock { wall });
        }
        for (link, entry) in self.lines.take_told() {
            self.record_outside(now, What::Line { link, entry });
        }
    }

    /// Records what has come from outside.
    pub fn record_outside(&mut self, now: Time, what: What) {
        self.push_event(Event { t: seconds(now), task: None, what });
    }

    fn push_event(&mut self, event: Event) {
        self.recorded += size_of::<Event>();
        self.events.push(event);
    }

    /// What has happened since this was asked before.
    pub fn take_events(&mut self) -> Vec<Event> {
        self.recorded = 0;
        std::mem::take(&mut self.events)
    }
}

impl std::fmt::Debug for Devices {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Devices").field("origin", &self.origin).finish_non_exhaustive()
    }
}
