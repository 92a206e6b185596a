//! Fragments on the stack of a task, above the stack frames at which the task has stopped.

use val3_bytecode::Op;
use val3_lang::call::{Wait, Waiting};
use val3_lang::memory::Lanes;
use val3_lang::ports::{TaskNumber, Time};

use crate::enter::leave;
use crate::task::Thread;
use crate::{Frame, TaskState, Vm};

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
}

impl Position {
    pub(crate) fn of(thread: &Thread) -> Self {
        let Thread { next, line, waiting, watched, wait, is_at_stop, is_at_end, is_at_return, .. } = *thread;
        Self { next, line, waiting, watched, wait, is_at_stop, is_at_end, is_at_return }
    }

    pub(crate) fn apply(self, thread: &mut Thread) {
        let Self { next, line, waiting, watched, wait, is_at_stop, is_at_end, is_at_return } = self;
        (thread.next, thread.line) = (next, line);
        (thread.waiting, thread.watched, thread.wait) = (waiting, watched, wait);
        (thread.is_at_stop, thread.is_at_end, thread.is_at_return) = (is_at_stop, is_at_end, is_at_return);
    }
}

impl Vm {
    /// Number of fragments on the stack of a task, among its `depth` outermost stack frames.
    #[must_use]
    pub fn fragments_below(&self, id: TaskNumber, depth: usize) -> usize {
        let thread = self.thread(id);
        thread.map_or(0, |thread| thread.fragments.iter().filter(|fragment| fragment.depth < depth).count())
    }

    /// Whether a fragment is on the stack of a task.
    #[must_use]
    pub fn has_fragment(&self, id: TaskNumber) -> bool {
        self.thread(id).is_some_and(|thread| !thread.fragments.is_empty())
    }

    /// Whether a stack frame is the frame of a fragment.
    #[must_use]
    pub fn is_fragment(&self, frame: &Frame) -> bool {
        self.space.instance(frame.instance).is_some_and(|instance| instance.is_fragment(frame.program))
    }

    /// Whether a task has executed the innermost fragment on its stack to its end.
    #[must_use]
    pub fn is_at_fragment_end(&self, id: TaskNumber) -> bool {
        self.thread(id).is_some_and(|thread| {
            let is_innermost = thread.fragments.last().is_some_and(|last| thread.frames.len() == last.depth + 1);
            let next = self.program(thread).and_then(|program| program.code.get(thread.next as usize));
            is_innermost && next.is_some_and(|step| step.op == Op::Return)
        })
    }

    /// Removes the innermost fragment of a task from its stack, with the programs that it has called. The task is then
    /// in the position and state that it had before. Returns `false` if there is no fragment.
    pub fn end_fragment(&mut self, id: TaskNumber) -> bool {
        let Some(at) = self.roster.position(id) else { return false };
        let Some(task) = self.roster.tasks.get_mut(at) else { return false };
        let Some(fragment) = task.thread.fragments.pop() else { return false };
        let first = task.thread.frames.get(fragment.depth).copied();
        task.thread.frames.truncate(fragment.depth);
        fragment.position.apply(&mut task.thread);
        task.state = fragment.state;
        if let Some(Frame { base, .. }) = first {
            self.exchange_stack(id);
            let memory = &mut self.space.memory;
            leave(memory, &base);
            let lanes = Lanes { num: base.num, text: base.text, link: base.link, part: base.part };
            let bytes = memory.stack.truncate(lanes, base.place, base.view);
            memory.stores.room.give_back(bytes);
            self.exchange_stack(id);
        }
        self.release_fragments();
        true
    }

    /// Removes the code of fragments that are on no stack any more.
    pub(crate) fn release_fragments(&mut self) {
        if self.space.instances.iter().all(|instance| instance.fragments.is_empty()) {
            return;
        }
        let frames = self.roster.tasks.iter().flat_map(|task| &task.thread.frames);
        let used: Vec<_> = frames.map(|frame| (frame.instance, frame.program)).collect();
        self.space.retain_fragments(|id, number| used.contains(&(id, number)));
    }

    fn thread(&self, id: TaskNumber) -> Option<&Thread> {
        let task = self.roster.position(id).and_then(|at| self.roster.tasks.get(at))?;
        Some(&task.thread)
    }
}
