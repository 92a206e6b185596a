//! Conditions of breakpoints as users write them: `nCount>3`, `task=="main~"`, `task=="main~" and nCount>3`.

use val3_debug::CompiledExpression;
use val3_session::EvaluationError;

use crate::debugged_run::DebuggedRun;

/// Condition of a breakpoint.
#[derive(Debug, Clone, Default)]
pub(crate) struct ConditionText {
    /// Name of the only task that the breakpoint affects; `None` for all tasks.
    pub(crate) task: Option<String>,
    /// Condition for a hit to count.
    pub(crate) condition: Option<CompiledExpression>,
}

impl ConditionText {
    /// Compiles a condition for the program of a file. A task filter is only recognised if the entire text is not a
    /// valid condition, because a program may have a variable `task`.
    ///
    /// # Errors
    /// The condition is invalid in the program.
    pub(crate) fn compiled(text: &str, file: &str, run: &mut DebuggedRun<'_>) -> Result<Self, EvaluationError> {
        let vm = &run.debugger.controller.vm;
        let found = run.evaluator.condition(vm, file, text);
        let Some((task, rest)) = task_filter(text).filter(|_| found.is_err()) else {
            return Ok(Self { task: None, condition: Some(found?) });
        };
        let condition = rest.map(|rest| run.evaluator.condition(vm, file, rest)).transpose()?;
        Ok(Self { task: Some(task.to_owned()), condition })
    }
}

/// Splits `task=="name"` or `task=="name" and condition` into the task name and the condition.
fn task_filter(text: &str) -> Option<(&str, Option<&str>)> {
    let value = text.trim().strip_prefix("task")?.trim_start().strip_prefix("==")?.trim_start();
    let (name, rest) = value.strip_prefix('"')?.split_once('"')?;
    let rest = rest.trim_start();
    if rest.is_empty() {
        return Some((name, None));
    }
    let condition = rest.strip_prefix("and").filter(|rest| rest.starts_with([' ', '\t', '(']))?;
    Some((name, Some(condition.trim_start())))
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::task_filter;
    use crate::test_client::{FIRST_LINE, MAIN_THREAD, TestClient, WORKER_THREAD, source};

    /// Two tasks execute `work`.
    const TWO_TASKS: &str = "num nCount\n\nprogram start()\nbegin\n  taskCreate \"other\",10,work()\n  call work()\n  \
                             delay(1)\nend\n\nprogram work()\nbegin\n  nCount=nCount+1\n  delay(0.1)\n  \
                             nCount=nCount+1\nend\n";

    fn stops(condition: &str) -> Vec<Value> {
        let mut client = TestClient::stopped(TWO_TASKS);
        let breakpoint = json!({ "name": "work", "condition": condition });
        let set = client.body("setFunctionBreakpoints", json!({ "breakpoints": [breakpoint] }));
        assert_eq!(set["breakpoints"][0]["verified"], true, "{set}");
        let line = json!({ "line": FIRST_LINE + 2, "condition": condition });
        let set = client.body("setBreakpoints", json!({ "source": source("work"), "breakpoints": [line] }));
        assert_eq!(set["breakpoints"][0]["verified"], true, "{set}");
        let mut tasks = Vec::new();
        loop {
            client.body("continue", json!({ "threadId": MAIN_THREAD }));
            let events = client.run();
            let Some((_, stop)) = events.iter().find(|(event, _)| event == "stopped") else { return tasks };
            tasks.push(stop["threadId"].clone());
        }
    }

    #[test]
    fn a_breakpoint_can_be_for_one_task() {
        let all = stops("true");
        let [mine, other] = [MAIN_THREAD, WORKER_THREAD].map(|task| all.iter().filter(|id| **id == task).count());
        assert_eq!([mine, other], [2, 2], "{all:?}");
        assert_eq!(stops("task==\"other\""), [WORKER_THREAD, WORKER_THREAD]);
        assert_eq!(stops("task == \"other\" and nCount>1"), [WORKER_THREAD]);
        assert_eq!(stops("task==\"nobody\""), Vec::<Value>::new());
    }

    #[test]
    fn other_conditions_have_no_filter() {
        assert_eq!(task_filter("task==\"a\" and(nX>1)"), Some(("a", Some("(nX>1)"))));
        for text in ["tasks==\"a\"", "task!=\"a\"", "task==\"a\" or nX>1", "task==\"a\" andnX>1", "task==3"] {
            assert_eq!(task_filter(text), None, "{text}");
        }
    }
}
