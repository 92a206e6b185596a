//! Replacement of a line in a program in memory, while the run continues.

use val3_lang::fault::Fault;
use val3_vm::LineReplacement;

use crate::debugger::Debugger;

impl Debugger {
    /// Replaces a line of a program in memory, like [`Controller::replace_line`](val3_machine::controller::Controller::replace_line).
    /// Breakpoints stay at their rows. The current step ends without a stop. Discards the recorded history, whose
    /// snapshots contain the previous code.
    ///
    /// # Errors
    /// 40 without memory, 61 without the program. The run is then unchanged.
    pub fn replace_line(&mut self, replacement: LineReplacement, code: &str) -> Result<(), Fault> {
        self.controller.replace_line(replacement, code)?;
        self.abandon_step();
        self.restore_marks();
        self.settle_data();
        self.forget_past();
        Ok(())
    }
}
