//! `movelf` (11.1.5): records a compliant straight move: the arm pushes with a given force and yields to external
//! forces.

use crate::call::{Call, Flow, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::MdescValue;

instruction! {
    /// Records a compliant straight move: the arm pushes with a given force and yields to external forces.
    ///
    /// - `pPosition`: the target.
    /// - `tTool`, `mDesc`: tool, speed and acceleration; blending is not possible before or after such a move.
    /// - `nForce`: per cent of the nominal load, -1000 to 1000: 0 passive, above 0 it pushes towards the target, below
    ///   0 back to the start.
    /// - Result: the id of the move.
    /// - Errors: 70 invalid `nForce`, 81 another kind of arm, 100 to 106 an invalid value in `mDesc`, 150 an earlier
    ///   move cannot be executed, 153 not supported, 154 target out of reach, no straight path, or blending before it,
    ///   250 no licence.
    ///
    /// It needs the compliance option. The arm stays on its path and cannot be pulled back beyond the start.
    ///
    /// ## Example
    /// ```val3
    /// point pEject
    /// tool tGripper
    /// mdesc mSlow
    ///   movelf(pEject,tGripper,mSlow,0)
    ///   wait(isCompliant())
    /// ```
    "movelf": Options "11.1.5", role(Move Compliant), blocking,
        errors [70, 81, 100, 101, 102, 103, 104, 105, 106, 150, 153, 154, 250];
    modifier (point pPosition, tool tTool, mdesc mDesc, num nForce) -> num = to_point;
}

fn to_point(call: &mut Call<'_>, point: PointRef, tool: ToolRef, mdesc: MdescValue, force: f64) -> Result<Flow<f64>> {
    let manner = moves::compliant(force)?;
    let path = moves::line(call, point)?;
    moves::record(call, "movelf", path, tool, mdesc, manner)
}
