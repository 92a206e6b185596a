//! `execVal3`: executes code in a stack frame, or with the data of an application.

use val3_debug::DisplayFormat;
use val3_session::{Evaluation, EvaluationError, Purpose};
use val3_soap::v2::{ExecVal3, ExecVal3Answer, ExecutionResult};
use val3_soap::{ExceptionCode, SoapFault};
use val3_vm::FragmentContext;

use crate::context::{Context, refused};

/// Answers the request.
pub(super) fn answer(request: &ExecVal3, context: &mut Context<'_, '_>) -> Result<ExecVal3Answer, SoapFault> {
    let target = &mut *context.target;
    let place = match request.task.as_deref().unwrap_or_default() {
        "" => FragmentContext::Instance(target.instance(request.project.as_deref().unwrap_or_default())?),
        task => {
            let task = target.task(Some(task), request.created_by.as_deref())?;
            let depth = usize::try_from(request.frame).ok();
            let count = val3_debug::frames(&target.debugger.controller.vm, task).len();
            let depth = depth.filter(|depth| *depth < count);
            FragmentContext::Frame(
                task,
                depth.ok_or_else(|| refused(ExceptionCode::StackFrameNotFound, "the task has no such stack frame"))?,
            )
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

/// Value of an expression, or the lines that statements have printed.
fn text(evaluation: Evaluation) -> String {
    match evaluation.value {
        Some(value) => value.shown,
        None => evaluation.output.join("\n"),
    }
}
