//! Snapshots of the controller, which can be restored.

use val3_lang::ports::TaskNumber;
use val3_vm::{Schedule, Vm};

use super::operator::Operations;
use super::{Controller, RunPhase};
use crate::devices::{DeviceState, LinesState, MediaState};
use crate::script::Script;

/// State of a controller at one time.
#[derive(Debug, Clone)]
pub struct Snapshot {
    vm: Vm,
    state: DeviceState,
    lines: LinesState,
    media: MediaState,
    schedule: Schedule,
    phase: RunPhase,
    lead: Option<TaskNumber>,
    stopped: bool,
    script: Script,
    operations: Operations,
    /// Position in the recording of external input.
    inputs: u64,
}

/// Average size of the devices in a snapshot, in bytes: arm, pendant, logs.
const DEVICE_BYTES: u64 = 64 << 10;

impl Snapshot {
    /// Estimated size in bytes, without memory shared between snapshots.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        DEVICE_BYTES + self.vm.copied_bytes() + self.media.bytes()
    }
}

impl Controller {
    /// Creates a snapshot, also in the middle of a cycle. From the first snapshot on, all external input is recorded,
    /// and files that programs change stay in memory until [`write_files`](Self::write_files).
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

    /// Restores a snapshot of this controller. The limit of the run stays.
    ///
    /// The input that was recorded after the snapshot is replayed, so the controller repeats its behaviour until the
    /// time of this call. No external read or write is executed in that time.
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

    /// Restores a snapshot of this controller for another sequence of events: calls reach the outside again.
    /// Connections of lines to the outside stay unchanged.
    pub fn begin_again(&mut self, snapshot: &Snapshot) {
        self.restore(snapshot);
        self.devices.lines.inputs().rewind_anew(snapshot.inputs);
    }

    /// Discards the input that was recorded before a snapshot. No earlier snapshot may be restored afterwards.
    pub fn forget_inputs_before(&mut self, snapshot: &Snapshot) {
        self.devices.lines.inputs().forget_before(snapshot.inputs);
    }

    /// Estimated size of the recorded input, in bytes.
    #[must_use]
    pub fn input_bytes(&self) -> u64 {
        self.devices.lines.inputs().bytes()
    }

    /// Writes the files that programs have changed since the first snapshot. A file that another process has changed
    /// meanwhile stays; the program's file is written next to it, and the event log reports it.
    pub fn write_files(&mut self) {
        self.devices.write_files(self.schedule.now);
    }

    /// Ends the recording that the first snapshot has started, and writes files. No snapshot may be restored
    /// afterwards.
    pub fn end_recording(&mut self) {
        self.write_files();
        self.devices.lines.inputs().end();
        self.devices.uncover_media();
    }
}
