//! `movej` (10.6): records a joint move: all axes start and arrive together, on the fastest path.

use val3_moves::Manner;

use crate::call::{Call, Flow, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::{JointValue, MdescValue};

instruction! {
    /// Records a joint move: all axes start and arrive together, on the fastest path.
    ///
    /// - `jPosition`, `pPosition`: the target; a point determines the configuration in which it is reached.
    /// - `tTool`: the tool that reaches a point, and whose speed is limited.
    /// - `mDesc`: speed, acceleration and blending around the target.
    /// - Result: the id of the move, as in `getMoveId`.
    /// - Errors: 81 a target for another kind of arm, 100 to 106 an invalid value in `mDesc`, 150 an earlier move
    ///   cannot be executed, 153 not supported, 154 target out of limits or out of reach, 160 to 164 `flange` or
    ///   `world` was changed, or point, frame or tool has no reference.
    ///
    /// The program continues immediately, far ahead of the arm. It waits only if no more moves can be recorded.
    ///
    /// ## Example
    /// ```val3
    /// joint jPark
    /// point pPick
    /// tool tGripper
    /// mdesc mFast
    ///   movej(jPark,tGripper,mFast)
    ///   movej(pPick,tGripper,mFast)
    ///   waitEndMove()
    /// ```
    "movej": Motion "10.6", role(Move Joint), blocking,
        errors [81, 100, 101, 102, 103, 104, 105, 106, 150, 153, 154, 160, 161, 162, 163, 164];
    modifier (joint jPosition, tool tTool, mdesc mDesc) -> num = to_joint;
    modifier (point pPosition, tool tTool, mdesc mDesc) -> num = to_point;
}

fn to_joint(call: &mut Call<'_>, joint: JointValue, tool: ToolRef, mdesc: MdescValue) -> Result<Flow<f64>> {
    let path = moves::joint_path(call, joint)?;
    moves::record(call, "movej", path, tool, mdesc, Manner::Rigid)
}

fn to_point(call: &mut Call<'_>, point: PointRef, tool: ToolRef, mdesc: MdescValue) -> Result<Flow<f64>> {
    let path = moves::joint_path_to_point(call, point)?;
    moves::record(call, "movej", path, tool, mdesc, Manner::Rigid)
}
