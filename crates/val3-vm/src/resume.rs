//! Line at which a halted task resumes (5.2, 5.10).

use val3_bytecode::Program;
use val3_lang::fault::{Fault, Result};
use val3_lang::runtime_errors::NO_LINE;

/// Returns the first operation of the line `skip` lines after the line that begins at `line`, in source order.
///
/// The position after the last line is the end of the program.
///
/// # Errors
/// 90 if there is no such line.
pub(crate) fn line_to_resume(program: &Program, line: u32, skip: f64) -> Result<u32> {
    let number = program.line_of(line).ok_or(Fault(NO_LINE))?;
    #[allow(clippy::cast_precision_loss, reason = "programs have fewer lines than 2^52")]
    let wanted = number as f64 + (skip + 0.5).floor();
    let lines = program.lines.iter().map(|line| line.op);
    let end = u32::try_from(program.code.len()).unwrap_or(u32::MAX).saturating_sub(1);
    #[allow(clippy::cast_precision_loss, reason = "programs have fewer lines than 2^52")]
    let found = (0u32..).zip(lines.chain([end])).find(|(number, _)| f64::from(*number) == wanted);
    found.map(|(_, op)| op).ok_or(Fault(NO_LINE))
}
