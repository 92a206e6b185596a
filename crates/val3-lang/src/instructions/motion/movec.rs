//! `movec` (10.6): records a move on an arc that starts at the end of the previous move.

use val3_moves::Manner;

use crate::call::{Call, Flow, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::MdescValue;

instruction! {
    /// Records a move on an arc, from where the move before ends.
    ///
    /// - `pIntermediate`: a point on the way; its configuration does not count.
    /// - `pTarget`: the end. A full circle takes two moves.
    /// - `tTool`: the tool that runs on the arc.
    /// - `mDesc`: speed, acceleration and blending around the target.
    /// - Result: the id of the move, as `getMoveId` counts it.
    /// - Errors: 81 a target for another kind of arm, 100 to 106 a bad value in `mDesc`, 150 an earlier move cannot be
    ///   done, 153 not supported, 154 a point out of reach, no arc through the points, an arc that the arm cannot follow,
    ///   or an orientation on it that is ambiguous, 160 to 164 `flange` or `world` was changed, or point, frame or tool
    ///   has no reference.
    ///
    /// The tool turns over the orientation of the intermediate point: the same three times keeps it constant.
    ///
    /// ## Example
    /// ```val3
    /// point pArc[3]
    /// tool tTorch
    /// mdesc mWeld
    ///   movel(pArc[0],tTorch,mWeld)
    ///   movec(pArc[1],pArc[2],tTorch,mWeld)
    ///   waitEndMove()
    /// ```
    "movec": Motion "10.6", role(Move Cartesian), blocking,
        errors [81, 100, 101, 102, 103, 104, 105, 106, 150, 153, 154, 160, 161, 162, 163, 164];
    modifier (point pIntermediate, point pTarget, tool tTool, mdesc mDesc) -> num = to_point;
}

fn to_point(
    call: &mut Call<'_>,
    intermediate: PointRef,
    target: PointRef,
    tool: ToolRef,
    mdesc: MdescValue,
) -> Result<Flow<f64>> {
    let path = moves::circle(call, intermediate, target)?;
    moves::record(call, "movec", path, tool, mdesc, Manner::Rigid)
}
