//! `movel` (10.6): records a straight move: the tool centre point moves on a line and rotates evenly.

use val3_moves::Manner;

use crate::call::{Call, Flow, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::MdescValue;

instruction! {
    /// Records a straight move: the tool centre point moves on a line and rotates evenly.
    ///
    /// - `pPosition`: the target. It cannot request a configuration other than the start configuration.
    /// - `tTool`: the tool that moves on the line.
    /// - `mDesc`: speed, acceleration and blending around the target.
    /// - Result: the id of the move, as in `getMoveId`.
    /// - Errors: 81 a target for another kind of arm, 100 to 106 an invalid value in `mDesc`, 150 an earlier move
    ///   cannot be executed, 153 not supported, 154 target out of reach or no straight path to it: on the path an axis
    ///   would leave its limits, or jump at a singularity; 160 to 164 `flange` or `world` was changed, or point, frame
    ///   or tool has no reference.
    ///
    /// The program continues immediately. It waits only if no more moves can be recorded.
    ///
    /// ## Example
    /// ```val3
    /// point pPick
    /// tool tGripper
    /// mdesc mSlow
    ///   movel(appro(pPick,{0,0,-50,0,0,0}),tGripper,mSlow)
    ///   movel(pPick,tGripper,mSlow)
    ///   waitEndMove()
    /// ```
    "movel": Motion "10.6", role(Move Cartesian), blocking,
        errors [81, 100, 101, 102, 103, 104, 105, 106, 150, 153, 154, 160, 161, 162, 163, 164];
    modifier (point pPosition, tool tTool, mdesc mDesc) -> num = to_point;
}

fn to_point(call: &mut Call<'_>, point: PointRef, tool: ToolRef, mdesc: MdescValue) -> Result<Flow<f64>> {
    let path = moves::line(call, point)?;
    moves::record(call, "movel", path, tool, mdesc, Manner::Rigid)
}
