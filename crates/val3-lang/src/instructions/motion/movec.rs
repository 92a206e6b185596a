//! `movec` (10.6): records a move on an arc that starts at the end of the previous move.

use val3_moves::Manner;

use crate::call::{Call, Flow, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::MdescValue;

instruction! {
    /// Records a move on an arc that starts at the end of the previous move.
    ///
    /// - `pIntermediate`: a point on the arc; its configuration is ignored.
    /// - `pTarget`: the end of the arc. A full circle requires two moves.
    /// - `tTool`: the tool that moves on the arc.
    /// - `mDesc`: speed, acceleration and blending around the target.
    /// - Result: the id of the move, as in `getMoveId`.
    /// - Errors: 81 a target for another kind of arm, 100 to 106 an invalid value in `mDesc`, 150 an earlier move
    ///   cannot be executed, 153 not supported, 154 a point out of reach, no arc through the points, an arc that the
    ///   arm cannot follow, or an orientation on it that is ambiguous, 160 to 164 `flange` or `world` was changed, or
    ///   point, frame or tool has no reference.
    ///
    /// At the intermediate point, the tool has the orientation of this point. If all three orientations are equal, the
    /// orientation of the tool stays constant.
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
