//! Execution of `open` and `close` (9.5.4): `waitEndMove`, then the output of the tool, then `delay`.

use crate::call::{Call, Flow, IoRef, StoredValue, ToolRef, Wait};
use crate::fault::{Fault, Result};
use crate::memory::{Place, field_offset};
use crate::ports::nanoseconds;
use crate::types::BaseType;

/// Parts of the instruction: first the arm moves, then the tool.
const ARM_MOVES: u8 = 0;
const TOOL_MOVES: u8 = 1;

/// Sets the output of a tool when the arm has arrived, and waits for the time in its field `time`.
///
/// # Errors
/// 122 if the output is an input, 123 if it is not linked, 124 if it is protected, 125 if its device has failed.
pub(crate) fn set(call: &mut Call<'_>, ToolRef(tool): ToolRef, state: bool, time: &str) -> Result<Flow> {
    if call.part() == ARM_MOVES {
        if !call.ports.arrive()? {
            return Ok(Flow::Wait(Wait::FOR_OTHERS));
        }
        let output = IoRef::read(call.memory, field(tool, "gripper")?)?;
        call.ports.write_digital(output.port, state)?;
    }
    let time = nanoseconds(f64::read(call.memory, field(tool, time)?)?);
    Ok(match call.part() {
        TOOL_MOVES if call.waited() < time => call.sleep(time),
        TOOL_MOVES => Flow::Done(()),
        _ => call.sleep_in_part(TOOL_MOVES, time),
    })
}

fn field(tool: Place, name: &str) -> Result<Place> {
    let offset = field_offset(BaseType::Tool, None, name).ok_or(Fault::INTERPRETER)?;
    Ok(tool.after(offset))
}
