//! Setting a task's next line, like `taskResume` (5.10).

use std::error::Error;
use std::fmt;

use val3_bytecode::Program;
use val3_lang::ports::TaskNumber;

use crate::debugger::Debugger;
use crate::program_breakpoints::file_of;

/// Line at which a task can continue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GotoTarget {
    /// Row of the line; for the end of the program, the requested row.
    pub row: u32,
    /// Whether this is the end of the program.
    pub is_end: bool,
    /// First operation of the line.
    op: u32,
}

/// Reason why a task cannot continue at a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GotoFault {
    /// There is no such task.
    NoTask,
    /// The row is not in the task's innermost program.
    OtherProgram,
    /// The program no longer has this line.
    NoLine,
}

impl fmt::Display for GotoFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NoTask => "the task no longer exists",
            Self::OtherProgram => "a task can continue only in the innermost program that it is in",
            Self::NoLine => "the program has no instruction line there",
        })
    }
}

impl Error for GotoFault {}

impl Debugger {
    /// Returns the line at which the task can continue for a row of a file: the line at this row, the next line with an
    /// instruction, or the end of the program.
    ///
    /// # Errors
    /// The row is not in the innermost program of the task.
    pub fn goto_target(&self, task: TaskNumber, file: &str, row: u32) -> Result<GotoTarget, GotoFault> {
        let vm = &self.controller.vm;
        let found = vm.tasks().iter().find(|known| known.id == task).ok_or(GotoFault::NoTask)?;
        let frame = found.thread.frames.last().ok_or(GotoFault::NoTask)?;
        let image = &vm.space.instance(frame.instance).ok_or(GotoFault::NoTask)?.image;
        let program = image.programs.get(usize::from(frame.program)).ok_or(GotoFault::OtherProgram)?;
        if file_of(image, program) != file {
            return Err(GotoFault::OtherProgram);
        }
        Ok(target(program, row))
    }

    /// Sets the next line of a task in its innermost program, like `taskResume` for a task that is not running.
    /// Nothing is executed. A task that was halted or stopped by an error runs again. Discards the recorded future.
    ///
    /// # Errors
    /// There is no such task or line.
    pub fn goto(&mut self, task: TaskNumber, target: GotoTarget) -> Result<(), GotoFault> {
        if !self.controller.vm.tasks().iter().any(|known| known.id == task) {
            return Err(GotoFault::NoTask);
        }
        if !self.controller.continue_at(task, target.op) {
            return Err(GotoFault::NoLine);
        }
        self.abandon_step();
        self.controller.vm.pass_stop(task);
        self.begin_new_future();
        Ok(())
    }
}

fn target(program: &Program, row: u32) -> GotoTarget {
    match program.line_from(row).and_then(|line| program.lines.get(line)) {
        Some(line) => GotoTarget { row: line.row, is_end: false, op: line.op },
        None => {
            // The last operation is the return.
            let op = u32::try_from(program.code.len()).unwrap_or(u32::MAX).saturating_sub(1);
            GotoTarget { row, is_end: true, op }
        }
    }
}
