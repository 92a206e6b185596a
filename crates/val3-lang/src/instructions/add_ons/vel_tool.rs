//! `$velTool`: starts motion by speed along the axes of the tool.

use crate::declare::instruction;

instruction! {
    /// Starts motion by speed along the axes of the tool.
    ///
    /// - `tTool`, `mDesc`: tool, and limits of speed and acceleration.
    /// - Result: the id of the move.
    ///
    /// `$setVelCmd` then sets the speed.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// mdesc mSlow
    /// num nSpeed[6]
    ///   $velTool(tGripper,mSlow)
    ///   nSpeed[2]=10
    ///   $setVelCmd(nSpeed)
    /// ```
    "$velTool": AddOns, with_add_on "Velocity";
    modifier (tool tTool, mdesc mDesc) -> num;
}
