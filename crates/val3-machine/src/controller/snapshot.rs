//! Snapshots: the controller at one moment, to which it can return.

use val3_lang::ports::TaskNumber;
use val3_vm::{Schedule, Vm};

use super::operator::Operations;
use super::{Controller, Phase};
use crate::devices::{LinesState, MediaState, State};
use crate::script::Script;

/// A controller at one moment.
#[derive(Debug, Clone)]
pub struct Snapshot {
    vm: Vm,
    state: State,
    lines: LinesState,
    media: MediaState,
    schedule: Schedule,
    phase: Phase,
    lead: Option<TaskNumber>,
    stopped: bool,
    script: Script,
    operations: Operations,
    /// The position in the recording of inputs.
    inputs: u64,
}

/// Bytes of the devices in a snapshot: arm, pendant, logs. An average.
const DEVICE_BYTES: u64 = 64 << 10;

impl Snapshot {
    /// An estimate of its bytes, without what snapshots share.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        DEVICE_BYTES + self.vm.copied_bytes() + self.media.bytes()
    }
}

impl Controller {
    /// Takes a snapshot, also in the middle of a cycle. From the first one on, all inputs are recorded, and files that
    /// programs change stay in memory until [`write_files`](Self::write_files).
    pub fn snapshot(&mut self) -> Snapshot {
        Snapshot {
            vm: self.vm.clone(),
            state: self.devices.state.clone(),
            lines: self.devices.lines.state(),
            media: self.devices.media_state(),
            schedule: self.schedule.clone(),
            phase: self.phase,
            lead: self.lead,
            stopped: self.stopped,
            script: self.script.clone(),
            operations: self.operations.clone(),
            inputs: self.devices.lines.inputs().mark(),
        }
    }

    /// Returns to a snapshot of this controller. The limit of the run stays.
    ///
    /// The inputs that were recorded after the snapshot are given again, so the controller does the same as before until
    /// the moment at which this was called. The outside is neither read nor changed in that time.
    pub fn restore(&mut self, snapshot: &Snapshot) {
        let Snapshot { vm, state, lines, media, schedule, phase, lead, stopped, script, operations, inputs } =
            snapshot.clone();
        self.vm = vm;
        self.devices.state = state;
        self.devices.lines.restore(&lines);
        self.devices.restore_media(&media);
        let limit = self.schedule.limit;
        self.schedule = schedule;
        self.schedule.limit = limit;
        (self.phase, self.lead, self.stopped, self.script) = (phase, lead, stopped, script);
        self.operations.rewind(&operations);
        self.devices.lines.inputs().rewind(inputs);
    }

    /// Returns to a snapshot of this controller for another course of events: the outside is asked again. Connections of
    /// lines to the outside stay as they are.
    pub fn begin_again(&mut self, snapshot: &Snapshot) {
        self.restore(snapshot);
        self.devices.lines.inputs().rewind_anew(snapshot.inputs);
    }

    /// Drops the inputs that were recorded before a snapshot: the controller returns to no earlier one.
    pub fn forget_inputs_before(&mut self, snapshot: &Snapshot) {
        self.devices.lines.inputs().forget_before(snapshot.inputs);
    }

    /// The bytes of the recorded inputs, as estimated.
    #[must_use]
    pub fn input_bytes(&self) -> u64 {
        self.devices.lines.inputs().bytes()
    }

    /// Writes the files that programs have changed since the first snapshot. A file that something else has changed
    /// meanwhile stays, and that of the program is written next to it, which the event log says.
    pub fn write_files(&mut self) {
        self.devices.write_files(self.schedule.now);
    }

    /// Ends the recording of inputs that the first snapshot has begun, and writes files. No snapshot may be restored any
    /// more.
    pub fn end_recording(&mut self) {
        self.write_files();
        self.devices.lines.inputs().end();
        self.devices.uncover_media();
    }
}
