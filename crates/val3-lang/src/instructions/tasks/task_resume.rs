//! `taskResume` (5.10): resumes a halted task.

use crate::call::{Call, Flow};
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::Text;

instruction! {
    /// Resumes a halted task.
    ///
    /// - `sName`: the task, created by this application or library. A running task is not affected.
    /// - `nSkip`: the line at which to resume, counted in instruction lines from the one at which it stopped: 0 this
    ///   line, 1 the next line, -1 the previous line.
    /// - Errors: 30 no such task, 90 no instruction line there.
    ///
    /// ## Example
    /// ```val3
    ///   if taskStatus("robot")>1
    ///     // leave out the line that failed
    ///     taskResume("robot",1)
    ///   endIf
    /// ```
    "taskResume": Tasks "5.10", blocking, errors [30, 90];
    modifier (string sName, num nSkip) = task_resume;
}

/// Passes the turn, so that the task can be ready when the next line begins (5.4).
fn task_resume(call: &mut Call<'_>, name: Text, skip: f64) -> Result<Flow> {
    if !call.is_first() {
        return Ok(Flow::Done(()));
    }
    call.tasks.resume(&name, skip)?;
    Ok(call.sleep(0))
}

#[cfg(test)]
mod tests {
    use crate::runtime_errors::TaskStatusCode;
    use crate::testing::Bench;

    #[test]
    fn resumes_a_task_and_passes_the_turn() {
        let mut bench = Bench::default();
        bench.tasks.states.insert("robot".to_owned(), TaskStatusCode::Halted);
        let line = "taskResume(\"robot\",1)";
        assert_eq!([bench.run(line), bench.run(line)], ["sleeps until 0", ""]);
        assert_eq!(bench.tasks.states["robot"], TaskStatusCode::Running);
        assert_eq!(bench.run("taskResume(\"tools\",0)"), "error 30");
    }
}
