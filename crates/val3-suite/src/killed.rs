//! Failure of a test whose task was killed by a program, so that the rest was not tested.

use val3_lang::ports::TaskNumber;
use val3_machine::controller::Controller;
use val3_machine::event::{Event, EventKind};

use crate::failure::{Failure, FailureLocation};
use crate::unfinished::places_of;

/// Returns the failure if this event kills the task with this name. Its places are the call stack of the killing task.
pub(crate) fn killed(event: &Event, name: &str, controller: &Controller) -> Option<Failure> {
    let EventKind::Task { state: "killed", name: killed, program, line, file, .. } = &event.kind else { return None };
    // Tasks that are killed at the end of their application have no killing task.
    let killer = event.task.as_deref().filter(|_| killed == name)?;
    let here = FailureLocation { program: program.clone(), file: file.clone(), line: *line };
    if killer == name {
        return Some(Failure { message: "its task has killed itself".to_owned(), places: vec![here] });
    }
    let killing = places_of(controller, killer);
    let message = format!("its task was at line {line} of `{program}` when the task `{killer}` killed it");
    Some(Failure { message, places: if killing.is_empty() { vec![here] } else { killing } })
}

/// Name of a task that has not ended.
pub(crate) fn task_name(controller: &Controller, task: TaskNumber) -> Option<String> {
    controller.vm.tasks().iter().find(|known| known.id == task).map(|known| known.name.clone())
}

/// Number of a task that has not ended.
pub(crate) fn task_number(controller: &Controller, name: &str) -> Option<TaskNumber> {
    controller.vm.tasks().iter().find(|known| known.name == name).map(|known| known.id)
}
