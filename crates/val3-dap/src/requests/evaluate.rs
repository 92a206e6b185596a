//! `evaluate`: evaluates an expression, or executes a statement of the debug console.

use val3_debug::{DebugValue, DisplayFormat, count, values};
use val3_session::{Evaluation, Purpose};

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
        let format = session.format(arguments.format.as_ref());
        let evaluation = session.evaluate_while(context, &arguments.expression, (purpose, format), run)?;
        let Evaluation { value, output, .. } = evaluation;
        let is_whole = arguments.context == Some(EvaluateContext::Clipboard);
        let list = value.as_ref().filter(|_| is_whole).and_then(|value| list(value, run, format));
        let variable = value.map(|value| session.shown(value, run)).unwrap_or_default();
        let mut lines = output;
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

    use crate::test_client::{COUNTER, TestClient};

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
