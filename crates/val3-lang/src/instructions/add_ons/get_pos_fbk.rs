//! `$getPosFbk`: returns the position of a tool as measured by the encoders.

use crate::call::{Call, FrameRef, PointValue, ToolRef, Var};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;

instruction! {
    /// Returns the position of a tool as measured by the encoders.
    ///
    /// - `tTool`: the tool.
    /// - `fReference`: the frame of the result.
    /// - Result: the measured position; `here` returns the commanded position.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// point pNow
    ///   pNow=$getPosFbk(tGripper,world)
    ///   putln(pNow.trsf.z)
    /// ```
    "$getPosFbk": AddOns, with_add_on "Expansion";
    function (tool tTool, frame& fReference) -> point = measured;
}

fn measured(call: &mut Call<'_>, tool: ToolRef, frame: Var<FrameRef>) -> Result<PointValue> {
    let joint = call.ports.measured_joint();
    moves::point_at(call, &joint, tool, FrameRef(frame.place))
}
