//! Devices of the controller: the ports of the instructions, one file for each port.
//!
//! [`DeviceState`] is plain data that a snapshot copies. [`ChannelTable`] and the media access the outside, and each result passes
//! through the recorder of [`Inputs`].

mod blends;
mod cell;
mod cycle;
mod io;
mod lines;
mod loaded;
mod media;
mod media_cost;
mod motion;
mod outside;
mod part_events;
mod projects;
mod questions;
mod received;
mod record;
mod robot;
mod saving;
mod screen;
mod scripted_lines;
mod serial;
mod signal_reads;
mod stand_ins;
mod state;
mod tasks;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use val3_lang::memory::Place;
use val3_lang::ports::{CodePlace, Time};
use val3_vm::{InstanceId, Space};

use crate::controller_state::MessageSeverity;
use crate::event::{Event, EventKind};
use crate::files::{FileFault, Roots};
use crate::inputs::Inputs;
use crate::io::IoChange;
use crate::screen::Pendant;
use crate::shapes::LinkShape;

pub use lines::{ChannelTable, LinesState};
pub use loaded::ReplacedLines;
pub use outside::{Libraries, MediaState};
pub use saving::{DataSelection, DocumentFault, SavedValues};
pub use stand_ins::StandIns;
pub use state::DeviceState;

use cell::CellFile;
use outside::Outside;
use signal_reads::SignalReads;

/// All parts of the controller except the programs.
pub struct Devices {
    /// Inputs and outputs, pendant, power, log and the other parts that are plain data.
    pub state: DeviceState,
    /// Serial lines and sockets.
    pub lines: ChannelTable,
    /// Media and libraries.
    outside: Outside,
    /// While set, the cycle is suspended after the current instruction, so that the caller can end the run even in a loop
    /// of slow instructions.
    pub interrupt: Arc<AtomicBool>,
    /// Memory limits of the devices.
    pub limits: DeviceLimits,
    /// Shapes of the base and the following links, if known.
    pub shapes: Vec<Option<LinkShape>>,
    /// Libraries that are loaded in place of other libraries.
    pub stand_ins: StandIns,
    signal_reads: SignalReads,
    /// Values that signals receive at the beginning of the next cycle.
    received: Vec<IoChange>,
}

/// Event record and related state, saved while code outside of the run is executed.
pub(crate) struct RecordAside {
    record: record::Aside,
    lacks: bool,
    signal_reads: SignalReads,
}

impl Devices {
    /// Creates devices in their state after a start, with these media and this library compiler.
    #[must_use]
    pub fn new(roots: Roots, libraries: Box<dyn Libraries>) -> Self {
        let inputs = Inputs::default();
        Self {
            state: DeviceState::default(),
            lines: ChannelTable::new(inputs.clone()),
            outside: Outside::new(roots, libraries, inputs),
            interrupt: Arc::default(),
            limits: DeviceLimits::default(),
            shapes: Vec::new(),
            stand_ins: StandIns::default(),
            signal_reads: SignalReads::default(),
            received: Vec::new(),
        }
    }

    /// Records an event of the task that runs.
    fn record(&mut self, kind: EventKind) {
        self.state.record.push(kind);
    }

    /// Records events of the task that runs.
    fn record_all(&mut self, kinds: impl IntoIterator<Item = EventKind>) {
        kinds.into_iter().for_each(|kind| self.record(kind));
    }

    /// Records events of no task.
    fn record_all_outside(&mut self, now: Time, kinds: impl IntoIterator<Item = EventKind>) {
        kinds.into_iter().for_each(|kind| self.record_outside(now, kind));
    }

    /// Acts on the pendant for the running task, and records the changes.
    fn on_pendant<T>(&mut self, act: impl FnOnce(&mut Pendant) -> T) -> T {
        let result = act(&mut self.state.pendant);
        let seen = part_events::seen(&mut self.state.pendant);
        self.record_all(seen);
        result
    }

    /// Writes a line of the controller itself to the event log, where such lines are never lost.
    pub fn report(&mut self, text: &str, severity: MessageSeverity, now: Time) {
        self.state.log.report(text, severity, now);
        let logged = part_events::logged(&mut self.state.log);
        self.record_all_outside(now, logged);
    }

    /// Writes a line about the instruction of the task that runs to the event log.
    fn report_here(&mut self, text: &str, severity: MessageSeverity) {
        self.state.log.report(text, severity, self.now());
        let logged = part_events::logged(&mut self.state.log);
        self.record_all(logged);
    }

    /// Applies the settings of the arm, its speed and the language in a file such as `arm.cfx` or `cell.cfx`.
    pub fn describe(&mut self, file: &str) {
        for warning in CellFile::read(file).apply(&mut self.state) {
            self.report(&warning, MessageSeverity::Warning, 0);
        }
    }

    /// Stores the loaded files of the instance, so that it can be saved.
    pub fn keep_files(&mut self, instance: InstanceId, path: &str) {
        if let Ok(files) = self.outside.files(path) {
            self.state.loaded.keep_files(instance.0, files);
        }
    }

    /// Writes values that an operator has changed into the files from which they were loaded.
    ///
    /// # Errors
    /// A file cannot be read or written, or belongs to an encrypted library.
    pub fn save_values(&mut self, space: &Space, places: &[Place], overwrite: bool) -> Result<SavedValues, FileFault> {
        let DeviceState { io, loaded, .. } = &mut self.state;
        let request = saving::SaveRequest { space, places, io, lines: &self.lines, overwrite };
        saving::save(&request, loaded, &mut self.outside)
    }

    /// Writes copies of the data files with the values at these places, next to the files: `main.dtx.unsaved`. Returns
    /// the names of the copies.
    ///
    /// # Errors
    /// A file cannot be read or written, or belongs to an encrypted library.
    pub fn save_copies(&mut self, space: &Space, places: &[Place]) -> Result<Vec<String>, FileFault> {
        let DeviceState { io, loaded, .. } = &mut self.state;
        let request = saving::SaveRequest { space, places, io, lines: &self.lines, overwrite: false };
        saving::save_copies(&request, loaded, &mut self.outside)
    }

    /// Returns the file changes of programs. From the first call on, they stay in memory.
    pub(crate) fn media_state(&mut self) -> MediaState {
        self.outside.state(self.limits.changed)
    }

    /// Restores an earlier state of the file changes.
    pub(crate) fn restore_media(&mut self, state: &MediaState) {
        self.outside.restore(state);
    }

    /// Writes the file changes in memory to the media. The event log lists the files that were not written, with the
    /// reason.
    pub(crate) fn write_files(&mut self, now: Time) {
        for message in self.outside.write() {
            self.report(&message, MessageSeverity::Warning, now);
        }
    }

    /// Ends the storage of file changes in memory: programs write to the media again.
    pub(crate) fn uncover_media(&mut self) {
        self.outside.uncover();
    }

    /// Records the results of lines.
    pub(crate) fn record_lines(&mut self, now: Time) {
        if let Some(wall) = self.lines.take_peer_change() {
            self.record_outside(now, EventKind::Clock { wall });
        }
        for (link, entry) in self.lines.take_answers() {
            self.record_outside(now, EventKind::Line { link, entry });
        }
    }

    /// Records an event of no task.
    pub fn record_outside(&mut self, now: Time, kind: EventKind) {
        self.state.record.push_outside(now, kind);
    }

    /// The events since the last [`take_events`](Self::take_events), which remain.
    #[must_use]
    pub fn pending_events(&self) -> &[Event] {
        self.state.record.pending()
    }

    /// The events since the last call.
    pub fn take_events(&mut self) -> Vec<Event> {
        self.state.record.take()
    }

    /// Saves the pending events and the rest of the record's state.
    pub(crate) fn set_record_aside(&mut self) -> RecordAside {
        let signal_reads = std::mem::take(&mut self.signal_reads);
        RecordAside { record: self.state.record.set_aside(), lacks: self.state.lacks, signal_reads }
    }

    /// Restores the saved record. All events since must have been taken.
    pub(crate) fn resume_record(&mut self, aside: RecordAside) {
        self.state.record.resume(aside.record);
        self.state.lacks = aside.lacks;
        self.signal_reads = aside.signal_reads;
        self.state.media_cost.take();
    }

    /// Time of the current instruction.
    fn now(&self) -> Time {
        self.state.record.origin().time
    }

    /// Program, line of the file and file of a code location.
    #[must_use]
    pub fn place(&self, at: CodePlace) -> (String, u32, String) {
        self.state.loaded.position(at)
    }

    /// Program, line of the file and file of a move; empty and 0 for a move of a client.
    #[must_use]
    pub fn place_of_move(&self, at: Option<CodePlace>) -> (String, u32, String) {
        at.map(|at| self.place(at)).unwrap_or_default()
    }

    /// Whether a task has reached an unsupported instruction since the last call.
    pub(crate) fn take_missing_instruction(&mut self) -> bool {
        std::mem::take(&mut self.state.lacks)
    }
}

impl std::fmt::Debug for Devices {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Devices").field("state", &self.state).finish_non_exhaustive()
    }
}

/// Maximum amounts of data that the devices store for programs, in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DeviceLimits {
    /// Events in a cycle. The cycle is then suspended, so that the caller can take the events.
    pub recorded: usize,
    /// Data that all tasks together have to send over lines. Beyond this limit, sending raises error 40.
    pub pending: usize,
    /// Size of the data that `libSave` writes. Beyond this limit, the instruction returns code 38.
    pub saved: u64,
    /// Files that programs have changed since external input is recorded, which stay in memory. Beyond this limit,
    /// writing fails.
    pub changed: u64,
}

impl Default for DeviceLimits {
    fn default() -> Self {
        Self { recorded: 64 << 20, pending: 64 << 20, saved: 64 << 20, changed: 256 << 20 }
    }
}
