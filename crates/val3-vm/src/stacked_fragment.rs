//! Fragments on the stack of a task, above the stack frames at which the task has stopped.

use val3_bytecode::Op;
use val3_lang::memory::Lanes;
use val3_lang::ports::TaskNumber;

use crate::enter::leave;
use crate::task::Thread;
use crate::{Frame, Vm};

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
