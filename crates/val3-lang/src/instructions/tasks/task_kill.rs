//! `taskKill` (5.10): ends a task.

use crate::call::{Call, Flow};
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Ends a task.
    ///
    /// - `sName`: the task, created by this application or library. If it does not exist, nothing happens.
    ///
    /// It returns when the task was removed, so the name can be used again.
    ///
    /// ## Example
    /// ```val3
    ///   taskKill("robot")
    ///   resetMotion()
    /// ```
    "taskKill": Tasks "5.10", blocking;
    modifier (string sName) = task_kill;
}

/// Passes the turn; the task is removed at the end of the turn (5.4).
fn task_kill(call: &mut Call<'_>, name: Text) -> Flow {
    if !call.is_first() {
        return Flow::Done(());
    }
    call.tasks.kill(&name);
    call.sleep(0)
}

#[cfg(test)]
mod tests {
    use crate::runtime_errors::TaskStatusCode;
    use crate::testing::Bench;

    #[test]
    fn ends_a_task_once() {
        let mut bench = Bench::default();
        bench.tasks.states.insert("robot".to_owned(), TaskStatusCode::Running);
        assert_eq!(bench.run("taskKill(\"robot\")"), "sleeps until 0");
        assert!(bench.tasks.states.is_empty());
        bench.tasks.states.insert("robot".to_owned(), TaskStatusCode::Running);
        assert_eq!(bench.run("taskKill(\"robot\")"), "");
        assert_eq!(bench.tasks.states["robot"], TaskStatusCode::Running);
    }

    #[test]
    fn an_unknown_task_is_no_error() {
        assert_eq!(Bench::default().run("taskKill(\"robot\")"), "sleeps until 0");
    }
}
