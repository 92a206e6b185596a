//! Tasks: programs in execution with their position and data (5.1).

use val3_bytecode::Program;
use val3_lang::call::{Wait, Waiting};
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Lanes, MemoryBudget, Place, Stack, bytes_of};
use val3_lang::ports::{CodePlace, TaskNumber, Time};

use crate::InstanceId;
use crate::operands::on_frame;

/// A task.
#[derive(Debug, Clone)]
pub struct Task {
    /// Identity.
    pub id: TaskNumber,
    /// Name.
    pub name: String,
    /// Application or library whose program created the task. The task is visible only there (5.3).
    pub owner: InstanceId,
    /// Priority or period.
    pub rate: Rate,
    /// State.
    pub state: TaskState,
    /// Position.
    pub thread: Box<Thread>,
    /// Largest size of the stack, in bytes.
    pub stack_size: u32,
    /// Remaining lines of a turn that the end of a cycle interrupted.
    pub left: u32,
    /// Whether the task is held from outside: it gets no turns, which programs cannot detect.
    pub is_held: bool,
}

/// Position of a task, which changes during its execution. The running task lends it to the interpreter.
#[derive(Debug, Clone, Default)]
pub struct Thread {
    /// Stack frames, the innermost last.
    pub frames: Vec<Frame>,
    /// Data of the frames. While the task runs, they are in the memory.
    pub stack: Stack,
    /// Next operation in the innermost program.
    pub next: u32,
    /// First operation of the current line.
    pub line: u32,
    /// Instruction in which the task waits.
    pub waiting: Option<Waiting>,
    /// Time at which the task reached the `watch` in which it waits, in ns.
    pub watched: Option<Time>,
    /// Present wait; contains the wake-up time if the wait is timed.
    pub wait: Option<Wait>,
    /// Whether the task has stopped at a stop mark. It begins that line when it continues.
    pub is_at_stop: bool,
    /// Whether the task has stopped before its end.
    pub is_at_end: bool,
    /// Whether the task has stopped before the return of a program with [watched](crate::DataWatch::frames) variables.
    pub is_at_return: bool,
    /// Fragments on the stack, the innermost last: see [`Vm::execute`](crate::Vm::execute).
    pub(crate) fragments: Vec<StackedFragment>,
    /// Operation that has stopped the task with a run-time error.
    pub(crate) failed: Option<u32>,
}

/// A fragment whose frame is on the stack of a task.
#[derive(Debug, Clone)]
pub(crate) struct StackedFragment {
    /// Number of stack frames below the fragment.
    pub(crate) depth: usize,
    /// Clock of the fragment while no turn of the task executes it, in ns.
    pub(crate) clock: Time,
    /// Granted lines that were not executed.
    pub(crate) left: u32,
    /// Position of the task below the fragment.
    pub(crate) position: Position,
    /// State of the task before the fragment.
    pub(crate) state: TaskState,
}

/// Position of a thread, without its frames.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Position {
    pub(crate) next: u32,
    pub(crate) line: u32,
    waiting: Option<Waiting>,
    watched: Option<Time>,
    wait: Option<Wait>,
    is_at_stop: bool,
    is_at_end: bool,
    is_at_return: bool,
    failed: Option<u32>,
}

impl Position {
    pub(crate) fn of(thread: &Thread) -> Self {
        let Thread { next, line, waiting, watched, wait, is_at_stop, is_at_end, is_at_return, failed, .. } = *thread;
        Self { next, line, waiting, watched, wait, is_at_stop, is_at_end, is_at_return, failed }
    }

    pub(crate) fn apply(self, thread: &mut Thread) {
        let Self { next, line, waiting, watched, wait, is_at_stop, is_at_end, is_at_return, failed } = self;
        (thread.next, thread.line) = (next, line);
        (thread.waiting, thread.watched, thread.wait) = (waiting, watched, wait);
        (thread.is_at_stop, thread.is_at_end, thread.is_at_return) = (is_at_stop, is_at_end, is_at_return);
        thread.failed = failed;
    }
}

/// A thread that has not run yet, and its largest stack size in bytes.
pub(crate) struct NewThread {
    pub(crate) thread: Thread,
    pub(crate) stack_size: u32,
}

/// Size of a task without its stack, in bytes. It limits a controller to some thousands of tasks.
pub(crate) const TASK_BYTES: u64 = 64 << 10;

impl Thread {
    /// Creates a thread without a program, and reserves the memory of a task.
    ///
    /// # Errors
    /// 40 if the memory does not suffice.
    pub(crate) fn new(room: &mut MemoryBudget) -> Result<Self> {
        room.take(TASK_BYTES)?;
        Ok(Self::default())
    }

    /// Returns the size of the frames and of the stack, if the thread owns it, in bytes.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        bytes_of::<Frame>(self.frames.capacity()) + self.stack.bytes()
    }

    /// Releases the memory of a task that has ended.
    pub(crate) fn give_back(&self, room: &mut MemoryBudget) {
        room.give_back(TASK_BYTES + self.bytes());
    }

    /// Enters a program.
    ///
    /// # Errors
    /// 40 if the memory does not suffice.
    #[inline(always)]
    pub(crate) fn push(&mut self, frame: Frame, room: &mut MemoryBudget) -> Result<()> {
        if self.frames.len() == self.frames.capacity() {
            self.grow(room)?;
        }
        self.frames.push(frame);
        Ok(())
    }

    /// Doubles the capacity for frames.
    #[cold]
    fn grow(&mut self, room: &mut MemoryBudget) -> Result<()> {
        let more = self.frames.len().max(LEAST_FRAMES);
        room.take(bytes_of::<Frame>(more))?;
        self.frames.reserve_exact(more);
        Ok(())
    }

    /// Returns the position; `None` while it is lent to the interpreter.
    #[must_use]
    pub fn place(&self) -> Option<CodePlace> {
        let frame = self.frames.last()?;
        Some(CodePlace { instance: frame.instance.0, program: frame.program, line: self.line })
    }

    /// Whether the task stops at the stop mark that it has reached. At the mark at which it has already stopped, it
    /// continues.
    #[cold]
    pub(crate) fn meets_stop(&mut self) -> bool {
        self.is_at_stop = !self.is_at_stop;
        self.is_at_stop
    }

    /// Whether the task stops before its end: at the return of its first program, at the first attempt only.
    #[cold]
    pub(crate) fn meets_end(&mut self) -> bool {
        let meets = self.frames.len() == 1 && !std::mem::replace(&mut self.is_at_end, true);
        // The task has passed a stop mark of this operation, and does not stop at it again.
        self.is_at_stop |= meets;
        meets
    }

    /// Whether the task stops before the return of a program with watched variables: at the first attempt only.
    /// `has_passed_stop` is `true` if the task has passed a stop mark of this operation.
    #[cold]
    pub(crate) fn meets_return(&mut self, has_passed_stop: bool) -> bool {
        self.is_at_return = !self.is_at_return;
        self.is_at_stop |= self.is_at_return && has_passed_stop;
        self.is_at_return
    }

    /// Moves to the beginning of a line and discards the waits within the previous one.
    pub(crate) fn go_to_line(&mut self, op: u32) {
        (self.next, self.line) = (op, op);
        (self.waiting, self.watched, self.wait) = (None, None, None);
        (self.is_at_stop, self.is_at_end, self.is_at_return) = (false, false, false);
        self.failed = None;
    }
}

/// Initial capacity for frames in a thread.
const LEAST_FRAMES: usize = 4;

/// Priority or period of a task.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rate {
    /// Asynchronous task: number of lines in each turn (5.4).
    Priority(u32),
    /// Synchronous task (5.5, 5.6).
    Period {
        /// Period in ns, a multiple of 4 ms.
        period: Time,
        /// Beginning of the next period.
        next: Time,
        /// Variable that is set after an overrun.
        overrun: Place,
        /// Whether the task had not finished when the period ended, so that the next period is skipped.
        late: bool,
        /// Number of such overruns.
        overruns: u32,
    },
}

/// State of a task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TaskState {
    /// Running or waiting.
    Running,
    /// Halted.
    Halted,
    /// Stopped by an error.
    Failed(Fault),
    /// Killed; the name is free.
    Killed,
}

/// Stack frame of a called program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Frame {
    /// Application or library.
    pub instance: InstanceId,
    /// Program number.
    pub program: u16,
    /// Operation at which the caller resumes.
    pub back: u32,
    /// First operation of the calling line.
    pub back_line: u32,
    /// Start of the frame's lanes.
    pub base: Base,
}

impl Frame {
    /// Returns the place of the frame's value whose lanes begin at `lanes`, on the task's stack.
    #[inline(always)]
    #[must_use]
    pub fn place(&self, lanes: Lanes) -> Place {
        on_frame(&self.base, lanes)
    }
}

/// Start of a frame's lanes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Base {
    /// First number.
    pub num: u32,
    /// First text.
    pub text: u32,
    /// First link.
    pub link: u32,
    /// First container.
    pub part: u32,
    /// First place.
    pub place: u32,
    /// First container by reference.
    pub view: u32,
    /// Declared stack size of all previous frames, in bytes.
    pub bytes: u32,
}

impl Base {
    /// Returns the first lanes after the frame of a program that begins here.
    #[inline(always)]
    #[must_use]
    pub fn after(&self, program: &Program) -> Self {
        let size = &program.frame;
        Self {
            num: self.num + size.lanes.num,
            text: self.text + size.lanes.text,
            link: self.link + size.lanes.link,
            part: self.part + size.lanes.part,
            place: self.place + size.places,
            view: self.view + size.views,
            // The sums do not exceed the size of a stack, because the frame was admitted.
            bytes: self.bytes.wrapping_add(program.stack_bytes),
        }
    }
}

impl Task {
    /// Whether the task can have turns.
    pub(crate) fn can_run(&self) -> bool {
        self.is_running() && !self.is_held
    }

    /// Whether the task runs or waits, and is neither halted nor failed.
    #[must_use]
    pub fn is_running(&self) -> bool {
        self.state == TaskState::Running
    }

    /// Returns the result of `taskStatus` (5.10).
    #[must_use]
    pub fn status(&self) -> i16 {
        use val3_lang::runtime_errors::TaskStatusCode as Number;
        match self.state {
            TaskState::Running => Number::Running.number(),
            TaskState::Halted => Number::Halted.number(),
            TaskState::Killed => Number::Absent.number(),
            TaskState::Failed(Fault(number)) => i16::try_from(number).unwrap_or(i16::MAX),
        }
    }
}
