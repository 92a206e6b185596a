//! `getCallStack`: the stack of a task, from the innermost program.

use val3_soap::SoapFault;
use val3_soap::v2::{GetCallStack, GetCallStackAnswer, LineReference, StackFrameSummary};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(request: &GetCallStack, context: &mut Context<'_, '_>) -> Result<GetCallStackAnswer, SoapFault> {
    let task = context.target.task(request.task.as_deref(), request.created_by.as_deref())?;
    let frames = val3_debug::frames(&context.target.debugger.controller.vm, task);
    let lines = frames.iter().map(|frame| LineReference { line: context.target.line_of(frame) });
    Ok(GetCallStackAnswer { frames: lines.map(|current| StackFrameSummary { current }).collect() })
}
