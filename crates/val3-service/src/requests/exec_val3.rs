//! `execVal3`: executes code in a stack frame, or with an application's global data.

use val3_debug::DisplayFormat;
use val3_session::{Evaluation, EvaluationError, Purpose};
use val3_soap::SoapFault;
use val3_soap::v2::{ExecVal3, ExecVal3Answer, ExecutionResult};
use val3_vm::FragmentContext;

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &ExecVal3, context: &mut Context<'_, '_>) -> Result<ExecVal3Answer, SoapFault> {
    let target = &mut *context.target;
    let place = match request.task.as_deref().unwrap_or_default() {
        "" => FragmentContext::Instance(target.named_instance(request.project.as_deref().unwrap_or_default())?),
        task => {
            let task = target.task(Some(task), request.created_by.as_deref())?;
            FragmentContext::Frame(task, target.frame_depth(task, request.frame)?)
        }
    };
    let code = request.command.as_deref().unwrap_or_default();
    let controller = &mut target.debugger.controller;
    let result = target.evaluator.evaluate(controller, place, code, Purpose::Execute, DisplayFormat::default());
    let (code, output) = match result {
        Ok(evaluation) => (ExecutionResult::NoError, text(evaluation)),
        Err(error @ EvaluationError::Code(_)) => (ExecutionResult::CompilationError, error.to_string()),
        Err(error @ EvaluationError::Ended { .. }) => (ExecutionResult::RuntimeError, error.to_string()),
    };
    Ok(ExecVal3Answer { code, output: Some(output) })
}

/// Text of the result: the expression's value, or the lines that statements have printed.
fn text(evaluation: Evaluation) -> String {
    match evaluation.value {
        Some(value) => value.shown,
        None => evaluation.output.join("\n"),
    }
}
