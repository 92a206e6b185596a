//! Images in memory and their tasks.

use std::collections::BTreeSet;
use std::sync::Arc;

use val3_bytecode::{LineMark, Op, Program};
use val3_lang::fault::Fault;
use val3_lang::memory::Memory;
use val3_lang::ports::{TaskChange, TaskNumber, Time};

use crate::data_watch::{BegunLine, DataWatch};
use crate::enter::leave;
use crate::hit_counters::{CounterId, HitCounters};
use crate::roster::Roster;
use crate::task::{Base, NewThread, TASK_BYTES, Thread};
use crate::turn_context::TurnContext;
use crate::{Grant, Host, ProgramId, Rate, Space, StopGuard, Task, TaskState, TurnEnd, TurnReport};

/// The virtual machine: applications and libraries in memory, and their tasks.
#[derive(Debug, Clone, Default)]
pub struct Vm {
    /// Applications and libraries in memory.
    pub space: Space,
    pub(crate) roster: Roster,
    /// Placeholder for the thread of the running task; `None` while a task runs.
    idle: Option<Box<Thread>>,
    /// Stop marks that the last fragment has passed.
    pub(crate) passed_stops: u32,
    /// Values whose change ends a turn.
    watch: Option<Arc<DataWatch>>,
    /// Line that the last turn has begun last.
    last_line: Option<BegunLine>,
}

impl Vm {
    /// Returns the tasks in the order of creation.
    #[must_use]
    pub fn tasks(&self) -> &[Box<Task>] {
        &self.roster.tasks
    }

    /// Starts a program without parameters as a task, under any name (5.2).
    ///
    /// # Errors
    /// 61 if there is no such program, 40 if the memory does not suffice.
    pub fn start(
        &mut self,
        name: &str,
        program: ProgramId,
        priority: u32,
        host: &mut dyn Host,
    ) -> Result<TaskNumber, Fault> {
        self.start_with(name, program, &[], priority, host)
    }

    /// Like [`start`](Self::start), for a program with `num` parameters by value, which receive `numbers`.
    ///
    /// # Errors
    /// 61 if there is no such program, 70 if its parameters differ, 40 if the memory does not suffice, 41 if the stack
    /// does not.
    pub fn start_with(
        &mut self,
        name: &str,
        program: ProgramId,
        numbers: &[f64],
        priority: u32,
        host: &mut dyn Host,
    ) -> Result<TaskNumber, Fault> {
        let id = self.roster.new_id();
        let stack_size = self.space.instance(program.instance).map_or(0, |instance| instance.image.stack_size);
        let mut context = self.turn_context(id, Grant::once(0), 0, 0, stack_size, host);
        let thread = context.new_thread_with(program, numbers)?;
        host.task(id, name, TaskChange::Created, thread.place());
        self.roster.add(id, name, program.instance, Rate::Priority(priority), NewThread { thread, stack_size });
        Ok(id)
    }

    /// Returns the size of data, stacks and frames, which every copy duplicates, in bytes. Code is shared.
    #[must_use]
    pub fn copied_bytes(&self) -> u64 {
        let code = self.space.loaded().map(|(_, instance)| instance.image.code_bytes()).sum();
        let tasks = TASK_BYTES.saturating_mul(self.roster.tasks.len() as u64);
        self.space.memory.stores.room.taken().saturating_sub(code).saturating_sub(tasks)
    }

    /// Calls `look` with the memory while it contains the stack of a task. `None` if there is no such task.
    pub fn with_stack<T>(&mut self, id: TaskNumber, look: impl FnOnce(&mut Memory) -> T) -> Option<T> {
        self.with_stack_in_space(id, |space| look(&mut space.memory))
    }

    /// Like [`with_stack`](Self::with_stack), but with all applications and libraries.
    pub fn with_stack_in_space<T>(&mut self, id: TaskNumber, look: impl FnOnce(&mut Space) -> T) -> Option<T> {
        let task = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at))?;
        std::mem::swap(&mut self.space.memory.stack, &mut task.thread.stack);
        let seen = look(&mut self.space);
        std::mem::swap(&mut self.space.memory.stack, &mut task.thread.stack);
        Some(seen)
    }

    /// Runs a turn of a task from `now` on, with `line_cost` ns per line.
    pub fn turn(
        &mut self,
        id: TaskNumber,
        grant: Grant,
        now: Time,
        line_cost: Time,
        host: &mut dyn Host,
    ) -> TurnReport {
        let nothing =
            TurnReport { end: TurnEnd::Waiting(None), lines: 0, left: 0, reads_clock: false, has_changed_data: false };
        let (watch, is_within_line) = (self.watch.clone(), self.watch.is_some() && self.is_within_line(id));
        let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) else { return nothing };
        let stack_size = task.stack_size;
        let mut thread = std::mem::replace(&mut task.thread, self.idle.take().unwrap_or_default());
        thread.wait = None;
        std::mem::swap(&mut self.space.memory.stack, &mut thread.stack);
        let mut context = self.turn_context(id, grant, now, line_cost, stack_size, host);
        (context.watch, context.has_executed) = (watch, is_within_line);
        context.begun = thread.frames.last().map(|frame| BegunLine { frame: *frame, op: thread.next });
        let end = context.interpret(&mut thread).unwrap_or_else(TurnEnd::Failed);
        if let Some(frame) = thread.frames.last() {
            context.ports.origin(context.origin(context.now(), frame, thread.line));
        }
        let lines = context.granted - context.budget;
        let is_unfinished = matches!(end, TurnEnd::Busy | TurnEnd::Suspended | TurnEnd::AtStop(_));
        let left = if is_unfinished { grant.left(lines) } else { 0 };
        let has_changed_data = context.has_changed_data(&thread);
        let report = TurnReport { end, lines, left, reads_clock: context.reads_clock, has_changed_data };
        self.last_line = context.begun;
        std::mem::swap(&mut self.space.memory.stack, &mut thread.stack);
        self.settle(id, thread, end, host);
        report
    }

    pub(crate) fn turn_context<'v>(
        &'v mut self,
        task: TaskNumber,
        grant: Grant,
        now: Time,
        line_cost: Time,
        stack_size: u32,
        host: &'v mut dyn Host,
    ) -> TurnContext<'v> {
        let budget = grant.budget();
        TurnContext {
            space: &mut self.space,
            roster: &mut self.roster,
            ports: host,
            task,
            stack_size,
            grant,
            granted: budget,
            budget,
            end: now + Time::from(budget) * line_cost,
            line_cost,
            reads_clock: false,
            watch: None,
            has_executed: false,
            begun: None,
            stops_as: task,
        }
    }

    /// Returns the thread to its task after the turn.
    fn settle(&mut self, id: TaskNumber, mut thread: Box<Thread>, end: TurnEnd, host: &mut dyn Host) {
        let Some(at) = self.roster.position(id) else { return };
        let Some(task) = self.roster.tasks.get_mut(at) else { return };
        match end {
            // The error ends the fragment, and not the task.
            TurnEnd::Failed(fault) if !thread.fragments.is_empty() => {
                task.state = TaskState::Failed(fault);
                thread.go_to_line(thread.line);
            }
            TurnEnd::Failed(fault) => {
                task.state = TaskState::Failed(fault);
                let failed = thread.next.checked_sub(1);
                thread.go_to_line(thread.line);
                thread.failed = failed;
                host.task(id, &task.name, TaskChange::Failed(fault), None);
            }
            TurnEnd::Unsupported => task.state = TaskState::Failed(Fault::INTERPRETER),
            _ => {}
        }
        self.idle = Some(std::mem::replace(&mut task.thread, thread));
        if end == TurnEnd::Finished
            && let Some(task) = self.roster.end(at)
        {
            host.task(id, &task.name, TaskChange::Ended, None);
        }
        self.sweep();
    }

    /// Removes the tasks that have ended or were killed, with their frames' data.
    pub(crate) fn sweep(&mut self) {
        let mut had_fragments = false;
        for mut task in self.roster.take_over() {
            had_fragments |= !task.thread.fragments.is_empty();
            std::mem::swap(&mut self.space.memory.stack, &mut task.thread.stack);
            leave(&mut self.space.memory, &Base::default());
            std::mem::swap(&mut self.space.memory.stack, &mut task.thread.stack);
            task.thread.give_back(&mut self.space.memory.stores.room);
        }
        if had_fragments {
            self.release_fragments();
        }
    }

    /// Returns a task's priority or period for writing.
    pub(crate) fn rate_mut(&mut self, id: TaskNumber) -> Option<&mut Rate> {
        let at = self.roster.position(id)?;
        self.roster.tasks.get_mut(at).map(|task| &mut task.rate)
    }

    /// Stores the number of lines that remain in an unfinished turn.
    pub(crate) fn set_left(&mut self, id: TaskNumber, left: u32) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) {
            task.left = left;
        }
    }

    /// Sets the lines of a file before which tasks stop: for each of `rows`, the first line of the program at or after
    /// this row. Replaces all other stops of the file. Images that are loaded later are included.
    pub fn set_stops(&mut self, file: &str, rows: BTreeSet<u32>) {
        self.space.set_stops(file, rows);
        self.forget_removed_stops();
    }

    /// Sets the programs before whose first line tasks stop at each arrival. Replaces all other stops on programs.
    /// Images that are loaded later are included.
    pub fn set_program_stops(&mut self, names: BTreeSet<String>) {
        self.space.set_program_stops(names);
        self.forget_removed_stops();
    }

    /// Replaces all guards of stop marks.
    pub fn set_guards(&mut self, guards: Vec<StopGuard>) {
        self.space.guards = Arc::new(guards);
    }

    /// Starts the hit counters of the guards with the numbers of hits at which tasks do not stop. Without its counter,
    /// each hit of a guard is a stop.
    pub fn count_hits(&mut self, passes: impl IntoIterator<Item = (CounterId, u64)>) {
        self.space.hit_counters = HitCounters::new(passes);
    }

    /// Removes the hit counters, and returns the hits at which tasks have not stopped.
    pub fn take_hits(&mut self) -> impl Iterator<Item = (CounterId, u64)> + use<> {
        std::mem::take(&mut self.space.hit_counters).passed()
    }

    /// Sets the values whose change ends a turn. Evaluations do not watch them.
    pub fn watch_data(&mut self, watch: Option<Arc<DataWatch>>) {
        if watch.is_none() {
            self.roster.tasks.iter_mut().for_each(|task| task.thread.is_at_return = false);
        }
        self.watch = watch;
    }

    /// Returns the line of the last turn: the line that the turn began last while values are watched or if it executed
    /// a single line.
    #[must_use]
    pub fn last_line(&self) -> Option<BegunLine> {
        self.last_line
    }

    /// Returns the number of stop marks that the last [evaluated](Self::evaluate) fragment has passed in called programs
    /// without a stop.
    #[must_use]
    pub fn passed_stops(&self) -> u32 {
        self.passed_stops
    }

    /// Passes the stop mark at the task's next line, because the caller has already handled this stop.
    pub fn pass_stop(&mut self, id: TaskNumber) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) {
            task.thread.is_at_stop = true;
        }
        self.forget_removed_stops();
    }

    /// Stops the task once more where it has stopped. The caller has stopped there for another reason.
    pub fn meet_stop_again(&mut self, id: TaskNumber) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) {
            (task.thread.is_at_stop, task.thread.is_at_end) = (false, false);
        }
    }

    /// Whether a task is after the instructions of the line that it has executed last: before its end, or at a stop
    /// mark of a keyword that closes a block.
    #[must_use]
    pub fn is_after_line(&self, id: TaskNumber) -> bool {
        let task = self.roster.position(id).and_then(|at| self.roster.tasks.get(at));
        task.is_some_and(|task| {
            let Thread { is_at_end, is_at_return, .. } = *task.thread;
            is_at_end || is_at_return || self.mark(&task.thread) == Some(LineMark::StopWithin)
        })
    }

    /// Whether a task has stopped before the return of a program with watched variables.
    #[must_use]
    pub fn is_at_return(&self, id: TaskNumber) -> bool {
        let task = self.roster.position(id).and_then(|at| self.roster.tasks.get(at));
        task.is_some_and(|task| task.thread.is_at_return)
    }

    /// Whether a task has begun a line and not ended it.
    #[must_use]
    pub fn is_within_line(&self, id: TaskNumber) -> bool {
        let task = self.roster.position(id).and_then(|at| self.roster.tasks.get(at));
        task.is_some_and(|task| {
            let Thread { is_at_end, is_at_return, .. } = *task.thread;
            !is_at_end && !is_at_return && self.mark(&task.thread).is_some_and(LineMark::is_within_line)
        })
    }

    /// Sets whether tasks stop before their end, after the last line of their first program.
    pub fn stop_at_ends(&mut self, is_wanted: bool) {
        self.space.stops_at_ends = is_wanted;
    }

    /// Whether a task has stopped before its end.
    #[must_use]
    pub fn is_at_end(&self, id: TaskNumber) -> bool {
        let task = self.roster.position(id).and_then(|at| self.roster.tasks.get(at));
        task.is_some_and(|task| task.thread.is_at_end)
    }

    /// Marks the stop before the end of a task as done, if the next operation of the task is the return of its first
    /// program. The caller has stopped there for another reason, such as a breakpoint.
    pub fn pass_end(&mut self, id: TaskNumber) {
        let Some(at) = self.roster.position(id) else { return };
        let Some(thread) = self.roster.tasks.get(at).map(|task| &task.thread) else { return };
        let next = self.program(thread).and_then(|program| program.code.get(thread.next as usize));
        let is_last = thread.frames.len() == 1 && next.is_some_and(|step| step.op == Op::Return);
        if let Some(task) = self.roster.tasks.get_mut(at).filter(|_| is_last) {
            task.thread.is_at_end = true;
        }
    }

    /// Whether a task is before the first line of a program that it has just entered, and not before a further
    /// iteration of a loop there.
    #[must_use]
    pub fn begins_program(&self, id: TaskNumber) -> bool {
        let task = self.roster.position(id).and_then(|at| self.roster.tasks.get(at));
        task.is_some_and(|task| {
            let (thread, entry) = (&task.thread, self.program(&task.thread).and_then(Program::entry));
            // No line of the program was executed.
            thread.line == 0 && (thread.next == 0 || Some(thread.next) == entry) && thread.waiting.is_none()
        })
    }

    /// Returns the innermost program.
    pub(crate) fn program(&self, thread: &Thread) -> Option<&Program> {
        let frame = thread.frames.last()?;
        self.space.instance(frame.instance)?.program(frame.program)
    }

    /// Returns the mark of the next operation.
    fn mark(&self, thread: &Thread) -> Option<LineMark> {
        self.program(thread)?.code.get(thread.next as usize).map(|step| step.mark)
    }

    /// Discards positions in the code of a program that has changed.
    pub(crate) fn forget_positions(&mut self) {
        (self.watch, self.last_line) = (None, None);
        self.forget_removed_stops();
    }

    /// Resets tasks whose stop mark was removed, so that they stop at the next mark.
    fn forget_removed_stops(&mut self) {
        let tasks = self.roster.tasks.iter().filter(|task| self.mark(&task.thread).is_some_and(LineMark::is_stop));
        let at_stops: BTreeSet<TaskNumber> = tasks.map(|task| task.id).collect();
        for task in &mut self.roster.tasks {
            task.thread.is_at_stop &= at_stops.contains(&task.id);
        }
    }

    /// Holds a task from outside, or releases it. A held task gets no turns, which programs cannot detect.
    pub fn hold(&mut self, id: TaskNumber, is_held: bool) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) {
            task.is_held = is_held;
        }
    }

    /// Sets a task's next line: the line that begins with operation `op` in the innermost program, or the end of the
    /// program. A task that is not running is resumed. Returns `false` if there is no such task or line.
    pub fn continue_at(&mut self, id: TaskNumber, op: u32, host: &mut dyn Host) -> bool {
        let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) else { return false };
        let instance = task.thread.frames.last().and_then(|frame| Some((frame, self.space.instance(frame.instance)?)));
        let program = instance.and_then(|(frame, instance)| instance.image.programs.get(usize::from(frame.program)));
        if task.state == TaskState::Killed || !program.is_some_and(|program| begins_line(program, op)) {
            return false;
        }
        task.thread.go_to_line(op);
        if std::mem::replace(&mut task.state, TaskState::Running) != TaskState::Running {
            host.task(id, &task.name, TaskChange::Resumed, task.thread.place());
        }
        true
    }

    /// Kills a task from outside.
    pub fn kill(&mut self, id: TaskNumber, host: &mut dyn Host) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.end(at)) {
            host.task(id, &task.name, TaskChange::Killed, task.thread.place());
        }
        self.sweep();
    }
}

/// Whether a line of the program begins with operation `op`, or the program ends there.
fn begins_line(program: &Program, op: u32) -> bool {
    let end = program.code.len().checked_sub(1);
    program.lines.iter().any(|line| line.op == op) || end == Some(op as usize)
}
