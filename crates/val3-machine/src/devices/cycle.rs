//! The work of the devices at the beginning and the end of a cycle (5.7).

use val3_lang::ports::Time;

use super::Devices;
use crate::event::EventKind;
use crate::io::IoChange;

impl Devices {
    /// The cycle begins: lines hear their peers, keys come up, power changes, programs see new inputs.
    pub fn begin_cycle(&mut self, now: Time) {
        self.lines.attend();
        self.state.pendant.advance(now);
        self.record_pendant(now);
        self.state.advance_arm(now);
        self.record_steps(now);
        self.record_robot(now);
        let changes = self.state.io.refresh_inputs();
        self.record_io(now, changes);
        self.state.watch_latch();
    }

    /// The cycle ends: the hardware gets new outputs.
    pub fn end_cycle(&mut self, now: Time) {
        self.record_lines(now);
        let changes = self.state.io.refresh_outputs();
        self.record_io(now, changes);
    }

    /// When a device does something of itself; `None` where all of them wait for programs or the outside.
    #[must_use]
    pub fn next_due(&self, now: Time) -> Option<Time> {
        let arm = self.state.arm.is_busy(self.state.robot.drive()).then_some(now);
        self.state.pendant.next_due(now).into_iter().chain(self.state.robot.next_due()).chain(arm).min()
    }

    fn record_io(&mut self, now: Time, changes: Vec<IoChange>) {
        for IoChange { signal, value } in changes {
            if let Some(link) = self.state.io.signal(signal).map(|signal| signal.path.clone()) {
                self.record_outside(now, EventKind::Io { link, value });
            }
        }
    }
}
