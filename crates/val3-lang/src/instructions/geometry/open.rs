//! `open` (9.5.4): opens a tool when the arm has arrived.

use crate::call::{Call, Flow, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::gripper;

instruction! {
    /// Opens a tool once the arm has arrived.
    ///
    /// - `tTool`: the tool. Its output `gripper` becomes `true`; then the task waits for `otime` seconds.
    /// - Errors: 122 its output is an input, 123 it is not linked, 150 an earlier move cannot be executed.
    ///
    /// Before that, it waits like `waitEndMove` and thereby ends blending. It does not wait until the arm is at rest:
    /// write `wait(isSettled())` before it.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// point pPick
    /// mdesc mSlow
    ///   movel(pPick,tGripper,mSlow)
    ///   open(tGripper)
    /// ```
    "open": Geometry "9.5.4", role(Arrive), blocking, errors [122, 123, 150];
    modifier (tool tTool) = open;
}

fn open(call: &mut Call<'_>, tool: ToolRef) -> Result<Flow> {
    gripper::set(call, tool, true, "otime")
}
