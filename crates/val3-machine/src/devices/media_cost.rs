//! Duration of instructions on media.

use val3_lang::ports::Time;
use val3_vm::CYCLE;

/// Time to find, create or delete an entry on a medium: a cycle, after which the run can be ended.
const ACCESS: Time = CYCLE;

/// Time to read from or write to an open file, without the bytes.
const TRANSFER: Time = 100_000;

/// Time for each byte: 4 MB in a second.
const PER_BYTE: Time = 250;

/// Time that the last instruction has spent outside the program.
#[derive(Debug, Clone, Default)]
pub(super) struct MediaCost {
    elapsed: Time,
}

impl MediaCost {
    /// Adds the time for a path on a medium, and for the bytes read or written there, to the current instruction.
    pub(super) fn access(&mut self, bytes: usize) {
        self.spend(ACCESS, bytes);
    }

    /// Adds the time for bytes in an open file to the current instruction.
    pub(super) fn transfer(&mut self, bytes: usize) {
        self.spend(TRANSFER, bytes);
    }

    /// The time since the last call.
    pub(super) fn take(&mut self) -> Time {
        std::mem::take(&mut self.elapsed)
    }

    fn spend(&mut self, time: Time, bytes: usize) {
        let bytes = PER_BYTE.saturating_mul(bytes as Time);
        self.elapsed = self.elapsed.saturating_add(time).saturating_add(bytes);
    }
}
