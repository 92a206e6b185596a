//! `getBreakpoints`: the breakpoints of clients.

use val3_soap::SoapFault;
use val3_soap::v2::{GetBreakpoints, GetBreakpointsAnswer, LineReference};

use crate::context::Context;

/// Answers the request.
pub(super) fn answer(_: &GetBreakpoints, context: &mut Context<'_, '_>) -> Result<GetBreakpointsAnswer, SoapFault> {
    let breakpoints = context.state.debugging.breakpoints.iter();
    let breakpoints = breakpoints.map(|breakpoint| LineReference { line: breakpoint.line.clone() }).collect();
    Ok(GetBreakpointsAnswer { breakpoints })
}
