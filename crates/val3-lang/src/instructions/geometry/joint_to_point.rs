//! `jointToPoint` (9.6.3): returns the position of a tool for a joint position.

use crate::call::{Call, FrameRef, PointValue, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::JointValue;

instruction! {
    /// Returns the position of a tool for a joint position.
    ///
    /// - `tTool`: the tool.
    /// - `fReference`: the frame of the result.
    /// - `jPosition`: the position of each axis.
    /// - Result: the point, with the configuration of the arm at `jPosition`.
    /// - Errors: 81 a position for another kind of arm, 163 the frame, 164 the tool has no reference.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// joint jPark
    /// point pPark
    ///   pPark=jointToPoint(tGripper,world,jPark)
    /// ```
    "jointToPoint": Geometry "9.6.3", errors [81, 163, 164];
    function (tool tTool, frame fReference, joint jPosition) -> point = point;
}

fn point(call: &mut Call<'_>, tool: ToolRef, frame: FrameRef, joint: JointValue) -> Result<PointValue> {
    moves::check_arm(call)?;
    let joints = moves::to_arm(call, joint);
    moves::point_at(call, &joints, tool, frame)
}
