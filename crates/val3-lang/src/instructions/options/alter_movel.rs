//! `alterMovel` (11.2.6): records a straight move that `alter` can deviate.

use val3_moves::Manner;

use crate::call::{Call, Flow, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::MdescValue;

instruction! {
    /// Records a straight move that `alter` can deviate.
    ///
    /// - `pPosition`: the target. A configuration cannot be requested: the arm keeps its current one.
    /// - `tTool`, `mDesc`: as for `movel`.
    /// - Result: the id of the move.
    /// - Errors: as for `movel`, and 250 without the alter licence.
    ///
    /// Consecutive moves of this kind form one alterable path. A move without a distance is ignored.
    ///
    /// ## Example
    /// ```val3
    /// point pEnd
    /// tool tGripper
    /// mdesc mSlow
    ///   alterMovel(pEnd,tGripper,mSlow)
    ///   alterBegin(tGripper,mSlow)
    /// ```
    "alterMovel": Options "11.2.6", role(Move Altered), blocking,
        errors [81, 100, 101, 102, 103, 104, 105, 106, 150, 154, 250];
    modifier (point pPosition, tool tTool, mdesc mDesc) -> num = to_point;
}

fn to_point(call: &mut Call<'_>, point: PointRef, tool: ToolRef, mdesc: MdescValue) -> Result<Flow<f64>> {
    let path = moves::line(call, point)?;
    moves::record(call, "alterMovel", path, tool, mdesc, Manner::Alterable)
}
