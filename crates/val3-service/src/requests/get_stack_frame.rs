//! `getStackFrame`: the parameters and locals of a stack frame. The form is inferred.

use val3_machine::devices::DocumentFault;
use val3_soap::v2::{GetStackFrame, GetStackFrameAnswer, MimeData};
use val3_soap::{ExceptionCode, SoapFault};

use crate::context::{Context, refused};

/// Answers the request.
pub(super) fn answer(request: &GetStackFrame, context: &mut Context<'_, '_>) -> Result<GetStackFrameAnswer, SoapFault> {
    let task = context.target.task(request.task.as_deref(), request.created_by.as_deref())?;
    let depth = context.target.frame_depth(task, request.frame)?;
    let controller = context.controller();
    let document = controller.devices.frame_document(&mut controller.vm, task, depth);
    document.map(|text| GetStackFrameAnswer { data: MimeData::xml(text) }).map_err(|fault| {
        let code = match fault {
            DocumentFault::NoFrame => ExceptionCode::StackFrameNotFound,
            _ => ExceptionCode::Unknown,
        };
        refused(code, &fault.to_string())
    })
}
