//! `taskSuspend` (5.10): halts a task.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::Text;

instruction! {
    /// Halts a task.
    ///
    /// - `sName`: the task, created by this application or library. A halted task stays halted.
    /// - Error 30: no such task.
    ///
    /// `taskResume` resumes it. The arm does not stop: use `stopMove` for that.
    ///
    /// ## Example
    /// ```val3
    ///   if taskStatus("robot")==1
    ///     taskSuspend("robot")
    ///   endIf
    /// ```
    "taskSuspend": Tasks "5.10", errors [30];
    modifier (string sName) = task_suspend;
}

fn task_suspend(call: &mut Call<'_>, name: Text) -> Result<()> {
    call.tasks.suspend(&name)
}

#[cfg(test)]
mod tests {
    use crate::runtime_errors::TaskStatusCode;
    use crate::testing::Bench;

    #[test]
    fn halts_an_existing_task() {
        let mut bench = Bench::default();
        bench.tasks.states.insert("robot".to_owned(), TaskStatusCode::Running);
        assert_eq!([bench.run("taskSuspend(\"robot\")"), bench.run("taskSuspend(\"Robot\")")], ["", "error 30"]);
        assert_eq!(bench.tasks.states["robot"], TaskStatusCode::Halted);
    }
}
