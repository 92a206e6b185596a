//! The questions on the pendant that tasks wait for.

use std::collections::BTreeMap;

use val3_lang::ports::{InputResult, TaskNumber};

use crate::screen::{Pendant, ReadingId};

/// The question of each task to the operator.
#[derive(Debug, Clone, Default)]
pub(super) struct Questions {
    by_task: BTreeMap<TaskNumber, ReadingId>,
}

impl Questions {
    /// A task begins to wait for an answer.
    pub(super) fn begin(&mut self, task: TaskNumber, question: ReadingId) {
        self.by_task.insert(task, question);
    }

    /// The answer to the question of a task, once the operator has given it.
    pub(super) fn take_answer(&mut self, task: TaskNumber, pendant: &mut Pendant) -> Option<InputResult> {
        let answer = pendant.take_answer(*self.by_task.get(&task)?)?;
        self.by_task.remove(&task);
        Some(answer)
    }

    /// Cancels the question of a task.
    pub(super) fn cancel(&mut self, task: TaskNumber, pendant: &mut Pendant) {
        if let Some(question) = self.by_task.remove(&task) {
            pendant.cancel_reading(question);
        }
    }
}
