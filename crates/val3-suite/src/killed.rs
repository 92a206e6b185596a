//! The failure of a test whose task a program has killed: nothing after that place was tested.

use val3_lang::ports::TaskNumber;
use val3_machine::controller::Controller;
use val3_machine::event::{Event, EventKind};

use crate::failure::{Failure, Place};
use crate::unfinished::places_of;

/// The failure, if this event ends the task with this name. Its places are those of the task that has killed it.
pub(crate) fn killed(event: &Event, name: &str, controller: &Controller) -> Option<Failure> {
    let EventKind::Task { state: "killed", name: killed, program, line, file, .. } = &event.kind else { return None };
    // The end of an application, which kills its tasks, is no task.
    let killer = event.task.as_deref().filter(|_| killed == name)?;
    let here = Place { program: program.clone(), file: file.clone(), line: *line };
    if killer == name {
        return Some(Failure { message: "its task has killed itself".to_owned(), places: vec![here] });
    }
    let killing = places_of(controller, killer);
    let message = format!("its task was at line {line} of `{program}` when the task `{killer}` killed it");
    Some(Failure { message, places: if killing.is_empty() { vec![here] } else { killing } })
}

/// The name of a task that has not ended.
pub(crate) fn task_name(controller: &Controller, task: TaskNumber) -> Option<String> {
    controller.vm.tasks().iter().find(|known| known.id == task).map(|known| known.name.clone())
}

/// The number of a task that has not ended.
pub(crate) fn task_number(controller: &Controller, name: &str) -> Option<TaskNumber> {
    controller.vm.tasks().iter().find(|known| known.name == name).map(|known| known.id)
}
