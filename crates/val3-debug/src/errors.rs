//! Run-time errors that stop the run, and the tasks that can handle them.

use std::collections::BTreeSet;

use val3_lang::fault::Fault;
use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors;
use val3_vm::{InstanceId, ProgramId, Task, TaskState, Vm};

/// Run-time errors that stop the run: every error that at least one field selects.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct StopErrors {
    /// Every error.
    pub all: bool,
    /// Errors that no task can handle: see [`handler`].
    pub unhandled: bool,
    /// Errors of moves and motion descriptors ([`runtime_errors::is_motion`]), and paths that the arm cannot follow.
    pub motion: bool,
    /// Contacts of the arm, or of a thing that it carries, with a thing around it.
    pub contacts: bool,
    /// Errors with these numbers.
    pub numbers: BTreeSet<u16>,
}

impl StopErrors {
    /// Selects every run-time error.
    #[must_use]
    pub fn all() -> Self {
        Self { all: true, ..Self::default() }
    }

    /// Selects the errors with these numbers.
    #[must_use]
    pub fn only(numbers: impl IntoIterator<Item = u16>) -> Self {
        Self { numbers: numbers.into_iter().collect(), ..Self::default() }
    }

    /// Whether no error stops the run.
    #[must_use]
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// Whether the run stops when the arm comes to rest before a path that it cannot follow.
    pub(crate) fn contain_path_faults(&self) -> bool {
        self.all || self.motion
    }

    /// Whether an error that has stopped a task also stops the run.
    pub(crate) fn contain(&self, vm: &Vm, task: TaskNumber, Fault(number): Fault) -> bool {
        self.all
            || self.numbers.contains(&number)
            || (self.motion && runtime_errors::is_motion(number))
            || (self.unhandled && handler(vm, task).is_none())
    }
}

/// Returns a task that can handle the error of `task`.
///
/// VAL 3 has no error handlers: another task reads `taskStatus`, and resumes or kills the failed task. When the error
/// occurs, it is unknown whether a task will do so. An error therefore counts as handled if another running task is in
/// a program that contains `taskStatus`, `taskResume` or `taskKill`, or that can call such a program. The instruction
/// has to be in the application or library that created the failed task, because tasks are visible only there (5.3).
#[must_use]
pub fn handler(vm: &Vm, task: TaskNumber) -> Option<TaskNumber> {
    let failed = vm.tasks().iter().find(|known| known.id == task)?;
    let mut others = vm.tasks().iter().filter(|other| other.id != task && other.state == TaskState::Running);
    others.find(|other| watches(vm, other, failed.owner)).map(|other| other.id)
}

/// Instructions that read or change another task's state.
const HANDLING: [&str; 3] = ["taskStatus", "taskResume", "taskKill"];

/// Whether the task is in a program of `owner` with such an instruction, or can call one.
fn watches(vm: &Vm, task: &Task, owner: InstanceId) -> bool {
    let frames = task.thread.frames.iter();
    let mut left: Vec<_> = frames.map(|frame| ProgramId { instance: frame.instance, number: frame.program }).collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = left.pop() {
        if !seen.insert(id) {
            continue;
        }
        let Some(instance) = vm.space.instance(id.instance) else { continue };
        let Some(program) = instance.image.programs.get(usize::from(id.number)) else { continue };
        if id.instance == owner && program.instructions.iter().any(|site| HANDLING.contains(&site.callee.name())) {
            return true;
        }
        left.extend(program.calls.iter().filter_map(|call| vm.space.called(id.instance, call.program)));
    }
    false
}
