//! `setBreakpoints`: a task that arrives at a line is held; other tasks continue.

use val3_soap::SoapFault;
use val3_soap::v2::{ProgramLine, SetBreakpoints, SetBreakpointsAnswer};

use crate::context::Context;
use crate::debugging::breakpoint_responses;

/// Answers the request.
pub(super) fn answer(
    request: &SetBreakpoints,
    context: &mut Context<'_, '_>,
) -> Result<SetBreakpointsAnswer, SoapFault> {
    context.debug()?;
    let lines = request.breakpoints.iter().map(|reference| &reference.line);
    let results: Vec<_> = lines.map(|line| set(line, context)).collect();
    Ok(SetBreakpointsAnswer { responses: breakpoint_responses(results) })
}

fn set(line: &ProgramLine, context: &mut Context<'_, '_>) -> Result<(), SoapFault> {
    let at = context.target.find_line(line)?;
    context.state.debugging.set(at, line.clone(), context.target.debugger)
}
