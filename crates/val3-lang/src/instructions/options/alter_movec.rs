//! `alterMovec` (11.2.6): records a move on an arc that `alter` can deviate.

use val3_moves::Manner;

use crate::call::{Call, Flow, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::MdescValue;

instruction! {
    /// Records a move on an arc that `alter` can deviate.
    ///
    /// - `pIntermediate`, `pTarget`: the arc, as for `movec`. A configuration cannot be requested: the arm keeps its
    ///   current one.
    /// - `tTool`, `mDesc`: as for `movec`.
    /// - Result: the id of the move.
    /// - Errors: as for `movec`, and 250 without the alter licence.
    ///
    /// Consecutive moves of this kind form one alterable path.
    ///
    /// ## Example
    /// ```val3
    /// point pArc[3]
    /// tool tTorch
    /// mdesc mSlow
    ///   alterMovel(pArc[0],tTorch,mSlow)
    ///   alterMovec(pArc[1],pArc[2],tTorch,mSlow)
    ///   alterBegin(tTorch,mSlow)
    /// ```
    "alterMovec": Options "11.2.6", role(Move Altered), blocking,
        errors [81, 100, 101, 102, 103, 104, 105, 106, 150, 154, 250];
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
    moves::record(call, "alterMovec", path, tool, mdesc, Manner::Alterable)
}
