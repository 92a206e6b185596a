//! Execution of fragments in a stack frame, while the task and the clock do not advance.

use std::sync::Arc;

use val3_bytecode::{Fragment, Program, Storage};
use val3_lang::call::Argument;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Lanes, Memory, Stack};
use val3_lang::ports::{TaskNumber, Time};

use crate::calls::program_of;
use crate::enter::{enter, leave, write};
use crate::instance::FRAGMENT;
use crate::operands::{OperandContext, place_of, view_of};
use crate::task::{Base, Thread};
use crate::turn_context::TurnContext;
use crate::{Frame, Grant, Host, InstanceId, TurnEnd, Vm};

/// Context of a fragment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FragmentContext {
    /// A program on a task's stack; 0 is the innermost one.
    Frame(TaskNumber, usize),
    /// An application or library, outside all tasks.
    Instance(InstanceId),
}

impl FragmentContext {
    /// Returns the task of the context.
    #[must_use]
    pub fn task(self) -> Option<TaskNumber> {
        match self {
            Self::Frame(task, _) => Some(task),
            Self::Instance(_) => None,
        }
    }
}

/// End of a fragment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FragmentEnd<T> {
    /// The expression has this value.
    Value(T),
    /// The statements were executed.
    Done,
    /// A run-time error has ended the fragment.
    Failed(Fault),
    /// The fragment waits for an event that only other tasks or the clock can cause.
    Waiting,
    /// All granted lines were executed.
    Limit,
    /// The host has interrupted statements.
    Interrupted,
    /// The fragment has reached an instruction that the controller does not support.
    Unsupported,
    /// The task, stack frame, application or library does not exist.
    Gone,
}

impl<T> FragmentEnd<T> {
    /// Converts the value.
    pub fn map<U>(self, value: impl FnOnce(T) -> U) -> FragmentEnd<U> {
        match self {
            Self::Value(found) => FragmentEnd::Value(value(found)),
            Self::Done => FragmentEnd::Done,
            Self::Failed(fault) => FragmentEnd::Failed(fault),
            Self::Waiting => FragmentEnd::Waiting,
            Self::Limit => FragmentEnd::Limit,
            Self::Interrupted => FragmentEnd::Interrupted,
            Self::Unsupported => FragmentEnd::Unsupported,
            Self::Gone => FragmentEnd::Gone,
        }
    }
}

impl Vm {
    /// Executes a fragment, and calls `look` with the expression's value while the task's stack is in the memory. The
    /// task is not affected: its position and state remain. Timed waits end immediately.
    ///
    /// Each item of `grants` is a number of lines that the fragment may execute. If it needs another line after the
    /// last grant, it is ended.
    pub fn evaluate<T, H: Host>(
        &mut self,
        fragment: &Fragment,
        context: FragmentContext,
        grants: &mut dyn Iterator<Item = u32>,
        now: Time,
        host: &mut H,
        look: impl FnOnce(&mut Memory, &H, Argument) -> T,
    ) -> FragmentEnd<T> {
        let Some((instance, frame, task)) = self.found(context) else { return FragmentEnd::Gone };
        let variables = frame.and_then(|frame| Some(Arc::clone(&self.space.instance(frame.instance)?.image)));
        let called = frame.zip(variables.as_ref()).and_then(|(frame, image)| {
            image.programs.get(usize::from(frame.program)).map(|program| (frame.base, program))
        });
        let Some(found) = self.space.instance_mut(instance) else { return FragmentEnd::Gone };
        found.fragment = Some(Arc::clone(&fragment.program));
        let stack_size = found.image.stack_size;
        self.exchange_stack(task);
        let base = end_of(&self.space.memory.stack);
        // A fragment is no task, so nothing stops before its end.
        let mut thread = Thread { is_at_end: true, ..Thread::default() };
        // No task runs: an instruction that stops the task of the frame does not end the fragment.
        let grant = Grant::once(grants.next().unwrap_or_default());
        let context = self.turn_context(TaskNumber::default(), grant, now, 0, stack_size, host);
        let mut run = FragmentRun { context, instance, base, fragment, passed_stops: 0 };
        let end = run.enter(&mut thread, called).and_then(|()| run.execute(&mut thread, grants));
        let passed_stops = run.passed_stops;
        let end = end.unwrap_or_else(FragmentEnd::Failed).map(|value| look(&mut self.space.memory, host, value));
        self.passed_stops = passed_stops;
        self.clear(&thread, &base);
        self.exchange_stack(task);
        if let Some(found) = self.space.instance_mut(instance) {
            found.fragment = None;
        }
        self.sweep();
        end
    }

    /// Returns the application or library, the stack frame and the task of a context.
    fn found(&self, context: FragmentContext) -> Option<(InstanceId, Option<Frame>, TaskNumber)> {
        match context {
            FragmentContext::Frame(task, depth) => {
                let found = self.tasks().iter().find(|known| known.id == task)?;
                let frame = *found.thread.frames.iter().rev().nth(depth)?;
                Some((frame.instance, Some(frame), task))
            }
            FragmentContext::Instance(instance) => {
                self.space.instance(instance).filter(|instance| instance.loaded)?;
                Some((instance, None, TaskNumber::default()))
            }
        }
    }

    /// Swaps the stack in the memory with the stack of a task, if the task still exists.
    fn exchange_stack(&mut self, id: TaskNumber) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) {
            std::mem::swap(&mut self.space.memory.stack, &mut task.thread.stack);
        }
    }

    /// Removes the frames of a fragment, which begin at `base`.
    fn clear(&mut self, thread: &Thread, base: &Base) {
        let memory = &mut self.space.memory;
        leave(memory, base);
        let lanes = Lanes { num: base.num, text: base.text, link: base.link, part: base.part };
        let bytes = memory.stack.truncate(lanes, base.place, base.view);
        memory.stores.room.give_back(bytes + thread.bytes());
    }
}

/// A fragment in execution.
struct FragmentRun<'v, 'f> {
    context: TurnContext<'v>,
    instance: InstanceId,
    /// Start of the fragment's stack frame.
    base: Base,
    fragment: &'f Fragment,
    /// Passed stop marks.
    passed_stops: u32,
}

impl FragmentRun<'_, '_> {
    /// Creates the fragment's frame, with references to the variables of the program in `called`, whose frame begins at
    /// the given base.
    fn enter(&mut self, thread: &mut Thread, called: Option<(Base, &Program)>) -> Result<()> {
        let Self { context, instance, base, fragment, .. } = self;
        let memory = &mut context.space.memory;
        let frame = Frame { instance: *instance, program: FRAGMENT, back: 0, back_line: 0, base: *base };
        thread.push(frame, &mut memory.stores.room)?;
        enter(memory, &fragment.program, base, u32::MAX)?;
        let Some((of_frame, program)) = called else { return Ok(()) };
        let mut pairs = program.variables.iter().zip(&fragment.program.variables);
        pairs.try_for_each(|(variable, reference)| refer(memory, &of_frame, variable.storage, base, reference.storage))
    }

    fn execute(&mut self, thread: &mut Thread, grants: &mut dyn Iterator<Item = u32>) -> Result<FragmentEnd<Argument>> {
        loop {
            match self.context.interpret(thread)? {
                TurnEnd::AtStop(_) if self.is_at_end(thread) => {
                    return self.value().map(FragmentEnd::Value);
                }
                TurnEnd::Waiting(Some(wake)) | TurnEnd::Pausing(wake) => {
                    // Only the fragment's own clock advances.
                    self.context.end = self.context.end.max(wake);
                    thread.wait = None;
                }
                TurnEnd::Waiting(None) => return Ok(FragmentEnd::Waiting),
                TurnEnd::Finished | TurnEnd::Halted => return Ok(FragmentEnd::Done),
                // An interrupt does not end an expression, because its number of lines is limited.
                TurnEnd::Suspended if self.fragment.value.is_some() => {}
                TurnEnd::Suspended => return Ok(FragmentEnd::Interrupted),
                TurnEnd::Failed(fault) => return Ok(FragmentEnd::Failed(fault)),
                TurnEnd::Unsupported => return Ok(FragmentEnd::Unsupported),
                TurnEnd::Busy => match grants.next() {
                    Some(lines) => self.context.extend(lines),
                    None => return Ok(FragmentEnd::Limit),
                },
                // Breakpoints in called programs have no effect.
                TurnEnd::AtStop(_) => self.passed_stops = self.passed_stops.saturating_add(1),
            }
        }
    }

    fn is_at_end(&self, thread: &Thread) -> bool {
        thread.frames.len() == 1 && thread.next == self.fragment.end()
    }

    /// Returns the value of the expression.
    fn value(&self) -> Result<Argument> {
        let instance = self.context.instance(self.instance)?;
        let frame = Frame { instance: self.instance, program: FRAGMENT, back: 0, back_line: 0, base: self.base };
        let scope = OperandContext { instance, program: program_of(&frame, instance)?, base: self.base };
        let value = self.fragment.value.as_ref().ok_or(Fault::INTERPRETER)?;
        scope.argument(&self.context.space.memory, &value.site)
    }
}

/// Makes a variable of the frame at `base` refer to a variable in the other frame.
fn refer(memory: &mut Memory, other: &Base, found: Storage, base: &Base, reference: Storage) -> Result<()> {
    match reference {
        Storage::Place(number) => {
            let place = place_of(memory, other, found).ok_or(Fault::INTERPRETER)?;
            write(&mut memory.stack.places, base.place + u32::from(number), place)
        }
        Storage::View(number) => {
            let view = view_of(memory, other, found).ok_or(Fault::INTERPRETER)?;
            write(&mut memory.stack.views, base.view + u32::from(number), view)
        }
        Storage::Value(_) | Storage::Part(_) => Err(Fault::INTERPRETER),
    }
}

/// Returns the first free lanes of a stack.
fn end_of(stack: &Stack) -> Base {
    let lanes = stack.ends();
    let count = |len: usize| u32::try_from(len).unwrap_or(u32::MAX);
    let (place, view) = (count(stack.places.len()), count(stack.views.len()));
    Base { num: lanes.num, text: lanes.text, link: lanes.link, part: lanes.part, place, view, bytes: 0 }
}
