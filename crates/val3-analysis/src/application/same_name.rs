//! Tasks with the same name that cannot run one after another.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;

use super::{Application, START, STOP, StaticTask, Summary, TaskStart};

impl Application {
    /// Fills `certain`: follows the unconditional calls and tasks of `start`.
    pub(super) fn find_certain(&mut self, summaries: &FxHashMap<&SmolStr, &Summary>) {
        let mut open = vec![SmolStr::new_static(START)];
        while let Some(program) = open.pop() {
            let Some(summary) = summaries.get(&program).filter(|_| !self.certain.contains(&program)) else { continue };
            open.extend(summary.certain_calls.iter().cloned());
            let tasks = summary.tasks.iter().filter(|start| start.certain && start.program.library.is_none());
            open.extend(tasks.map(|start| start.program.program.clone()));
            self.certain.insert(program);
        }
    }

    /// Fills `managed_tasks`. Programs that run only at the end of the application are ignored, because they kill its
    /// tasks too late.
    pub(super) fn find_managed_tasks(&mut self, summaries: &FxHashMap<&SmolStr, &Summary>) {
        let managing = summaries.iter().filter(|(name, _)| !self.runs_at_end_alone(name));
        let names: FxHashSet<SmolStr> =
            managing.flat_map(|(_, summary)| summary.managed_tasks.iter().cloned()).collect();
        self.managed_tasks = names;
    }

    fn runs_at_end_alone(&self, program: &str) -> bool {
        let mut tasks = self.tasks_of(program).peekable();
        tasks.peek().is_some() && tasks.all(|task| task.created_by.is_none() && task.start.program.program == STOP)
    }

    /// Returns another program that always creates a task with the name that `start` has in `program`, if both tasks
    /// run forever and no program kills them or reads their status. Only one of two such programs finds the other.
    pub fn creator_of_same(&self, program: &str, start: &TaskStart) -> Option<&SmolStr> {
        let name = start.name.as_ref().filter(|name| self.sound && !self.is_managed(name) && self.is_endless(start))?;
        let order = |program: &str| (program != START, SmolStr::from(program));
        let runs = self.run_by.contains_key(program) && !self.runs_at_end_alone(program);
        let is_certain = start.certain && self.certain.contains(program);
        let created = self.tasks.iter().filter(|task| runs && self.is_certain(task) && self.is_endless(&task.start));
        let same = created.filter(|task| task.start.name.as_ref() == Some(name));
        let mut others = same.filter_map(|task| task.created_by.as_ref()).filter(|other| *other != program);
        others.find(|other| !is_certain || order(other) < order(program))
    }

    fn is_certain(&self, task: &StaticTask) -> bool {
        task.start.certain && task.created_by.as_ref().is_some_and(|program| self.certain.contains(program))
    }

    fn is_endless(&self, start: &TaskStart) -> bool {
        start.program.library.is_none() && self.endless.contains(&start.program.program)
    }

    fn is_managed(&self, name: &str) -> bool {
        self.managed_tasks.iter().any(|beginning| name.starts_with(beginning.as_str()))
    }
}
