//! `alterBegin` (11.2.6): starts the deviation of the current alterable path.

use val3_moves::AlterReference;

use crate::call::{Call, FrameRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::MdescValue;

instruction! {
    /// Starts the deviation of the current alterable path.
    ///
    /// - `fAlterReference`: the deviation is relative to this frame, which is fixed in space: for a part that moves.
    /// - `tAlterReference`: the deviation is relative to this tool: for a sensor on the tool.
    /// - `mMaxVelocity`: its `vel`, `tvel` and `rvel` limit the deviated motion; exceeding them is an error and stops
    ///   the arm. Its `accel` and `decel` limit the stop of the deviation.
    /// - Result: 1 started, 0 waits for the path to start, -1 started already, -2 no alter option, -3 a motion error:
    ///   `resetMotion` is needed.
    ///
    /// ## Example
    /// ```val3
    /// point pEnd
    /// tool tGripper
    /// mdesc mSlow
    ///   alterMovel(pEnd,tGripper,mSlow)
    ///   wait(alterBegin(world,mSlow)==1)
    /// ```
    "alterBegin": Options "11.2.6";
    modifier (frame fAlterReference, mdesc mMaxVelocity) -> num = in_frame;
    modifier (tool tAlterReference, mdesc mMaxVelocity) -> num = in_tool;
}

fn in_frame(call: &mut Call<'_>, frame: FrameRef, limits: MdescValue) -> Result<f64> {
    let reference = AlterReference::Frame(moves::pose_of_frame(call, frame)?);
    begin(call, reference, limits)
}

fn in_tool(call: &mut Call<'_>, tool: ToolRef, limits: MdescValue) -> Result<f64> {
    let reference = AlterReference::Tool(moves::pose_of_tool(call, tool)?);
    begin(call, reference, limits)
}

fn begin(call: &mut Call<'_>, reference: AlterReference, limits: MdescValue) -> Result<f64> {
    let limits = limits.checked(call.unit.millimetres())?;
    Ok(call.ports.begin_alter(reference, &limits).into())
}
