//! A task: a program in execution with its position and data (5.1).

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
    /// The identity.
    pub id: TaskNumber,
    /// Its name.
    pub name: String,
    /// The application or library whose program has created it. It is visible only there (5.3).
    pub owner: InstanceId,
    /// How often it runs.
    pub rate: Rate,
    /// Its state.
    pub state: TaskState,
    /// Its position.
    pub thread: Box<Thread>,
    /// Bytes of stack it may use.
    pub stack_size: u32,
    /// Lines that are left of its turn if the end of a cycle interrupted it.
    pub left: u32,
    /// It is held from outside and gets no turns, which programs do not notice.
    pub is_held: bool,
}

/// The position of a task, which changes while it runs. The task that runs lends it to the interpreter.
#[derive(Debug, Clone, Default)]
pub struct Thread {
    /// The active programs, the innermost last.
    pub frames: Vec<Frame>,
    /// The data of the frames. The memory has them while the task runs.
    pub stack: Stack,
    /// The next operation, in the innermost program.
    pub next: u32,
    /// The first operation of the line it is in.
    pub line: u32,
    /// The instruction that it waits in.
    pub waiting: Option<Waiting>,
    /// The time at which it reached the `watch` that it waits in.
    pub watched: Option<Time>,
    /// Set while the task waits. Holds the wake-up time if the wait is timed.
    pub wait: Option<Wait>,
    /// It has stopped before a line with a stop mark, which it begins when it continues.
    pub is_at_stop: bool,
}

/// A thread that has not run yet, and the bytes of stack it may use.
pub(crate) struct NewThread {
    pub(crate) thread: Thread,
    pub(crate) stack_size: u32,
}

/// Bytes of a task without its stack. They limit a controller to some thousands of tasks.
pub(crate) const TASK_BYTES: u64 = 64 << 10;

impl Thread {
    /// A thread in no program yet, with the memory that a task takes.
    ///
    /// # Errors
    /// 40 without memory.
    pub(crate) fn new(room: &mut MemoryBudget) -> Result<Self> {
        room.take(TASK_BYTES)?;
        Ok(Self::default())
    }

    /// Bytes of its frames and of its stack, as far as the thread has it.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        bytes_of::<Frame>(self.frames.capacity()) + self.stack.bytes()
    }

    /// Returns the memory of a task that is over.
    pub(crate) fn give_back(&self, room: &mut MemoryBudget) {
        room.give_back(TASK_BYTES + self.bytes());
    }

    /// Enters a program.
    ///
    /// # Errors
    /// 40 without memory.
    #[inline(always)]
    pub(crate) fn push(&mut self, frame: Frame, room: &mut MemoryBudget) -> Result<()> {
        if self.frames.len() == self.frames.capacity() {
            self.grow(room)?;
        }
        self.frames.push(frame);
        Ok(())
    }

    /// Doubles the room for frames.
    #[cold]
    fn grow(&mut self, room: &mut MemoryBudget) -> Result<()> {
        let more = self.frames.len().max(LEAST_FRAMES);
        room.take(bytes_of::<Frame>(more))?;
        self.frames.reserve_exact(more);
        Ok(())
    }

    /// The position; `None` while the interpreter has it.
    #[must_use]
    pub fn place(&self) -> Option<CodePlace> {
        let frame = self.frames.last()?;
        Some(CodePlace { instance: frame.instance.0, program: frame.program, line: self.line })
    }

    /// Arrives at a stop mark: whether it stops there. It continues from the mark at which it has stopped.
    #[cold]
    pub(crate) fn meets_stop(&mut self) -> bool {
        self.is_at_stop = !self.is_at_stop;
        self.is_at_stop
    }

    /// Moves to the beginning of a line and forgets the waits within the previous one.
    pub(crate) fn go_to_line(&mut self, op: u32) {
        (self.next, self.line) = (op, op);
        (self.waiting, self.watched, self.wait, self.is_at_stop) = (None, None, None, false);
    }
}

/// Initial room for frames in a thread.
const LEAST_FRAMES: usize = 4;

/// How often a task runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rate {
    /// An asynchronous task: lines in each turn (5.4).
    Priority(u32),
    /// A synchronous task (5.5, 5.6).
    Period {
        /// Nanoseconds, a multiple of 4 ms.
        period: Time,
        /// When its next cycle begins.
        next: Time,
        /// The variable that is set after an overrun.
        overrun: Place,
        /// Set if it had not finished when its period ended: the next one is left out.
        late: bool,
        /// How often it had not finished when its period ended.
        overruns: u32,
    },
}

/// The state of a task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TaskState {
    /// It runs, or waits.
    Running,
    /// It was halted.
    Halted,
    /// An error has stopped it.
    Failed(Fault),
    /// It was killed; its name is free.
    Killed,
}

/// A program that a task is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Frame {
    /// The application or library.
    pub instance: InstanceId,
    /// The program, by number.
    pub program: u16,
    /// The operation at which its caller resumes when it ends.
    pub back: u32,
    /// The first operation of the line of that call.
    pub back_line: u32,
    /// Where its lanes begin.
    pub base: Base,
}

impl Frame {
    /// The place of a value of the frame whose lanes begin at `lanes`, on the stack of its task.
    #[inline(always)]
    #[must_use]
    pub fn place(&self, lanes: Lanes) -> Place {
        on_frame(&self.base, lanes)
    }
}

/// Where the lanes of a frame begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Base {
    /// Its numbers.
    pub num: u32,
    /// Its texts.
    pub text: u32,
    /// Its links.
    pub link: u32,
    /// Its containers.
    pub part: u32,
    /// Its places.
    pub place: u32,
    /// Its containers by reference.
    pub view: u32,
    /// Bytes of the declared stack that the frames before take.
    pub bytes: u32,
}

impl Base {
    /// The first lanes after the frame of a program that begins here.
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
    /// Whether it can have turns.
    pub(crate) fn can_run(&self) -> bool {
        self.is_running() && !self.is_held
    }

    /// Whether it runs or waits, thus neither is halted nor has failed.
    #[must_use]
    pub fn is_running(&self) -> bool {
        self.state == TaskState::Running
    }

    /// The result of `taskStatus` (5.10).
    #[must_use]
    pub fn status(&self) -> i16 {
        use val3_lang::runtime_errors::TaskState as Number;
        match self.state {
            TaskState::Running => Number::Running.number(),
            TaskState::Halted => Number::Halted.number(),
            TaskState::Killed => Number::Absent.number(),
            TaskState::Failed(Fault(number)) => i16::try_from(number).unwrap_or(i16::MAX),
        }
    }
}
