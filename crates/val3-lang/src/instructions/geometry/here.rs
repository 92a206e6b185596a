//! `here` (9.6.3): returns the position of a tool as a point.

use crate::call::{Call, FrameRef, PointValue, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;

instruction! {
    /// Returns the position of a tool as a point.
    ///
    /// - `tTool`: the tool.
    /// - `fReference`: the frame of the result.
    /// - Result: the position that the controller commands, with the current configuration of the arm.
    /// - Errors: 163 the frame has no reference frame, 164 the tool has no reference tool.
    ///
    /// `herej` returns the position of each axis.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// point pNow
    ///   pNow=here(tGripper,world)
    ///   putln(pNow.trsf.z)
    /// ```
    "here": Geometry "9.6.3", role(Position), errors [163, 164];
    function (tool tTool, frame fReference) -> point = here;
}

fn here(call: &mut Call<'_>, tool: ToolRef, frame: FrameRef) -> Result<PointValue> {
    let joint = call.ports.commanded_joint();
    moves::point_at(call, &joint, tool, frame)
}
