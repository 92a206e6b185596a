//! Execution of fragments in a stack frame, while the task and the clock do not advance.

use std::sync::Arc;

use val3_bytecode::{Fragment, FragmentValue, Op, Program, Storage};
use val3_lang::call::Argument;
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Lanes, Memory, Stack, bytes_of};
use val3_lang::ports::{TaskNumber, Time};

use crate::calls::program_of;
use crate::enter::{enter, leave, write};
use crate::operands::{OperandContext, place_of, view_of};
use crate::task::{Base, Position, StackedFragment, Thread};
use crate::turn_context::TurnContext;
use crate::{Frame, Grant, Host, InstanceId, TaskState, TurnEnd, Vm};

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
    /// The fragment is at a stop mark in a program that it has called: see [`Vm::execute`].
    AtStop,
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
            Self::AtStop => FragmentEnd::AtStop,
            Self::Gone => FragmentEnd::Gone,
        }
    }
}

impl Vm {
    /// Executes a fragment, and calls `look` with the expression's value while the task's stack is in the memory. The
    /// task is not affected: its position and state remain. Timed waits end immediately. Stop marks in called programs
    /// have no effect.
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
        let Some(mut started) = self.begin(fragment, context, now) else { return FragmentEnd::Gone };
        self.exchange_stack(started.task);
        let (end, passed_stops) = self.run(&mut started, Some(fragment), grants, host, false);
        let end = end.map(|value| look(&mut self.space.memory, host, value));
        self.passed_stops = passed_stops;
        self.clear(&started.thread, &started.base);
        self.exchange_stack(started.task);
        self.release(&started);
        self.sweep();
        end
    }

    /// Executes statements like [`evaluate`](Self::evaluate), in a stack frame of a task. `depth` 0 is the innermost
    /// one. If they are not executed to their end, they stay on the stack of the task, which continues them in its next
    /// turns. [`FragmentEnd::AtStop`] is the stop at a mark in a called program: [`resume`](Self::resume) continues.
    /// [`end_fragment`](Self::end_fragment) removes them.
    pub fn execute<H: Host>(
        &mut self,
        fragment: &Fragment,
        task: TaskNumber,
        depth: usize,
        grants: &mut dyn Iterator<Item = u32>,
        now: Time,
        host: &mut H,
    ) -> FragmentEnd<()> {
        let context = FragmentContext::Frame(task, depth);
        let Some(started) = self.begin(fragment, context, now) else { return FragmentEnd::Gone };
        self.run_statements(started, Some(fragment), grants, host)
    }

    /// Continues the innermost fragment on the stack of a task like [`execute`](Self::execute).
    pub fn resume<H: Host>(
        &mut self,
        task: TaskNumber,
        grants: &mut dyn Iterator<Item = u32>,
        now: Time,
        host: &mut H,
    ) -> FragmentEnd<()> {
        let Some(started) = self.unstack(task, now) else { return FragmentEnd::Gone };
        self.run_statements(started, None, grants, host)
    }

    fn run_statements<H: Host>(
        &mut self,
        mut started: StartedFragment,
        fragment: Option<&Fragment>,
        grants: &mut dyn Iterator<Item = u32>,
        host: &mut H,
    ) -> FragmentEnd<()> {
        let task = started.task;
        self.exchange_stack(task);
        let (end, _) = self.run(&mut started, fragment, grants, host, true);
        let end = end.map(drop);
        let is_over = matches!(end, FragmentEnd::Value(()) | FragmentEnd::Done) || started.thread.frames.is_empty();
        if is_over {
            self.clear(&started.thread, &started.base);
            self.release(&started);
        }
        self.exchange_stack(task);
        if !is_over && let Err(fault) = self.stack(started) {
            return FragmentEnd::Failed(fault);
        }
        self.sweep();
        end
    }

    /// Adds the code of a fragment to its application or library. Its frame begins at the end of the task's stack.
    fn begin(&mut self, fragment: &Fragment, context: FragmentContext, now: Time) -> Option<StartedFragment> {
        let (instance, frame, task) = self.found(context)?;
        let number = self.space.instance_mut(instance)?.add_fragment(&fragment.program)?;
        // A fragment is no task, so nothing stops before its end.
        let thread = Thread { is_at_end: true, ..Thread::default() };
        self.exchange_stack(task);
        let base = end_of(&self.space.memory.stack);
        self.exchange_stack(task);
        Some(StartedFragment { task, thread, instance, number, base, called: frame, clock: now, left: 0 })
    }

    /// Executes a fragment, while the stack of its task is in the memory. Returns its end, and the number of passed stop
    /// marks. `entered` is the fragment if it has no frame yet.
    fn run<H: Host>(
        &mut self,
        started: &mut StartedFragment,
        entered: Option<&Fragment>,
        grants: &mut dyn Iterator<Item = u32>,
        host: &mut H,
        stops: bool,
    ) -> (FragmentEnd<Argument>, u32) {
        let StartedFragment { task, thread, instance, number, base, called, clock, left } = started;
        let Some(found) = self.space.instance(*instance) else { return (FragmentEnd::Gone, 0) };
        let stack_size = found.image.stack_size;
        let image = called.and_then(|frame| Some(Arc::clone(&self.space.instance(frame.instance)?.image)));
        let called = called.zip(image.as_ref()).and_then(|(frame, image)| {
            image.programs.get(usize::from(frame.program)).map(|program| (frame.base, program))
        });
        // No task runs: an instruction that stops the task of the frame does not end the fragment.
        let grant = Grant::once(if *left > 0 { *left } else { grants.next().unwrap_or_default() });
        let mut context = self.turn_context(TaskNumber::default(), grant, *clock, 0, stack_size, host);
        context.stops_as = *task;
        let value = entered.and_then(|fragment| fragment.value.as_ref());
        let (instance, number, base) = (*instance, *number, *base);
        let mut run = FragmentRun { context, instance, number, base, value, stops, passed_stops: 0 };
        let entry = entered.map_or(Ok(()), |fragment| run.enter(thread, &fragment.program, called));
        let end = entry.and_then(|()| run.execute(thread, grants)).unwrap_or_else(FragmentEnd::Failed);
        (*clock, *left) = (run.context.end, run.context.budget);
        (end, run.passed_stops)
    }

    /// Moves the frames of a fragment to the stack of its task, which continues it in its next turns.
    ///
    /// # Errors
    /// 40 if the memory does not suffice. The fragment is then removed.
    fn stack(&mut self, started: StartedFragment) -> Result<()> {
        let StartedFragment { task: id, thread, clock, left, .. } = started;
        let is_within_line = self.is_within_line(id);
        let room = &mut self.space.memory.stores.room;
        room.give_back(bytes_of::<Frame>(thread.frames.capacity()));
        let position = self.roster.position(id);
        let Some(task) = position.and_then(|at| self.roster.tasks.get_mut(at)) else {
            self.release_fragments();
            return Ok(());
        };
        let own = &mut task.thread;
        let (depth, position) = (own.frames.len(), Position::of(own));
        own.fragments.push(StackedFragment { depth, clock, left, position, state: task.state });
        let (back, back_line) = (own.next, if is_within_line { own.line } else { own.next });
        let mut frames = thread.frames.iter().copied();
        let first = frames.next().map(|frame| Frame { back, back_line, ..frame });
        let pushed = first.into_iter().chain(frames).try_for_each(|frame| own.push(frame, room));
        Position::of(&thread).apply(own);
        (own.is_at_end, own.wait) = (false, None);
        task.state = TaskState::Running;
        if pushed.is_err() {
            self.end_fragment(id);
        }
        pushed
    }

    /// Takes the frames of the innermost fragment from the stack of a task.
    fn unstack(&mut self, id: TaskNumber, now: Time) -> Option<StartedFragment> {
        let at = self.roster.position(id)?;
        let task = self.roster.tasks.get_mut(at)?;
        let StackedFragment { depth, clock, left, position, state } = task.thread.fragments.pop()?;
        let mut thread = Thread::default();
        Position::of(&task.thread).apply(&mut thread);
        thread.is_at_end = true;
        for frame in task.thread.frames.drain(depth..) {
            // The fragment has had these frames before.
            thread.frames.push(frame);
        }
        let room = &mut self.space.memory.stores.room;
        room.count(bytes_of::<Frame>(thread.frames.capacity()));
        position.apply(&mut task.thread);
        task.state = state;
        let Frame { instance, program: number, base, .. } = *thread.frames.first()?;
        let clock = clock.max(now);
        Some(StartedFragment { task: id, thread, instance, number, base, called: None, clock, left })
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
    pub(crate) fn exchange_stack(&mut self, id: TaskNumber) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) {
            std::mem::swap(&mut self.space.memory.stack, &mut task.thread.stack);
        }
    }

    /// Removes the code of a fragment.
    fn release(&mut self, started: &StartedFragment) {
        if let Some(instance) = self.space.instance_mut(started.instance) {
            instance.retain_fragments(|number| number != started.number);
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

/// A fragment with its own thread, which is not on the stack of a task.
struct StartedFragment {
    /// Task of the stack; the default without a stack.
    task: TaskNumber,
    thread: Thread,
    instance: InstanceId,
    /// Program number.
    number: u16,
    /// Start of the fragment's stack frame.
    base: Base,
    /// Stack frame whose variables the fragment uses.
    called: Option<Frame>,
    /// Clock of the fragment, in ns.
    clock: Time,
    /// Granted lines that were not executed.
    left: u32,
}

/// A fragment in execution.
struct FragmentRun<'v, 'f> {
    context: TurnContext<'v>,
    instance: InstanceId,
    /// Program number.
    number: u16,
    /// Start of the fragment's stack frame.
    base: Base,
    /// Value of an expression.
    value: Option<&'f FragmentValue>,
    /// Whether stop marks in called programs end the execution.
    stops: bool,
    /// Passed stop marks.
    passed_stops: u32,
}

impl FragmentRun<'_, '_> {
    /// Creates the fragment's frame, with references to the variables of the program in `called`, whose frame begins at
    /// the given base.
    fn enter(&mut self, thread: &mut Thread, code: &Program, called: Option<(Base, &Program)>) -> Result<()> {
        let Self { context, instance, number, base, .. } = self;
        let memory = &mut context.space.memory;
        let frame = Frame { instance: *instance, program: *number, back: 0, back_line: 0, base: *base };
        thread.push(frame, &mut memory.stores.room)?;
        enter(memory, code, base, u32::MAX)?;
        let Some((of_frame, program)) = called else { return Ok(()) };
        let mut pairs = program.variables.iter().zip(&code.variables);
        pairs.try_for_each(|(variable, reference)| refer(memory, &of_frame, variable.storage, base, reference.storage))
    }

    fn execute(&mut self, thread: &mut Thread, grants: &mut dyn Iterator<Item = u32>) -> Result<FragmentEnd<Argument>> {
        loop {
            match self.context.interpret(thread)? {
                TurnEnd::AtStop(_) if self.is_at_end(thread) => {
                    return self.value.map_or(Ok(FragmentEnd::Done), |value| self.read(value).map(FragmentEnd::Value));
                }
                TurnEnd::Waiting(Some(wake)) | TurnEnd::Pausing(wake) => {
                    // Only the fragment's own clock advances.
                    self.context.end = self.context.end.max(wake);
                    thread.wait = None;
                }
                TurnEnd::Waiting(None) => return Ok(FragmentEnd::Waiting),
                TurnEnd::Finished | TurnEnd::Halted => return Ok(FragmentEnd::Done),
                // An interrupt does not end an expression, because its number of lines is limited.
                TurnEnd::Suspended if self.value.is_some() => {}
                TurnEnd::Suspended => return Ok(FragmentEnd::Interrupted),
                TurnEnd::Failed(fault) => return Ok(FragmentEnd::Failed(fault)),
                TurnEnd::Unsupported => return Ok(FragmentEnd::Unsupported),
                TurnEnd::Busy => match grants.next() {
                    Some(lines) => self.context.extend(lines),
                    None => return Ok(FragmentEnd::Limit),
                },
                TurnEnd::AtStop(_) if self.stops => return Ok(FragmentEnd::AtStop),
                TurnEnd::AtStop(_) => self.passed_stops = self.passed_stops.saturating_add(1),
            }
        }
    }

    fn is_at_end(&self, thread: &Thread) -> bool {
        let program = self.context.space.instance(self.instance).and_then(|instance| instance.program(self.number));
        let next = program.and_then(|program| program.code.get(thread.next as usize));
        thread.frames.len() == 1 && next.is_some_and(|step| step.op == Op::Return)
    }

    /// Returns the value of the expression.
    fn read(&self, value: &FragmentValue) -> Result<Argument> {
        let instance = self.context.instance(self.instance)?;
        let frame = Frame { instance: self.instance, program: self.number, back: 0, back_line: 0, base: self.base };
        let scope = OperandContext { instance, program: program_of(&frame, instance)?, base: self.base };
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
