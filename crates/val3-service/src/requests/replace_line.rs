//! `replaceLine`: replaces a line of a program in memory, which tasks continue with. The file stays unchanged.

use val3_soap::SoapFault;
use val3_soap::v2::{ReplaceLine, ReplaceLineAnswer, ReplacementResult};

use crate::context::Context;
use crate::inferred::replacement_result;

/// Answers the request.
pub(super) fn answer(request: &ReplaceLine, context: &mut Context<'_, '_>) -> Result<ReplaceLineAnswer, SoapFault> {
    let (program, line) = context.target.find_program_line(&request.line)?;
    context.debug()?;
    let code = request.new_line.as_deref().unwrap_or_default();
    let target = &mut *context.target;
    let replaced = target.evaluator.replace_line(target.debugger, program, line.row, code);
    let (code, output) = match replaced {
        Ok(()) => {
            context.mark_as_modified(program.instance);
            (ReplacementResult::NoError, String::new())
        }
        Err(fault) => (replacement_result(&fault), fault.to_string()),
    };
    Ok(ReplaceLineAnswer { code, output: Some(output) })
}
