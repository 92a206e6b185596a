//! `taskStatus` (5.10): returns the state of a task.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns the state of a task.
    ///
    /// - `sName`: the task, created by this application or library.
    /// - Result: 1 running (also while it waits), 0 halted, -1 no such task; every other number is the run-time error
    ///   that stopped it.
    ///
    /// ## Example
    /// ```val3
    /// num nStatus
    ///   nStatus=taskStatus("robot")
    ///   if nStatus>1
    ///     logMsg("robot: error "+toString("",nStatus))
    ///   endIf
    /// ```
    "taskStatus": Tasks "5.10";
    function (string sName) -> num = task_status;
}

fn task_status(call: &mut Call<'_>, name: Text) -> f64 {
    f64::from(call.tasks.status(&name))
}

#[cfg(test)]
mod tests {
    use crate::runtime_errors::TaskStatusCode;
    use crate::testing::Bench;

    #[test]
    fn returns_states_as_numbers() {
        let mut bench = Bench::default();
        bench.tasks.states.insert("robot".to_owned(), TaskStatusCode::Running);
        bench.tasks.states.insert("tools".to_owned(), TaskStatusCode::Halted);
        let states = ["robot", "tools", "other"].map(|name| bench.run(&format!("taskStatus(\"{name}\")")));
        assert_eq!(states, ["1", "0", "-1"]);
    }
}
