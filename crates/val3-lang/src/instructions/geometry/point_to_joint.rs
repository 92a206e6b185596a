//! `pointToJoint` (9.6.3): finds the joint position with which a tool reaches a point.

use crate::call::{Call, PointRef, PointValue, StoredValue, ToolRef, Var};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::JointValue;

instruction! {
    /// Finds the joint position with which a tool reaches a point.
    ///
    /// - `tTool`: the tool.
    /// - `jInitial`: the start position. It determines the meaning of `ssame`, `esame`, `wsame`, and the turn of an
    ///   axis for which several turns are possible.
    /// - `pPosition`: the point with the requested configuration.
    /// - `jResult`: receives the position; unchanged if the result is `false`.
    /// - Result: `false` if the point is out of reach, or out of the limits in that configuration.
    /// - Errors: 81 a position for another kind of arm, 162 the point, 164 the tool has no reference.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// point pPick
    /// joint jPick
    ///   if pointToJoint(tGripper,herej(),pPick,jPick)==false
    ///     popUpMsg("The point is out of reach")
    ///   endIf
    /// ```
    "pointToJoint": Geometry "9.6.3", errors [81, 162, 164];
    modifier (tool tTool, joint jInitial, point pPosition, joint& jResult) -> bool = joint;
}

fn joint(
    call: &mut Call<'_>,
    tool: ToolRef,
    initial: JointValue,
    point: PointRef,
    result: Var<JointValue>,
) -> Result<bool> {
    moves::check_arm(call)?;
    let tool = moves::pose_of_tool(call, tool)?;
    let flange = moves::pose_of_point(call, point)? * tool.inverse();
    let requested = PointValue::read(call.memory, point.0)?.config.requested();
    let initial = moves::to_arm(call, initial);
    let Ok(joints) = call.ports.arm().solve(&flange.into(), &initial, requested) else { return Ok(false) };
    let joint = moves::of_arm(call, joints);
    result.set(call, joint).map(|()| true)
}
