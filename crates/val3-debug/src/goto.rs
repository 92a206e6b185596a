//! Another next line for a task, as `taskResume` sets it (5.10).

use std::error::Error;
use std::fmt;

use val3_bytecode::Program;
use val3_lang::ports::TaskNumber;

use crate::debugger::Debugger;
use crate::program_breakpoints::file_of;

/// A line at which a task can continue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GotoTarget {
    /// The row of the line. For the end of the program, the row that was asked for.
    pub row: u32,
    /// The end of the program: no line is left.
    pub is_end: bool,
    /// The first operation of the line.
    op: u32,
}

/// Why a task cannot continue at a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GotoFault {
    /// There is no such task.
    NoTask,
    /// The row is not in the program that the task is in.
    OtherProgram,
    /// The program has no such line any more.
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
    /// Where a task can continue for a row of a file: at the line there or the next one with an instruction, or at the end
    /// of the program.
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

    /// Lets a task continue at another line of the innermost program that it is in, as `taskResume` does for a task that is
    /// not running. Nothing is executed. A task that was halted or that an error has stopped runs again. A new future
    /// begins here.
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
