//! `getTasks`: all tasks with their state.

use super::TaskStatus;
use crate::structure::{operation, structure};

structure! {
    /// Request `getTasks`.
    GetTasks {}
}

structure! {
    /// Answer of `getTasks`.
    GetTasksAnswer {
        /// Tasks.
        tasks: Vec<TaskStatus> = "tasks" of "Task",
    }
}

operation!(GetTasks: V2 "getTasks" => GetTasksAnswer, "getTasksResponse");
