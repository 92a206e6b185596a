//! Pauses: of the whole run, or of single tasks while the others and the arm continue.

use val3_lang::ports::TaskNumber;

use crate::debugger::{Debugger, Stop};

/// A pause of the whole run that was asked for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pause {
    /// The task that the stop is to name.
    task: Option<TaskNumber>,
}

impl Debugger {
    /// Lets the run stop with [`Stop::Pause`] before the next line: the next call of [`Debugger::advance`] stops at once
    /// unless a line is executed just now, which ends first. A task that waits is in the line that waits. The arm
    /// stops in the middle of its motion, because no time passes.
    ///
    /// The stop names `task` if it exists. Otherwise it names the task that has executed a line last, or the first one.
    pub fn pause(&mut self, task: Option<TaskNumber>) {
        self.pause = Some(Pause { task });
    }

    /// The stop of a pause, unless a task is in the middle of a line.
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

    /// Whether a task is in the middle of a line that does not wait.
    fn is_within_line(&self) -> bool {
        let vm = &self.controller.vm;
        let is_busy = |id: TaskNumber| vm.is_within_line(id);
        let mut running = vm.tasks().iter().filter(|task| task.is_running() && !task.is_held);
        running.any(|task| task.thread.wait.is_none() && task.thread.waiting.is_none() && is_busy(task.id))
    }

    /// Pauses one task, or lets it continue. The other tasks and the arm run on as on the controller, time passes, and no
    /// program notices: `taskStatus` of the task is that of a running one. A new future begins here.
    ///
    /// A task that waits is paused in its line: the time of a `delay` passes meanwhile.
    pub fn pause_task(&mut self, task: TaskNumber, is_paused: bool) {
        if self.is_task_paused(task) != is_paused {
            self.controller.vm.hold(task, is_paused);
            self.begin_new_future();
        }
    }

    /// Pauses all tasks but one, which continues: a step or a run of a single task. Tasks that are created later run.
    pub fn pause_others(&mut self, task: TaskNumber) {
        let tasks: Vec<TaskNumber> = self.controller.vm.tasks().iter().map(|known| known.id).collect();
        tasks.into_iter().for_each(|known| self.pause_task(known, known != task));
    }

    /// Lets all tasks continue that were paused one by one.
    pub fn resume_tasks(&mut self) {
        for task in self.paused_tasks() {
            self.pause_task(task, false);
        }
    }

    /// Whether a task was paused while others run.
    #[must_use]
    pub fn is_task_paused(&self, task: TaskNumber) -> bool {
        self.controller.vm.tasks().iter().any(|known| known.id == task && known.is_held)
    }

    /// The tasks that were paused one by one. After going back, those that were paused at that moment.
    #[must_use]
    pub fn paused_tasks(&self) -> Vec<TaskNumber> {
        self.controller.vm.tasks().iter().filter(|task| task.is_held).map(|task| task.id).collect()
    }
}
