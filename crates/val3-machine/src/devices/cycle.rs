//! Actions of the devices at the beginning and end of a cycle (5.7).

use val3_lang::ports::Time;

use super::Devices;
use super::part_events::{changed, seen, switched};

impl Devices {
    /// Begins a cycle: lines read from their peers, tapped keys are released, the power changes, and the inputs of
    /// programs are updated.
    pub fn begin_cycle(&mut self, now: Time) {
        self.lines.attend();
        self.state.pendant.advance(now);
        let seen = seen(&mut self.state.pendant);
        self.record_all_outside(now, seen);
        self.state.advance_arm(now);
        self.record_move_events(now);
        self.record_motion_fault(now);
        let switched = switched(&mut self.state.robot);
        self.record_all_outside(now, switched);
        let changes = self.state.io.refresh_inputs();
        let changed = changed(&self.state.io, changes);
        self.record_all_outside(now, changed);
        self.state.watch_latch();
    }

    /// Ends a cycle: writes the outputs to the hardware.
    pub fn end_cycle(&mut self, now: Time) {
        self.record_lines(now);
        let changes = self.state.io.refresh_outputs();
        let changed = changed(&self.state.io, changes);
        self.record_all_outside(now, changed);
    }

    /// Time of the next change in a device without an external cause; `None` if all devices wait for programs or the
    /// outside.
    #[must_use]
    pub fn next_due(&self, now: Time) -> Option<Time> {
        let arm = self.state.arm.is_busy(self.state.robot.drive()).then_some(now);
        self.state.pendant.next_due(now).into_iter().chain(self.state.robot.next_due()).chain(arm).min()
    }
}
