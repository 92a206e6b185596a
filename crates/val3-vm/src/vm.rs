//! Images in memory and the tasks on them.

use val3_lang::fault::Fault;
use val3_lang::ports::{TaskChange, TaskNumber, Time};

use crate::enter::leave;
use crate::machine::Machine;
use crate::roster::Roster;
use crate::task::{Base, NewThread, Thread};
use crate::{Grant, Host, InstanceId, Rate, Space, Stop, Task, TaskState, Turn};

/// Applications and libraries in memory, and the tasks that run.
#[derive(Debug, Clone, Default)]
pub struct Vm {
    /// What is in memory.
    pub space: Space,
    pub(crate) roster: Roster,
    /// What the task that runs has instead of its thread, while none does.
    idle: Option<Box<Thread>>,
}

impl Vm {
    /// The tasks in the order of their creation.
    #[must_use]
    pub fn tasks(&self) -> &[Box<Task>] {
        &self.roster.tasks
    }

    /// Starts a program without parameters as a task, under any name (5.2).
    ///
    /// # Errors
    /// 61 if there is no such program, 40 without memory.
    pub fn start(
        &mut self,
        name: &str,
        (instance, program): (InstanceId, u16),
        priority: u32,
        host: &mut dyn Host,
    ) -> Result<TaskNumber, Fault> {
        let id = self.roster.new_id();
        let stack_size = self.space.instance(instance).map_or(0, |instance| instance.image.stack_size);
        let mut machine = self.machine(id, Grant::once(0), (0, 0), stack_size, host);
        let thread = machine.new_thread((instance, program), &[])?;
        host.task(id, name, TaskChange::Created, thread.place());
        self.roster.add(id, name, instance, Rate::Priority(priority), NewThread { thread, stack_size });
        Ok(id)
    }

    /// Gives a task its turn: lines of `line_cost` nanoseconds each, from `now` on.
    pub fn turn(&mut self, id: TaskNumber, grant: Grant, (now, line_cost): (Time, Time), host: &mut dyn Host) -> Turn {
        let nothing = Turn { stop: Stop::Waits, lines: 0, left: 0, reads_clock: false };
        let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) else { return nothing };
        let stack_size = task.stack_size;
        let mut thread = std::mem::replace(&mut task.thread, self.idle.take().unwrap_or_default());
        thread.wait = None;
        std::mem::swap(&mut self.space.memory.stack, &mut thread.stack);
        let mut machine = self.machine(id, grant, (now, line_cost), stack_size, host);
        let stop = machine.interpret(&mut thread).unwrap_or_else(Stop::Failed);
        if let Some(frame) = thread.frames.last() {
            machine.ports.origin(machine.origin(machine.now(), frame, thread.line));
        }
        let lines = machine.granted - machine.budget;
        let left = if stop == Stop::Budget { grant.left(lines) } else { 0 };
        let turn = Turn { stop, lines, left, reads_clock: machine.reads_clock };
        std::mem::swap(&mut self.space.memory.stack, &mut thread.stack);
        self.settle(id, thread, stop, host);
        turn
    }

    fn machine<'v>(
        &'v mut self,
        task: TaskNumber,
        grant: Grant,
        (now, line_cost): (Time, Time),
        stack_size: u32,
        host: &'v mut dyn Host,
    ) -> Machine<'v> {
        let budget = grant.budget();
        Machine {
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
        }
    }

    /// Puts the thread of a task back after its turn.
    fn settle(&mut self, id: TaskNumber, mut thread: Box<Thread>, stop: Stop, host: &mut dyn Host) {
        let Some(at) = self.roster.position(id) else { return };
        let Some(task) = self.roster.tasks.get_mut(at) else { return };
        match stop {
            Stop::Failed(fault) => {
                task.state = TaskState::Failed(fault);
                thread.go_to_line(thread.line);
                host.task(id, &task.name, TaskChange::Failed(fault), None);
            }
            Stop::Lacking => task.state = TaskState::Failed(Fault::INTERPRETER),
            Stop::Ended | Stop::Budget | Stop::Waits | Stop::Pauses(_) | Stop::Halted => {}
        }
        self.idle = Some(std::mem::replace(&mut task.thread, thread));
        if stop == Stop::Ended
            && let Some(task) = self.roster.end(at)
        {
            host.task(id, &task.name, TaskChange::Ended, None);
        }
        self.sweep();
    }

    /// Removes the tasks that have ended or were killed, with the data of their frames.
    fn sweep(&mut self) {
        for mut task in self.roster.take_over() {
            std::mem::swap(&mut self.space.memory.stack, &mut task.thread.stack);
            leave(&mut self.space.memory, &Base::default());
            std::mem::swap(&mut self.space.memory.stack, &mut task.thread.stack);
            task.thread.give_back(&mut self.space.memory.stores.room);
        }
    }

    /// When a task runs.
    pub(crate) fn rate_mut(&mut self, id: TaskNumber) -> Option<&mut Rate> {
        let at = self.roster.position(id)?;
        self.roster.tasks.get_mut(at).map(|task| &mut task.rate)
    }

    /// The lines that a task has left of a turn that the end of a cycle has interrupted.
    pub(crate) fn set_left(&mut self, id: TaskNumber, left: u32) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.tasks.get_mut(at)) {
            task.left = left;
        }
    }

    /// Kills a task from outside.
    pub fn kill(&mut self, id: TaskNumber, host: &mut dyn Host) {
        if let Some(task) = self.roster.position(id).and_then(|at| self.roster.end(at)) {
            host.task(id, &task.name, TaskChange::Killed, task.thread.place());
        }
        self.sweep();
    }
}
