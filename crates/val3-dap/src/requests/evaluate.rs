//! `evaluate`: evaluates an expression, or executes a statement of the debug console.

use val3_debug::{DebugValue, DisplayFormat, count, values};
use val3_session::{Evaluation, Purpose};
use val3_vm::FragmentContext;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::EvaluateContext;
use crate::protocol::{EvaluateArguments, EvaluateResponse};
use crate::request::DebugRequest;
use crate::session::DebugSession;

/// The request `evaluate`.
pub(crate) enum Evaluate {}

impl DebugRequest for Evaluate {
    const COMMAND: &'static str = "evaluate";
    type Arguments = EvaluateArguments;
    type Body = EvaluateResponse;

    fn answer(
        session: &mut DebugSession,
        run: &mut DebuggedRun<'_>,
        arguments: EvaluateArguments,
    ) -> Result<EvaluateResponse, RequestFailure> {
        let context = session.context(arguments.frame_id, run)?;
        let purpose = match arguments.context {
            Some(EvaluateContext::Repl) => Purpose::Execute,
            _ => Purpose::Watch,
        };
        let is_copied = arguments.context == Some(EvaluateContext::Clipboard);
        let is_short = arguments.context == Some(EvaluateContext::Hover);
        let format = session.format(arguments.format.as_ref());
        let format = DisplayFormat { bare: is_copied, exact: !is_short, ..format };
        let evaluation = match context {
            FragmentContext::Frame(task, depth)
                if purpose == Purpose::Execute && session.check_task_stopped(task, run).is_ok() =>
            {
                session.execute(task, depth, &arguments.expression, format, run)?
            }
            _ => session.evaluate_while(context, &arguments.expression, purpose, format, run)?,
        };
        let Evaluation { value, output, passed_stops, stop, .. } = evaluation;
        if purpose == Purpose::Execute && passed_stops > 0 {
            session.note(&passed(passed_stops));
        }
        let list = value.as_ref().filter(|_| is_copied).and_then(|value| list(value, run, format));
        let value = value.map(|value| DebugValue {
            refers_to: value.refers_to.filter(|other| !is_copied && !names(&arguments.expression, other)),
            ..value
        });
        let mut variable = value.map(|value| session.shown(value, run)).unwrap_or_default();
        if is_short && variable.variables_reference == 0 {
            let earlier = session.earlier_values(&arguments.expression, arguments.frame_id, run);
            variable.value.extend(earlier.map(|earlier| format!(" · {earlier}")));
        }
        let mut lines = output;
        lines.extend(stop.map(|_| STOPPED.to_owned()));
        lines.extend(Some(list.unwrap_or(variable.value)).filter(|value| !value.is_empty()));
        Ok(EvaluateResponse {
            result: lines.join("\n"),
            r#type: variable.r#type,
            variables_reference: variable.variables_reference,
            indexed_variables: variable.indexed_variables,
            named_variables: variable.named_variables,
            ..EvaluateResponse::default()
        })
    }
}

/// Result of statements that have stopped in a called program.
const STOPPED: &str = "stopped in the called program; the task returns here after the call";

/// Formats the note that breakpoints have no effect without the stack of a stopped task.
fn passed(stops: u32) -> String {
    let times = if stops == 1 { "time" } else { "times" };
    format!("the code has passed breakpoints {stops} {times} in called programs; they stop it in a stack frame only")
}

/// Whether an expression is the variable, or an element or a field of it.
fn names(expression: &str, variable: &str) -> bool {
    let rest = expression.trim().strip_prefix(variable);
    rest.is_some_and(|rest| !rest.starts_with(|next: char| next.is_alphanumeric() || next == '_'))
}

/// Returns all values of an array or collection as one text.
fn list(value: &DebugValue, run: &mut DebuggedRun<'_>, format: DisplayFormat) -> Option<String> {
    let inside = value.inside.as_ref().filter(|inside| inside.is_indexed())?;
    let controller = &mut run.debugger.controller;
    let all = 0..count(&mut controller.vm, inside);
    let texts = values(controller, inside, all, format).into_iter().map(|value| value.shown);
    Some(format!("{{{}}}", texts.collect::<Vec<_>>().join(", ")))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use crate::test_client::{CALLER, COUNTER, TestClient, source};

    #[test]
    fn a_statement_without_a_stack_frame_passes_breakpoints_with_a_note() {
        let mut client = TestClient::stopped(CALLER);
        client.body("setBreakpoints", json!({ "source": source("work"), "breakpoints": [{ "line": 5 }] }));
        let notes = |client: &mut TestClient, code: &str| {
            let events = client.events("evaluate", json!({ "expression": code, "context": "repl" })).into_iter();
            let outputs = events.filter(|(event, _)| event == "output").map(|(_, body)| body["output"].clone());
            outputs.collect::<Vec<_>>()
        };
        let passed = "the code has passed breakpoints 1 time in called programs; they stop it in a stack frame only";
        assert_eq!(notes(&mut client, "call work()"), [format!("note: {passed}\n")]);
        assert_eq!(notes(&mut client, "delay(0)"), Vec::<String>::new());
    }

    #[test]
    fn copied_values_have_no_notes_and_all_digits() {
        let listing = "num nThird\nnum nOne[1]\n\nprogram start()\nbegin\n  nThird=1/3\n  delay(1)\nend\n";
        let mut client = TestClient::stopped(listing);
        let (thread, _) = client.thread_and_frame();
        client.stop_after("next", json!({ "threadId": thread }));
        let (_, frame) = client.thread_and_frame();
        let mut shown = |expression: &str, context: &str| {
            let arguments = json!({ "expression": expression, "frameId": frame, "context": context });
            client.body("evaluate", arguments)["result"].clone()
        };
        assert_eq!(shown("nThird", "clipboard"), "0.3333333333333333");
        assert_eq!(shown("nThird", "watch"), "0.3333333333333333");
        assert!(shown("nThird", "hover").as_str().unwrap().starts_with("0.33333333333333 · since "));
        assert_eq!(shown("nOne[0]", "watch"), "0");
        assert_eq!(shown("nThird*3", "watch"), "1");
    }

    #[test]
    fn only_the_console_executes_statements() {
        let mut client = TestClient::stopped(COUNTER);
        let (_, frame) = client.thread_and_frame();
        let console = json!({ "expression": "nCount=7", "frameId": frame, "context": "repl" });
        client.body("evaluate", console);
        let watch = json!({ "expression": "nCount+1", "frameId": frame, "context": "watch" });
        assert_eq!(client.body("evaluate", watch)["result"], "8");
    }
}
