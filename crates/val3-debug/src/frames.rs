//! The programs that a task is in.

use val3_lang::ports::TaskNumber;
use val3_vm::{Frame, InstanceId, Vm};

/// A program that a task is in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TaskFrame {
    /// The name of the application or library.
    pub application: String,
    /// The name of the program.
    pub program: String,
    /// The file of the program.
    pub file: String,
    /// The line of the file that is executed, or executed next, from 1.
    pub row: u32,
    /// The application or library in memory.
    pub instance: InstanceId,
    /// The number of the program in it.
    pub number: u16,
}

/// The programs that a task is in, the innermost first; none if there is no such task.
#[must_use]
pub fn frames(vm: &Vm, task: TaskNumber) -> Vec<TaskFrame> {
    let Some(task) = vm.tasks().iter().find(|known| known.id == task) else { return Vec::new() };
    let thread = &task.thread;
    // Between two lines the next one counts, within a line that line.
    let first = if vm.is_within_line(task.id) { thread.line } else { thread.next };
    let mut op = first;
    let shown = |frame: &Frame| {
        let shown = task_frame(vm, frame, op);
        op = frame.back_line;
        shown
    };
    thread.frames.iter().rev().filter_map(shown).collect()
}

/// The program of a frame, at the line that an operation belongs to.
pub(crate) fn task_frame(vm: &Vm, frame: &Frame, op: u32) -> Option<TaskFrame> {
    let image = &vm.space.instance(frame.instance)?.image;
    let program = image.programs.get(usize::from(frame.program))?;
    let row = program.line_of(op).and_then(|line| program.lines.get(line)).map_or(0, |line| line.row);
    Some(TaskFrame {
        application: image.name.clone(),
        program: program.name.clone(),
        file: image.files.get(program.file as usize).cloned().unwrap_or_default(),
        row,
        instance: frame.instance,
        number: frame.program,
    })
}
