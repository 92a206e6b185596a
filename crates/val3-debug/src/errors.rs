//! Run-time errors at which the run stops, and the tasks that can handle them.

use std::collections::BTreeSet;

use val3_lang::fault::Fault;
use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors;
use val3_vm::{InstanceId, Task, TaskState, Vm};

use crate::called::called_program;

/// The run-time errors at which tasks stop the run: those that any of these select.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Errors {
    /// Each.
    pub all: bool,
    /// Errors without a task that can handle them: see [`handler`].
    pub unhandled: bool,
    /// Those of moves and motion descriptors ([`runtime_errors::is_motion`]), and paths that the arm cannot follow.
    pub motion: bool,
    /// Those with these numbers.
    pub numbers: BTreeSet<u16>,
}

impl Errors {
    /// Each run-time error.
    #[must_use]
    pub fn all() -> Self {
        Self { all: true, ..Self::default() }
    }

    /// The errors with these numbers.
    #[must_use]
    pub fn only(numbers: impl IntoIterator<Item = u16>) -> Self {
        Self { numbers: numbers.into_iter().collect(), ..Self::default() }
    }

    /// No error stops the run.
    #[must_use]
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// Whether the run stops when the arm comes to rest before a path that it cannot follow.
    pub(crate) fn contain_path_faults(&self) -> bool {
        self.all || self.motion
    }

    /// Whether an error that has stopped a task stops the run.
    pub(crate) fn contain(&self, vm: &Vm, task: TaskNumber, Fault(number): Fault) -> bool {
        self.all
            || self.numbers.contains(&number)
            || (self.motion && runtime_errors::is_motion(number))
            || (self.unhandled && handler(vm, task).is_none())
    }
}

/// The task that can handle the error of a task, if there is one at this moment.
///
/// VAL 3 has no handlers of errors: another task reads `taskStatus`, and resumes or kills the task. Whether it will do so is
/// not known when the error occurs. So an error counts as handled if another running task of the same application or
/// library is in a program that contains `taskStatus`, `taskResume` or `taskKill`, or that can call such a program. Tasks are
/// visible only in the application or library that has created them (5.3), so the instruction has to be there.
#[must_use]
pub fn handler(vm: &Vm, task: TaskNumber) -> Option<TaskNumber> {
    let failed = vm.tasks().iter().find(|known| known.id == task)?;
    let mut others = vm.tasks().iter().filter(|other| other.id != task && other.state == TaskState::Running);
    others.find(|other| watches(vm, other, failed.owner)).map(|other| other.id)
}

/// The instructions that ask for the state of another task or change it.
const HANDLING: [&str; 3] = ["taskStatus", "taskResume", "taskKill"];

/// Whether a task is in a program with an instruction about tasks of an application or library, or may call one.
fn watches(vm: &Vm, task: &Task, owner: InstanceId) -> bool {
    let mut left: Vec<(InstanceId, u16)> =
        task.thread.frames.iter().map(|frame| (frame.instance, frame.program)).collect();
    let mut seen: BTreeSet<(u16, u16)> = BTreeSet::new();
    while let Some((id, number)) = left.pop() {
        if !seen.insert((id.0, number)) {
            continue;
        }
        let Some(instance) = vm.space.instance(id) else { continue };
        let Some(program) = instance.image.programs.get(usize::from(number)) else { continue };
        let is_handling = |name: &str| HANDLING.contains(&name);
        if id == owner && program.instructions.iter().any(|site| is_handling(site.callee.name())) {
            return true;
        }
        left.extend(program.calls.iter().filter_map(|call| called_program(vm, id, call)));
    }
    false
}
