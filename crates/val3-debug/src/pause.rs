//! Pauses of the entire run, and of single tasks while the other tasks and the arm continue.

use val3_lang::ports::TaskNumber;

use crate::debugger::{Debugger, Stop};

/// Requested pause of the entire run.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pause {
    /// Task that the stop should name.
    task: Option<TaskNumber>,
}

impl Debugger {
    /// Requests a stop with [`Stop::Pause`] before the next line: the next call of [`Debugger::advance`] stops
    /// immediately unless a task is within a line, which ends first. A waiting task is shown at its waiting line. The
    /// arm stops within its motion, because no time passes.
    ///
    /// The stop names `task` if it exists, otherwise the task that executed the last line, otherwise the first task.
    pub fn pause(&mut self, task: Option<TaskNumber>) {
        self.pause = Some(Pause { task });
    }

    /// Returns the stop of a requested pause, unless a task is within a line.
    pub(crate) fn take_pause(&mut self) -> Option<Stop> {
        let pause = self.pause?;
        if self.travel.is_none() && self.is_within_line() {
            return None;
        }
        self.pause = None;
        let tasks = self.controller.vm.tasks();
        let known = |id: &TaskNumber| tasks.iter().any(|task| task.id == *id);
        let running = tasks.iter().find(|task| task.is_running()).or(tasks.first()).map(|task| task.id);
        Some(Stop::Pause { task: pause.task.filter(known).or(self.last.filter(known)).or(running) })
    }

    /// Whether a task is within a line that does not wait.
    fn is_within_line(&self) -> bool {
        let vm = &self.controller.vm;
        let mut running = vm.tasks().iter().filter(|task| task.is_running() && !task.is_held);
        running.any(|task| task.thread.wait.is_none() && task.thread.waiting.is_none() && vm.is_within_line(task.id))
    }

    /// Pauses one task, or resumes it. The other tasks, the arm and the clock continue, and programs cannot detect the
    /// pause: `taskStatus` returns the status of a running task. Discards the recorded future.
    ///
    /// A waiting task is paused within its line; a `delay` continues to elapse.
    pub fn pause_task(&mut self, task: TaskNumber, is_paused: bool) {
        if self.is_task_paused(task) != is_paused {
            self.controller.vm.hold(task, is_paused);
            self.begin_new_future();
        }
    }

    /// Pauses all tasks except one, which continues: for a step or run of a single task. Tasks that are created later
    /// run.
    pub fn pause_others(&mut self, task: TaskNumber) {
        let tasks: Vec<TaskNumber> = self.controller.vm.tasks().iter().map(|known| known.id).collect();
        tasks.into_iter().for_each(|known| self.pause_task(known, known != task));
    }

    /// Resumes all individually paused tasks.
    pub fn resume_tasks(&mut self) {
        for task in self.paused_tasks() {
            self.pause_task(task, false);
        }
    }

    /// Whether a task is individually paused.
    #[must_use]
    pub fn is_task_paused(&self, task: TaskNumber) -> bool {
        self.controller.vm.tasks().iter().any(|known| known.id == task && known.is_held)
    }

    /// Returns the individually paused tasks; after going back, the tasks that were paused at that moment.
    #[must_use]
    pub fn paused_tasks(&self) -> Vec<TaskNumber> {
        self.controller.vm.tasks().iter().filter(|task| task.is_held).map(|task| task.id).collect()
    }
}
