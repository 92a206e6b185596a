//! Questions on the pendant for which tasks wait.

use std::collections::BTreeMap;

use val3_lang::ports::{InputResult, TaskNumber};

use crate::screen::{Pendant, ReadingId};

/// Each task's question to the operator.
#[derive(Debug, Clone, Default)]
pub(super) struct Questions {
    by_task: BTreeMap<TaskNumber, ReadingId>,
}

impl Questions {
    /// Notes that a task waits for an answer.
    pub(super) fn begin(&mut self, task: TaskNumber, question: ReadingId) {
        self.by_task.insert(task, question);
    }

    /// Returns the operator's answer to the question of a task, if it exists.
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
