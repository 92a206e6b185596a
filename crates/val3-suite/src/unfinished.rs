//! Failure of a program that does not end, and call stacks of tasks.

use val3_debug::frames;
use val3_lang::ports::{TaskNumber, Time};
use val3_machine::controller::{Activity, Controller};
use val3_machine::event::shown_seconds;
use val3_session::LineCondition;

use crate::failure::{Failure, FailureLocation};
use crate::killed::task_number;
use crate::library::NAME;

/// A program that does not end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Unfinished {
    /// Timeout on the controller's clock, in nanoseconds.
    pub(crate) limit: Time,
    /// Whether something can still happen.
    pub(crate) has_time: bool,
}

/// Function that returns the conditions for which a task waits.
pub(crate) type Conditions<'c> = &'c mut dyn FnMut(&mut Controller, TaskNumber) -> Vec<LineCondition>;

impl Unfinished {
    /// Failure of a program whose task does not end. If this task has ended, another task keeps the application
    /// running.
    pub(crate) fn failure(self, controller: &mut Controller, task: TaskNumber, conditions: Conditions<'_>) -> Failure {
        let mut tasks = controller.vm.tasks().iter().map(|task| task.id).zip(controller.task_positions());
        let found = tasks.clone().find(|(id, _)| *id == task).map(|(id, position)| (id, "it".to_owned(), position));
        let found = found
            .or_else(|| tasks.next().map(|(id, position)| (id, format!("the task `{}`", position.name), position)));
        let (id, activity) = match found {
            Some((id, subject, position)) => (id, format!(": {subject} {}", position.activity)),
            None => (task, String::new()),
        };
        let conditions: String = conditions(controller, id).iter().map(worded).collect();
        let message = if self.has_time {
            format!("not ended after {} s{activity}{conditions}", shown_seconds(self.limit))
        } else {
            format!("it never ends{activity}, and nothing can happen any more{conditions}")
        };
        Failure { message, places: places(controller, id) }
    }
}

/// Formats a condition and the values in it as lines.
fn worded(LineCondition { line, text, values }: &LineCondition) -> String {
    let values = values.iter().map(|(name, value)| format!("\n    {name} = {value}"));
    format!("\n  line {line}: {text}{}", values.collect::<String>())
}

/// Whether a run-time error has stopped a task.
pub(crate) fn is_stopped(controller: &Controller, task: TaskNumber) -> bool {
    matches!(activity(controller, task), Some(Activity::Failed(_)))
}

fn activity(controller: &Controller, task: TaskNumber) -> Option<Activity> {
    let mut positions = controller.vm.tasks().iter().zip(controller.task_positions());
    positions.find(|(known, _)| known.id == task).map(|(_, position)| position.activity)
}

/// Call stack of a task, without programs of the library `val3assert`.
pub(crate) fn places(controller: &Controller, task: TaskNumber) -> Vec<FailureLocation> {
    let frames = frames(&controller.vm, task).into_iter().filter(|frame| frame.application != NAME);
    let places = frames.map(|frame| FailureLocation {
        program: format!("{}:{}", frame.application, frame.program),
        file: frame.file,
        line: frame.row,
    });
    places.collect()
}

/// Call stack of the task with this name; empty if it has ended.
pub(crate) fn places_of(controller: &Controller, task: &str) -> Vec<FailureLocation> {
    task_number(controller, task).map(|task| places(controller, task)).unwrap_or_default()
}

/// Whether a task is in a program of the library `val3assert`.
pub(crate) fn is_in_library(controller: &Controller, task: TaskNumber) -> bool {
    frames(&controller.vm, task).first().is_some_and(|frame| frame.application == NAME)
}
