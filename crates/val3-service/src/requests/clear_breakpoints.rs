//! `clearBreakpoints`.

use val3_soap::v2::{ClearBreakpoints, ClearBreakpointsAnswer, ProgramLine};
use val3_soap::{ExceptionCode, SoapFault};

use crate::context::{Context, refused};
use crate::debugging::breakpoint_responses;

/// Answers the request.
pub(super) fn answer(
    request: &ClearBreakpoints,
    context: &mut Context<'_, '_>,
) -> Result<ClearBreakpointsAnswer, SoapFault> {
    context.debug()?;
    let lines = request.breakpoints.iter().map(|reference| &reference.line);
    let results: Vec<_> = lines.map(|line| clear(line, context)).collect();
    Ok(ClearBreakpointsAnswer { responses: breakpoint_responses(results) })
}

fn clear(line: &ProgramLine, context: &mut Context<'_, '_>) -> Result<(), SoapFault> {
    let at = context.target.find_line(line)?;
    if context.state.debugging.clear(&at, context.target.debugger) {
        return Ok(());
    }
    Err(refused(ExceptionCode::ProgramLineNotFound, "the line has no breakpoint"))
}
