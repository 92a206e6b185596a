//! `setCurrentInstruction`: sets the next line of a held or stopped task, which stays held.

use val3_debug::GotoFault;
use val3_lang::ports::TaskNumber;
use val3_soap::v2::SetCurrentInstruction;
use val3_soap::{Empty, ExceptionCode, SoapFault};

use crate::context::{Context, refused};

/// Answers the request.
pub(super) fn answer(request: &SetCurrentInstruction, context: &mut Context<'_, '_>) -> Result<Empty, SoapFault> {
    let task = context.target.task(request.task.as_deref(), request.created_by.as_deref())?;
    let line = context.target.find_line(&request.line)?;
    check_stopped(task, context)?;
    context.debug()?;
    let debugger = &mut *context.target.debugger;
    let next = debugger.goto_target(task, &line.file, line.row).map_err(fault)?;
    if next.row != line.row {
        return Err(refused(ExceptionCode::ProgramLineNotFound, "the line has no instruction"));
    }
    // `goto` continues a task that an error or the application has stopped.
    debugger.pause_task(task, true);
    if request.reset_motion {
        debugger.controller.discard_moves();
    }
    debugger.goto(task, next).map(|()| Empty).map_err(fault)
}

fn check_stopped(task: TaskNumber, context: &Context<'_, '_>) -> Result<(), SoapFault> {
    let mut tasks = context.target.debugger.controller.vm.tasks().iter();
    if tasks.any(|known| known.id == task && known.is_running() && !known.is_held) {
        return Err(refused(ExceptionCode::Unknown, "the task runs: suspend it first (taskSuspend)"));
    }
    Ok(())
}

fn fault(fault: GotoFault) -> SoapFault {
    let code = match fault {
        GotoFault::NoTask => ExceptionCode::TaskNotFound,
        GotoFault::OtherProgram => ExceptionCode::ProgramNotFound,
        GotoFault::NoLine => ExceptionCode::ProgramLineNotFound,
    };
    refused(code, &fault.to_string())
}
