//! `alterMovej` (11.2.6): records a joint move that `alter` can deviate.

use val3_moves::Manner;

use crate::call::{Call, Flow, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::{JointValue, MdescValue};

instruction! {
    /// Records a joint move that `alter` can deviate.
    ///
    /// - `jPosition`, `pPosition`: the target. A configuration cannot be requested: the arm keeps its current one.
    /// - `tTool`, `mDesc`: as for `movej`.
    /// - Result: the id of the move.
    /// - Errors: as for `movej`, and 250 without the alter licence.
    ///
    /// Consecutive moves of this kind form one alterable path. A move without a distance is ignored.
    ///
    /// ## Example
    /// ```val3
    /// joint jEnd
    /// tool tGripper
    /// mdesc mSlow
    ///   alterMovej(jEnd,tGripper,mSlow)
    ///   alterBegin(world,mSlow)
    /// ```
    "alterMovej": Options "11.2.6", role(Move Altered), blocking,
        errors [81, 100, 101, 102, 103, 104, 105, 106, 150, 154, 250];
    modifier (joint jPosition, tool tTool, mdesc mDesc) -> num = to_joint;
    modifier (point pPosition, tool tTool, mdesc mDesc) -> num = to_point;
}

fn to_joint(call: &mut Call<'_>, joint: JointValue, tool: ToolRef, mdesc: MdescValue) -> Result<Flow<f64>> {
    let path = moves::joint_path(call, joint)?;
    moves::record(call, "alterMovej", path, tool, mdesc, Manner::Alterable)
}

fn to_point(call: &mut Call<'_>, point: PointRef, tool: ToolRef, mdesc: MdescValue) -> Result<Flow<f64>> {
    let path = moves::joint_path_to_point(call, point)?;
    moves::record(call, "alterMovej", path, tool, mdesc, Manner::Alterable)
}
