//! Tasks of a controller, in the order of creation (5.4).

use val3_lang::fault::{Fault, Result};
use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors::{BAD_TASK_NAME, PERIODS, TASK_EXISTS};
use val3_lang::tasks::{MAX_PERIODS, name_fault};
use val3_lang::versions::Version;

use crate::task::NewThread;
use crate::{InstanceId, Rate, Task, TaskState};

/// All tasks that were created and have not ended.
#[derive(Debug, Clone, Default)]
pub(crate) struct Roster {
    /// In the order of creation. The running task is included, without its thread.
    #[allow(clippy::vec_box, reason = "when one of a thousand ends, only pointers move")]
    pub(crate) tasks: Vec<Box<Task>>,
    /// Whether some tasks have ended or were killed, and still have to be removed.
    any_over: bool,
    next: u64,
}

impl Roster {
    pub(crate) fn find(&self, owner: InstanceId, name: &str) -> Option<usize> {
        let alive = |task: &Task| task.state != TaskState::Killed;
        self.tasks.iter().position(|task| task.owner == owner && task.name == name && alive(task))
    }

    pub(crate) fn position(&self, id: TaskNumber) -> Option<usize> {
        let at = self.first_from(id);
        self.tasks.get(at).filter(|task| task.id == id).map(|_| at)
    }

    /// Returns the index of the task, or of the next task created after it.
    ///
    /// If no task in between has ended, the index is the difference between the task's number and the first task's
    /// number.
    pub(crate) fn first_from(&self, id: TaskNumber) -> usize {
        let first = self.tasks.first().map_or(0, |task| task.id.0);
        let guess = usize::try_from(id.0.saturating_sub(first)).unwrap_or(usize::MAX);
        match self.tasks.get(guess) {
            Some(task) if task.id == id => guess,
            _ => self.tasks.partition_point(|task| task.id < id),
        }
    }

    /// Checks that the name is valid and free.
    ///
    /// # Errors
    /// 29 for an invalid name, 31 for a name in use.
    pub(crate) fn check_name(&self, owner: InstanceId, name: &str, version: Version) -> Result<()> {
        if name_fault(name, version).is_some() {
            return Err(Fault(BAD_TASK_NAME));
        }
        if self.find(owner, name).is_some() { Err(Fault(TASK_EXISTS)) } else { Ok(()) }
    }

    /// Checks that one more period is possible.
    pub(crate) fn check_period(&self, period: u64) -> Result<()> {
        let mut periods: Vec<u64> = self.tasks.iter().filter_map(|task| period_of(task)).chain([period]).collect();
        periods.sort_unstable();
        periods.dedup();
        if periods.len() > MAX_PERIODS { Err(Fault(PERIODS)) } else { Ok(()) }
    }

    /// Returns the number for the next task.
    pub(crate) fn new_id(&mut self) -> TaskNumber {
        self.next += 1;
        TaskNumber(self.next)
    }

    /// Adds a task that begins to run.
    pub(crate) fn add(&mut self, id: TaskNumber, name: &str, owner: InstanceId, rate: Rate, new: NewThread) {
        let NewThread { thread, stack_size } = new;
        let (name, state) = (name.to_owned(), TaskState::Running);
        let thread = Box::new(thread);
        self.tasks.push(Box::new(Task { id, name, owner, rate, state, thread, stack_size, left: 0, is_held: false }));
    }

    /// Marks a task as ended: its name is free, and it is removed after the turn.
    pub(crate) fn end(&mut self, at: usize) -> Option<&Task> {
        let task = self.tasks.get_mut(at)?;
        task.state = TaskState::Killed;
        self.any_over = true;
        Some(task)
    }

    /// Removes and returns the ended tasks.
    #[allow(clippy::vec_box, reason = "as they are kept")]
    pub(crate) fn take_over(&mut self) -> Vec<Box<Task>> {
        if !std::mem::take(&mut self.any_over) {
            return Vec::new();
        }
        self.tasks.extract_if(.., |task| task.state == TaskState::Killed).collect()
    }

    /// Whether a task of this application or library exists that was not killed.
    pub(crate) fn has_tasks_of(&self, owner: InstanceId) -> bool {
        self.tasks.iter().any(|task| task.owner == owner && task.state != TaskState::Killed)
    }
}

fn period_of(task: &Task) -> Option<u64> {
    match task.rate {
        Rate::Period { period, .. } => Some(period),
        Rate::Priority(_) => None,
    }
}
