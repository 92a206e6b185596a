//! `movejf` (11.1.5): records a compliant joint move: the arm pushes with a given force and yields to external forces.

use crate::call::{Call, Flow, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::{JointValue, MdescValue};

instruction! {
    /// Records a compliant joint move: the arm pushes with a given force and yields to external forces.
    ///
    /// - `jPosition`: the target.
    /// - `tTool`, `mDesc`: tool, speed and acceleration; blending is not possible before or after such a move.
    /// - `nForce`: per cent of the nominal load, -1000 to 1000: 0 passive, above 0 it pushes towards the target, below
    ///   0 back to the start.
    /// - Result: the id of the move.
    /// - Errors: 70 invalid `nForce`, 81 another kind of arm, 100 to 106 an invalid value in `mDesc`, 150 an earlier
    ///   move cannot be executed, 153 not supported, 154 target out of limits or blending before it, 250 no licence.
    ///
    /// It needs the compliance option. The arm stays on its path and cannot be pulled back beyond the start.
    ///
    /// ## Example
    /// ```val3
    /// joint jPress
    /// tool tGripper
    /// mdesc mSlow
    ///   movejf(jPress,tGripper,mSlow,20)
    ///   waitEndMove()
    /// ```
    "movejf": Options "11.1.5", role(Move Compliant), blocking,
        errors [70, 81, 100, 101, 102, 103, 104, 105, 106, 150, 153, 154, 250];
    modifier (joint jPosition, tool tTool, mdesc mDesc, num nForce) -> num = to_joint;
}

fn to_joint(call: &mut Call<'_>, joint: JointValue, tool: ToolRef, mdesc: MdescValue, force: f64) -> Result<Flow<f64>> {
    let manner = moves::compliant(force)?;
    let path = moves::joint_path(call, joint)?;
    moves::record(call, "movejf", path, tool, mdesc, manner)
}
