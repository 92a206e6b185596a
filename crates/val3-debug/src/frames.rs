//! The call stack of a task.

use std::ops::Range;

use val3_bytecode::Image;
use val3_lang::ports::TaskNumber;
use val3_vm::{Frame, InstanceId, Vm};

/// Stack frame of a task.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TaskFrame {
    /// Name of the application or library.
    pub application: String,
    /// Program name.
    pub program: String,
    /// File of the program.
    pub file: String,
    /// Current or next line of the file, from 1.
    pub row: u32,
    /// Bytes of the statement, or of its beginning up to the condition, in the file. Empty if the line is unknown.
    pub code: Range<u32>,
    /// Application or library in memory.
    pub instance: InstanceId,
    /// Number of the program in its application or library.
    pub number: u16,
    /// Whether the frame belongs to statements that the debugger executes: see
    /// [`Debugger::execute`](crate::Debugger::execute). It has no file, and its program name describes it.
    pub is_console: bool,
}

/// Program name in the stack frame of the debugger's statements.
const CONSOLE: &str = "called from the debug console";

/// Returns the stack frames of a task, the innermost first; empty if there is no such task.
#[must_use]
pub fn frames(vm: &Vm, task: TaskNumber) -> Vec<TaskFrame> {
    let Some(task) = vm.tasks().iter().find(|known| known.id == task) else { return Vec::new() };
    let thread = &task.thread;
    // Between two lines the frame shows the next line, within a line the current line.
    let first = if vm.is_within_line(task.id) { thread.line } else { thread.next };
    let frames = thread.frames.iter().rev();
    let lines = std::iter::once(first).chain(frames.clone().map(|frame| frame.back_line));
    frames.zip(lines).filter_map(|(frame, op)| task_frame(vm, frame, op)).collect()
}

/// Returns the stack frame at an operation's line.
pub(crate) fn task_frame(vm: &Vm, frame: &Frame, op: u32) -> Option<TaskFrame> {
    let image = &vm.space.instance(frame.instance)?.image;
    if vm.is_fragment(frame) {
        return Some(console_frame(image, frame));
    }
    let program = image.programs.get(usize::from(frame.program))?;
    let halt = program.halt_at(op);
    Some(TaskFrame {
        application: image.name.clone(),
        program: program.name.clone(),
        file: image.files.get(program.file as usize).cloned().unwrap_or_default(),
        row: halt.map_or(0, |halt| halt.row),
        code: halt.map_or(0..0, |halt| halt.range.start..halt.range.end),
        instance: frame.instance,
        number: frame.program,
        is_console: false,
    })
}

fn console_frame(image: &Image, frame: &Frame) -> TaskFrame {
    TaskFrame {
        application: image.name.clone(),
        program: CONSOLE.to_owned(),
        file: String::new(),
        row: 0,
        code: 0..0,
        instance: frame.instance,
        number: frame.program,
        is_console: true,
    }
}
